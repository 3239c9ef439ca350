// SPDX-License-Identifier: MIT
#include "core/io/model/model_import.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

#include "core/io/model/assimp_file.h"
#include "core/io/model/material_conversion.h"
#include "core/io/model/model_format.h"
#include "core/io/model/mtl_colors.h"
#include "core/io/model/ply_header.h"
#include "core/io/model/scene_conversion.h"

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

// Turns the y axis up to z; (x, y, z) becomes (x, -z, y).
const dmat3 kZFromY(dvec3(1, 0, 0), dvec3(0, 0, 1), dvec3(0, -1, 0));
const dmat3 kZFromX(dvec3(0, 0, 1), dvec3(0, 1, 0), dvec3(-1, 0, 0));

Result<ModelFormat> check(const fs::path& file, const ImportOptions& options) {
  const auto wrong = [&](const char* what, const char* hint) {
    return Error{file.string(), what, hint};
  };
  if (!(options.unit > 0.0) || !std::isfinite(options.unit)) {
    return wrong("the unit must be a positive number of metres", "Use 0.001 for millimetres");
  }
  if (options.scale == 0.0 || !std::isfinite(options.scale)) {
    return wrong("the scale must be a number other than 0", "Use 1 for the model's own size");
  }
  if (!isFinite(options.translate) || !isFinite(options.rotate_deg)) {
    return wrong("translation and rotation must be finite numbers", "Use 0 for none");
  }
  if (options.up && *options.up != 'y' && *options.up != 'z') {
    return wrong("the up axis must be y or z", "Look at the model in a viewer to see which it is");
  }
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return wrong("the file does not exist", "Check the name");
  if (!fs::is_regular_file(file, ignored)) return wrong("is not a file", "Name the model file");
  const auto format = modelFormat(file);
  if (!format) {
    return wrong("is no model format that can be read",
                 "Readable are OBJ, glTF, GLB, PLY, STL, 3DS, FBX, DAE and IFC");
  }
  if (!std::ifstream(file)) return wrong("cannot be opened", "Check the access rights");
  if (*format == ModelFormat::kPly) {
    const std::string problem = plyHeaderProblem(file);
    if (!problem.empty()) return wrong(problem.c_str(), "Export the model again");
  }
  return *format;
}

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

void warnOfLosses(ImportedModel& out) {
  const auto say = [&](std::size_t count, const char* what) {
    if (count > 0) out.warnings.push_back(fmt::format("{} {}", count, what));
  };
  say(out.cleaning.non_finite, "triangles dropped: corners that are not finite numbers");
  say(out.cleaning.degenerate, "triangles dropped: no area");
  say(out.cleaning.duplicate, "triangles dropped: duplicates of others");
  say(out.points, "points left out");
  say(out.lines, "lines left out");
  say(out.lights, "lights of the file ignored: place luminaires in the project");
  say(out.cameras, "cameras of the file ignored");
}

Error noTriangles(const fs::path& file, const ImportedModel& model) {
  if (model.cleaning.triangles_in > 0) {
    return {file.string(),
            fmt::format("all of its {} triangles are degenerate or not finite",
                        model.cleaning.triangles_in),
            "Check the unit and the export settings"};
  }
  return {file.string(), "holds no triangles",
          "Export the model with its meshes; curves and bodies must be tessellated"};
}

}  // namespace

Result<ImportedModel> importModel(const fs::path& file, const ImportOptions& options,
                                  const Job& job) {
  const Result<ModelFormat> format = check(file, options);
  if (!format) return format.error();
  fs::path folder = options.folder.empty() ? file.parent_path() : options.folder;
  if (folder.empty()) folder = ".";
  Result<AssimpFile> read = AssimpFile::read(file, *format, options.up.has_value(), folder, job);
  if (!read) return read.error();
  const aiScene& scene = read->scene();
  job.report("placing the model", 0.0);
  Result<ConvertedScene> converted =
      convertScene(scene, worldFromRoot(*format, options, scene), *format == ModelFormat::kFbx,
                   file.stem().string());
  if (!converted) {
    return Error{file.string(), converted.error().what, converted.error().hint};
  }
  ImportedModel out;
  out.points = converted->points;
  out.lines = converted->lines;
  out.lights = scene.mNumLights;
  out.cameras = scene.mNumCameras;
  out.side_files = read->sideFiles();
  takeMaterials({scene, *format, file, folder, mtlColors(read->sideFiles())}, converted->raw, out);
  if (job.cancelled()) return Error{file.string(), "the import was cancelled", {}};
  job.report("cleaning the model", 0.0);
  geometry::CleanedMesh cleaned = geometry::cleanMesh(converted->raw);
  if (job.cancelled()) return Error{file.string(), "the import was cancelled", {}};
  out.mesh = std::move(cleaned.mesh);
  out.cleaning = cleaned.report;
  if (out.mesh.triangles.empty()) return noTriangles(file, out);
  warnOfLosses(out);
  job.report("cleaning the model", 1.0);
  return out;
}

}  // namespace soffit::io
