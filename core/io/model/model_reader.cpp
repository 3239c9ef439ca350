// SPDX-License-Identifier: MIT
#include "core/io/model/model_reader.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/io/model/assimp_file.h"
#include "core/io/model/material_conversion.h"
#include "core/io/model/mtl_colors.h"
#include "core/io/model/scene_conversion.h"

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

// Turns the y axis up to z; (x, y, z) becomes (x, -z, y).
const dmat3 kZFromY(dvec3(1, 0, 0), dvec3(0, 0, 1), dvec3(0, -1, 0));
const dmat3 kZFromX(dvec3(0, 0, 1), dvec3(0, 1, 0), dvec3(-1, 0, 0));

// From the coordinates that Assimp delivers to z up.
dmat3 zUpFromDelivered(ModelFormat format, std::optional<char> up, const aiScene& scene) {
  // Assimp turns these from their own z up to y up.
  const bool turned = format == ModelFormat::kIfc || format == ModelFormat::k3ds;
  if (up) {
    const dmat3 raw = turned ? kZFromY : dmat3(1.0);
    return *up == 'y' ? kZFromY * raw : raw;
  }
  // Collada comes turned from its stated axis to y up.
  if (turned || format == ModelFormat::kGltf || format == ModelFormat::kCollada) return kZFromY;
  int axis = 2;
  if (format == ModelFormat::kFbx) {
    axis = 1;
    if (scene.mMetaData != nullptr) scene.mMetaData->Get("UpAxis", axis);
  }
  return axis == 0 ? kZFromX : axis == 1 ? kZFromY : dmat3(1.0);
}

// Metres per delivered unit. FBX states centimetres per unit; IFC and Collada come in metres.
double statedUnit(ModelFormat format, const aiScene& scene) {
  if (format != ModelFormat::kFbx) return 1.0;
  double centimetres = 1.0;
  if (scene.mMetaData != nullptr) {
    float single = 1.0F;
    if (!scene.mMetaData->Get("UnitScaleFactor", centimetres) &&
        scene.mMetaData->Get("UnitScaleFactor", single)) {
      centimetres = single;
    }
  }
  return std::isfinite(centimetres) && centimetres > 0.0 ? 0.01 * centimetres : 0.01;
}

glm::dmat4 worldFromRoot(ModelFormat format, const ImportOptions& options, const aiScene& scene) {
  const double size = options.scale * options.unit * statedUnit(format, scene);
  const dmat3 linear =
      rotationXyz(options.rotate_deg) * (size * zUpFromDelivered(format, options.up, scene));
  glm::dmat4 out(linear);
  out[3] = glm::dvec4(options.translate, 1.0);
  return out;
}

std::set<std::string> mtlColors(const std::vector<fs::path>& side_files) {
  std::set<std::string> out;
  for (const fs::path& path : side_files) {
    if (path.extension() != ".mtl" && path.extension() != ".MTL") continue;
    std::ifstream stream(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    out.merge(materialsWithColor(text));
  }
  return out;
}

// The name itself, or with the first free " (n)", n >= 2.
std::string uniqueName(const std::string& name, std::set<std::string>& taken) {
  std::string out = name;
  for (int n = 2; !taken.insert(out).second; ++n) out = fmt::format("{} ({})", name, n);
  return out;
}

// Reads the materials that triangles use and renumbers material_of accordingly.
void takeMaterials(const MaterialContext& context, geometry::RawMesh& raw, ImportedModel& out) {
  constexpr std::uint32_t kUnused = 0xffffffffU;
  std::vector<std::uint32_t> index(context.scene.mNumMaterials, kUnused);
  std::set<std::string> taken;
  for (std::uint32_t& material : raw.material_of) {
    std::uint32_t& target = index[material];
    if (target == kUnused) {
      target = static_cast<std::uint32_t>(out.materials.size());
      ConvertedMaterial made =
          convertMaterial(*context.scene.mMaterials[material], context, out.embedded_textures);
      made.material.name = uniqueName(made.material.name, taken);
      for (const std::string& warning : made.warnings) {
        out.warnings.push_back(fmt::format("material '{}': {}", made.material.name, warning));
      }
      if (made.material.glass) {
        out.warnings.push_back(
            fmt::format("material '{}' is more than half transparent and becomes clear glass",
                        made.material.name));
      }
      raw.materials.push_back(made.material.name);
      out.described.push_back(made.described);
      out.materials.push_back(std::move(made.material));
    }
    material = target;
  }
}

}  // namespace

Result<ModelPayload> readModel(const fs::path& file, ModelFormat format,
                               const ImportOptions& options, const Job& job) {
  const fs::path& folder = options.folder;
  Result<AssimpFile> read = AssimpFile::read(file, format, options.up.has_value(), folder, job);
  if (!read) return read.error();
  const aiScene& scene = read->scene();
  const bool skip_root = format == ModelFormat::kFbx;  // newer importers put their turn there
  Result<ConvertedScene> converted =
      convertScene(scene, worldFromRoot(format, options, scene), skip_root, file.stem().string());
  if (!converted) {
    return Error{file.string(), converted.error().what, converted.error().hint};
  }
  ModelPayload out{.raw = std::move(converted->raw)};
  out.model.points = converted->points;
  out.model.lines = converted->lines;
  out.model.lights = scene.mNumLights;
  out.model.cameras = scene.mNumCameras;
  out.model.side_files = read->sideFiles();
  takeMaterials({scene, format, file, folder, mtlColors(read->sideFiles())}, out.raw, out.model);
  return out;
}

}  // namespace soffit::io
