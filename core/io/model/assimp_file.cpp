// SPDX-License-Identifier: MIT
#include "core/io/model/assimp_file.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <assimp/ProgressHandler.hpp>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <exception>
#include <string>
#include <system_error>

#include "core/io/model/model_path.h"

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

// What the file system guard saw; shared because Assimp owns the guard.
struct Opened {
  std::vector<fs::path> files;
  fs::path refused;
};

// Lets Assimp open regular files in and below one folder only, so that a model from elsewhere
// cannot read what it should not.
class GuardedFiles : public Assimp::DefaultIOSystem {
 public:
  GuardedFiles(fs::path folder, std::shared_ptr<Opened> opened)
      : folder_(std::move(folder)), opened_(std::move(opened)) {}

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    if (!allowed(name)) return nullptr;
    Assimp::IOStream* stream = DefaultIOSystem::Open(name, mode);
    if (stream != nullptr) opened_->files.emplace_back(name);
    return stream;
  }
  bool Exists(const char* name) const override {
    return allowed(name) && DefaultIOSystem::Exists(name);
  }

 private:
  [[nodiscard]] bool allowed(const fs::path& path) const {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return false;
    if (liesInFolder(path, folder_)) return true;
    opened_->refused = path;
    return false;
  }

  fs::path folder_;
  std::shared_ptr<Opened> opened_;
};

class Reporter : public Assimp::ProgressHandler {
 public:
  explicit Reporter(Job job) : job_(std::move(job)) {}
  bool Update(float share) override {
    if (share >= 0.0F) job_.report("reading the model", std::min(share, 1.0F));
    return !job_.cancelled();
  }

 private:
  Job job_;
};

std::string oneLine(std::string text) {
  constexpr std::size_t kLongest = 200;
  text.resize(std::min(text.size(), kLongest));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return text;
}

const char* remedy(ModelFormat format) {
  if (format == ModelFormat::kIfc) return "Export it again as IFC 2x3 or glTF";
  return "Export the model again, or to another format such as glTF or OBJ";
}

// What the conversion trusts; files may lie.
bool referencesHold(const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    if (mesh.mMaterialIndex >= scene.mNumMaterials) return false;
    if (mesh.mVertices == nullptr && mesh.mNumVertices > 0) return false;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        if (face.mIndices[k] >= mesh.mNumVertices) return false;
      }
    }
  }
  std::vector<const aiNode*> open{scene.mRootNode};
  while (!open.empty()) {
    const aiNode& node = *open.back();
    open.pop_back();
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene.mNumMeshes) return false;
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) open.push_back(node.mChildren[i]);
  }
  return true;
}

}  // namespace

struct AssimpFile::Impl {
  Assimp::Importer importer;
  std::shared_ptr<Opened> opened = std::make_shared<Opened>();
  fs::path file;

  void configure(bool keep_axes, const fs::path& folder, const Job& job) {
    importer.SetIOHandler(new GuardedFiles(folder, opened));
    importer.SetProgressHandler(new Reporter(job));
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, keep_axes);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  }

  Result<void> load(ModelFormat format, const Job& job) {
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (job.cancelled()) return Error{file.string(), "the import was cancelled", {}};
    if (!opened->refused.empty()) {
      return Error{file.string(),
                   fmt::format("it wants to read '{}', which lies outside of the project's folder",
                               opened->refused.string()),
                   "Copy that file beside the model and mend the reference"};
    }
    if (scene == nullptr || scene->mRootNode == nullptr) {
      return Error{file.string(),
                   fmt::format("cannot be read: {}", oneLine(importer.GetErrorString())),
                   remedy(format)};
    }
    if (!referencesHold(*scene)) {
      return Error{file.string(),
                   "is damaged: it refers to vertices, materials or meshes that it "
                   "does not contain",
                   remedy(format)};
    }
    return {};
  }
};

AssimpFile::AssimpFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
AssimpFile::~AssimpFile() = default;
AssimpFile::AssimpFile(AssimpFile&&) noexcept = default;
AssimpFile& AssimpFile::operator=(AssimpFile&&) noexcept = default;

Result<AssimpFile> AssimpFile::read(const fs::path& file, ModelFormat format, bool keep_axes,
                                    const fs::path& folder, const Job& job) {
  try {
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    impl->configure(keep_axes, folder, job);
    if (Result<void> loaded = impl->load(format, job); !loaded) return loaded.error();
    return AssimpFile(std::move(impl));
  } catch (const std::bad_alloc&) {
    return Error{file.string(), "needs more memory than there is",
                 "Split the model, or simplify it"};
  } catch (const std::exception& e) {
    return Error{file.string(), fmt::format("cannot be read: {}", oneLine(e.what())),
                 remedy(format)};
  }
}

const aiScene& AssimpFile::scene() const {
  return *impl_->importer.GetScene();
}

std::vector<fs::path> AssimpFile::sideFiles() const {
  std::vector<fs::path> out;
  for (const fs::path& path : impl_->opened->files) {
    if (path != impl_->file && std::find(out.begin(), out.end(), path) == out.end()) {
      out.push_back(path);
    }
  }
  return out;
}

}  // namespace soffit::io
