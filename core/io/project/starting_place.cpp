// SPDX-License-Identifier: MIT
#include "core/io/project/starting_place.h"

#include "core/geometry/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace soffit::io {
namespace {

constexpr int kGrid = 16;     // plan positions along either side
constexpr int kStoreys = 64;  // surfaces followed on one plumb line
constexpr int kDirections = 24;
constexpr float kEye = 1.6F;  // metres above the floor
constexpr float kDesk = 0.8F;
constexpr float kLintel = 2.25F;  // metres above the floor
constexpr float kLeastRoom = 2.0F;
constexpr float kMostRoom = 12.0F;
constexpr float kLeastDistance = 0.3F;
constexpr double kBorder = 0.5;  // of the work plane to the walls
constexpr double kCell = 0.5;

vec3 level(int k) {
  const double angle = 2.0 * kPi * k / kDirections;
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0F};
}

/// Scene-local distance to the next surface; infinite in the open.
float reach(const geometry::RayCaster& caster, const vec3& from, const vec3& direction) {
  const geometry::Hit hit = caster.closest({.origin = from, .direction = direction});
  return hit.valid() ? hit.t : std::numeric_limits<float>::infinity();
}

struct Place {
  float score = 0.0F;
  vec3 eye{0.0F};
  vec3 view{1.0F, 0.0F, 0.0F};
  float distance = 0.0F;
};

/// How good it is to stand here; a score of 0 is no place at all.
Place judge(const geometry::RayCaster& caster, const vec3& eye) {
  Place place;
  place.eye = eye;
  for (int k = 0; k < kDirections; ++k) {
    const float distance = reach(caster, eye, level(k));
    if (!std::isfinite(distance) || distance < kLeastDistance) return {};
    // The square root of what is seen: a wide room before a long corridor.
    place.score += std::sqrt(distance);
    if (distance > place.distance) {
      place.distance = distance;
      place.view = level(k);
    }
  }
  return place;
}

/// The eye's places above one point of the plan, from the lowest floor up.
std::vector<vec3> floorsAt(const geometry::RayCaster& caster, float x, float y, const Box& bounds) {
  const float step = 1e-4F * std::max(bounds.size().z, 1.0F);
  std::vector<vec3> eyes;
  vec3 from(x, y, bounds.lo.z - step);
  float below = std::numeric_limits<float>::quiet_NaN();
  for (int k = 0; k < kStoreys; ++k) {
    const float rise = reach(caster, from, {0.0F, 0.0F, 1.0F});
    if (!std::isfinite(rise)) break;
    const float height = from.z + rise;
    const float room = height - below;  // NaN below the first surface: no room
    if (room >= kLeastRoom && room <= kMostRoom) eyes.emplace_back(x, y, below + kEye);
    below = height;
    from.z = height + step;
  }
  return eyes;
}

Place bestPlace(const geometry::RayCaster& caster, const Box& bounds) {
  Place best;
  for (int j = 0; j < kGrid; ++j) {
    for (int i = 0; i < kGrid; ++i) {
      // Off the regular grid by a little, so that no row runs along a wall on the axis.
      const float u = (static_cast<float>(i) + 0.5F + 0.037F) / kGrid;
      const float v = (static_cast<float>(j) + 0.5F - 0.041F) / kGrid;
      const float x = bounds.lo.x + u * bounds.size().x;
      const float y = bounds.lo.y + v * bounds.size().y;
      for (const vec3& eye : floorsAt(caster, x, y, bounds)) {
        const Place place = judge(caster, eye);
        if (place.score > best.score) best = place;
      }
    }
  }
  return best;
}

/// Rounded to centimetres: numbers that people read.
double tidy(double metres) {
  return std::round(metres * 100.0) / 100.0;
}
dvec3 tidy(const dvec3& p) {
  return {tidy(p.x), tidy(p.y), tidy(p.z)};
}

/// The distance to the wall: the least of three parallel rays, so that a gap beside a wardrobe is
/// no way out.
double wallDistance(const geometry::RayCaster& caster, const vec3& from, const vec3& direction) {
  const vec3 aside(-direction.y, direction.x, 0.0F);
  float least = reach(caster, from, direction);
  for (const float shift : {-kLeastDistance, kLeastDistance}) {
    least = std::min(least, reach(caster, from + shift * aside, direction));
  }
  return least;
}

std::optional<scene::WorkPlane> deskPlane(const geometry::RayCaster& caster, const Place& place,
                                          const dvec3& origin) {
  const vec3 desk = place.eye - vec3(0.0F, 0.0F, kEye - kDesk);
  // Above doors and most furniture, where a room's walls are whole.
  vec3 high = place.eye;
  high.z += std::min(kLintel - kEye, 0.9F * reach(caster, place.eye, {0.0F, 0.0F, 1.0F}));
  const double west = wallDistance(caster, high, {-1.0F, 0.0F, 0.0F});
  const double east = wallDistance(caster, high, {1.0F, 0.0F, 0.0F});
  const double south = wallDistance(caster, high, {0.0F, -1.0F, 0.0F});
  const double north = wallDistance(caster, high, {0.0F, 1.0F, 0.0F});
  const dvec2 size(west + east, south + north);
  if (!std::isfinite(size.x + size.y) || std::min(size.x, size.y) < kCell) return std::nullopt;
  const dvec2 border = glm::min(dvec2(kBorder), 0.1 * size);
  const dvec2 span = size - 2.0 * border;
  scene::WorkPlane plane;
  plane.name = "Work plane";
  plane.origin = tidy(origin + dvec3(desk) + dvec3(border.x - west, border.y - south, 0.0));
  plane.u = {tidy(span.x), 0.0, 0.0};
  plane.v = {0.0, tidy(span.y), 0.0};
  plane.nu = std::clamp(static_cast<int>(std::lround(span.x / kCell)), 2, 200);
  plane.nv = std::clamp(static_cast<int>(std::lround(span.y / kCell)), 2, 200);
  return plane;
}

scene::Camera outsideCamera(const Box& bounds, const dvec3& origin) {
  const dvec3 center = origin + dvec3(bounds.center());
  const double distance = 1.2 * std::max(static_cast<double>(bounds.diagonal()), 1e-3);
  scene::Camera camera;
  camera.target = center;
  camera.position = center + distance * glm::normalize(dvec3(-0.6, -0.8, 0.5));
  return camera;
}

}  // namespace

StartingPlace startingPlace(const geometry::Mesh& mesh) {
  const geometry::RayCaster caster(mesh.positions, mesh.triangles);
  const Box bounds = mesh.bounds();
  StartingPlace start;
  const Place place = bestPlace(caster, bounds);
  if (place.score > 0.0F) {
    start.camera.position = tidy(mesh.origin + dvec3(place.eye));
    const vec3 ahead = place.eye + 0.8F * place.distance * place.view;
    start.camera.target = tidy(mesh.origin + dvec3(ahead) - dvec3(0.0, 0.0, 0.2));
    start.camera.vertical_fov_deg = 60.0;
    start.work_plane = deskPlane(caster, place, mesh.origin);
  } else {
    start.camera = outsideCamera(bounds, mesh.origin);
  }
  start.camera.name = "Start";
  return start;
}

}  // namespace soffit::io
