// SPDX-License-Identifier: MIT
#include "core/io/project/room_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soffit::io {
namespace {

constexpr double kEye = 1.6;
constexpr double kDesk = 0.8;
constexpr double kBorder = 0.5;
constexpr double kCell = 0.5;

/// Rounded to centimetres: numbers that people read.
double tidy(double metres) {
  return std::round(metres * 100.0) / 100.0;
}
dvec3 tidy(const dvec3& p) {
  return {tidy(p.x), tidy(p.y), tidy(p.z)};
}

scene::Camera cameraIn(const geometry::Space& space, const dvec3& origin) {
  const double eye = std::min(kEye, 0.7 * static_cast<double>(space.height));
  scene::Camera camera;
  const dvec3 floor(0.0, 0.0, space.floor);
  camera.position = tidy(origin + floor + dvec3(dvec2(space.corner), eye));
  camera.target = tidy(origin + floor + dvec3(dvec2(space.center), 0.75 * eye));
  // A room without a corner to stand in is looked at from its middle.
  if (space.corner == space.center) camera.target.x = tidy(camera.target.x + 1.0);
  camera.vertical_fov_deg = 60.0;
  return camera;
}

scene::WorkPlane planeIn(const geometry::Space& space, const dvec3& origin) {
  const dvec2 size(space.rectangle_hi - space.rectangle_lo);
  const dvec2 border = glm::min(dvec2(kBorder), 0.1 * size);
  const dvec2 span = size - 2.0 * border;
  const double height = std::min(kDesk, 0.35 * static_cast<double>(space.height));
  scene::WorkPlane plane;
  plane.origin = tidy(origin + dvec3(dvec2(space.rectangle_lo) + border, space.floor + height));
  plane.u = {tidy(span.x), 0.0, 0.0};
  plane.v = {0.0, tidy(span.y), 0.0};
  plane.nu = std::clamp(static_cast<int>(std::lround(span.x / kCell)), 2, 200);
  plane.nv = std::clamp(static_cast<int>(std::lround(span.y / kCell)), 2, 200);
  return plane;
}

}  // namespace

RoomPlaces roomPlaces(const std::vector<geometry::Space>& spaces,
                      const std::vector<std::string>& names, const dvec3& origin) {
  RoomPlaces places;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    places.cameras.push_back(cameraIn(spaces[i], origin));
    places.cameras.back().name = names[i];
    places.work_planes.push_back(planeIn(spaces[i], origin));
    places.work_planes.back().name = names[i];
  }
  return places;
}

std::vector<std::string> roomNames(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) names.push_back(fmt::format("Room {}", i));
  return names;
}

}  // namespace soffit::io
