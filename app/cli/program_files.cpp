// SPDX-License-Identifier: MIT
#include "app/cli/program_files.h"

#include "core/math/rng.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace soffit::cli {
namespace fs = std::filesystem;
namespace {

fs::path ownFile() {
  std::error_code trouble;
  const fs::path file = fs::read_symlink("/proc/self/exe", trouble);
  return trouble ? fs::path() : file;
}

std::vector<std::string> projectsIn(const fs::path& folder) {
  std::vector<std::string> out;
  std::error_code trouble;
  for (const auto& entry : fs::directory_iterator(folder, trouble)) {
    const fs::path file = entry.path() / (entry.path().filename().string() + ".soffit");
    if (fs::is_regular_file(file, trouble)) out.push_back(file.string());
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

std::vector<std::string> sampleProjects() {
  fs::path folder = ownFile().parent_path();
  std::vector<fs::path> places{folder / ".." / "share" / "soffit" / "projects"};
  // build/release/bin lies three levels below the source tree.
  for (int level = 0; level < 4 && folder.has_relative_path(); ++level) {
    places.push_back(folder / "projects");
    folder = folder.parent_path();
  }
  places.emplace_back("projects");
  for (const fs::path& place : places) {
    auto found = projectsIn(place);
    if (!found.empty()) return found;
  }
  return {};
}

std::string programVersion() {
  std::uint64_t key = 0;
  std::ifstream file(ownFile(), std::ios::binary);
  std::vector<char> block(1U << 16U);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    for (std::streamsize i = 0; i < file.gcount(); ++i) {
      key = (key ^ static_cast<unsigned char>(block[static_cast<std::size_t>(i)])) *
            0x100000001b3ULL;  // FNV-1a
    }
  }
  return fmt::format("{}-{:08x}", SOFFIT_VERSION, mixBits(key) >> 32U);
}

}  // namespace soffit::cli
