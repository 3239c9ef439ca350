// SPDX-License-Identifier: MIT
#include "core/io/project/companion_files.h"

#include "core/io/project/atomic_file.h"
#include "core/io/project/project_folder.h"

#include <cstddef>
#include <set>
#include <system_error>
#include <utility>

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostBytes = std::size_t{4} << 30U;

/// The textures that are files: those that exist beside the model.
std::set<std::string> textureFiles(const LoadedModel& model, const fs::path& folder) {
  std::set<std::string> names;
  for (const scene::Material& material : model.materials) {
    for (const std::string& map :
         {material.diffuse_map, material.normal_map, material.roughness_map}) {
      std::error_code ignored;
      if (!map.empty() && fs::is_regular_file(folder / map, ignored)) names.insert(map);
    }
  }
  return names;
}

}  // namespace

Result<void> takeFile(const fs::path& file, const fs::path& from_folder, CompanionFiles& files) {
  std::error_code code;
  const fs::path relative = fs::relative(file, from_folder, code);
  if (code || relative.empty() || *relative.begin() == "..") return {};
  if (files.contains(relative.generic_string())) return {};
  auto content = readFile(file, kMostBytes);
  if (!content) return content.error();
  files.emplace(relative.generic_string(), std::move(*content));
  return {};
}

Result<void> takeFileIfThere(const fs::path& file, const fs::path& from_folder,
                             CompanionFiles& files) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return {};
  return takeFile(file, from_folder, files);
}

Result<void> takeModel(const fs::path& model_file, const LoadedModel& model,
                       const fs::path& from_folder, CompanionFiles& files) {
  if (auto taken = takeFile(model_file, from_folder, files); !taken) return taken;
  for (const fs::path& side : model.side_files) {
    if (auto taken = takeFile(side, from_folder, files); !taken) return taken;
  }
  const fs::path folder = folderOf(model_file);
  for (const std::string& texture : textureFiles(model, folder)) {
    if (auto taken = takeFile(folder / texture, from_folder, files); !taken) return taken;
  }
  for (const auto& [name, bytes] : model.embedded) {
    std::error_code code;
    const fs::path relative = fs::relative(folder / name, from_folder, code);
    if (!code) files.emplace(relative.generic_string(), bytes);
  }
  return {};
}

Result<void> dropPresent(const fs::path& folder, CompanionFiles& files) {
  for (auto entry = files.begin(); entry != files.end();) {
    const fs::path target = folder / entry->first;
    std::error_code ignored;
    if (!fs::exists(target, ignored)) {
      ++entry;
      continue;
    }
    const auto present = readFile(target, kMostBytes);
    if (!present) return present.error();
    if (*present != entry->second) {
      return Error{target.string(), "another file of this name is there already",
                   "Choose another folder for the project, or remove that file."};
    }
    entry = files.erase(entry);
  }
  return {};
}

Result<void> writeFiles(const fs::path& folder, const CompanionFiles& files) {
  for (const auto& [name, content] : files) {
    const fs::path target = folder / name;
    std::error_code code;
    fs::create_directories(target.parent_path(), code);
    if (code) {
      return Error{target.parent_path().string(), "the folder cannot be made: " + code.message(),
                   "Choose another place."};
    }
    if (auto written = writeFileAtomically(target, content); !written) return written;
  }
  return {};
}

}  // namespace soffit::io
