// SPDX-License-Identifier: MIT
#include "core/relight/lighting.h"

#include "core/relight/bodies.h"
#include "core/relight/direct_sums.h"
#include "core/relight/same_light.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace soffit::relight {
namespace {

/// Whether the luminaires whose bodies block light are the same.
bool sameBodies(const std::vector<light::Emitter>& a, const std::vector<light::Emitter>& b) {
  const auto bodies = [](const std::vector<light::Emitter>& list) {
    std::vector<const light::Emitter*> found;
    for (const light::Emitter& e : list) {
      if (e.casts_shadow) found.push_back(&e);
    }
    return found;
  };
  return std::ranges::equal(
      bodies(a), bodies(b),
      [](const light::Emitter* x, const light::Emitter* y) { return sameLight(*x, *y); });
}

}  // namespace

std::vector<light::MaskBlocker> Lighting::otherBodies(std::size_t i) const {
  std::vector<light::MaskBlocker> out;
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    // Its own body does not block a luminaire's light, except that a mesh shades itself.
    if (k == i && emitters_[k].kind != light::EmitterKind::mesh) continue;
    out.insert(out.end(), entries_[k].body.begin(), entries_[k].body.end());
  }
  return out;
}

std::vector<float> Lighting::openShare() const {
  return relight::openShare(emitters_, solver_->operators().texels);
}

void Lighting::compute(std::size_t i) {
  Entry& entry = entries_[i];
  if (!entry.direct) {
    light::DirectCounts counts;
    solver_->direct(emitters_[i], otherBodies(i), entry.column, &counts);
    counts_.add(counts);
    entry.direct = true;
  }
  solver_->indirect(entry.column, openShare());
  entry.ready = true;
}

std::size_t Lighting::columnFor(const light::Emitter& emitter, std::size_t at) const {
  const auto fits = [&](std::size_t i) {
    return entries_[i].direct && sameLight(emitter, emitters_[i]);
  };
  if (at < entries_.size() && fits(at)) return at;
  // It changed its number: others were added or removed before it.
  std::size_t i = 0;
  while (i < entries_.size() && !fits(i)) ++i;
  return i;
}

Result<void> Lighting::setLuminaires(std::span<const light::Luminaire> luminaires, const Job& job) {
  std::vector<light::Emitter> emitters;
  for (const light::Luminaire& l : luminaires) {
    auto emitter = light::makeEmitter(l, solver_->scene().mesh->origin);
    if (!emitter) return emitter.error();
    emitters.push_back(std::move(*emitter));
  }
  // A body that came, went or moved changes every column's shadows: then all are computed again.
  const bool keep = sameBodies(emitters, emitters_);
  std::vector<Entry> entries(emitters.size());
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    entries[i].body = bodyBlockers(emitters[i]);
    const std::size_t from = keep ? columnFor(emitters[i], i) : entries_.size();
    if (from == entries_.size()) continue;
    entries[i].column = std::move(entries_[from].column);
    entries[i].direct = true;
    entries[i].ready = entries_[from].ready;
    entries_[from].direct = false;  // taken
  }
  emitters_ = std::move(emitters);
  entries_ = std::move(entries);
  sky_hand_.reset();
  outdoors_stale_ = outdoors_stale_ || !keep;
  if (outdoors_stale_) {
    sky_transfer_.reset();
    if (auto done = computeOutdoors(job); !done) return done;
    outdoors_stale_ = false;
  }
  letGo();
  for (std::size_t i = 0; i < emitters_.size(); ++i) {
    if (job.cancelled()) return Error{"light", "cancelled", ""};
    job.report("computing luminaires",
               static_cast<double>(i) / static_cast<double>(emitters_.size()));
    if (!entries_[i].ready && emitters_[i].gain > 0.0) compute(i);
  }
  return {};
}

Result<void> Lighting::repaint(std::shared_ptr<const Solver> solver, const Job& job) {
  solver_ = std::move(solver);
  sky_transfer_.reset();
  sky_hand_.reset();
  letGo();
  const std::vector<float> open = openShare();
  for (Entry& entry : entries_) entry.ready = false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!entries_[i].direct) continue;
    if (job.cancelled()) return Error{"light", "cancelled", ""};
    solver_->indirect(entries_[i].column, open);
    entries_[i].ready = true;
  }
  for (Column& column : outdoors_.columns) solver_->indirect(column, open);
  return {};
}

std::optional<Planes> Lighting::under(const Solver& painted, const Planes& thrown,
                                      LightPart part) const {
  DirectSums sums;
  for (std::size_t i = 0; i < emitters_.size(); ++i) {
    if (emitters_[i].gain <= 0.0) continue;
    if (!entries_[i].direct) return std::nullopt;
    sums.add(entries_[i].column, emitters_[i].gain, emitters_[i].color, painted.operators());
  }
  for (std::size_t c = 0; c < 3; ++c) {
    if (thrown[c].empty()) continue;
    Column one;
    one.direct = thrown[c];
    one.lit.assign(painted.operators().texels.receivers.clusters.size(), 1);
    dvec3 color(0.0);
    color[static_cast<int>(c)] = 1.0;
    sums.add(one, 1.0, color, painted.operators());
  }
  const std::vector<float> open = openShare();
  sums.reflect(painted, open);
  std::vector<WeightedColumn> together = sums.lights();
  std::vector<Column> outside(outdoors_.columns.size());
  for (std::size_t i = 0; i < outside.size(); ++i) {
    outside[i].direct = outdoors_.columns[i].direct;
    outside[i].lit = outdoors_.columns[i].lit;
    painted.indirect(outside[i], open);
    together.push_back({&outside[i], outdoors_.weight(i)});
  }
  Planes total;
  spread({}, together, painted.operators(), total, part);
  return total;
}

std::optional<Planes> Lighting::totalUnder(const Solver& painted) const {
  return under(painted, {}, LightPart::all);
}

std::optional<Planes> Lighting::reflectedUnder(const Solver& painted, const Planes& thrown) const {
  return under(painted, thrown, LightPart::reflected);
}

void Lighting::setMix(std::size_t i, double gain, const dvec3& color) {
  emitters_[i].gain = gain;
  emitters_[i].color = color;
  sky_hand_.reset();
  if (gain > 0.0 && !entries_[i].ready) compute(i);
}

std::vector<WeightedColumn> Lighting::lights(std::span<const std::size_t> but) const {
  std::vector<WeightedColumn> on;
  for (std::size_t i = 0; i < emitters_.size(); ++i) {
    const bool left_out = std::ranges::find(but, i) != but.end();
    if (!left_out && emitters_[i].gain > 0.0) on.push_back({&entries_[i].column, weight(i)});
  }
  const std::vector<WeightedColumn> outside = outdoorLights();
  on.insert(on.end(), outside.begin(), outside.end());
  return on;
}

Planes Lighting::total() const {
  Planes lux;
  spread({}, lights(), solver_->operators(), lux);
  return lux;
}

Planes Lighting::indirectTotal() const {
  Planes lux;
  spread({}, lights(), solver_->operators(), lux, LightPart::reflected);
  return lux;
}

std::vector<SensorLight> Lighting::read(const Sensors& sensors,
                                        std::optional<std::size_t> only) const {
  std::vector<SensorLight> out(sensors.size());
  std::vector<vec4> source(solver_->operators().texels.slotCount(), vec4(0.0F));
  const std::vector<float> open = openShare();
  for (std::size_t i = 0; i < emitters_.size(); ++i) {
    if (emitters_[i].gain <= 0.0 || (only && *only != i)) continue;
    const dvec3 w = weight(i);
    const std::vector<double> direct = sensors.direct(*solver_, emitters_[i], otherBodies(i));
    for (std::size_t k = 0; k < out.size(); ++k) out[k].direct += w * direct[k];
    std::vector<vec4> one;
    Column again;
    again.direct = entries_[i].column.direct;
    again.lit = entries_[i].column.lit;
    solver_->indirect(again, open, &one);
    const vec4 w4(vec3(w), 0.0F);
    for (std::size_t s = 0; s < one.size(); ++s) source[s] += w4 * one[s];
  }
  if (environment_ != nullptr && !only) {
    const std::vector<dvec3> direct = sensors.outdoors(*solver_, *environment_, allBodies());
    for (std::size_t k = 0; k < out.size(); ++k) out[k].direct += direct[k];
    for (std::size_t c = 0; c < outdoors_.columns.size(); ++c) {
      std::vector<vec4> one;
      Column again;
      again.direct = outdoors_.columns[c].direct;
      again.lit = outdoors_.columns[c].lit;
      solver_->indirect(again, open, &one);
      const vec4 w4(vec3(outdoors_.weight(c)), 0.0F);
      for (std::size_t s = 0; s < one.size(); ++s) source[s] += w4 * one[s];
    }
  }
  const std::vector<dvec3> indirect = sensors.indirect(source);
  for (std::size_t k = 0; k < out.size(); ++k) out[k].indirect = indirect[k];
  return out;
}

}  // namespace soffit::relight
