// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project/project.h"
#include "core/relight/lighting.h"
#include "core/render/film.h"
#include "core/render/picture.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soffit::cli {

struct LayoutPictureOptions {
  std::string camera;  ///< a name, or "all"; empty: the first
  int width = 1280;
  int height = 800;
  int samples = 4;
  std::string exposure;             ///< EV, "auto", or empty: the project's
  std::string view;                 ///< OCIO view; empty: the project's
  std::optional<double> range_lux;  ///< of difference pictures
};

/// Pictures of layouts in a folder, all at one exposure, and of every later layout what it changes
/// in lux against the first: "LAYOUT.png", "LAYOUT minus FIRST.png"; with all cameras their names
/// are added.
class LayoutPictures {
 public:
  LayoutPictures(std::string folder, LayoutPictureOptions options);

  /// Checks the options against the scene, before anything is computed.
  /// Errors: unknown camera, exposure or view.
  Result<void> prepare(const scene::Scene& scene);

  /// Renders and writes the pictures of one layout; the first call is the one that others are
  /// compared with. Errors: the renderer's and the disk's.
  Result<void> take(const io::Project& variant, const std::string& layout,
                    const std::shared_ptr<const relight::Lighting>& lighting, const Job& job);

  /// What was written, in order.
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

 private:
  Result<void> write(const io::Project& variant, const std::string& layout, std::size_t camera,
                     const render::Film& film);

  std::filesystem::path folder_;
  LayoutPictureOptions options_;
  std::vector<scene::Camera> cameras_;
  render::PictureOptions picture_;
  bool auto_exposure_ = false;
  std::string first_layout_;
  std::vector<render::Film> first_;  ///< per camera
  std::vector<double> ranges_;       ///< of difference pictures, per camera: the same for all
  std::vector<std::string> files_;
};

}  // namespace soffit::cli
