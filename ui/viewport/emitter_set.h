// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/emitter.h"
#include "core/render/emitter_hits.h"
#include "core/render/emitter_radiance.h"

#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace soffit::ui {

/// The luminaires of a view: placed, named, and found by rays, switched off or not.
class EmitterSet {
 public:
  /// Luminaires that cannot be placed (their fault is reported elsewhere) are left out.
  EmitterSet(std::span<const light::Luminaire> luminaires, const dvec3& origin);
  EmitterSet(const EmitterSet&) = delete;
  EmitterSet& operator=(const EmitterSet&) = delete;

  [[nodiscard]] const std::vector<light::Emitter>& emitters() const { return emitters_; }
  [[nodiscard]] const std::string& name(std::size_t i) const { return names_[i]; }
  [[nodiscard]] const render::EmitterRadiance& radiance(std::size_t i) const {
    return radiance_[i];
  }
  /// -1 for a name that is not there.
  [[nodiscard]] int indexOf(const std::string& name) const;
  [[nodiscard]] render::EmitterHit closest(const geometry::Ray& ray) const {
    return hits_->closest(ray);
  }

 private:
  std::vector<light::Emitter> emitters_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, int> numbers_;
  std::vector<render::EmitterRadiance> radiance_;
  std::vector<light::Emitter> pickable_;  // as if all were on
  std::unique_ptr<render::EmitterHits> hits_;
};

}  // namespace soffit::ui
