// SPDX-License-Identifier: MIT
#include "core/prt/shadow_pass.h"

#include "core/base/parallel.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <string_view>
#include <utility>

namespace soffit::prt {
namespace {

/// Receivers per task: 64 x 1000 rays are some 20 ms, which is how soon a cancellation is noticed.
constexpr std::size_t kGrain = 32;

Error cancelled() {
  return {"transfer", "cancelled", ""};
}

/// Scratch of one task.
struct Scratch {
  std::vector<std::uint32_t> which;  ///< direction of each ray
  std::vector<geometry::Ray> rays;
  std::vector<std::uint8_t> blocked;
  std::vector<float> share;
};

/// Tells a job's observer how far a loop over receivers is.
class Count {
 public:
  Count(const Job& job, std::string_view stage, std::size_t total)
      : job_(job), stage_(stage), total_(total) {}
  void add(std::size_t n) {
    const std::size_t before = done_.fetch_add(n);
    if (100 * before / total_ != 100 * (before + n) / total_) {
      job_.report(stage_, static_cast<double>(before + n) / static_cast<double>(total_));
    }
  }

 private:
  const Job& job_;
  std::string_view stage_;
  std::size_t total_;
  std::atomic<std::size_t> done_{0};
};

/// Rays of a receiver toward the directions above its horizon that `wanted` picks.
template <class Wanted>
void collectRays(const Receivers& r, std::size_t i, const Directions& directions,
                 const Wanted& wanted, Scratch& s,
                 float reach = std::numeric_limits<float>::infinity()) {
  s.which.clear();
  s.rays.clear();
  const vec3 origin = geometry::offsetOrigin(r.positions[i], r.facing[i]);
  for (std::uint32_t d = 0; d < directions.size(); ++d) {
    if (glm::dot(directions[d], r.facing[i]) <= 0.0F || !wanted(origin, directions[d])) continue;
    s.which.push_back(d);
    s.rays.push_back({origin, 0.0F, directions[d], reach});
  }
}

/// What glass lets through on the way of each ray, up to where something ends it.
void dimByGlass(const Surfaces& surfaces, Scratch& s, std::vector<VisibilityFlags::Dimmed>& out) {
  for (std::size_t k = 0; k < s.rays.size(); ++k) {
    if (s.blocked[k] == 0) continue;
    const geometry::Hit hit = surfaces.caster->closest(s.rays[k]);
    if (hit.valid()) s.rays[k].t_max = hit.t;
  }
  s.share.assign(s.rays.size(), 1.0F);
  surfaces.panes->attenuate(s.rays, s.share);
  for (std::size_t k = 0; k < s.rays.size(); ++k) {
    if (s.share[k] < 1.0F) out.push_back({s.which[k], s.share[k]});
  }
}

/// Per receiver lists, joined.
void joinDimmed(std::vector<std::vector<VisibilityFlags::Dimmed>>& lists, VisibilityFlags& flags) {
  std::vector<std::uint32_t> first{0};
  std::vector<VisibilityFlags::Dimmed> all;
  for (auto& list : lists) {
    all.insert(all.end(), list.begin(), list.end());
    first.push_back(static_cast<std::uint32_t>(all.size()));
    list = {};
  }
  flags.setDimmed(std::move(first), std::move(all));
}

/// Whether a ray from p meets the box (slabs; a zero component of d gives infinities that compare
/// as they should, and a NaN on a slab's plane counts as meeting it).
bool meets(const Box& box, const vec3& p, const vec3& d) {
  float lo = 0.0F;
  float hi = std::numeric_limits<float>::infinity();
  for (int a = 0; a < 3; ++a) {
    float t0 = (box.lo[a] - p[a]) / d[a];
    float t1 = (box.hi[a] - p[a]) / d[a];
    if (t0 > t1) std::swap(t0, t1);
    if (t0 > lo) lo = t0;
    if (t1 < hi) hi = t1;
  }
  return lo <= hi;
}

std::vector<Box> widened(std::span<const Box> edited) {
  std::vector<Box> boxes;
  for (Box box : edited) {
    if (box.empty()) continue;
    // Room for the rounding of the slab test.
    const float margin = 1e-5F * (box.diagonal() + glm::length(box.center())) + 1e-5F;
    box.lo -= margin;
    box.hi += margin;
    boxes.push_back(box);
  }
  return boxes;
}

bool crossesAny(std::span<const Box> boxes, const vec3& p, const vec3& d) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) { return meets(b, p, d); });
}

/// Traces the collected rays; whether any flag of theirs was another before.
bool setFlags(const Surfaces& surfaces, std::size_t i, Scratch& s, VisibilityFlags& flags) {
  s.blocked.resize(s.rays.size());
  surfaces.caster->occluded(s.rays, s.blocked);
  bool changed = false;
  for (std::size_t k = 0; k < s.rays.size(); ++k) {
    const bool now = s.blocked[k] != 0;
    if (now == flags.blocked(i, s.which[k])) continue;
    flags.setBlocked(i, s.which[k], now);
    changed = true;
  }
  return changed;
}

/// What glass dims now: the old list where no ray was traced, the rest anew. Whether they differ.
bool dimAgain(const Surfaces& surfaces, std::span<const VisibilityFlags::Dimmed> before, Scratch& s,
              std::vector<VisibilityFlags::Dimmed>& out) {
  using Dimmed = VisibilityFlags::Dimmed;
  dimByGlass(surfaces, s, out);
  for (const Dimmed& old : before) {
    if (!std::binary_search(s.which.begin(), s.which.end(), old.direction)) out.push_back(old);
  }
  std::sort(out.begin(), out.end(),
            [](const Dimmed& a, const Dimmed& b) { return a.direction < b.direction; });
  return !std::equal(out.begin(), out.end(), before.begin(), before.end());
}

}  // namespace

Result<ShadowPass> traceShadows(const Surfaces& surfaces, const Receivers& receivers,
                                const Directions& directions, const Job& job, float reach) {
  ShadowPass pass{VisibilityFlags(receivers.size(), directions.size()), 0};
  const bool glass = surfaces.panes != nullptr;
  std::vector<std::vector<VisibilityFlags::Dimmed>> dimmed(glass ? receivers.size() : 0);
  std::atomic<std::uint64_t> rays{0};
  Count count(job, "shadow pass", receivers.size());
  parallelFor(receivers.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Scratch s;
    std::uint64_t traced = 0;
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      if (!receivers.standsForItself(i)) continue;
      collectRays(
          receivers, i, directions, [](const vec3&, const vec3&) { return true; }, s, reach);
      traced += s.rays.size();
      setFlags(surfaces, i, s, pass.flags);
      if (glass) dimByGlass(surfaces, s, dimmed[i]);
    }
    rays += traced;
    count.add(end - begin);
  });
  if (job.cancelled()) return cancelled();
  if (glass) joinDimmed(dimmed, pass.flags);
  pass.rays = rays;
  return pass;
}

Result<ShadowUpdate> retraceShadows(const VisibilityFlags& flags, const Surfaces& surfaces,
                                    const Receivers& receivers, const Directions& directions,
                                    std::span<const Box> edited,
                                    std::span<const std::uint8_t> fresh, const Job& job) {
  ShadowUpdate update{flags, std::vector<std::uint8_t>(receivers.size(), 0), 0};
  const std::vector<Box> boxes = widened(edited);
  const bool glass = surfaces.panes != nullptr;
  std::vector<std::vector<VisibilityFlags::Dimmed>> dimmed(glass ? receivers.size() : 0);
  std::atomic<std::uint64_t> rays{0};
  Count count(job, "shadow pass", receivers.size());
  parallelFor(receivers.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Scratch s;
    std::uint64_t traced = 0;
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      if (!receivers.standsForItself(i)) continue;
      const bool all = !fresh.empty() && fresh[i] != 0;
      collectRays(
          receivers, i, directions,
          [&](const vec3& p, const vec3& d) { return all || crossesAny(boxes, p, d); }, s);
      traced += s.rays.size();
      update.changed[i] = setFlags(surfaces, i, s, update.flags) || all ? 1 : 0;
      const bool dims =
          glass ? dimAgain(surfaces, flags.dimmed(i), s, dimmed[i]) : !flags.dimmed(i).empty();
      if (dims) update.changed[i] = 1;
    }
    rays += traced;
    count.add(end - begin);
  });
  if (job.cancelled()) return cancelled();
  if (glass) {
    joinDimmed(dimmed, update.flags);
  } else {
    update.flags.setDimmed({}, {});
  }
  update.rays = rays;
  return update;
}

Result<std::vector<std::uint8_t>> findUncovered(const Surfaces& surfaces,
                                                const Receivers& receivers, const Job& job) {
  constexpr std::uint32_t kProbes = 64;
  constexpr std::size_t kMostInside = kProbes / 4;
  std::array<vec3, kProbes> local;
  for (std::uint32_t k = 0; k < kProbes; ++k) {
    local[k] = cosineHemisphere((static_cast<float>(k) + 0.5F) / kProbes,
                                static_cast<float>(radicalInverse2(k)));
  }
  std::vector<std::uint8_t> valid(receivers.size(), 1);
  parallelFor(receivers.size(), 8 * kGrain, [&](std::size_t begin, std::size_t end) {
    std::array<geometry::Ray, kProbes> rays;
    std::array<geometry::Hit, kProbes> hits;
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      vec3 t, b;
      orthonormalBasis(receivers.facing[i], t, b);
      const vec3 origin = geometry::offsetOrigin(receivers.positions[i], receivers.facing[i]);
      for (std::size_t k = 0; k < kProbes; ++k) {
        const vec3& d = local[k];
        rays[k] = {origin, 0.0F, d.x * t + d.y * b + d.z * receivers.facing[i]};
      }
      surfaces.caster->closest(rays, hits);
      std::size_t inside = 0;
      for (std::size_t k = 0; k < kProbes; ++k) {
        if (!hits[k].valid()) continue;
        const bool front = surfaces.hitsFront(hits[k].triangle, rays[k].direction);
        if (!surfaces.receives(hits[k].triangle, front)) ++inside;
      }
      if (inside > kMostInside) valid[i] = 0;
    }
  });
  if (job.cancelled()) return cancelled();
  return valid;
}

}  // namespace soffit::prt
