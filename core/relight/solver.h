// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/direct_stage.h"
#include "core/relight/reflectance.h"
#include "core/transfer/node_solver.h"
#include "core/transfer/operators.h"
#include "core/transfer/static_scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// From one luminaire's position to its light everywhere, all bounces included (design.md § 4).
namespace soffit::relight {

/// Milliseconds of the stages of one update, in the order they run.
struct StageTimes {
  double direct = 0, restrict_ = 0, nodes = 0, source = 0, gather = 0, interpolate = 0;
  [[nodiscard]] double total() const { return direct + restrict_ + nodes + source + gather + interpolate; }
};

/// One luminaire's light at dimming 1 and a colour of Y = 1.
struct Column {
  std::vector<float> direct;        ///< lux per slot
  std::vector<std::uint8_t> lit;    ///< per cluster
  /// Response of each channel to white light of this luminaire (colour is applied by mixing):
  std::vector<vec4> skeleton;       ///< per gather list; empty with coarse operators
  std::array<std::vector<float>, 3> node;  ///< node coefficients of the indirect light
};

struct SolveOptions {
  int sweeps = 0;  ///< extra bounces at texel resolution: y = W gather(x), x = rho (E + y)
};

/// Everything that depends on geometry and reflectances but not on luminaires. Thread-compatible:
/// const members may run at the same time.
class Solver {
 public:
  Solver(std::shared_ptr<const transfer::StaticScene> scene, std::shared_ptr<const transfer::Operators> operators,
         std::span<const scene::Material> materials);

  [[nodiscard]] const transfer::StaticScene& scene() const { return *scene_; }
  [[nodiscard]] const transfer::Operators& operators() const { return *operators_; }
  [[nodiscard]] const Reflectances& reflectances() const { return reflectances_; }

  /// New reflectances without a bake.
  void setMaterials(std::span<const scene::Material> materials);

  /// Direct light of an emitter on all texels; bodies: blockers of all other luminaires' bodies.
  void direct(const light::Emitter& emitter, std::span<const light::MaskBlocker> bodies, Column& column,
              light::DirectCounts* counts = nullptr, StageTimes* times = nullptr) const;

  /// Indirect light from column.direct. open: share of each texel that no hugging body covers
  /// (bodies.h), empty for none. source: when given, gets the radiosity per slot that the last
  /// gather used (for sensors), RGB in lux.
  void indirect(Column& column, std::span<const float> open, const SolveOptions& options,
                std::vector<vec4>* source = nullptr, StageTimes* times = nullptr) const;

  /// Adds gain * color * column to RGB planes of slotCount() floats.
  void add(const Column& column, const dvec3& weight, std::array<std::vector<float>, 3>& total,
           StageTimes* times = nullptr) const;

  /// Gives invalid texels the light of the valid ones they stand for.
  void fill(std::array<std::vector<float>, 3>& total) const;

 private:
  void factor();
  void gatherAll(const std::vector<vec4>& x, std::vector<vec4>& y) const;

  std::shared_ptr<const transfer::StaticScene> scene_;
  std::shared_ptr<const transfer::Operators> operators_;
  Reflectances reflectances_;
  std::vector<transfer::NodeSolver> nodes_;   ///< one per distinct channel
  std::array<std::size_t, 3> node_of_{0, 0, 0};
  std::vector<std::uint32_t> filled_;         ///< slots that show another's light
};

}  // namespace soffit::relight
