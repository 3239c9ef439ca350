// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/project/importers.h"
#include "core/io/project/project.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soffit::io {

/// All geometry entries of a project as one mesh with its materials (internal to io_project).
struct MergedGeometry {
  std::shared_ptr<const geometry::Mesh> mesh;
  std::vector<scene::Material> materials;  ///< as the files have them; index = Mesh::materials
  std::vector<bool> described;
  std::vector<std::string> warnings;
};

/// What a project's files hold, each read once: layouts and variants of a project share it.
/// Every place in an error is left to the caller but for faults inside a file. Not thread-safe.
class AssetCache {
 public:
  explicit AssetCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  Result<std::shared_ptr<const LoadedModel>> model(const std::string& file, double unit,
                                                   std::optional<char> up, const Job& job = {});
  Result<std::shared_ptr<const LoadedPhotometry>> photometry(const std::string& file);
  Result<std::shared_ptr<const scene::Image>> image(const std::string& file, ImageUse use);

  /// The last merged geometry, kept as long as the entries stay the same.
  std::shared_ptr<const MergedGeometry> merged;
  std::vector<GeometryEntry> merged_entries;

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::shared_ptr<const LoadedModel>> models_;
  std::map<std::string, std::shared_ptr<const LoadedPhotometry>> photometry_;
  std::map<std::string, std::shared_ptr<const scene::Image>> images_;
};

}  // namespace soffit::io
