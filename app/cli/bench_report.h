// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/chart.h"
#include "core/design/bench_row.h"
#include "core/io/project/json.h"

#include <string>
#include <vector>

/// What a sweep found, to read.
namespace soffit::cli {

/// Two panels per project: run time of a move against the RMS error of the moved light alone, and
/// of all luminaires; the Pareto front marked and named.
std::vector<ChartPanel> benchPanels(const std::vector<design::BenchRow>& rows);

/// A table per project; what lies on the front of either panel is starred.
std::string benchText(const std::vector<design::BenchRow>& rows,
                      const std::vector<std::string>& left_out,
                      const std::vector<std::string>& files, double seconds);

/// seconds, rows (the columns of bench.csv that matter, with `pareto`), left_out, files.
io::Json benchJson(const std::vector<design::BenchRow>& rows,
                   const std::vector<std::string>& left_out, const std::vector<std::string>& files,
                   double seconds);

}  // namespace soffit::cli
