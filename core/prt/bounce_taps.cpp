// SPDX-License-Identifier: MIT
#include "core/prt/bounce_taps.h"

#include <algorithm>

namespace soffit::prt {

const std::vector<Tap>& BounceTaps::find(const Receivers& to, const VisibilityFlags& flags,
                                         std::size_t i, List list) {
  which_.clear();
  cosines_.clear();
  rays_of_.clear();
  taps_.clear();
  choice_ = 0.5F;
  const vec3 origin = geometry::offsetOrigin(to.positions[i], to.facing[i]);
  double sum = 0.0;
  for (std::uint32_t d = 0; d < directions_.size(); ++d) {
    const float cosine = glm::dot(directions_[d], to.normals[i]);
    if (cosine <= 0.0F) continue;
    sum += double{cosine} * directions_.weight(d);
    if (!flags.blocked(i, d)) continue;
    which_.push_back(d);
    cosines_.push_back(cosine * directions_.weight(d));
    rays_of_.push_back({origin, 0.0F, directions_[d]});
  }
  if (which_.empty()) return taps_;
  hits_.resize(rays_of_.size());
  surfaces_.caster->closest(rays_of_, hits_);
  rays_ += rays_of_.size();
  const auto dimmed = flags.dimmed(i);
  auto next = dimmed.begin();
  ReceiverSet::Around around;
  for (std::size_t k = 0; k < hits_.size(); ++k) {
    if (!hits_[k].valid()) continue;
    const bool front = surfaces_.hitsFront(hits_[k].triangle, directions_[which_[k]]);
    const std::size_t count = from_.around(hits_[k], front, around);
    while (next != dimmed.end() && next->direction < which_[k]) ++next;
    const bool dims = next != dimmed.end() && next->direction == which_[k];
    const float weight = cosines_[k] / static_cast<float>(sum) * (dims ? next->share : 1.0F);
    add(around, count, weight, list);
  }
  if (list == List::merged) merge();
  return taps_;
}

void BounceTaps::add(const ReceiverSet::Around& around, std::size_t count, float weight,
                     List list) {
  if (list != List::one_per_ray) {
    for (std::size_t a = 0; a < count; ++a) {
      taps_.push_back({around[a].receiver, weight * around[a].weight});
    }
    return;
  }
  // Multiples of the golden ratio: evenly spread over any run of rays.
  choice_ += 0.61803399F;
  if (choice_ >= 1.0F) choice_ -= 1.0F;
  float passed = 0.0F;
  for (std::size_t a = 0; a < count; ++a) {
    passed += around[a].weight;
    if (choice_ >= passed && a + 1 < count) continue;
    taps_.push_back({around[a].receiver, weight});
    return;
  }
}

void BounceTaps::merge() {
  std::sort(taps_.begin(), taps_.end(), [](const Tap& a, const Tap& b) {
    return a.receiver != b.receiver ? a.receiver < b.receiver : a.weight < b.weight;
  });
  std::size_t count = 0;
  for (const Tap& tap : taps_) {
    if (count > 0 && taps_[count - 1].receiver == tap.receiver) {
      taps_[count - 1].weight += tap.weight;
    } else {
      taps_[count++] = tap;
    }
  }
  taps_.resize(count);
}

}  // namespace soffit::prt
