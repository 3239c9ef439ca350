// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The founding papers' headline figures beside those of this machine on the same kind of work:
/// Fujita & Kanai 2004, Table 2 (a mesh of 50,000 triangles, diffuse and glossy, 25 coefficients),
/// Dhawal et al. 2022, Tables 1 and 2 (vertices against transfer textures, triple product against
/// fixed light, memory).
///
/// What is timed is what follows from the light: a frame is every receiver's value. The papers'
/// frames hold drawing by a graphics card as well, and those with textures shade the pixels that
/// are seen instead of all texels. Ratios between the methods are less a matter of the machine than
/// frames per second are.
namespace soffit::design {

/// A published figure or a range of them, as it is quoted; without text it is not known here.
struct Published {
  std::string text;
  double low = 0.0, high = 0.0;  ///< in the row's unit
  std::string machine;           ///< it was measured on; empty: not known here

  [[nodiscard]] bool known() const { return !text.empty(); }
};

struct PapersRow {
  std::string table;  ///< "Fujita & Kanai 2", "Dhawal et al. 1", .. with the table's number
  std::string work;   ///< "glossy, vertices", ..
  std::string unit;   ///< of published and ours: "frames/s", "MB" (10^6 bytes), "times"
  Published published;
  double ours = 0.0;

  std::size_t triangles = 0;   ///< of the mesh
  std::size_t receivers = 0;   ///< vertices, or texels with a surface
  int coefficients = 0;        ///< of light, per channel (three channels)
  std::size_t bytes = 0;       ///< of transfer
  double multiply_adds = 0.0;  ///< per frame; 0 where nothing is timed
  double ms = 0.0;             ///< median of a frame
  double bake_s = 0.0;         ///< from triangles to coefficients

  /// Ours over the published: what a range leaves open. 0, 0 where that is not known.
  [[nodiscard]] double leastRatio() const { return published.known() ? ours / published.high : 0; }
  [[nodiscard]] double mostRatio() const { return published.known() ? ours / published.low : 0; }
};

struct PapersBenchOptions {
  std::uint64_t seed = 1;          ///< of the lobes' directions
  std::size_t triangles = 50'000;  ///< of the mesh, about
  int side = 1024;                 ///< of the largest texture, texels; a half and a quarter as well
  int directions = 128;  ///< by which visibility is found; what a frame takes does not depend on it
  int cube_side = 32;    ///< of the light's cube map
  double seconds_per_case = 0.3;  ///< spent on timing each; at least three frames
};

/// Makes the work and measures it on the threads that are allowed. Errors: cancelled.
Result<std::vector<PapersRow>> measurePapers(const PapersBenchOptions& options, const Job& job);

/// table,work,unit,published,published_low,published_high,machine,ours,ratio_low,ratio_high,
/// triangles,receivers,coefficients,bytes,multiply_adds,ms,bake_s; a header and a row per element,
/// empty fields for what is not known.
std::string formatPapersRows(const std::vector<PapersRow>& rows);

}  // namespace soffit::design
