// SPDX-License-Identifier: MIT
// Lighting's luminaires in hand.
#include "core/relight/bodies.h"
#include "core/relight/direct_sums.h"
#include "core/relight/lighting.h"
#include "core/relight/same_light.h"

#include <algorithm>
#include <chrono>

namespace soffit::relight {
void Lighting::grab(std::span<const std::size_t> which) {
  hand_.assign(which.begin(), which.end());
  const bool shades =
      std::ranges::any_of(hand_, [&](std::size_t i) { return emitters_[i].casts_shadow; });
  moving_ = hand_;
  if (shades) {
    for (std::size_t i = 0; i < emitters_.size(); ++i) {
      if (emitters_[i].gain > 0.0 && !inHand(i)) moving_.push_back(i);
    }
  }
  rest_ = noLight(solver_->operators());
  for (const WeightedColumn& other : lights(moving_)) addTo(rest_, other, solver_->operators());
  const WeightedSum rest{&rest_};
  spread({&rest, 1}, {}, solver_->operators(), moved_);
}

bool Lighting::inHand(std::size_t i) const {
  return std::ranges::find(hand_, i) != hand_.end();
}

/// Puts the luminaires in hand to their new places; returns where bodies were and are.
std::vector<Box> Lighting::takeBodies(std::span<const light::Emitter> emitters) {
  std::vector<Box> changed;
  for (std::size_t k = 0; k < hand_.size(); ++k) {
    Entry& entry = entries_[hand_[k]];
    const light::Emitter& before = emitters_[hand_[k]];
    const bool same = sameLight(before, emitters[k]);
    if (!same && (before.casts_shadow || emitters[k].casts_shadow)) {
      if (!entry.body.empty()) changed.push_back(boxOf(entry.body));
      entry.body = bodyBlockers(emitters[k]);
      if (!entry.body.empty()) changed.push_back(boxOf(entry.body));
    }
    if (!same) {
      entry.direct = false;
      entry.ready = false;
    }
    emitters_[hand_[k]] = emitters[k];
  }
  return changed;
}

StageTimes Lighting::move(std::span<const light::Emitter> emitters, light::DirectCounts* counts) {
  StageTimes times;
  sky_hand_.reset();
  const std::vector<Box> changed = takeBodies(emitters);
  if (!changed.empty()) {
    outdoors_stale_ = true;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      // What is not lit now waits until it is.
      if (std::ranges::find(moving_, i) == moving_.end()) entries_[i].direct = false;
      entries_[i].ready = false;
    }
  }
  for (const std::size_t i : moving_) {
    Entry& entry = entries_[i];
    if (emitters_[i].gain <= 0.0) continue;  // its light is asked for when it is switched on
    if (!entry.direct) {
      solver_->direct(emitters_[i], otherBodies(i), entry.column, counts, &times);
    } else if (!changed.empty()) {
      solver_->directAgain(emitters_[i], otherBodies(i), changed, entry.column, counts, &times);
    }
    entry.direct = true;
  }
  const std::vector<float> open = openShare();
  DirectSums together;
  std::vector<WeightedColumn> own;
  if (moving_.size() == 1 && emitters_[moving_.front()].gain > 0.0) {
    Entry& entry = entries_[moving_.front()];
    if (!entry.ready) solver_->indirect(entry.column, open, nullptr, &times);
    entry.ready = true;
    own.push_back({&entry.column, weight(moving_.front())});
  } else {
    for (const std::size_t i : moving_) {
      if (emitters_[i].gain <= 0.0) continue;
      together.add(entries_[i].column, emitters_[i].gain, emitters_[i].color, solver_->operators());
    }
    together.reflect(*solver_, open, &times);
    own = together.lights();
  }
  const auto start = std::chrono::steady_clock::now();
  const WeightedSum rest{&rest_};
  spread({&rest, 1}, own, solver_->operators(), moved_);
  const auto passed = std::chrono::steady_clock::now() - start;
  times.interpolate = std::chrono::duration<double, std::milli>(passed).count();
  return times;
}

}  // namespace soffit::relight
