// SPDX-License-Identifier: MIT
#include "core/light/direct_stage.h"

#include "core/base/parallel.h"
#include "core/light/clip_blocker.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace soffit::light {
namespace {

float boxDistance(const Box& a, const Box& b) {
  const vec3 gap = glm::max(glm::max(a.lo - b.hi, b.lo - a.hi), vec3(0.0F));
  return glm::length(gap);
}

float highest(const Box& b, const vec3& n) {
  return (n.x > 0 ? b.hi.x : b.lo.x) * n.x + (n.y > 0 ? b.hi.y : b.lo.y) * n.y +
         (n.z > 0 ? b.hi.z : b.lo.z) * n.z;
}

bool hasPlane(const Receivers::Bounds& b) {
  return b.normal != vec3(0.0F);
}

/// Scratch memory of one task, reused from cluster to cluster.
struct Scratch {
  BlockerLanes cluster;  ///< what may block light for the cluster
  BlockerLanes section;  ///< for a few of its groups in a row
  BlockerLanes group;    ///< for the group, clipped to the front of the light
};

/// Moves what hides most to the front: where all is hidden, the rest need not be looked at.
void putLargestFirst(const vec3& eye, BlockerLanes& blockers) {
  constexpr std::size_t kFirst = BlockerLanes::kBlock;
  if (blockers.size() <= kFirst) return;
  thread_local std::vector<std::pair<float, std::uint32_t>> order;
  order.clear();
  for (std::size_t i = 0; i < blockers.size(); ++i) {
    const auto number = [&](std::size_t row) { return blockers.row(row)[i]; };
    const vec3 a(number(BlockerRow::kX), number(BlockerRow::kY), number(BlockerRow::kZ));
    const vec3 c(number(BlockerRow::kX + 2), number(BlockerRow::kY + 2),
                 number(BlockerRow::kZ + 2));
    const vec3 to = 0.5F * (a + c) - eye;
    const vec3 n(number(BlockerRow::kNx), number(BlockerRow::kNy), number(BlockerRow::kNz));
    const float r2 = glm::dot(to, to) + 1e-4F;
    const float size = number(BlockerRow::kArea) * std::abs(glm::dot(n, to)) / (r2 * std::sqrt(r2));
    order.emplace_back(-size, static_cast<std::uint32_t>(i));
  }
  std::nth_element(order.begin(), order.begin() + kFirst, order.end());
  // Those that belong to the front and are not there change places with those that are but do not.
  std::size_t free = 0;
  std::array<bool, kFirst> stays{};
  for (std::size_t k = 0; k < kFirst; ++k) {
    if (order[k].second < kFirst) stays[order[k].second] = true;
  }
  for (std::size_t k = 0; k < kFirst; ++k) {
    if (order[k].second < kFirst) continue;
    while (stays[free]) ++free;
    blockers.swap(order[k].second, free++);
  }
}

class Stage {
 public:
  Stage(const PreparedLight& light, const Receivers& receivers, const Blockers& blockers,
        const DirectOptions& options, std::span<float> lux)
      : light_(light),
        receivers_(receivers),
        blockers_(blockers),
        bodies_(options.bodies),
        changed_(options.changed),
        kept_(options.kept),
        epsilon_(options.epsilon),
        lux_(lux) {
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
    if (keeps(c.bounds)) {
      markKept(c.begin, c.end);
      return anyLight(c.begin, c.end);
    }
    counts.points += c.used;
    collect(c.bounds, scratch);
    if (scratch.cluster.empty()) ++counts.clusters_clear;
    bool lit = false;
    constexpr std::uint32_t kSection = 4 * Receivers::kGroup;
    for (std::uint32_t begin = c.begin; begin < c.end; begin += kSection) {
      const std::uint32_t end = std::min(c.end, begin + kSection);
      const BlockerLanes& candidates = narrowed(begin, end, scratch);
      for (std::uint32_t slot = begin; slot < end; slot += Receivers::kGroup) {
        if (keeps(receivers_.groups[slot / Receivers::kGroup])) {
          markKept(slot, slot + Receivers::kGroup);
          lit = lit || anyLight(slot, slot + Receivers::kGroup);
          continue;
        }
        lit = group(slot, candidates, scratch, counts) || lit;
      }
    }
    return lit;
  }

 private:
  /// Nothing of the light reaches these bounds, whatever blocks.
  [[nodiscard]] bool outOfSight(const Receivers::Bounds& b) const {
    if (one_sided_ && highest(b.box, plane_n_) <= plane_d_) return true;
    return hasPlane(b) && highest(light_.emitter().bounds, b.normal) <= b.plane_min;
  }

  /// Whether nothing changed between these bounds and the light.
  [[nodiscard]] bool keeps(const Receivers::Bounds& b) const {
    if (changed_.empty()) return false;
    const Shaft shaft = shaftTo(b);
    return std::ranges::none_of(changed_, [&](const Box& box) { return shaft.touches(box); });
  }

  void markKept(std::uint32_t begin, std::uint32_t end) const {
    if (kept_.empty()) return;
    std::fill(kept_.begin() + begin / Receivers::kGroup, kept_.begin() + end / Receivers::kGroup,
              1);
  }

  [[nodiscard]] bool anyLight(std::uint32_t begin, std::uint32_t end) const {
    return std::any_of(lux_.begin() + begin, lux_.begin() + end, [](float e) { return e > 0.0F; });
  }

  [[nodiscard]] Shaft shaftTo(const Receivers::Bounds& b) const {
    Shaft shaft(b.box, light_.emitter().bounds);
    if (hasPlane(b)) shaft.addPlane(-b.normal, -b.plane_min);
    if (one_sided_) shaft.addPlane(-plane_n_, -plane_d_);
    return shaft;
  }

  void collect(const Receivers::Bounds& bounds, Scratch& scratch) const {
    scratch.cluster.clear();
    const Shaft shaft = shaftTo(bounds);
    blockers_.collect(shaft, scratch.cluster);
    if (bodies_.size() > 0) bodies_.collect(shaft, scratch.cluster);
    putLargestFirst(bounds.box.center(), scratch.cluster);
  }

  /// The cluster's blockers that matter to the groups of slots [begin, end).
  const BlockerLanes& narrowed(std::uint32_t begin, std::uint32_t end, Scratch& scratch) const {
    // Few are as quickly culled group by group.
    if (scratch.cluster.size() <= 2 * BlockerLanes::kBlock) return scratch.cluster;
    Box box;
    for (std::uint32_t slot = begin; slot < end; slot += Receivers::kGroup) {
      box.add(receivers_.groups[slot / Receivers::kGroup].box);
    }
    const Shaft shaft = shaftTo({.box = box});
    scratch.section.clear();
    const BlockerFilter filter{shaft.hull(), shaft.slopes(), shaft.from(), shaft.to(), nullptr};
    for (std::size_t k = 0; k < scratch.cluster.size(); k += BlockerLanes::kBlock) {
      filterLanes(scratch.cluster, k, filter, scratch.section);
    }
    return scratch.section;
  }

  /// Finds what may hide a part of the light in front of `cut` from the group. Leaves it in
  /// scratch.group, or, with a shadow, hands it over bit by bit until nothing is lit any more.
  /// Returns how many it found.
  std::size_t findBlockers(const Receivers::Bounds& b, const vec4* cut,
                           const BlockerLanes& candidates, MaskShadow* shadow,
                           Scratch& scratch) const {
    const Shaft shaft = shaftTo(b);
    std::size_t found = 0;
    scratch.group.clear();
    const auto flush = [&] {
      found += scratch.group.size();
      const bool dark = shadow->hide(scratch.group, epsilon_);
      scratch.group.clear();
      return dark;
    };
    const BlockerFilter filter{shaft.hull(), shaft.slopes(), shaft.from(), shaft.to(), cut};
    for (std::size_t k = 0; k < candidates.size(); k += BlockerLanes::kBlock) {
      std::uint32_t behind = filterLanes(candidates, k, filter, scratch.group);
      for (; behind != 0; behind &= behind - 1) {
        const auto i = k + static_cast<std::size_t>(std::countr_zero(behind));
        const MaskBlocker front = clipToFront(candidates.at(i), vec3(*cut), cut->w);
        if (front.count > 0) scratch.group.push(front);
      }
      if (shadow != nullptr && scratch.group.size() >= BlockerLanes::kBlock && flush()) {
        return found;
      }
    }
    if (shadow == nullptr) return scratch.group.size();
    flush();
    return found;
  }

  bool group(std::uint32_t slot, const BlockerLanes& candidates, Scratch& scratch,
             DirectCounts& counts) const {
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
    if (r.lanes == 0) {
      ++counts.groups_clear;
      std::fill(out, out + Receivers::kGroup, 0.0F);
      return false;
    }
    MaskLight face;
    if (light_.form() == PreparedLight::Form::facing && !candidates.empty()) {
      face = light_.facing(b.box.center());
      if (spread(b) || seenAtGrazing(face, r)) {
        return oneByOne(slot, r, lux, candidates, scratch, counts);
      }
    }
    MaskSums sums;
    if (candidates.empty() || !shade(b, r, distance, face, candidates, scratch, counts, sums)) {
      ++counts.groups_clear;
      for (std::size_t i = 0; i < lux.size(); ++i) out[i] = static_cast<float>(lux[i]);
      return true;
    }
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
  bool oneByOne(std::uint32_t slot, MaskReceivers r, const std::array<double, 16>& lux,
                const BlockerLanes& candidates, Scratch& scratch, DirectCounts& counts) const {
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
      MaskSums sums;
      r.lanes = 1U << i;
      const float distance = boxDistance(b.box, light_.emitter().bounds);
      shade(b, r, distance, light_.facing(b.box.center()), candidates, scratch, counts, sums);
      out = static_cast<float>(lux[i] * static_cast<double>(visibleShare(sums, i)));
      lit = lit || out > 0.0F;
    }
    return lit;
  }

  /// Whether a receiver is behind the face that a round light turns to the group, or sees it so
  /// flat that no float tells what is in front of it: close to a tube's axis, beyond its ends.
  [[nodiscard]] bool seenAtGrazing(const MaskLight& face, const MaskReceivers& r) const {
    constexpr float kLeastSine = 0.02F;
    for (std::uint32_t i = 0; i < Receivers::kGroup; ++i) {
      if ((r.lanes >> i & 1U) == 0) continue;
      const vec3 to = vec3(r.x[i], r.y[i], r.z[i]) - (face.origin + 0.5F * (face.u + face.v));
      if (glm::dot(face.normal, to) < kLeastSine * glm::length(to)) return true;
    }
    return false;
  }

  /// What the group sees of the light. face: of a round light. Returns false, and leaves the sums
  /// alone, when nothing is in its way.
  bool shade(const Receivers::Bounds& b, const MaskReceivers& r, float distance,
             const MaskLight& face, const BlockerLanes& candidates, Scratch& scratch,
             DirectCounts& counts, MaskSums& sums) const {
    const bool planar = light_.form() == PreparedLight::Form::planar;
    // Points stand on the surface itself: they know what is before them however flat it is seen.
    if (light_.form() == PreparedLight::Form::points ||
        (light_.emitter().kind == EmitterKind::tube && seenAtGrazing(face, r))) {
      const std::size_t found = findBlockers(b, nullptr, candidates, nullptr, scratch);
      counts.blocker_tests += found;
      if (found > 0) addPoints(r, distance, scratch, sums);
      return found > 0;
    }
    std::span<const MaskLight> masks(&face, 1);
    if (planar) masks = light_.masks(light_.maskLevel(distance));
    const vec4 cut =
        planar ? vec4(plane_n_, plane_d_) : vec4(face.normal, glm::dot(face.normal, face.origin));
    if (masks.size() == 1) {
      MaskShadow shadow(masks[0], r);
      const std::size_t found = findBlockers(b, &cut, candidates, &shadow, scratch);
      counts.blocker_tests += found;
      if (found > 0) shadow.addTo(sums);
      return found > 0;
    }
    const std::size_t found = findBlockers(b, &cut, candidates, nullptr, scratch);
    counts.blocker_tests += found;
    if (found == 0) return false;
    for (const MaskLight& mask : masks) {
      MaskShadow shadow(mask, r);
      shadow.hide(scratch.group, epsilon_);
      shadow.addTo(sums);
    }
    return true;
  }

  void addPoints(const MaskReceivers& r, float distance, const Scratch& scratch,
                 MaskSums& sums) const {
    // Shadows want more points than the unoccluded light does.
    const int level = std::max(light_.sampleLevel(distance), 3);
    addPointVisibility(light_.samples(level), scratch.group, r, epsilon_, sums);
  }

  const PreparedLight& light_;
  const Receivers& receivers_;
  const Blockers& blockers_;
  Blockers bodies_;
  std::span<const Box> changed_;
  std::span<std::uint8_t> kept_;
  float epsilon_;
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

void directIlluminance(const PreparedLight& light, const Receivers& receivers,
                       const Blockers& blockers, const DirectOptions& options, std::span<float> lux,
                       std::span<std::uint8_t> lit, DirectCounts* counts) {
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
