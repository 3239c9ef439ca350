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
  std::vector<std::uint32_t> found;
  std::vector<MaskBlocker> cluster;
  std::vector<MaskBlocker> group;
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
    if (scratch.cluster.empty()) ++counts.clusters_clear;
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

  void collect(const Receivers::Bounds& bounds, Scratch& scratch) const {
    scratch.found.clear();
    scratch.cluster.clear();
    const Shaft shaft = shaftTo(bounds);
    blockers_.collect(shaft, scratch.found);
    for (const std::uint32_t i : scratch.found) {
      const Blocker& blocker = blockers_[i];
      // A solid's back hides nothing that its fronts do not.
      if (blocker.solid && highest(bounds.box, blocker.normal) <= glm::dot(blocker.normal, blocker.corners[0])) {
        continue;
      }
      push(maskBlocker(blocker), scratch.cluster);
    }
    for (const MaskBlocker& body : options_.bodies) {
      if (shaft.touches(std::span(body.corners.data(), static_cast<std::size_t>(body.count)))) {
        push(body, scratch.cluster);
      }
    }
  }

  void push(const MaskBlocker& blocker, std::vector<MaskBlocker>& to) const {
    if (!one_sided_) {
      to.push_back(blocker);
      return;
    }
    const MaskBlocker front = clipToFront(blocker, plane_n_, plane_d_);
    if (front.count > 0) to.push_back(front);
  }

  bool group(std::uint32_t slot, Scratch& scratch, DirectCounts& counts) const {
    const Receivers::Bounds& b = receivers_.groups[slot / Receivers::kGroup];
    const MaskReceivers r{&receivers_.x[slot],  &receivers_.y[slot],  &receivers_.z[slot],
                          &receivers_.nx[slot], &receivers_.ny[slot], &receivers_.nz[slot]};
    float* out = &lux_[slot];
    if (outOfSight(b)) {
      std::fill(out, out + Receivers::kGroup, 0.0F);
      return false;
    }
    const float distance = boxDistance(b.box, light_.emitter().bounds);
    alignas(64) std::array<double, 16> lux{};
    light_.unoccluded(r, distance, lux.data());
    const bool any = std::any_of(lux.begin(), lux.end(), [](double e) { return e > 0.0; });
    scratch.group.clear();
    if (any && !scratch.cluster.empty()) {
      const Shaft shaft = shaftTo(b);
      for (const MaskBlocker& blocker : scratch.cluster) {
        if (shaft.touches(std::span(blocker.corners.data(), static_cast<std::size_t>(blocker.count)))) {
          scratch.group.push_back(blocker);
        }
      }
    }
    if (!any || scratch.group.empty()) {
      ++counts.groups_clear;
      for (std::size_t i = 0; i < lux.size(); ++i) out[i] = static_cast<float>(lux[i]);
      return any;
    }
    counts.blocker_tests += scratch.group.size();
    MaskSums sums;
    visibility(b, distance, r, scratch.group, sums);
    bool lit = false;
    for (std::size_t i = 0; i < lux.size(); ++i) {
      float share = 1.0F;
      if (sums.total[i] > 0.0F) {
        share = sums.visible[i] / sums.total[i];
      } else if (sums.plain_total[i] > 0.0F) {
        share = sums.plain_visible[i] / sums.plain_total[i];
      }
      out[i] = static_cast<float>(lux[i] * static_cast<double>(std::min(share, 1.0F)));
      lit = lit || out[i] > 0.0F;
    }
    return lit;
  }

  void visibility(const Receivers::Bounds& b, float distance, const MaskReceivers& r,
                  std::span<const MaskBlocker> blockers, MaskSums& sums) const {
    switch (light_.form()) {
      case PreparedLight::Form::planar:
        for (const MaskLight& mask : light_.masks(light_.maskLevel(distance))) {
          addMaskVisibility(mask, blockers, r, options_.epsilon, sums);
        }
        return;
      case PreparedLight::Form::facing: {
        const MaskLight mask = light_.facing(b.box.center());
        std::vector<MaskBlocker> front;
        const float d = glm::dot(mask.normal, mask.origin);
        for (const MaskBlocker& blocker : blockers) {
          const MaskBlocker clipped = clipToFront(blocker, mask.normal, d);
          if (clipped.count > 0) front.push_back(clipped);
        }
        addMaskVisibility(mask, front, r, options_.epsilon, sums);
        return;
      }
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

MaskBlocker maskBlocker(const Blocker& blocker) {
  MaskBlocker m;
  std::copy(blocker.corners.begin(), blocker.corners.end(), m.corners.begin());
  m.count = blocker.count;
  m.normal = blocker.normal;
  m.d = glm::dot(blocker.normal, blocker.corners[0]);
  m.solid = blocker.solid;
  return m;
}

MaskBlocker clipToFront(const MaskBlocker& blocker, const vec3& n, float d) {
  std::array<float, 5> height{};
  bool all = true;
  bool none = true;
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
