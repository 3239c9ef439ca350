// SPDX-License-Identifier: MIT
#include "core/io/project/assets.h"

#include "core/io/project/project_folder.h"

#include <fmt/format.h>

#include <utility>

namespace soffit::io {
namespace {

/// The cached value of `key`, else what `load(path)` gives for the file.
template <class T, class Load>
Result<std::shared_ptr<const T>> cached(std::map<std::string, std::shared_ptr<const T>>& cache,
                                        const std::string& key, const std::string& file,
                                        const std::filesystem::path& folder, const Load& load) {
  if (const auto found = cache.find(key); found != cache.end()) return found->second;
  const auto path = fileInFolder(folder, file);
  if (!path) return path.error();
  auto loaded = load(*path);
  if (!loaded) return loaded.error();
  return cache.emplace(key, std::move(*loaded)).first->second;
}

/// Result<T> as a Result of a shared constant.
template <class T>
Result<std::shared_ptr<const T>> shared(Result<T> result) {
  if (!result) return result.error();
  return std::shared_ptr<const T>(std::make_shared<const T>(std::move(*result)));
}

}  // namespace

Result<std::shared_ptr<const LoadedModel>> AssetCache::model(const std::string& file, double unit,
                                                             std::optional<char> up,
                                                             const Job& job) {
  const std::string key = fmt::format("{}|{}|{}", up.value_or('-'), unit, file);
  return cached(models_, key, file, folder_,
                [&](const auto& path) { return shared(loadModel(path, folder_, unit, up, job)); });
}

Result<std::shared_ptr<const LoadedPhotometry>> AssetCache::photometry(const std::string& file) {
  return cached(photometry_, file, file, folder_,
                [&](const auto& path) { return shared(loadPhotometry(path)); });
}

Result<std::shared_ptr<const scene::Image>> AssetCache::image(const std::string& file,
                                                              ImageUse use) {
  const char* kind = use == ImageUse::color ? "color" : "normal";
  return cached(images_, fmt::format("{}|{}", kind, file), file, folder_,
                [&](const auto& path) { return loadImage(path, use); });
}

}  // namespace soffit::io
