// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/daylight/environment.h"
#include "core/daylight/open_sky.h"
#include "core/light/direct_stage.h"
#include "core/prt/local_direct.h"
#include "core/relight/column.h"
#include "core/relight/reflectance.h"
#include "core/transfer/far_blocks.h"
#include "core/transfer/kernels.h"
#include "core/transfer/node_solver.h"
#include "core/transfer/operators.h"
#include "core/transfer/patch_weights.h"
#include "core/transfer/shadow_groups.h"
#include "core/transfer/static_scene.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

/// From one luminaire's position to its light everywhere, all bounces included (design.md § 4).
namespace soffit::relight {

/// Milliseconds of the stages of one update, in the order they run.
struct StageTimes {
  double direct = 0;        ///< closed form x visibility at all texels
  double first_bounce = 0;  ///< texels -> skeletons -> texels
  double nodes = 0;         ///< all further bounces at node level
  double gather = 0;        ///< nodes -> skeletons
  double sweep = 0;         ///< all bounces so far once more, texels -> skeletons
  double interpolate = 0;   ///< skeletons -> every display point, with the rest (light_sum.h)
  [[nodiscard]] double total() const {
    return direct + first_bounce + nodes + gather + sweep + interpolate;
  }
};

/// Everything that depends on geometry and reflectances but not on luminaires. Thread-compatible:
/// const members may run at the same time.
class Solver {
 public:
  Solver(std::shared_ptr<const transfer::StaticScene> scene,
         std::shared_ptr<const transfer::Operators> operators,
         std::span<const scene::Material> materials);

  [[nodiscard]] const transfer::StaticScene& scene() const { return *scene_; }
  [[nodiscard]] const transfer::Operators& operators() const { return *operators_; }
  [[nodiscard]] const Reflectances& reflectances() const { return reflectances_; }

  /// New reflectances without a bake.
  void setMaterials(std::span<const scene::Material> materials);

  /// The same geometry with other reflectances, and no bake; this one stays as it is.
  [[nodiscard]] std::shared_ptr<const Solver> repainted(
      std::span<const scene::Material> materials) const {
    auto painted = std::make_shared<Solver>(*this);
    painted->setMaterials(materials);
    return painted;
  }

  /// Direct light of luminaires by another method from now on, made for the texels' receivers;
  /// null: exactly. Luminaires' bodies shade with the exact method alone.
  void useDirect(std::shared_ptr<const prt::LocalDirect> method) { local_ = std::move(method); }
  [[nodiscard]] const prt::LocalDirect* directMethod() const { return local_.get(); }

  /// Direct light of an emitter on all texels; bodies: blockers of all other luminaires' bodies.
  void direct(const light::Emitter& emitter, std::span<const light::MaskBlocker> bodies,
              Column& column, light::DirectCounts* counts = nullptr,
              StageTimes* times = nullptr) const;
  /// The same after bodies moved within these boxes and nothing else: column.direct holds the light
  /// of before, and only what sees the emitter through a box is computed.
  void directAgain(const light::Emitter& emitter, std::span<const light::MaskBlocker> bodies,
                   std::span<const Box> changed, Column& column,
                   light::DirectCounts* counts = nullptr, StageTimes* times = nullptr) const;

  /// Indirect light from column.direct. open: share of each texel that no hugging body covers
  /// (bodies.h), empty for none. source: when given, gets the whole radiosity per slot (for
  /// sensors), RGB in lux.
  ///
  ///   x1 = rho E;  y1 = G x1;  e1 = W y1                 first bounce, texel by texel
  ///   b1 = R(rho e1);  e2+ = all further bounces         node level (node_solver.h)
  ///   skeleton = y1 + G_n (b1 + M e2+)
  ///   skeleton = G rho (E + W skeleton)                 sweeps() times
  ///
  /// Nodes know no more than a linear function on a patch, and in a gap or under a desk most of
  /// what is seen is the dark part of patches that reach out of it: without sweeps such places are
  /// a fifth too bright (README.md).
  void indirect(Column& column, std::span<const float> open, std::vector<vec4>* source = nullptr,
                StageTimes* times = nullptr) const;
  void useSweeps(int count) { sweeps_ = count; }
  [[nodiscard]] int sweeps() const { return sweeps_; }

  /// What each slot sees of the surroundings: looked at once per geometry, when somebody asks, and
  /// shared by solvers of other reflectances. Null when cancelled.
  [[nodiscard]] std::shared_ptr<const daylight::OpenSky> openSky(const Job& job = {}) const;
  /// RGB lux of the surroundings per slot without their spots (daylight::OpenSky::illuminance()),
  /// kept for the ones asked for last and shared in the same way. Null when cancelled.
  [[nodiscard]] std::shared_ptr<const std::vector<vec3>> skyLight(
      const std::shared_ptr<const daylight::Environment>& environment, const Job& job = {}) const;
  /// Whether skyLight() knows the answer.
  [[nodiscard]] bool knowsSkyLight(const daylight::Environment* environment) const;
  /// Keeps it in a file between calls (sky_cache.h).
  void keepSky(std::filesystem::path store) { sky_->store = std::move(store); }

 private:
  /// Shared by copies.
  struct Sky {
    std::mutex mutex;
    std::filesystem::path store;  ///< where it is kept between calls; empty: nowhere
    std::shared_ptr<const daylight::OpenSky> open;
    std::mutex light_mutex;
    std::shared_ptr<const daylight::Environment> lit_by;
    std::shared_ptr<const std::vector<vec3>> light;
  };
  void coarseIndirect(Column& column, std::span<const float> open, std::vector<vec4>* source) const;
  /// Skeleton and what the patches send after it.
  void firstBounce(Column& column, std::span<const float> open,
                   std::span<transfer::PatchLight> sent) const;
  /// Radiosity of direct light per slot and block, and the sum that stays in the scene.
  dvec3 sendDirect(const Column& column, std::span<const float> open, std::span<vec4> x) const;
  void sendCovered(std::span<const vec4> y, std::span<const float> open, std::size_t cluster,
                   std::span<transfer::PatchLight> sent) const;
  void addFromNodes(std::span<const transfer::PatchLight> sent, std::vector<vec4>& y) const;
  [[nodiscard]] vec4 conservingScale(const dvec3& sent, std::span<const vec4> y) const;
  /// One step of x = rho (E + W G x) from texel to texel. Linear: what is interpolated below 0
  /// stays.
  void sweep(Column& column, std::span<const float> open) const;
  void radiosityOf(const Column& column, std::span<const float> open,
                   std::vector<vec4>& source) const;
  void readDirect(std::span<const float> lux, Column& column) const;
  [[nodiscard]] float directAt(const Column& column, std::span<const float> open,
                               std::size_t slot) const {
    const float e = column.direct[operators_->fill_from[slot]];
    return open.empty() ? e : e * open[slot];
  }

  std::shared_ptr<const transfer::StaticScene> scene_;
  std::shared_ptr<const transfer::Operators> operators_;
  transfer::ShadowGroups shadow_groups_;
  transfer::FarBlocks blocks_;
  Reflectances reflectances_;
  std::optional<transfer::NodeSolver> nodes_;      ///< none without nodes
  transfer::PatchWeights patch_weights_;           ///< none before there are weights
  std::vector<std::uint32_t> first_patch_;         ///< per cluster, then the end
  std::vector<vec3> sends_moment_;                 ///< per patch: sum sends phi of its functions
  std::shared_ptr<const prt::LocalDirect> local_;  ///< null: direct light is exact
  int sweeps_ = 0;
  std::shared_ptr<Sky> sky_ = std::make_shared<Sky>();
};

}  // namespace soffit::relight
