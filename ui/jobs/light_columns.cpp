// SPDX-License-Identifier: MIT
#include "ui/jobs/light_columns.h"

#include "core/scene/equality.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace soffit::ui {
namespace {

/// Layouts whose columns are kept; an office of 60 luminaires takes about 30 MB each.
constexpr std::size_t kMostLayouts = 6;
/// With fewer luminaires each one's own reflections are as quick as their sum's.
constexpr std::size_t kManyLuminaires = 4;

/// Whether two luminaires differ in nothing but how much they give, and where they are listed.
bool sameButMix(const light::Luminaire& a, light::Luminaire b) {
  b.name = a.name;
  b.dimming = a.dimming;
  b.on = a.on;
  b.colour = a.colour;
  b.group = a.group;
  return scene::same(a, b);
}

}  // namespace

void LightColumns::setSolver(std::shared_ptr<const relight::Solver> solver) {
  entries_.clear();
  solver_ = std::move(solver);
}

void LightColumns::repaint(std::shared_ptr<const relight::Solver> solver) {
  solver_ = std::move(solver);
  for (Entry& entry : entries_) entry.grabbed.clear();
}

std::optional<LightColumns::Answer> LightColumns::paintedLight(
    const std::string& layout, const std::vector<light::Luminaire>& luminaires) const {
  const auto entry = std::ranges::find(entries_, layout, &Entry::layout);
  if (entry == entries_.end() || &entry->lighting->solver() == solver_.get()) return std::nullopt;
  if (luminaires.size() < kManyLuminaires) return std::nullopt;
  if (!scene::sameList(entry->luminaires, luminaires)) return std::nullopt;
  if (entry->outside != outside_) return std::nullopt;
  auto total = entry->lighting->totalUnder(*solver_);
  if (!total) return std::nullopt;
  Answer answer;
  answer.lux = std::move(*total);
  answer.emitters.assign(entry->lighting->emitters().begin(), entry->lighting->emitters().end());
  return answer;
}

void LightColumns::setOutside(std::shared_ptr<const daylight::Environment> outside) {
  outside_ = std::move(outside);
}

bool LightColumns::lacksOutside(const std::string& layout) const {
  const auto entry = std::ranges::find(entries_, layout, &Entry::layout);
  const bool found = entry != entries_.end() && entry->outside == outside_;
  return !found && outside_ != nullptr && !solver_->knowsSkyLight(outside_.get());
}

/// The entry of a layout whose light is known and that of these luminaires; null: none.
LightColumns::Entry* LightColumns::unchanged(const std::string& layout,
                                             const std::vector<light::Luminaire>& luminaires) {
  const auto entry = std::ranges::find(entries_, layout, &Entry::layout);
  if (entry == entries_.end() || entry->half_painted) return nullptr;
  if (&entry->lighting->solver() != solver_.get()) return nullptr;
  return scene::sameList(entry->luminaires, luminaires) ? &*entry : nullptr;
}

std::optional<relight::SkyParts> LightColumns::partsUnder(
    const daylight::Environment& outside, const std::string& layout,
    const std::vector<light::Luminaire>& luminaires, const Job& job) {
  Entry* entry = unchanged(layout, luminaires);
  if (entry == nullptr) return std::nullopt;
  auto parts = entry->lighting->partsUnderSky(outside, job);
  return parts ? std::optional(std::move(*parts)) : std::nullopt;
}

std::optional<LightColumns::Answer> LightColumns::lightUnder(
    const daylight::Environment& outside, const std::string& layout,
    const std::vector<light::Luminaire>& luminaires, const Job& job) {
  Entry* entry = unchanged(layout, luminaires);
  if (entry == nullptr) return std::nullopt;
  auto total = entry->lighting->totalUnderSky(outside, job);
  if (!total) return std::nullopt;
  Answer answer;
  answer.lux = std::move(*total);
  answer.emitters.assign(entry->lighting->emitters().begin(), entry->lighting->emitters().end());
  return answer;
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

/// Whether nothing but the luminaires in hand changed, and those not in their mix alone, which
/// many of them answer sooner than a move.
bool LightColumns::onlyMoved(const Entry& entry, const std::vector<light::Luminaire>& luminaires,
                             const std::vector<std::size_t>& in_hand) {
  if (entry.luminaires.size() != luminaires.size()) return false;
  if (in_hand.empty() || in_hand.back() >= luminaires.size()) return false;
  bool moved = false;
  bool lit = false;
  for (std::size_t i = 0; i < luminaires.size(); ++i) {
    if (std::ranges::binary_search(in_hand, i)) {
      moved = moved || !sameButMix(entry.luminaires[i], luminaires[i]);
      lit = lit || luminaires[i].on;
    } else if (!scene::same(entry.luminaires[i], luminaires[i])) {
      return false;
    }
  }
  return lit && (moved || entry.grabbed == in_hand);
}

Result<void> LightColumns::moveHand(Entry& entry, const std::vector<light::Luminaire>& luminaires,
                                    const std::vector<std::size_t>& in_hand, Answer& answer) const {
  relight::Lighting& lighting = *entry.lighting;
  std::vector<light::Emitter> emitters;
  for (const std::size_t i : in_hand) {
    auto emitter = light::makeEmitter(luminaires[i], solver_->scene().mesh->origin);
    if (!emitter) return emitter.error();
    emitters.push_back(std::move(*emitter));
  }
  if (entry.grabbed != in_hand) {
    lighting.grab(in_hand);
    entry.grabbed = in_hand;
  }
  answer.times = lighting.move(emitters, &answer.counts);
  for (const std::size_t i : in_hand) entry.luminaires[i] = luminaires[i];
  answer.lux = lighting.moved();
  return {};
}

/// Notes which luminaires shed another light, not only more or less of it.
Result<void> LightColumns::take(Entry& entry, const std::vector<light::Luminaire>& luminaires,
                                const Job& job, Outside part) {
  const std::vector<light::Luminaire> before = std::exchange(entry.luminaires, {});
  if (!entry.grabbed.empty() || before.size() != luminaires.size()) entry.sums.clear();
  entry.grabbed.clear();
  entry.changed.resize(luminaires.size(), true);
  if (&entry.lighting->solver() != solver_.get()) {
    entry.sums.clear();
    entry.half_painted = true;
    if (auto painted = entry.lighting->repaint(solver_, job); !painted) {
      entry.luminaires = before;  // their direct light is there
      return painted.error();
    }
  }
  auto set = entry.lighting->setLuminaires(luminaires, job);
  for (std::size_t i = 0; i < luminaires.size(); ++i) {
    const bool same = i < before.size() && sameButMix(before[i], luminaires[i]);
    entry.changed[i] = entry.changed[i] || !same;
  }
  if (!set) {
    entry.sums.clear();
    if (entry.lighting->environment() != nullptr && entry.lighting->outdoorLights().empty()) {
      // What shines in was given up half way: it is found again.
      (void)entry.lighting->setEnvironment(nullptr);
      entry.outside = nullptr;
    }
    return set;
  }
  entry.half_painted = false;
  entry.luminaires = luminaires;
  if (part == Outside::as_it_was || entry.outside == outside_) return {};
  entry.outside = nullptr;
  auto shone = entry.lighting->setEnvironment(outside_, job);
  if (shone) entry.outside = outside_;
  return shone;
}

relight::Planes LightColumns::mixed(Entry& entry) {
  std::vector<std::string> groups;
  for (const light::Luminaire& l : entry.luminaires) groups.push_back(l.group);
  relight::Planes total = entry.sums.total(*entry.lighting, groups, entry.changed);
  entry.changed.assign(groups.size(), false);
  return total;
}

const relight::Lighting* LightColumns::lightingOf(const std::string& layout) const {
  const auto found = std::ranges::find(entries_, layout, &Entry::layout);
  return found == entries_.end() ? nullptr : found->lighting.get();
}

Result<LightColumns::Answer> LightColumns::light(const std::string& layout,
                                                 const std::vector<light::Luminaire>& luminaires,
                                                 const std::vector<std::size_t>& in_hand,
                                                 const Job& job, Outside part) {
  Entry& entry = entryOf(layout);
  relight::Lighting& lighting = *entry.lighting;
  Answer answer;
  const bool painted = entry.half_painted || &lighting.solver() != solver_.get();
  const bool shines = part == Outside::as_it_was || entry.outside == outside_;
  if (!painted && shines && onlyMoved(entry, luminaires, in_hand)) {
    if (const auto done = moveHand(entry, luminaires, in_hand, answer); !done) return done.error();
  } else {
    if (const auto taken = take(entry, luminaires, job, part); !taken) return taken.error();
    answer.lux = mixed(entry);
  }
  answer.emitters.assign(lighting.emitters().begin(), lighting.emitters().end());
  return answer;
}

}  // namespace soffit::ui
