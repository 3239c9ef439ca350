// SPDX-License-Identifier: MIT
#include "core/io/project/atomic_file.h"
#include "core/io/project/content.h"
#include "core/io/project/document.h"
#include "core/io/project/project.h"
#include "core/io/project/report.h"
#include "core/io/project/sync.h"
#include "core/scene/checks.h"
#include "core/scene/edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soffit::io {
namespace {

/// All fields of a luminaire, defaults included, so that only what differs is written.
Json allFields(const light::Luminaire& l) {
  scene::LuminaireEdit edit{l.shape,   l.position, l.rotation_deg, l.scale,
                            l.flux,    l.colour,   l.distribution, l.casts_shadow,
                            l.dimming, l.on,       l.group};
  return toJson(edit);
}

Json newLuminaire(const light::Luminaire& luminaire) {
  scene::LuminaireEdit edit = scene::editBetween(light::Luminaire{}, luminaire);
  edit.shape = luminaire.shape;
  edit.position = luminaire.position;
  Json json = Json::object({{"name", luminaire.name}});
  updateFields(json, Json::object(), toJson(edit));
  return json;
}

void syncLuminaires(const scene::Scene& scene, Json& root) {
  syncList(
      root, "luminaires", scene.luminaires,
      [](const light::Luminaire& luminaire) { return newLuminaire(luminaire); },
      [](const light::Luminaire& luminaire, Json& json) {
        Report ignored("");
        const auto old = scene::applyEdit({}, readLuminaire(json, "", ignored));
        updateFields(json, allFields(old), allFields(luminaire));
      });
}

void updateLayout(const scene::Layout& layout, Json& json) {
  if (layout.edits.empty() && json.find("luminaires") == nullptr) return;
  Json& edits = json["luminaires"];
  if (edits.asObject() == nullptr) edits = Json::object();
  std::erase_if(*edits.asObject(),
                [&](const JsonMember& member) { return !layout.edits.contains(member.key); });
  for (const auto& [name, edit] : layout.edits) {
    Json& target = edits[name];
    if (target.asObject() == nullptr) target = Json::object();
    Report ignored("");
    updateFields(target, toJson(readLuminaire(target, "", ignored)), toJson(edit));
  }
}

void syncLayouts(const scene::Scene& scene, Json& root) {
  syncList(
      root, "layouts", scene.layouts,
      [](const scene::Layout& layout) {
        Json json = Json::object({{"name", layout.name}});
        updateLayout(layout, json);
        return json;
      },
      updateLayout);
}

void syncPlaces(const scene::Scene& scene, Json& root) {
  syncList(
      root, "cameras", scene.cameras, [](const scene::Camera& camera) { return toJson(camera); },
      [](const scene::Camera& camera, Json& json) {
        Report ignored("");
        scene::Camera old = readCamera(json, "", ignored);
        old.name = camera.name;
        updateFields(json, toJson(old), toJson(camera));
      });
  syncList(
      root, "work_planes", scene.work_planes,
      [](const scene::WorkPlane& plane) { return toJson(plane); },
      [](const scene::WorkPlane& plane, Json& json) {
        Report ignored("");
        scene::WorkPlane old = readWorkPlane(json, "", ignored);
        old.name = plane.name;
        updateFields(json, toJson(old), toJson(plane));
      });
}

/// A material's fields as the project writes them.
Json materialFields(const scene::Material& material) {
  Json json = Json::object();
  // Glass has no reflectance of its own: what the file says of it stays as it is.
  if (!material.glass) {
    json["diffuse"] = toJson(material.diffuse);
    json["specular"] = material.specular;
  }
  json["roughness"] = material.roughness;
  json["diffuse_map"] = material.diffuse_map;
  json["normal_map"] = material.normal_map;
  json["roughness_map"] = material.roughness_map;
  json["glass"] = material.glass ? toJson(*material.glass) : Json();
  return json;
}

/// Writes the fields in which a material differs from what loading the document would give; a
/// field that is again what the geometry file says loses its override.
void updateMaterial(const scene::Material& material, const scene::Material& from_file, Json& root) {
  const Json* materials = root.find("materials");
  const Json* entry = materials == nullptr ? nullptr : materials->find(material.name);
  Report ignored("");
  const MaterialEdit edit = entry == nullptr ? MaterialEdit{} : readMaterial(*entry, "", ignored);
  const Json old_fields = materialFields(applyMaterialEdit(from_file, edit));
  const Json file_fields = materialFields(applyMaterialEdit(from_file, {}));
  const Json fields = materialFields(material);
  for (const JsonMember& field : *fields.asObject()) {
    const Json* old = old_fields.find(field.key);
    if (old != nullptr && *old == field.value) continue;
    const Json* in_file = file_fields.find(field.key);
    Json& target = root["materials"][material.name];
    if (target.asObject() == nullptr) target = Json::object();
    if (in_file != nullptr && *in_file == field.value) {
      target.erase(field.key);
    } else {
      target[field.key] = field.value;
    }
  }
}

void syncMaterials(const Project& project, Json& root) {
  for (const scene::Material& material : project.scene.materials) {
    const auto from_file =
        std::ranges::find(project.file_materials, material.name, &scene::Material::name);
    if (from_file != project.file_materials.end()) {
      updateMaterial(material, *from_file, root);
      continue;
    }
    // No file was read yet: the project states what it knows.
    scene::Material blank;
    blank.name = material.name;
    if (!material.glass) root["materials"][material.name]["diffuse"] = toJson(material.diffuse);
    updateMaterial(material, blank, root);
  }
}

void syncGeometry(const Project& project, Json& root) {
  Report ignored("");
  const Json* old = root.find("geometry");
  const JsonArray* elements = old == nullptr ? nullptr : old->asArray();
  JsonArray written;
  for (std::size_t i = 0; i < project.geometry.size(); ++i) {
    const Json fields = toJson(project.geometry[i]);
    Json element = Json::object();
    if (elements != nullptr && i < elements->size()) element = (*elements)[i];
    updateFields(element, toJson(readGeometryEntry(element, "", ignored)), fields);
    written.push_back(std::move(element));
  }
  root["geometry"] = std::move(written);
}

void syncView(const scene::Scene& scene, Json& root) {
  Report ignored("");
  const Json* view = root.find("view");
  const Json old_view = toJson(view == nullptr ? scene::View{} : readView(*view, "", ignored));
  if (!(old_view == toJson(scene.view))) {
    Json& target = root["view"];
    if (target.asObject() == nullptr) target = Json::object();
    updateFields(target, old_view, toJson(scene.view));
  }
  const Json* quality = root.find("quality");
  const Json old_quality =
      toJson(quality == nullptr ? scene::Quality{} : readQuality(*quality, "", ignored));
  if (!(old_quality == toJson(scene.quality))) root["quality"] = toJson(scene.quality);
}

void syncEnvironment(const scene::Scene& scene, Json& root) {
  if (!scene.environment) {
    root.erase("environment");
    return;
  }
  const Json fields = toJson(*scene.environment);
  Json& target = root["environment"];
  Report ignored("");
  const Json old =
      target.asObject() == nullptr ? Json::object() : toJson(readEnvironment(target, "", ignored));
  if (old == fields) return;
  const bool same_kind =
      std::ranges::any_of(std::array{"sky", "image", "analytic"}, [&](const char* kind) {
        return target.find(kind) != nullptr && fields.find(kind) != nullptr;
      });
  if (!same_kind) {
    target = fields;
    return;
  }
  for (const JsonMember& field : *fields.asObject()) {
    const Json* before = old.find(field.key);
    if (before != nullptr && *before == field.value) continue;
    if (before != nullptr && field.value.asObject() != nullptr &&
        target.find(field.key) != nullptr) {
      updateFields(target[field.key], *before, field.value);
    } else {
      target[field.key] = field.value;
    }
  }
}

}  // namespace

Result<std::string> formatProject(const Project& project) {
  const std::string file = project.path.string();
  if (project.overridden) {
    return Error{file, "a project under a layout or --set cannot be saved: its base would be lost",
                 "Load it without them, edit and save that."};
  }
  for (Error& fault : scene::findFaults(project.scene)) {
    fault.place = file.empty() ? fault.place : fmt::format("{}: {}", file, fault.place);
    return fault;
  }
  Json root = project.document == nullptr ? Json::object({{"soffit", 1}}) : project.document->root;
  const Json* name = root.find("name");
  if (name == nullptr ? !project.scene.name.empty() : !(*name == Json(project.scene.name))) {
    root["name"] = project.scene.name;
  }
  syncGeometry(project, root);
  syncMaterials(project, root);
  syncLuminaires(project.scene, root);
  syncLayouts(project.scene, root);
  syncLightScenes(project.light_scenes, root);
  syncProbes(project.probes, root);
  syncPlaces(project.scene, root);
  syncView(project.scene, root);
  syncEnvironment(project.scene, root);
  return formatJson(root);
}

Result<void> saveProject(const Project& project, const std::filesystem::path& path) {
  const auto text = formatProject(project);
  if (!text) return text.error();
  return writeFileAtomically(path, *text, Previous::kept_as_backup);
}

}  // namespace soffit::io
