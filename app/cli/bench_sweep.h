// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/common_options.h"
#include "app/cli/session.h"
#include "core/base/progress.h"
#include "core/design/bench.h"
#include "core/io/project/project.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soffit::cli {

struct BenchSweepOptions {
  std::filesystem::path folder;
  double budget_s = 600.0;
  std::size_t receivers = 300;
  design::ReferenceEffort effort;
  std::string version;
};

/// A sweep over projects that writes what it finds as it goes, and goes on where an earlier one
/// with the same program, project and references stopped.
class BenchSweep {
 public:
  BenchSweep(BenchSweepOptions options, Job job);

  /// Reads what is in the folder already. Errors: a bench.csv that is none.
  Result<void> resume();

  /// Adds a project under a name that no other one has.
  void add(std::string name, io::Project project);

  /// Measures until nothing is left or the budget is used up. Errors: the first that any point
  /// meets; what was found before is in the folder.
  Result<void> run();

  /// Rows of the projects that were added, of this program and these references.
  [[nodiscard]] std::vector<design::BenchRow> rows() const;
  /// Points without a row, "project method settings".
  [[nodiscard]] std::vector<std::string> leftOut() const;
  [[nodiscard]] std::filesystem::path tableFile() const { return options_.folder / "bench.csv"; }

 private:
  struct Entry {
    std::string name;
    io::Project project;
    std::string key;
    std::optional<design::BenchCase> bench;
    double unit_seconds = 0.0;  ///< what the interactive preset took; 0: not known
  };
  [[nodiscard]] std::vector<design::BenchPoint> pending(const Entry& entry,
                                                        const design::BenchStep& step) const;
  [[nodiscard]] double secondsSoFar() const;
  [[nodiscard]] double expectedSeconds(const Entry& entry, const design::BenchStep& step) const;
  Result<void> runStep(Entry& entry, const design::BenchStep& step,
                       const std::vector<design::BenchPoint>& points);
  Result<void> provideReference(Entry& entry, const design::BenchEngine& engine);
  [[nodiscard]] bool isCurrent(const design::BenchRow& row) const;

  BenchSweepOptions options_;
  Job job_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<Entry> entries_;
  std::vector<design::BenchRow> rows_;  ///< of the file, others' too
};

}  // namespace soffit::cli
