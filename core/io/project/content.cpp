// SPDX-License-Identifier: MIT
#include "core/io/project/content.h"

#include "core/scene/edits.h"

#include <fmt/format.h>

#include <optional>

namespace soffit::io {
namespace {

/// Calls read_element(element, path) for each element of the member `key`, if it is there.
template <class ReadElement>
void readList(ObjectReader& reader, std::string_view key, Report& report,
              const ReadElement& read_element) {
  const Json* value = reader.get(key);
  if (value == nullptr) return;
  const JsonArray* array = value->asArray();
  if (array == nullptr) {
    report.fail(reader.pathOf(key), fmt::format("expected an array, found {}", value->describe()),
                "Write it as [ ... ].");
    return;
  }
  for (std::size_t i = 0; i < array->size(); ++i) {
    read_element((*array)[i], elementPath(reader.pathOf(key), i, (*array)[i]));
  }
}

/// Reads and returns the name of a list's element; fails when there is none.
std::string readName(const Json& value, const std::string& path, Report& report) {
  const Json* name = value.find("name");
  if (value.asObject() != nullptr && name == nullptr) {
    report.fail(joinPath(path, "name"), "this key is missing", "Give it a unique name.");
  }
  const std::string* text = name == nullptr ? nullptr : name->asText();
  if (name != nullptr && (text == nullptr || text->empty())) {
    report.fail(joinPath(path, "name"), fmt::format("expected a name, found {}", name->describe()),
                "Give it a unique name in double quotes.");
  }
  return text == nullptr ? std::string() : *text;
}

light::Luminaire readBaseLuminaire(const Json& value, const std::string& path, Report& report) {
  light::Luminaire luminaire;
  luminaire.name = readName(value, path, report);
  const scene::LuminaireEdit edit = readLuminaire(value, path, report);
  if (value.asObject() != nullptr && !edit.shape) {
    report.fail(joinPath(path, "shape"), "this key is missing",
                "Add \"shape\": { \"rectangle\": [0.6, 0.6] }, or another one.");
  }
  return scene::applyEdit(luminaire, edit);
}

scene::Layout readLayout(const Json& value, const std::string& path, Report& report) {
  scene::Layout layout;
  layout.name = readName(value, path, report);
  ObjectReader reader(value, path, report);
  reader.get("name");
  if (const Json* scenes = reader.get("scenes")) {
    (void)readLightScenes(*scenes, reader.pathOf("scenes"), report);
  }
  const Json* luminaires = reader.get("luminaires");
  if (luminaires == nullptr) return layout;
  const JsonObject* edits = luminaires->asObject();
  if (edits == nullptr) {
    report.fail(
        reader.pathOf("luminaires"),
        fmt::format("expected an object by luminaire name, found {}", luminaires->describe()),
        "Write it as { \"Panel 1\": { \"on\": false } }.");
    return layout;
  }
  for (const JsonMember& member : *edits) {
    const std::string place = joinPath(reader.pathOf("luminaires"), member.key);
    layout.edits[member.key] = readLuminaire(member.value, place, report);
  }
  return layout;
}

void checkOwnLuminaires(const ProjectContent& content, Report& report) {
  scene::Scene base;
  base.luminaires = content.luminaires;
  for (const scene::Layout& layout : content.layouts) {
    for (const auto& [name, edit] : layout.edits) {
      if (edit.shape || scene::findLuminaire(base, name) != nullptr) continue;
      report.fail(fmt::format("layouts.{}.luminaires.{}", layout.name, name),
                  "the base has no luminaire of this name, and as one of this layout alone it "
                  "lacks its shape",
                  "Correct the name, or add shape, position and flux.");
    }
  }
}

void readMaterials(ObjectReader& reader, Report& report, ProjectContent& content) {
  const Json* materials = reader.get("materials");
  if (materials == nullptr) return;
  const JsonObject* object = materials->asObject();
  if (object == nullptr) {
    report.fail("materials",
                fmt::format("expected an object by name, found {}", materials->describe()),
                "Write it as { \"wall\": { \"diffuse\": [0.7, 0.7, 0.7] } }.");
    return;
  }
  for (const JsonMember& member : *object) {
    const std::string path = joinPath("materials", member.key);
    content.materials.push_back({member.key, readMaterial(member.value, path, report)});
  }
}

}  // namespace

ProjectContent readContent(const Json& root, Report& report) {
  ProjectContent content;
  ObjectReader reader(root, "", report);
  reader.get("soffit");
  reader.read("name", content.name);
  readList(reader, "geometry", report, [&](const Json& value, const std::string& path) {
    content.geometry.push_back(readGeometryEntry(value, path, report));
  });
  readMaterials(reader, report, content);
  if (const Json* scenes = reader.get("scenes")) (void)readLightScenes(*scenes, "scenes", report);
  if (const Json* probes = reader.get("probes")) (void)readProbes(*probes, "probes", report);
  readList(reader, "luminaires", report, [&](const Json& value, const std::string& path) {
    content.luminaires.push_back(readBaseLuminaire(value, path, report));
  });
  readList(reader, "layouts", report, [&](const Json& value, const std::string& path) {
    content.layouts.push_back(readLayout(value, path, report));
  });
  readList(reader, "cameras", report, [&](const Json& value, const std::string& path) {
    content.cameras.push_back(readCamera(value, path, report));
    content.cameras.back().name = readName(value, path, report);
  });
  readList(reader, "work_planes", report, [&](const Json& value, const std::string& path) {
    content.work_planes.push_back(readWorkPlane(value, path, report));
    content.work_planes.back().name = readName(value, path, report);
  });
  if (const Json* environment = reader.get("environment"); environment && !environment->isNull()) {
    content.environment = readEnvironment(*environment, "environment", report);
  }
  if (const Json* view = reader.get("view")) content.view = readView(*view, "view", report);
  if (const Json* quality = reader.get("quality")) {
    content.quality = readQuality(*quality, "quality", report);
  }
  checkOwnLuminaires(content, report);
  return content;
}

scene::Material applyMaterialEdit(const scene::Material& material, const MaterialEdit& edit) {
  scene::Material result = material;
  if (edit.diffuse) result.diffuse = *edit.diffuse;
  if (edit.specular) result.specular = *edit.specular;
  if (edit.roughness) result.roughness = *edit.roughness;
  if (edit.diffuse_map && *edit.diffuse_map != result.diffuse_map) {
    result.diffuse_map = *edit.diffuse_map;
    result.diffuse_image = nullptr;
  }
  if (edit.normal_map && *edit.normal_map != result.normal_map) {
    result.normal_map = *edit.normal_map;
    result.normal_image = nullptr;
  }
  if (edit.roughness_map && *edit.roughness_map != result.roughness_map) {
    result.roughness_map = *edit.roughness_map;
    result.roughness_image = nullptr;
  }
  if (edit.glass) result.glass = edit.glass;
  if (edit.opaque) result.glass = std::nullopt;
  if (result.glass) {
    // Its own optics are all that it has.
    result.diffuse = dvec3(0.0);
    result.specular = 0.0;
  }
  return result;
}

}  // namespace soffit::io
