// SPDX-License-Identifier: MIT
#pragma once

#include "core/glossy/matrix_set.h"
#include "core/prt/evaluate.h"
#include "core/prt/surfaces.h"
#include "core/sh/projection.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

/// The work of the founding papers' tables, made with this program's own methods, and its frames.
namespace soffit::design {

/// Light coefficients of the papers' tables: 5 bands.
inline constexpr int kPapersBands = 5;

/// A light that changes from frame to frame: a cube map of 6 side^2 texels in three channels
/// (Fujita & Kanai 2004), projected anew with a table of basis times solid angle.
class CubeLight {
 public:
  explicit CubeLight(int side);
  [[nodiscard]] sh::RgbCoefficients project() const;
  /// Multiply-adds of project().
  [[nodiscard]] double work() const;

 private:
  sh::ProjectionTable table_;
  std::vector<float> radiance_[3];
};

/// Where transfer is kept: a mesh's vertices or the texels of a texture, and what each sees.
struct PapersPlace {
  std::string name;           ///< "vertices", "texture 1024"
  std::size_t triangles = 0;  ///< of the mesh
  prt::Receivers receivers;
  double bake_s = 0.0;  ///< to the coefficients of visibility
  /// Coefficients of visibility, 25 rows, and 81 where matrices are made of it (else empty).
  glossy::FloatBlocks visibility, wide;
  prt::TransferVectors diffuse;  ///< cosine-weighted, shadowed; vertices alone
};

/// The room with a skylight (prt_bench_room.h) in about so many triangles, received at vertices.
PapersPlace verticesPlace(std::size_t triangles, int directions);
/// The same room received in one texture of side x side texels.
PapersPlace texturePlace(std::size_t triangles, int side, int directions);

/// A lobe of alpha 0.5 per receiver about a direction in its upper half.
std::vector<glossy::LobeView> papersLobes(const prt::Receivers& receivers, std::uint64_t seed);

/// Matrices of n^2 x n^2 visibility products at all receivers, from PapersPlace::wide.
glossy::MatrixSet papersMatrices(const PapersPlace& place, bool symmetric);

/// Coefficients of visibility as the fixed-light product takes them.
glossy::VisibilitySet halvesOf(const glossy::FloatBlocks& visibility);

/// Dhawal et al.'s triple product: light times visibility at every receiver, both free. arriving:
/// 3 n^2 rows.
void multiplyTriple(const sh::RgbCoefficients& light, const glossy::FloatBlocks& visibility,
                    glossy::FloatBlocks& arriving);
/// Multiply-adds per receiver and channel of the triple product: the ordered triples whose integral
/// is not 0.
double tripleWork(int bands);

/// Bytes of `numbers` halves at each of so many receivers in blocks of 16 (glossy) or 32 (prt).
std::size_t halvesInBlocks(std::size_t receivers, std::size_t numbers, std::size_t block);

}  // namespace soffit::design
