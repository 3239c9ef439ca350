// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project/light_scenes.h"
#include "core/io/project/probes.h"
#include "core/math/vec.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The project file NAME.soffit: JSON beside the files that it names.
namespace soffit::io {

/// One file of architecture or furniture and where it stands:
/// v_world = translate + Rz Ry Rx (scale * unit * v_file), after the file's up axis became z.
struct GeometryEntry {
  std::string file;        ///< relative to the project
  double unit = 1.0;       ///< metres per unit of the file, above 0
  std::optional<char> up;  ///< 'y' or 'z'; absent: what the file or its format says
  dvec3 translate{0.0};
  dvec3 rotate_deg{0.0};
  double scale = 1.0;  ///< above 0
};

struct ProjectDocument;  // the JSON as it was read, with everything unknown
class AssetCache;        // models, photometry and images that were read already

/// A project in memory. `scene` may be edited freely before it is saved.
struct Project {
  std::filesystem::path path;  ///< the .soffit file itself
  scene::Scene scene;
  std::vector<GeometryEntry> geometry;
  /// One line each, with the path inside the project: unknown keys, what is not computed yet,
  /// materials that no file describes, what the importers dropped.
  std::vector<std::string> warnings;
  /// The materials as the geometry files have them, before the project's overrides.
  std::vector<scene::Material> file_materials;
  LightScenes light_scenes;   ///< presets of the mixer; presets of the base under the empty name
  std::vector<Probe> probes;  ///< points of surfaces whose light is watched
  /// Content by name of files that luminaires name and the folder may lack: saveProjectAs() writes
  /// them beside the project.
  std::map<std::string, std::string> pending_files;
  std::string layout;       ///< the layout that was applied; empty: the base
  bool overridden = false;  ///< a layout or --set was applied: such a project cannot be saved
  std::shared_ptr<const ProjectDocument> document;
  std::shared_ptr<AssetCache> assets;
};

struct LoadOptions {
  /// The layout that becomes scene.luminaires; scene.layouts then holds just its name. Empty: the
  /// base luminaires, and all layouts with their edits.
  std::string layout;
  /// "KEY=VALUE", applied in order after the layout. KEY is a path: "luminaires.Panel 1.position",
  /// "materials.wall.diffuse", "environment.ground_reflectance", "quality", "view.exposure";
  /// names that contain dots are matched longest first. VALUE: a number, numbers with commas,
  /// true or false, JSON, or else text.
  std::vector<std::string> sets;
  Job job;
  /// The content to load in place of the file's, which need not exist: a version that was kept
  /// elsewhere, of the project at that path.
  std::optional<std::string> text;
};

/// Loads a project with everything it names. `path` may be a folder that holds one .soffit file.
///
/// Nothing is half loaded: every error names the file, the path inside it ("luminaires.Panel
/// 1.flux") and the remedy. Files may not lie outside the project's folder, not by links either.
Result<Project> loadProject(const std::filesystem::path& path, const LoadOptions& options = {});

/// The same project under another layout or other settings. Models, photometry and images are
/// those in memory; when the geometry is the same, scene.mesh is the same pointer.
Result<Project> variantOf(const Project& project, const LoadOptions& options);

/// Writes the project to `path`: atomically, the previous version kept as NAME.soffit~.
///
/// Only what differs from the document is changed; unknown keys, their order and the spelling of
/// numbers stay (comments do not: JSON has none). Doubles are written so that they read back bit
/// for bit. Errors: `overridden` projects, faults of the scene (scene::findFaults), the disk.
Result<void> saveProject(const Project& project, const std::filesystem::path& path);

/// The text that saveProject() would write.
Result<std::string> formatProject(const Project& project);

/// The .soffit file that `path` means: itself, or the only one in a folder.
/// Errors: nothing there, no or several projects in the folder.
Result<std::filesystem::path> findProjectFile(const std::filesystem::path& path);

}  // namespace soffit::io
