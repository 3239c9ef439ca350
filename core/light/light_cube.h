// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/depth_cube.h"
#include "core/light/emitter.h"
#include "core/sh/index.h"
#include "core/sh/projection.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Luminaires of any shape as SH coefficients: drawn into a cube map around a probe, against the
/// cached depth of the scene (Fujita & Kanai 2004, with faces of 90 degrees and exact solid
/// angles).
///
/// Fujita & Kanai see lights from one point and outside a virtual sphere, so that all receivers get
/// the same coefficients. Here a drawn texel keeps the piece of luminaire that it shows, place,
/// normal and area; a receiver near the probe weighs the pieces anew by its own distances and
/// directions. Visibility remains that of the probe.
namespace soffit::light {

/// A piece of a luminaire that one texel shows.
struct LightTexel {
  std::uint32_t texel = 0;    ///< in the cube map
  std::uint32_t emitter = 0;  ///< in the list that was drawn
  dvec3 point{0.0};           ///< middle of the piece, relative to the scene origin
  dvec3 normal{0.0};          ///< mean normal; zero for a point source
  double area = 0.0;          ///< m^2, of bent Lambertian surfaces across `normal`; 0: point source
  double solid_angle = 0.0;   ///< that it covers at the probe; 0 for a point source
};

struct LightCube {
  dvec3 probe{0.0};
  int side = 0;
  std::vector<LightTexel> texels;  ///< lit ones, emitter by emitter in the order of the list

  /// RGB radiance per texel, cd/m^2 (linear Rec.709, gain and colour applied), averaged over the
  /// texel, in the layout of core/sh/cube_map.h: what reflection mapping shows.
  [[nodiscard]] std::array<std::vector<float>, 3> radiance(std::span<const Emitter> emitters) const;
};

struct LightCubeOptions {
  /// Lines of sight per luminaire, at least: 4 to 64^2 in each texel that a part of it may cover,
  /// in a sheared grid, so that a lamp smaller than a texel is neither missed nor counted whole.
  /// What they cover is scaled to the exact solid angle of the part.
  int lines_of_sight = 4096;
};

/// Draws emitters (all of them, whatever their gain) around depth.probe. The shapes are drawn as
/// emitters without shadow: luminaires hide nothing of one another or of themselves. Cost: a plane
/// hit test per line of sight; emitters in parallel, result independent of the number of threads.
LightCube drawLights(const DepthCube& depth, std::span<const Emitter> emitters,
                     const LightCubeOptions& options = {});

/// Coefficients of the drawn light at the probe itself by the table of the same cube map
/// (sh::cubeSamples(cube.side)). Unit cd/m^2 sr^1/2. Light within a texel comes from its centre: an
/// error of (degree / side)^2.
sh::RgbCoefficients coefficientsAtProbe(const LightCube& cube, std::span<const Emitter> emitters,
                                        const sh::ProjectionTable& table);

/// Coefficients at any receiver near the probe: each piece with the distance, direction and
/// emission towards this receiver, E per unit cosine = intensityPerArea area / r^2. At the probe
/// the limit of coefficientsAtProbe() for small texels, without its error of direction. The list of
/// emitters is the one that was drawn; their gains and colours may have changed. Pieces nearer than
/// their own size (square root of the area) to the receiver are poor: draw a cube there.
sh::RgbCoefficients coefficientsAt(const LightCube& cube, std::span<const Emitter> emitters,
                                   const dvec3& receiver, int bands);

}  // namespace soffit::light
