// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/model/model_format.h"

struct aiScene;

namespace soffit::io {

/// A model file as Assimp reads it, with checked references; faces may have any number of corners
/// (Assimp's own triangulation aborts on faces without any). Alive as long as this object.
class AssimpFile {
 public:
  /// keep_axes  do not turn a Collada file to its stated up axis.
  /// folder     side files (MTL, BIN) are opened in and below this folder only.
  static Result<AssimpFile> read(const std::filesystem::path& file, ModelFormat format,
                                 bool keep_axes, const std::filesystem::path& folder,
                                 const Job& job);
  ~AssimpFile();
  AssimpFile(AssimpFile&&) noexcept;
  AssimpFile& operator=(AssimpFile&&) noexcept;

  [[nodiscard]] const aiScene& scene() const;
  /// Files that were opened besides the model, in order.
  [[nodiscard]] std::vector<std::filesystem::path> sideFiles() const;

 private:
  struct Impl;
  explicit AssimpFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace soffit::io
