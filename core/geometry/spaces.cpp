// SPDX-License-Identifier: MIT
#include "core/geometry/spaces.h"

#include "core/geometry/plan_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace soffit::geometry {
namespace {

constexpr float kLeastCell = 0.15F;  // m
constexpr int kMostCells = 160;      // along the larger side of the plan
constexpr float kHeadroom = 2.0F;    // m, of a place where a room may begin
constexpr float kLeastGap = 0.8F;    // m, above furniture
constexpr float kMostGap = 25.0F;
constexpr float kBelowCeiling = 0.2F;  // m, where walls are whole: above doors
constexpr float kLintel = 0.85F;       // of a room's height; what comes lower parts rooms
constexpr float kStepDown = 0.3F, kStepUp = 1.2F;
constexpr float kLeastArea = 1.5F, kLeastSide = 0.8F;
constexpr float kEye = 1.6F;
constexpr float kStandOff = 0.35F;  // m, of the corner from walls
constexpr float kFree = 1.2F;       // m, of sight from the corner into the room
constexpr int kDirections = 32;
constexpr int kSurfaces = 200;  // followed on one plumb line

/// The air between two surfaces on a plumb line.
struct Gap {
  float floor, ceiling;
  int room = -1;
};

struct Plan {
  int nx = 0, ny = 0;
  float cell = 0.0F;
  vec2 lo{0.0F};
  std::vector<std::vector<Gap>> gaps;  ///< per cell, from below
  [[nodiscard]] vec2 center(int c) const {
    return lo + cell * (vec2(static_cast<float>(c % nx), static_cast<float>(c / nx)) + 0.5F);
  }
};

float reach(const RayCaster& caster, const vec3& from, const vec3& direction) {
  return caster.closest({.origin = from, .direction = direction}).t;
}

std::vector<Gap> gapsAt(const RayCaster& caster, const vec2& at, const Box& bounds) {
  const float step = 1e-4F * std::max(bounds.size().z, 1.0F);
  std::vector<Gap> gaps;
  vec3 from(at, bounds.lo.z - step);
  std::optional<float> below;
  for (int k = 0; k < kSurfaces; ++k) {
    const float rise = reach(caster, from, {0.0F, 0.0F, 1.0F});
    if (!std::isfinite(rise)) break;
    const float height = from.z + rise;
    if (below && height - *below >= kLeastGap && height - *below <= kMostGap) {
      gaps.push_back({*below, height});
    }
    below = height;
    from.z = height + step;
  }
  return gaps;
}

Plan makePlan(const RayCaster& caster, const Box& bounds) {
  Plan plan;
  const vec2 size(bounds.size());
  plan.cell = std::max(kLeastCell, std::max(size.x, size.y) / static_cast<float>(kMostCells));
  // A little larger and off the corner, so that no row runs along a wall on the axis.
  plan.lo = vec2(bounds.lo) - plan.cell * vec2(0.63F, 0.58F);
  plan.nx = static_cast<int>(std::ceil(size.x / plan.cell)) + 2;
  plan.ny = static_cast<int>(std::ceil(size.y / plan.cell)) + 2;
  for (int c = 0; c < plan.nx * plan.ny; ++c) {
    plan.gaps.push_back(gapsAt(caster, plan.center(c), bounds));
  }
  return plan;
}

/// Where a gap is: cell and place in its list.
struct Place {
  int cell;
  std::size_t gap;
};

/// Places to begin rooms at: common floors first, so that a room does not begin on a table.
std::vector<Place> seeds(const Plan& plan) {
  const auto level = [](const Gap& g) { return static_cast<int>(std::lround(g.floor / 0.05F)); };
  std::map<int, int> count;
  std::vector<Place> places;
  for (int c = 0; c < plan.nx * plan.ny; ++c) {
    const auto& gaps = plan.gaps[static_cast<std::size_t>(c)];
    for (std::size_t g = 0; g < gaps.size(); ++g) {
      if (gaps[g].ceiling - gaps[g].floor < kHeadroom) continue;
      ++count[level(gaps[g])];
      places.push_back({c, g});
    }
  }
  const auto common = [&](const Place& p) {
    return count[level(plan.gaps[static_cast<std::size_t>(p.cell)][p.gap])];
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](const Place& a, const Place& b) { return common(a) > common(b); });
  return places;
}

class Rooms {
 public:
  Rooms(Plan& plan, const RayCaster& caster) : plan_(plan), caster_(caster) {}

  /// All places that are reached from one, the seed first.
  std::vector<Place> grow(const Place& seed, int room) {
    std::vector<Place> members{seed};
    gap(seed).room = room;
    const Gap level = gap(seed);
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Place from = members[k];
      const int i = from.cell % plan_.nx;
      const int j = from.cell / plan_.nx;
      for (const glm::ivec2 step :
           {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
        const glm::ivec2 to(i + step.x, j + step.y);
        if (to.x < 0 || to.y < 0 || to.x >= plan_.nx || to.y >= plan_.ny) continue;
        enter(from, to.y * plan_.nx + to.x, level, members);
      }
    }
    return members;
  }

  Gap& gap(const Place& p) { return plan_.gaps[static_cast<std::size_t>(p.cell)][p.gap]; }

 private:
  void enter(const Place& from, int cell, const Gap& level, std::vector<Place>& members) {
    auto& gaps = plan_.gaps[static_cast<std::size_t>(cell)];
    for (std::size_t g = 0; g < gaps.size(); ++g) {
      Gap& there = gaps[g];
      if (there.room >= 0 || there.floor < level.floor - kStepDown ||
          there.floor > level.floor + kStepUp ||
          there.ceiling < level.floor + kLintel * (level.ceiling - level.floor)) {
        continue;
      }
      const Gap& here = gap(from);
      const float low = std::max(here.floor, there.floor);
      const float high = std::min(here.ceiling, there.ceiling);
      if (high - low < 2.0F * kBelowCeiling) continue;
      const vec3 a(plan_.center(from.cell), high - kBelowCeiling);
      const vec3 b(plan_.center(cell), high - kBelowCeiling);
      if (caster_.occluded({.origin = a, .direction = b - a, .t_max = 1.0F})) continue;
      there.room = gap(from).room;
      members.push_back({cell, g});
    }
  }

  Plan& plan_;
  const RayCaster& caster_;
};

/// The height of which half of the values are lower.
float median(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The share of level rays that meet something.
double enclosure(const RayCaster& caster, const vec3& eye) {
  int hits = 0;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * kPi * (k + 0.37) / kDirections;
    const vec3 direction(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)),
                         0.0F);
    if (std::isfinite(reach(caster, eye, direction))) ++hits;
  }
  return hits / static_cast<double>(kDirections);
}

/// The cell with most steps to the walls, and among such the one nearest to their mean, so that a
/// square room's center is its middle.
int centerCell(const Plan& plan, const std::vector<int>& steps) {
  const int most = *std::max_element(steps.begin(), steps.end());
  vec2 mean(0.0F);
  int count = 0;
  for (int c = 0; c < plan.nx * plan.ny; ++c) {
    if (steps[static_cast<std::size_t>(c)] != most) continue;
    mean += plan.center(c);
    ++count;
  }
  mean /= static_cast<float>(count);
  int best = -1;
  for (int c = 0; c < plan.nx * plan.ny; ++c) {
    if (steps[static_cast<std::size_t>(c)] != most) continue;
    if (best < 0 || glm::distance(plan.center(c), mean) < glm::distance(plan.center(best), mean)) {
      best = c;
    }
  }
  return best;
}

/// Whether somebody at `from` who looks toward `to` has nothing right before the face.
bool looksFreely(const RayCaster& caster, const vec3& from, const vec3& to) {
  const vec3 ahead = to - from;
  if (caster.occluded({.origin = from, .direction = ahead, .t_max = 1.0F})) return false;
  const float heading = std::atan2(ahead.y, ahead.x);
  for (const float aside : {-0.6F, -0.3F, 0.3F, 0.6F}) {
    for (const float down : {0.0F, -0.35F}) {
      const vec3 direction(std::cos(heading + aside), std::sin(heading + aside), down);
      if (reach(caster, from, direction) < kFree) return false;
    }
  }
  return true;
}

/// The farthest place with room to stand that sees the center at eye height.
vec2 cornerOf(const Plan& plan, const RayCaster& caster, const std::vector<int>& steps,
              const std::vector<float>& floors, const Space& space) {
  const float eye = space.floor + std::min(kEye, 0.7F * space.height);
  const int off = static_cast<int>(std::ceil(kStandOff / plan.cell));
  vec2 best = space.center;
  for (int c = 0; c < plan.nx * plan.ny; ++c) {
    const auto k = static_cast<std::size_t>(c);
    if (steps[k] < off || floors[k] > space.floor + kStepDown) continue;
    const vec2 at = plan.center(c);
    if (glm::distance(at, space.center) <= glm::distance(best, space.center)) continue;
    if (looksFreely(caster, vec3(at, eye), vec3(space.center, eye))) best = at;
  }
  return best;
}

std::optional<Space> describe(const Plan& plan, const RayCaster& caster,
                              const std::vector<Place>& members) {
  const auto cells = static_cast<std::size_t>(plan.nx) * static_cast<std::size_t>(plan.ny);
  PlanMask mask{plan.nx, plan.ny, std::vector<std::uint8_t>(cells, 0)};
  std::vector<float> floors(cells, 0.0F);
  std::vector<float> levels;
  std::vector<float> ceilings;
  Space space;
  for (const Place& p : members) {
    const Gap& gap = plan.gaps[static_cast<std::size_t>(p.cell)][p.gap];
    mask.inside[static_cast<std::size_t>(p.cell)] = 1;
    floors[static_cast<std::size_t>(p.cell)] = gap.floor;
    levels.push_back(gap.floor);
    ceilings.push_back(gap.ceiling);
    const vec2 at = plan.center(p.cell);
    space.box.add(vec3(at - 0.5F * plan.cell, gap.floor));
    space.box.add(vec3(at + 0.5F * plan.cell, gap.ceiling));
  }
  const CellRectangle best = largestRectangle(mask);
  const vec2 size = plan.cell * vec2(best.hi - best.lo);
  space.area = plan.cell * plan.cell *
               static_cast<float>(std::count(mask.inside.begin(), mask.inside.end(), 1));
  if (space.area < kLeastArea || std::min(size.x, size.y) < kLeastSide) return std::nullopt;
  // The seed stands on the floor; half of the room may be under furniture.
  space.floor = levels.front();
  space.height = median(ceilings) - space.floor;
  space.rectangle_lo = plan.lo + plan.cell * vec2(best.lo);
  space.rectangle_hi = plan.lo + plan.cell * vec2(best.hi);
  const std::vector<int> steps = stepsInside(mask);
  space.center = plan.center(centerCell(plan, steps));
  const float eye = space.floor + std::min(kEye, 0.7F * space.height);
  if (enclosure(caster, vec3(space.center, eye)) < 0.75) return std::nullopt;
  space.corner = cornerOf(plan, caster, steps, floors, space);
  return space;
}

}  // namespace

std::vector<Space> findSpaces(const Mesh& mesh, const RayCaster& caster) {
  const Box bounds = mesh.bounds();
  if (bounds.empty()) return {};
  Plan plan = makePlan(caster, bounds);
  Rooms rooms(plan, caster);
  std::vector<Space> spaces;
  int count = 0;
  for (const Place& seed : seeds(plan)) {
    if (rooms.gap(seed).room >= 0) continue;
    const auto space = describe(plan, caster, rooms.grow(seed, count++));
    if (space) spaces.push_back(*space);
  }
  constexpr float kSameFloor = 0.3F;
  const auto storey = [&](const Space& s) { return std::lround(s.floor / kSameFloor); };
  std::stable_sort(spaces.begin(), spaces.end(), [&](const Space& a, const Space& b) {
    return storey(a) != storey(b) ? storey(a) < storey(b) : a.area > b.area;
  });
  return spaces;
}

}  // namespace soffit::geometry
