// SPDX-License-Identifier: MIT
#include "core/design/rooms.h"

#include "core/base/parallel.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace soffit::design {
namespace {

constexpr std::uint32_t kPointsPerPlane = 24;
constexpr float kBefore = 1.2F;        // m before the plane
constexpr float kBelowCeiling = 0.2F;  // m; door heads are lower
constexpr float kHighest = 20.0F;      // m; what is higher has no ceiling
constexpr float kWithoutCeiling = 3.0F;
constexpr double kSameRoom = 0.1;

bool sees(const geometry::RayCaster& caster, const vec3& from, const vec3& to) {
  geometry::Ray ray;
  ray.origin = from;
  ray.direction = to - from;
  ray.t_min = 1e-4F;
  ray.t_max = 1.0F - 1e-4F;
  return !caster.occluded(ray);
}

/// How far it is free from `foot` along `direction`, `most` if nothing is nearer.
float clearance(const geometry::RayCaster& caster, const vec3& foot, const vec3& direction,
                float most) {
  geometry::Ray ray;
  ray.origin = foot;
  ray.direction = direction;
  ray.t_min = 1e-3F;
  ray.t_max = most;
  return std::min(caster.closest(ray).t, most);
}

struct PlanePoints {
  std::vector<vec3> before;         ///< in front of the plane, where people and things are
  std::vector<vec3> below_ceiling;  ///< above them
};

PlanePoints pointsOf(const geometry::RayCaster& caster, const dvec3& origin,
                     const scene::WorkPlane& plane) {
  PlanePoints points;
  const vec3 normal(glm::normalize(glm::cross(plane.u, plane.v)));
  const vec3 up(0.0F, 0.0F, 1.0F);
  for (std::uint32_t i = 0; i < kPointsPerPlane; ++i) {
    const dvec2 place = r2Sequence(i);
    const vec3 foot(plane.origin - origin + place.x * plane.u + place.y * plane.v);
    const float clear = clearance(caster, foot, normal, kBefore);
    const auto share = static_cast<float>(radicalInverse2(i + 1));
    const vec3 before = foot + (0.1F + 0.85F * share) * clear * normal;
    points.before.push_back(before);
    const float ceiling = clearance(caster, before, up, kHighest);
    const float height = ceiling < kHighest ? ceiling : kWithoutCeiling;
    points.below_ceiling.push_back(before + std::max(0.5F * height, height - kBelowCeiling) * up);
  }
  return points;
}

double freeShare(const geometry::RayCaster& caster, std::span<const vec3> a,
                 std::span<const vec3> b) {
  std::size_t free = 0;
  for (const vec3& p : a) {
    for (const vec3& q : b) free += sees(caster, p, q) ? 1U : 0U;
  }
  return static_cast<double>(free) / static_cast<double>(a.size() * b.size());
}

}  // namespace

std::vector<Room> findRooms(const geometry::RayCaster& caster, const dvec3& origin,
                            std::span<const scene::WorkPlane> planes) {
  std::vector<PlanePoints> points;
  for (const scene::WorkPlane& plane : planes) points.push_back(pointsOf(caster, origin, plane));
  std::vector<std::size_t> room_of(planes.size());
  std::iota(room_of.begin(), room_of.end(), std::size_t{0});
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t k = i + 1; k < planes.size(); ++k) {
      if (room_of[i] == room_of[k]) continue;
      const double free = freeShare(caster, points[i].below_ceiling, points[k].below_ceiling);
      if (free < kSameRoom) continue;
      const std::size_t old = std::max(room_of[i], room_of[k]);
      std::replace(room_of.begin(), room_of.end(), old, std::min(room_of[i], room_of[k]));
    }
  }
  std::vector<Room> rooms;
  for (std::size_t first = 0; first < planes.size(); ++first) {
    if (room_of[first] != first) continue;
    Room room;
    for (std::size_t i = first; i < planes.size(); ++i) {
      if (room_of[i] != first) continue;
      room.name += (room.name.empty() ? "" : " + ") + planes[i].name;
      room.planes.push_back(i);
      for (const auto& list : {points[i].before, points[i].below_ceiling}) {
        room.points.insert(room.points.end(), list.begin(), list.end());
      }
    }
    rooms.push_back(std::move(room));
  }
  return rooms;
}

std::vector<std::size_t> assignRooms(const geometry::RayCaster& caster, std::span<const Room> rooms,
                                     std::span<const dvec3> positions,
                                     std::span<const dvec3> normals) {
  std::vector<std::size_t> out(positions.size(), kNoRoom);
  parallelFor(positions.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const vec3 from(positions[i] + 1e-3 * normals[i]);
      double best = 0.0;
      for (std::size_t r = 0; r < rooms.size(); ++r) {
        std::size_t seen = 0;
        for (const vec3& p : rooms[r].points) {
          if (glm::dot(dvec3(p) - positions[i], normals[i]) > 0.0 && sees(caster, from, p)) ++seen;
        }
        const double share =
            static_cast<double>(seen) / static_cast<double>(rooms[r].points.size());
        if (share <= best) continue;
        best = share;
        out[i] = r;
      }
    }
  });
  return out;
}

}  // namespace soffit::design
