// SPDX-License-Identifier: MIT
#include "core/light/direct_stage.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace soffit::light {
namespace {

float boxDistance(const Box& a, const Box& b) {
  const vec3 gap = glm::max(glm::max(a.lo - b.hi, b.lo - a.hi), vec3(0.0F));
  return glm::length(gap);
}

float highest(const Box& b, const vec3& n) {
  return (n.x > 0 ? b.hi.x : b.lo.x) * n.x + (n.y > 0 ? b.hi.y : b.lo.y) * n.y + (n.z > 0 ? b.hi.z : b.lo.z) * n.z;
}

bool hasPlane(const Receivers::Bounds& b) { return b.normal != vec3(0.0F); }

/// Scratch memory of one task, reused from cluster to cluster.
struct Scratch {
  std::vector<BoxTree::Part> parts;   ///< of the static blockers, for the cluster
  std::vector<MaskBlocker> bodies;    ///< for the cluster
  Blockers::Found found;              ///< for the group
  std::vector<MaskBlocker> clipped;   ///< for the group
};

class Stage {
 public:
  Stage(const PreparedLight& light, const Receivers& receivers, const Blockers& blockers, const DirectOptions& options,
        std::span<float> lux)
      : light_(light), receivers_(receivers), blockers_(blockers), options_(options), lux_(lux) {
    const Emitter& e = light.emitter();
    one_sided_ = light.form() == PreparedLight::Form::planar;
    if (one_sided_) {
      plane_n_ = vec3(e.normal);
      plane_d_ = static_cast<float>(glm::dot(e.normal, e.disk ? e.position : e.outline[0]));
    }
  }

  bool cluster(std::size_t index, Scratch& scratch, DirectCounts& counts) const {
    const Receivers::Cluster& c = receivers_.clusters[index];
    ++counts.clusters;
    if (outOfSight(c.bounds)) {
      ++counts.clusters_culled;
      std::fill(lux_.begin() + c.begin, lux_.begin() + c.end, 0.0F);
      return false;
    }
    counts.points += c.used;
    collect(c.bounds, scratch);
    if (nothing(scratch)) ++counts.clusters_clear;
    bool lit = false;
    for (std::uint32_t slot = c.begin; slot < c.end; slot += Receivers::kGroup) {
      lit = group(slot, scratch, counts) || lit;
    }
    return lit;
  }

 private:
  /// Nothing of the light reaches these bounds, whatever blocks.
  [[nodiscard]] bool outOfSight(const Receivers::Bounds& b) const {
    if (one_sided_ && highest(b.box, plane_n_) <= plane_d_) return true;
    return hasPlane(b) && highest(light_.emitter().bounds, b.normal) <= b.plane_min;
  }

  [[nodiscard]] Shaft shaftTo(const Receivers::Bounds& b) const {
    Shaft shaft(b.box, light_.emitter().bounds);
    if (hasPlane(b)) shaft.addPlane(-b.normal, -b.plane_min);
    if (one_sided_) shaft.addPlane(-plane_n_, -plane_d_);
    return shaft;
  }

  static bool nothing(const Scratch& scratch) { return scratch.parts.empty() && scratch.bodies.empty(); }

  void collect(const Receivers::Bounds& bounds, Scratch& scratch) const {
    scratch.parts.clear();
    scratch.bodies.clear();
    const Shaft shaft = shaftTo(bounds);
    blockers_.collect(shaft, scratch.parts);
    for (const MaskBlocker& body : options_.bodies) {
      if (shaft.touches(std::span(body.corners.data(), static_cast<std::size_t>(body.count)))) {
        scratch.bodies.push_back(body);
      }
    }
  }

  /// Leaves in scratch.found.whole what may hide a part of the light in front of `cut` from the
  /// group; pieces cut off are in scratch.clipped.
  void findBlockers(const Receivers::Bounds& b, const vec4* cut, Scratch& scratch) const {
    Blockers::Found& found = scratch.found;
    blockers_.find(scratch.parts, shaftTo(b), b.box, cut, found);
    for (const MaskBlocker& body : scratch.bodies) (cut != nullptr ? found.cut : found.whole).push_back(&body);
    scratch.clipped.clear();
    scratch.clipped.reserve(found.cut.size());  // pointers into it must hold
    for (const MaskBlocker* const blocker : found.cut) {
      const MaskBlocker front = clipToFront(*blocker, vec3(*cut), cut->w);
      if (front.count == 0) continue;
      scratch.clipped.push_back(front);
      found.whole.push_back(&scratch.clipped.back());
    }
  }

  bool group(std::uint32_t slot, Scratch& scratch, DirectCounts& counts) const {
    const Receivers::Bounds& b = receivers_.groups[slot / Receivers::kGroup];
    MaskReceivers r{&receivers_.x[slot],  &receivers_.y[slot],  &receivers_.z[slot],
                          &receivers_.nx[slot], &receivers_.ny[slot], &receivers_.nz[slot]};
    float* out = &lux_[slot];
    if (outOfSight(b)) {
      std::fill(out, out + Receivers::kGroup, 0.0F);
      return false;
    }
    const float distance = boxDistance(b.box, light_.emitter().bounds);
    alignas(64) std::array<double, 16> lux{};
    light_.unoccluded(r, distance, lux.data());
    r.lanes = 0;
    for (std::size_t i = 0; i < lux.size(); ++i) r.lanes |= (lux[i] > 0.0 ? 1U : 0U) << i;
    const bool any = r.lanes != 0;
    if (any && light_.form() == PreparedLight::Form::facing && !nothing(scratch) && spread(b)) {
      return oneByOne(slot, r, lux, scratch, counts);
    }
    scratch.found.whole.clear();
    MaskLight facing;
    if (any && !nothing(scratch)) {
      if (one_sided_) {
        const vec4 cut(plane_n_, plane_d_);
        findBlockers(b, &cut, scratch);
      } else if (light_.form() == PreparedLight::Form::facing) {
        facing = light_.facing(b.box.center());
        const vec4 cut(facing.normal, glm::dot(facing.normal, facing.origin));
        findBlockers(b, &cut, scratch);
      } else {
        findBlockers(b, nullptr, scratch);
      }
    }
    const std::span<const MaskBlocker* const> blockers = scratch.found.whole;
    if (!any || blockers.empty()) {
      ++counts.groups_clear;
      for (std::size_t i = 0; i < lux.size(); ++i) out[i] = static_cast<float>(lux[i]);
      return any;
    }
    counts.blocker_tests += blockers.size();
    MaskSums sums;
    visibility(facing, distance, r, blockers, sums);
    bool lit = false;
    for (std::size_t i = 0; i < lux.size(); ++i) {
      out[i] = static_cast<float>(lux[i] * static_cast<double>(visibleShare(sums, i)));
      lit = lit || out[i] > 0.0F;
    }
    return lit;
  }

  static float visibleShare(const MaskSums& sums, std::size_t i) {
    float share = 1.0F;
    if (sums.total[i] > 0.0F) {
      share = sums.visible[i] / sums.total[i];
    } else if (sums.plain_total[i] > 0.0F) {
      share = sums.plain_visible[i] / sums.plain_total[i];
    }
    return std::min(share, 1.0F);
  }

  /// Whether a group sees a round light from such different sides that no one face of it stands for
  /// all: sensors far apart, or points close to the light.
  [[nodiscard]] bool spread(const Receivers::Bounds& b) const {
    const vec3 center(light_.emitter().position);
    return b.box.diagonal() > 0.5F * std::sqrt(b.box.distanceSquared(center));
  }

  /// A group of a round light, each point with the face that is turned to it.
  bool oneByOne(std::uint32_t slot, MaskReceivers r, const std::array<double, 16>& lux, Scratch& scratch,
                DirectCounts& counts) const {
    bool lit = false;
    const std::uint32_t lanes = r.lanes;
    for (std::uint32_t i = 0; i < Receivers::kGroup; ++i) {
      float& out = lux_[slot + i];
      out = 0.0F;
      if ((lanes >> i & 1U) == 0) continue;
      Receivers::Bounds b;
      b.box.add(receivers_.position(slot + i));
      b.normal = receivers_.normal(slot + i);
      b.plane_min = glm::dot(b.normal, receivers_.position(slot + i));
      const MaskLight facing = light_.facing(b.box.center());
      const vec4 cut(facing.normal, glm::dot(facing.normal, facing.origin));
      findBlockers(b, &cut, scratch);
      counts.blocker_tests += scratch.found.whole.size();
      MaskSums sums;
      r.lanes = 1U << i;
      visibility(facing, boxDistance(b.box, light_.emitter().bounds), r, scratch.found.whole, sums);
      out = static_cast<float>(lux[i] * static_cast<double>(visibleShare(sums, i)));
      lit = lit || out > 0.0F;
    }
    return lit;
  }

  void visibility(const MaskLight& facing, float distance, const MaskReceivers& r,
                  std::span<const MaskBlocker* const> blockers, MaskSums& sums) const {
    switch (light_.form()) {
      case PreparedLight::Form::planar:
        for (const MaskLight& mask : light_.masks(light_.maskLevel(distance))) {
          addMaskVisibility(mask, blockers, r, options_.epsilon, sums);
        }
        return;
      case PreparedLight::Form::facing: addMaskVisibility(facing, blockers, r, options_.epsilon, sums); return;
      case PreparedLight::Form::points: {
        // Shadows want more points than the unoccluded light does.
        const int level = std::max(light_.sampleLevel(distance), 3);
        addPointVisibility(light_.samples(level), blockers, r, options_.epsilon, sums);
        return;
      }
    }
  }

  const PreparedLight& light_;
  const Receivers& receivers_;
  const Blockers& blockers_;
  const DirectOptions& options_;
  std::span<float> lux_;
  bool one_sided_ = false;
  vec3 plane_n_{0.0F};
  float plane_d_ = 0.0F;
};

}  // namespace

void DirectCounts::add(const DirectCounts& o) {
  points += o.points;
  clusters += o.clusters;
  clusters_culled += o.clusters_culled;
  clusters_clear += o.clusters_clear;
  groups_clear += o.groups_clear;
  blocker_tests += o.blocker_tests;
}

MaskBlocker clipToFront(const MaskBlocker& blocker, const vec3& n, float d) {
  std::array<float, 5> height{};
  bool all = true;
  bool none = true;
  // How far a corner may stand on the wrong side by rounding alone.
  const float tolerance = 2e-7F * (std::abs(d) + 1.0F);
  for (int i = 0; i < blocker.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    height[k] = glm::dot(n, blocker.corners[k]) - d;
    all = all && height[k] >= -tolerance;
    none = none && height[k] <= tolerance;
  }
  if (none) {
    MaskBlocker empty = blocker;
    empty.count = 0;
    return empty;
  }
  if (all) return blocker;
  MaskBlocker out = blocker;
  out.count = 0;
  for (int i = 0; i < blocker.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto next = static_cast<std::size_t>((i + 1) % blocker.count);
    if (height[k] > 0.0F && out.count < 5) out.corners[static_cast<std::size_t>(out.count++)] = blocker.corners[k];
    if ((height[k] > 0.0F) != (height[next] > 0.0F) && out.count < 5) {
      const float t = height[k] / (height[k] - height[next]);
      out.corners[static_cast<std::size_t>(out.count++)] =
          blocker.corners[k] + t * (blocker.corners[next] - blocker.corners[k]);
    }
  }
  return out;
}

void directIlluminance(const PreparedLight& light, const Receivers& receivers, const Blockers& blockers,
                       const DirectOptions& options, std::span<float> lux, std::span<std::uint8_t> lit,
                       DirectCounts* counts) {
  const Stage stage(light, receivers, blockers, options, lux);
  constexpr std::size_t kGrain = 4;
  std::vector<DirectCounts> tallies(receivers.clusters.size() / kGrain + 1);
  parallelFor(receivers.clusters.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    thread_local Scratch scratch;
    for (std::size_t i = begin; i < end; ++i) {
      lit[i] = stage.cluster(i, scratch, tallies[begin / kGrain]) ? 1 : 0;
    }
  });
  if (counts != nullptr) {
    for (const DirectCounts& t : tallies) counts->add(t);
  }
}

}  // namespace soffit::light
