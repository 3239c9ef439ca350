// SPDX-License-Identifier: MIT
#include "core/io/project/importers.h"

#include "core/io/image/read_image.h"
#include "core/io/photometry/photometric_file.h"

#include <utility>

namespace soffit::io {

Result<LoadedModel> loadModel(const std::filesystem::path& path, double /*unit*/, char /*up*/) {
  return Error{path.filename().string(), "this build reads no models", ""};
}

Result<LoadedPhotometry> loadPhotometry(const std::filesystem::path& path) {
  auto file = readPhotometry(path);
  if (!file) return file.error();
  return LoadedPhotometry{
      std::make_shared<const photometry::IntensityDistribution>(std::move(file->distribution)),
      std::move(file->warnings)};
}

Result<std::shared_ptr<const scene::Image>> loadImage(const std::filesystem::path& path,
                                                      ImageUse use) {
  ReadOptions options;
  options.decode_srgb = use == ImageUse::color;
  auto image = readImage(path, options);
  if (!image) return image.error();
  return std::shared_ptr<const scene::Image>(
      std::make_shared<const scene::Image>(std::move(*image)));
}

}  // namespace soffit::io
