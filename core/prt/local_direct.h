// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/light/depth_cube.h"
#include "core/light/receivers.h"
#include "core/prt/luminaire_light.h"
#include "core/prt/surfaces.h"
#include "core/prt/transfer_rows.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// Direct light of luminaires in the room by the papers' methods, as the engine's direct stage
/// (light::directIlluminance) does it exactly: light coefficients at each receiver times its
/// transfer.
namespace soffit::prt {

/// Where visibility and light coefficients come from.
enum class LocalMethod : std::uint8_t {
  /// The light in closed form at each receiver (Wang & Ramamoorthi 2018; Annen et al. 2004 between
  /// receivers), shadows in the receiver's transfer: flags by direction, of what is near.
  harmonics,
  /// The light drawn into a cube map at a probe per cluster of receivers, against the depth of the
  /// room, weighted anew by each receiver's own distance; transfer without shadows (Fujita & Kanai
  /// 2004, from inside).
  cubes,
};

struct LocalOptions {
  LocalMethod method = LocalMethod::harmonics;
  int bands = 5;
  int directions = 1024;  ///< of the shadows, harmonics alone
  /// m, harmonics alone: what lies farther off does not shade. All of it would be right for distant
  /// light; in a room the walls behind the luminaires would shade them.
  float reach = 1.5F;
  int cube_side = 16;  ///< texels, cubes alone
};

class LocalDirect {
 public:
  /// Traces what visibility needs: flags of every receiver, or a depth cube per cluster.
  /// Errors: cancelled.
  static Result<std::shared_ptr<const LocalDirect>> make(const Surfaces& surfaces,
                                                         const light::Receivers& receivers,
                                                         const LocalOptions& options,
                                                         const Job& job = {});

  /// lux[slot] at dimming 1 and Y = 1, never below 0; lit[cluster] = 1 where any is not zero. Sizes
  /// as for light::directIlluminance(). Bodies of luminaires do not shade. Parallel over clusters;
  /// independent of the number of threads.
  void illuminate(const light::Emitter& emitter, std::span<float> lux,
                  std::span<std::uint8_t> lit) const;

  [[nodiscard]] std::uint64_t rays() const { return rays_; }
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] const LocalOptions& options() const { return options_; }

 private:
  LocalDirect(const light::Receivers& receivers, const LocalOptions& options)
      : receivers_(receivers), options_(options) {}
  [[nodiscard]] Result<void> traceFlags(const Surfaces& surfaces, const Job& job);
  [[nodiscard]] Result<void> traceCubes(const Surfaces& surfaces, const Job& job);
  void byHarmonics(const LuminaireLight& light, const light::Receivers::Cluster& cluster,
                   std::span<float> lux) const;
  void byCube(const light::Emitter& emitter, std::size_t cluster, std::span<float> lux) const;
  [[nodiscard]] float illuminance(const sh::Coefficients& light, std::size_t slot) const;

  light::Receivers receivers_;
  LocalOptions options_;
  TransferRows transfer_;
  std::vector<light::DepthCube> cubes_;  ///< per cluster
  std::uint64_t rays_ = 0;
};

}  // namespace soffit::prt
