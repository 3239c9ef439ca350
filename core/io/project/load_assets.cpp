// SPDX-License-Identifier: MIT
#include "core/io/project/load_assets.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <variant>

namespace soffit::io {
namespace {

/// "a, b and 3 more" of a list of names.
std::string shortList(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) {
    list += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() > kShown) list += fmt::format(" and {} more", names.size() - kShown);
  return list;
}

const MaterialEdit* findEdit(const std::vector<NamedMaterialEdit>& edits, const std::string& name) {
  const auto found = std::ranges::find(edits, name, &NamedMaterialEdit::name);
  return found == edits.end() ? nullptr : &found->edit;
}

/// Loads the map named `file`. One that only the model names may be missing, with a warning.
void loadMap(const std::string& file, bool from_project, const std::string& path, ImageUse use,
             std::shared_ptr<const scene::Image>& target, AssetCache& assets, Report& report) {
  if (file.empty()) return;
  auto image = assets.image(file, use);
  if (image) {
    target = *image;
  } else if (from_project) {
    report.failAt(path, image.error());
  } else {
    report.warn(path, fmt::format("{}; the surface has no picture", image.error().message()));
  }
}

void warnAboutNames(const MergedGeometry& geometry, const std::vector<NamedMaterialEdit>& edits,
                    const std::vector<std::string>& set_names, Report& report) {
  for (const NamedMaterialEdit& edit : edits) {
    if (std::ranges::find(geometry.materials, edit.name, &scene::Material::name) !=
        geometry.materials.end()) {
      continue;
    }
    const std::string path = joinPath("materials", edit.name);
    if (std::ranges::find(set_names, edit.name) == set_names.end()) {
      report.warn(path, "the geometry has no material of this name");
      continue;
    }
    std::vector<std::string> names;
    for (const scene::Material& material : geometry.materials) names.push_back(material.name);
    report.fail(path, "--set names a material that the geometry does not have",
                names.empty() ? "The project has no materials."
                              : fmt::format("There is: {}.", shortList(names)));
  }
}

/// Fills what a shape or a distribution keeps in a file of its own.
class LuminaireFiles {
 public:
  LuminaireFiles(AssetCache& assets, Report& report) : assets_(assets), report_(report) {}

  void load(light::Shape& shape, const std::string& path) {
    auto* mesh = std::get_if<light::MeshShape>(&shape);
    if (mesh == nullptr) return;
    const auto model = assets_.model(
        mesh->file, mesh->unit,
        mesh->up == light::kUpAsInFile ? std::nullopt : std::optional<char>(mesh->up));
    if (!model) return report_.failAt(path + ".shape.mesh", model.error());
    mesh->mesh = (*model)->mesh;
  }

  void load(light::Distribution& distribution, const std::string& path) {
    const bool is_ies = distribution.kind == light::DistributionKind::ies;
    if (!is_ies && distribution.kind != light::DistributionKind::ldt) return;
    const auto loaded = assets_.photometry(distribution.file);
    if (!loaded) {
      return report_.failAt(path + (is_ies ? ".distribution.ies" : ".distribution.ldt"),
                            loaded.error());
    }
    distribution.table = (*loaded)->table;
    if (!warned_.insert(distribution.file).second) return;
    for (const std::string& warning : (*loaded)->warnings) report_.warn(distribution.file, warning);
  }

 private:
  AssetCache& assets_;
  Report& report_;
  std::set<std::string> warned_;
};

}  // namespace

std::vector<scene::Material> loadMaterials(const MergedGeometry& geometry,
                                           const std::vector<NamedMaterialEdit>& edits,
                                           const std::vector<std::string>& set_names,
                                           AssetCache& assets, Report& report) {
  std::vector<scene::Material> materials;
  std::vector<std::string> undescribed;
  const MaterialEdit nothing;
  for (std::size_t i = 0; i < geometry.materials.size(); ++i) {
    const scene::Material& from_file = geometry.materials[i];
    const MaterialEdit* found = findEdit(edits, from_file.name);
    const MaterialEdit& edit = found == nullptr ? nothing : *found;
    scene::Material material = applyMaterialEdit(from_file, edit);
    const std::string path = joinPath("materials", material.name);
    loadMap(material.diffuse_map, edit.diffuse_map.has_value(), path + ".diffuse_map",
            ImageUse::color, material.diffuse_image, assets, report);
    loadMap(material.normal_map, edit.normal_map.has_value(), path + ".normal_map", ImageUse::data,
            material.normal_image, assets, report);
    loadMap(material.roughness_map, edit.roughness_map.has_value(), path + ".roughness_map",
            ImageUse::data, material.roughness_image, assets, report);
    if (!material.glass && !geometry.described[i] && !edit.diffuse) {
      undescribed.push_back(material.name);
    }
    materials.push_back(std::move(material));
  }
  if (!undescribed.empty()) {
    report.warn("materials", fmt::format("no file tells the colour of {}: diffuse 0.5 is taken",
                                         shortList(undescribed)));
  }
  warnAboutNames(geometry, edits, set_names, report);
  return materials;
}

void loadLuminaireFiles(std::vector<light::Luminaire>& luminaires,
                        std::vector<scene::Layout>& layouts, AssetCache& assets, Report& report) {
  LuminaireFiles files(assets, report);
  for (light::Luminaire& luminaire : luminaires) {
    const std::string path = joinPath("luminaires", luminaire.name);
    files.load(luminaire.shape, path);
    files.load(luminaire.distribution, path);
  }
  for (scene::Layout& layout : layouts) {
    for (auto& [name, edit] : layout.edits) {
      const std::string path = fmt::format("layouts.{}.luminaires.{}", layout.name, name);
      if (edit.shape) files.load(*edit.shape, path);
      if (edit.distribution) files.load(*edit.distribution, path);
    }
  }
}

void loadProbe(scene::Environment& environment, AssetCache& assets, Report& report) {
  auto* probe = std::get_if<scene::Probe>(&environment.light);
  if (probe == nullptr) return;
  const auto image = assets.image(probe->file, ImageUse::color);
  if (!image) return report.failAt("environment.image", image.error());
  probe->image = *image;
}

}  // namespace soffit::io
