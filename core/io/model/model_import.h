// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/cleaning.h"
#include "core/geometry/mesh.h"
#include "core/scene/material.h"

/// Architectural models and furniture from files: OBJ, glTF/GLB, PLY, STL, 3DS, FBX, Collada, IFC.
namespace soffit::io {

/// How a file's coordinates become the world's: p_world = translate + R (scale * unit * p), where
/// p has been turned so that the file's up axis is z, and R = Rz Ry Rx.
struct ImportOptions {
  /// Metres per unit of the file, positive. Formats that state their unit themselves (IFC,
  /// Collada, FBX; glTF is in metres) are in metres before this is applied: leave it at 1.
  double unit = 1.0;
  /// The file's own up axis, 'y' or 'z'. Absent: what the file or its format says (glTF y; Collada
  /// and FBX as stated; IFC, 3DS, OBJ, PLY, STL z).
  std::optional<char> up;
  dvec3 translate{0.0};   ///< metres
  dvec3 rotate_deg{0.0};  ///< about the fixed x, y, z axes in that order
  double scale = 1.0;     ///< not zero
  /// The folder that side files and textures may not lie outside of, e.g. the project's. Empty: the
  /// model's own folder.
  std::filesystem::path folder;
};

/// A texture stored inside the model file. A material names it in diffuse_map or normal_map as if
/// it lay beside the model; it is on whoever wants to keep it to write it there.
struct EmbeddedTexture {
  std::string path;                 ///< relative to the model's folder, e.g. "duck_texture0.png"
  std::vector<std::uint8_t> bytes;  ///< the image file, e.g. PNG or JPEG
};

struct ImportedModel {
  geometry::Mesh mesh;  ///< never without triangles; world frame
  /// Index = Mesh::material_of. Maps are paths relative to the model's folder; images not loaded.
  std::vector<scene::Material> materials;
  /// Per material whether the file states its color; where not, diffuse is 0.5 and it is on the
  /// caller to warn, unless the project describes the material.
  std::vector<bool> described;
  geometry::CleaningReport cleaning;
  std::vector<EmbeddedTexture> embedded_textures;
  std::vector<std::filesystem::path> side_files;  ///< opened besides the model: MTL, BIN
  std::size_t points = 0;                         ///< left out
  std::size_t lines = 0;                          ///< left out
  std::size_t lights = 0;                         ///< ignored
  std::size_t cameras = 0;                        ///< ignored
  std::vector<std::string> warnings;              ///< one line each, for the user
};

/// Reads a model file with all nodes, materials and names, cleans it (geometry/cleaning.h) and
/// places it in the world.
///
/// Materials: names as in the file, unique; a name that the file gives twice gets " (2)". Only
/// materials in use. What becomes of colors and gloss is in core/io/model/README.md.
/// Texture coordinates: v runs up, (0,0) is the lower left corner of the image.
///
/// Errors name the file and a remedy: missing or unreadable file, unknown format, broken content,
/// no triangles, a side file outside the folder, bad options, cancelled. The job's stop token is
/// looked at between stages and while the file is read.
Result<ImportedModel> importModel(const std::filesystem::path& file, const ImportOptions& options,
                                  const Job& job = {});

}  // namespace soffit::io
