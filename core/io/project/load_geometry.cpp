// SPDX-License-Identifier: MIT
#include "core/geometry/cleaning.h"
#include "core/io/project/load_assets.h"
#include "core/io/project/place_mesh.h"
#include "core/scene/equality.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace soffit::io {
namespace {

bool sameEntries(const std::vector<GeometryEntry>& a, const std::vector<GeometryEntry>& b) {
  return std::ranges::equal(a, b, [](const GeometryEntry& x, const GeometryEntry& y) {
    return x.file == y.file && x.unit == y.unit && x.up == y.up && x.translate == y.translate &&
           x.rotate_deg == y.rotate_deg && x.scale == y.scale;
  });
}

/// A map's path as the model has it, relative to the project.
std::string besideModel(const std::string& model, const std::string& map) {
  if (map.empty()) return map;
  return (std::filesystem::path(model).parent_path() / map).lexically_normal().generic_string();
}

/// Takes the model's materials over, the first of a name wins.
void addMaterials(const LoadedModel& model, const GeometryEntry& entry, MergedGeometry& merged) {
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    scene::Material material = model.materials[i];
    material.name = model.mesh->materials[i];
    material.diffuse_map = besideModel(entry.file, material.diffuse_map);
    material.normal_map = besideModel(entry.file, material.normal_map);
    material.roughness_map = besideModel(entry.file, material.roughness_map);
    const auto known = std::ranges::find(merged.materials, material.name, &scene::Material::name);
    if (known == merged.materials.end()) {
      merged.materials.push_back(std::move(material));
      merged.described.push_back(model.described[i]);
    } else if (model.described[i] && !scene::sameReflectance(*known, material)) {
      merged.warnings.push_back(
          fmt::format("materials.{}: {} describes it differently; the first file counts",
                      material.name, entry.file));
    }
  }
}

}  // namespace

std::shared_ptr<const MergedGeometry> loadGeometry(const std::vector<GeometryEntry>& entries,
                                                   AssetCache& assets, const Job& job,
                                                   Report& report) {
  if (assets.merged != nullptr && sameEntries(entries, assets.merged_entries)) return assets.merged;
  auto merged = std::make_shared<MergedGeometry>();
  std::vector<geometry::Mesh> parts;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    job.report("reading models", static_cast<double>(i) / static_cast<double>(entries.size()));
    const GeometryEntry& entry = entries[i];
    const auto model = assets.model(entry.file, entry.unit, entry.up, job);
    if (!model) {
      report.failAt(fmt::format("geometry[{}].file", i), model.error());
      return nullptr;
    }
    parts.push_back(placeMesh(*(*model)->mesh, entry));
    addMaterials(**model, entry, *merged);
    for (const std::string& warning : (*model)->warnings) {
      merged->warnings.push_back(fmt::format("geometry[{}]: {}", i, warning));
    }
  }
  merged->mesh = std::make_shared<const geometry::Mesh>(geometry::mergeMeshes(parts));
  job.report("reading models", 1.0);
  assets.merged = merged;
  assets.merged_entries = entries;
  return merged;
}

}  // namespace soffit::io
