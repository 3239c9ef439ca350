// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/daylight/environment.h"
#include "core/light/emitter.h"
#include "core/relight/solver.h"

#include <memory>
#include <span>
#include <vector>

/// Light from outside as the engine's columns: the sky by what each texel sees of it
/// (daylight::OpenSky), the sun and a picture's spots as far discs whose shadows are exact.
namespace soffit::relight {

/// A disc so far away that it looks the same from everywhere in the scene: 1 lx on a plane that
/// faces it. It lies 5000 times the scene's size away, which turns its direction by 0.01 degrees
/// across the scene.
light::Emitter farDisc(const daylight::Spot& spot, const Box& scene);

/// A column of direct light that is there: lux per slot.
Column columnOf(std::vector<float> direct, const light::Receivers& receivers);

/// The surroundings' light in one scene.
struct Outdoors {
  Planes sky;  ///< direct light of the sky per slot, RGB lux; spots left out
  /// All of it with its reflections: one column when the surroundings are grey, else one per
  /// channel.
  std::vector<Column> columns;
  /// What a column is multiplied by.
  [[nodiscard]] dvec3 weight(std::size_t column) const {
    if (columns.size() == 1) return dvec3(1.0);
    dvec3 one(0.0);
    one[static_cast<int>(column)] = 1.0;
    return one;
  }
};

/// Direct light alone; Solver::indirect() completes the columns. bodies: of all luminaires; they
/// shade spots and not the sky. Nothing when cancelled.
Outdoors outdoorLight(const Solver& solver,
                      const std::shared_ptr<const daylight::Environment>& environment,
                      std::span<const light::MaskBlocker> bodies, const Job& job);

}  // namespace soffit::relight
