// SPDX-License-Identifier: MIT
#include "ui/viewport/emitter_set.h"

#include <algorithm>

namespace soffit::ui {

EmitterSet::EmitterSet(std::span<const light::Luminaire> luminaires, const dvec3& origin) {
  for (const light::Luminaire& luminaire : luminaires) {
    auto emitter = light::makeEmitter(luminaire, origin);
    if (!emitter) continue;
    radiance_.emplace_back(*emitter);
    numbers_.emplace(luminaire.name, static_cast<int>(names_.size()));
    names_.push_back(luminaire.name);
    emitters_.push_back(std::move(*emitter));
  }
  pickable_ = emitters_;
  for (light::Emitter& e : pickable_) {
    e.gain = std::max(e.gain, 1.0);
    e.casts_shadow = true;  // found from its dark side, too: in a plan from above
  }
  hits_ = std::make_unique<render::EmitterHits>(pickable_);
}

int EmitterSet::indexOf(const std::string& name) const {
  const auto found = numbers_.find(name);
  return found == numbers_.end() ? -1 : found->second;
}

}  // namespace soffit::ui
