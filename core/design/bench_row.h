// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/design/error_figures.h"
#include "core/relight/solver.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soffit::design {

/// What the bench found at one point of the sweep.
struct BenchRow {
  std::string project;  ///< its file's stem
  std::string scene;    ///< content key: rows of other scenes, receivers or references do not count
  std::string version;  ///< of the program
  std::string method;   ///< BenchPoint::methodName()
  std::string settings;       ///< BenchPoint::settingsName()
  std::string light;          ///< the luminaire that moves
  std::size_t receivers = 0;  ///< display points that a move updates

  ErrorFigures total;  ///< all luminaires on
  ErrorFigures alone;  ///< the moved one, relative to its own mean

  double update_ms = 0.0;  ///< median of a move
  double update_p99_ms = 0.0;
  relight::StageTimes stages;  ///< medians, ms
  double mix_ms = 0.0;    ///< median: every luminaire dimmed by another factor, until the total
  double paint_ms = 0.0;  ///< median: every reflectance changed, until the total

  std::uint64_t rays = 0;          ///< traced in one move
  std::uint64_t rays_avoided = 0;  ///< that 64 shadow rays a point would have taken

  double bake_s = 0.0;
  double first_result_s = 0.0;
  std::uint64_t bake_rays = 0;
  std::size_t operator_bytes = 0;
  std::size_t peak_bytes = 0;  ///< of the process while it did this; 0: not known

  /// Whether both describe the same point of the same sweep.
  [[nodiscard]] bool sameKey(const BenchRow& o) const {
    return project == o.project && scene == o.scene && version == o.version && method == o.method &&
           settings == o.settings;
  }
};

/// Comma-separated, with a header; a row per element. Errors are fractions.
std::string formatBenchRows(const std::vector<BenchRow>& rows);

/// Reads them back; columns are found by name, unknown ones skipped, missing ones left at 0.
/// Errors: no header, a row with another number of fields, what is no number; `name` stands for
/// the file in messages.
Result<std::vector<BenchRow>> parseBenchRows(std::string_view text, const std::string& name);

}  // namespace soffit::design
