// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace soffit::design {

/// Ways to compute light that the bench compares.
enum class BenchMethod {
  bitmask,      ///< the engine: exact direct light by bitmasks, operators for all bounces
  nodes,        ///< its first usable result: bitmask direct light, bounces at node level alone
  shadow_rays,  ///< the engine's bounces, direct light by shadow rays
  harmonics,    ///< the engine's bounces, direct light by light coefficients times transfer vectors
  cubes,        ///< the same by dynamic cube maps at probes
};

/// One point of the sweep.
struct BenchPoint {
  BenchMethod method = BenchMethod::bitmask;
  int rays = 0;  ///< per point, shadow_rays only; bands of harmonics and cubes
  scene::Quality quality;
  /// Of harmonics: directions of the shadows; of cubes: texels of a side. 0: the method's own.
  int resolution = 0;

  /// "bitmask", "nodes", "shadow-rays-64", "harmonics-5", "cubes-5", "cubes-5-side-32".
  [[nodiscard]] std::string methodName() const;
  /// "interactive", or "interactive+list_rays=32" for a preset with changes.
  [[nodiscard]] std::string settingsName() const;

 private:
  [[nodiscard]] std::string atResolution(const char* what) const;
};

/// Points of one quality, which share a bake.
struct BenchStep {
  scene::Quality quality;
  std::vector<BenchPoint> points;
};

/// The whole sweep, the most informative steps first: the preset that people use with all
/// methods, the other presets, then each setting around the interactive preset, coarse changes
/// before fine ones.
std::vector<BenchStep> benchPlan();

}  // namespace soffit::design
