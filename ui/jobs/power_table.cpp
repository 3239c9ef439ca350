// SPDX-License-Identifier: MIT
#include "ui/jobs/power_table.h"

#include "core/io/photometry/photometric_file.h"

namespace soffit::ui {

std::optional<double> PowerTable::watts(const std::filesystem::path& file) {
  const auto found = known_.find(file.string());
  if (found != known_.end()) return found->second;
  std::optional<double> watts;
  if (const auto read = io::readPhotometry(file); read && read->watts > 0.0) watts = read->watts;
  known_.emplace(file.string(), watts);
  return watts;
}

}  // namespace soffit::ui
