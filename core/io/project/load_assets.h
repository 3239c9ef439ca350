// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/io/project/assets.h"
#include "core/io/project/content.h"
#include "core/io/project/report.h"
#include "core/scene/scene.h"

#include <memory>
#include <string>
#include <vector>

/// Opens the files that a project names (internal to io_project).
namespace soffit::io {

/// The merged geometry of all entries; from the cache when they are the same as last time. Null
/// after a failure.
std::shared_ptr<const MergedGeometry> loadGeometry(const std::vector<GeometryEntry>& entries,
                                                   AssetCache& assets, const Job& job,
                                                   Report& report);

/// The scene's materials: the files' with the project's overrides and their maps.
///
/// set_names  materials that --set named and the document does not: they must be in the geometry.
std::vector<scene::Material> loadMaterials(const MergedGeometry& geometry,
                                           const std::vector<NamedMaterialEdit>& edits,
                                           const std::vector<std::string>& set_names,
                                           AssetCache& assets, Report& report);

/// Fills meshes and photometric tables of luminaires and layouts.
void loadLuminaireFiles(std::vector<light::Luminaire>& luminaires,
                        std::vector<scene::Layout>& layouts, AssetCache& assets, Report& report);

/// Fills the picture of a probe.
void loadProbe(scene::Environment& environment, AssetCache& assets, Report& report);

}  // namespace soffit::io
