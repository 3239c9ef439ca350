// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace soffit::ui {

/// Input power of luminaires as their photometric files declare it. Files are read once, so this
/// belongs to a thread that may wait.
class PowerTable {
 public:
  /// Watts at full output; nothing where the file cannot be read or declares none.
  std::optional<double> watts(const std::filesystem::path& file);

 private:
  std::map<std::string, std::optional<double>> known_;
};

}  // namespace soffit::ui
