// SPDX-License-Identifier: MIT
#include "ui/jobs/light_columns.h"

#include "core/scene/equality.h"

#include <algorithm>
#include <iterator>

namespace soffit::ui {
namespace {

/// Layouts whose columns are kept; an office of 60 luminaires takes about 30 MB each.
constexpr std::size_t kMostLayouts = 6;

}  // namespace

void LightColumns::setSolver(std::shared_ptr<const relight::Solver> solver) {
  entries_.clear();
  solver_ = std::move(solver);
}

LightColumns::Entry& LightColumns::entryOf(const std::string& layout) {
  const auto found = std::ranges::find(entries_, layout, &Entry::layout);
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    entries_.push_front({layout, std::make_unique<relight::Lighting>(solver_), {}, {}});
    if (entries_.size() > kMostLayouts) {
      auto oldest = std::prev(entries_.end());
      if (oldest->layout == kept_) --oldest;
      entries_.erase(oldest);
    }
  }
  return entries_.front();
}

bool LightColumns::onlyMoved(const Entry& entry, const std::vector<light::Luminaire>& luminaires,
                             std::size_t in_hand) {
  if (entry.luminaires.size() != luminaires.size()) return false;
  for (std::size_t i = 0; i < luminaires.size(); ++i) {
    if (i != in_hand && !scene::same(entry.luminaires[i], luminaires[i])) return false;
  }
  return true;
}

Result<void> LightColumns::take(Entry& entry, const std::vector<light::Luminaire>& luminaires,
                                const Job& job) {
  entry.grabbed.reset();
  entry.luminaires.clear();
  const auto set = entry.lighting->setLuminaires(luminaires, job);
  if (set) entry.luminaires = luminaires;
  return set;
}

Result<LightColumns::Answer> LightColumns::light(const std::string& layout,
                                                 const std::vector<light::Luminaire>& luminaires,
                                                 std::optional<std::size_t> in_hand,
                                                 const Job& job) {
  Entry& entry = entryOf(layout);
  relight::Lighting& lighting = *entry.lighting;
  Answer answer;
  if (in_hand && *in_hand < luminaires.size() && luminaires[*in_hand].on &&
      onlyMoved(entry, luminaires, *in_hand)) {
    if (entry.grabbed != in_hand) {
      lighting.grab(*in_hand);
      entry.grabbed = in_hand;
    }
    const auto emitter = light::makeEmitter(luminaires[*in_hand], solver_->scene().mesh->origin);
    if (!emitter) return emitter.error();
    answer.times = lighting.move(*emitter);
    entry.luminaires[*in_hand] = luminaires[*in_hand];
    answer.lux = lighting.moved();
  } else {
    if (const auto taken = take(entry, luminaires, job); !taken) return taken.error();
    answer.lux = lighting.total();
  }
  answer.emitters.assign(lighting.emitters().begin(), lighting.emitters().end());
  return answer;
}

}  // namespace soffit::ui
