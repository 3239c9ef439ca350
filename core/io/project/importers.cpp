// SPDX-License-Identifier: MIT
#include "core/io/project/importers.h"

#include "core/io/image/read_image.h"
#include "core/io/model/model_import.h"
#include "core/io/photometry/photometric_file.h"
#include "core/io/project/utf8.h"

#include <utility>

namespace soffit::io {

Result<LoadedModel> loadModel(const std::filesystem::path& path,
                              const std::filesystem::path& folder, double unit,
                              std::optional<char> up, const Job& job) {
  ImportOptions options;
  options.unit = unit;
  options.up = up;
  options.folder = folder;
  auto imported = importModel(path, options, job);
  if (!imported) return imported.error();
  LoadedModel model;
  for (std::string& name : imported->mesh.materials) name = utf8FromUnknown(name);
  for (std::string& name : imported->mesh.objects) name = utf8FromUnknown(name);
  model.mesh = std::make_shared<const geometry::Mesh>(std::move(imported->mesh));
  model.materials = std::move(imported->materials);
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    model.materials[i].name = model.mesh->materials[i];
  }
  model.described = std::move(imported->described);
  model.warnings = std::move(imported->warnings);
  model.side_files = std::move(imported->side_files);
  for (const EmbeddedTexture& texture : imported->embedded_textures) {
    model.embedded.emplace_back(texture.path,
                                std::string(texture.bytes.begin(), texture.bytes.end()));
  }
  return model;
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
