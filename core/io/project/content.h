// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/json.h"
#include "core/io/project/project.h"
#include "core/io/project/report.h"
#include "core/light/luminaire.h"
#include "core/math/vec.h"
#include "core/scene/material.h"
#include "core/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The project file's sections as values, before any file that they name is opened (internal to
/// io_project). Reading and writing stand side by side: what is written reads back the same.
namespace soffit::io {

/// What a project says about a material; absent fields keep what the geometry file says.
struct MaterialEdit {
  std::optional<dvec3> diffuse;
  std::optional<double> specular;
  std::optional<double> roughness;
  std::optional<std::string> diffuse_map;
  std::optional<std::string> normal_map;
  std::optional<std::string> roughness_map;
  std::optional<scene::Glass> glass;
  bool opaque = false;  ///< "glass": null, against a file that says glass
};

struct NamedMaterialEdit {
  std::string name;
  MaterialEdit edit;
};

/// A project without the tables of its files.
struct ProjectContent {
  std::string name;
  std::vector<GeometryEntry> geometry;
  std::vector<NamedMaterialEdit> materials;
  std::vector<light::Luminaire> luminaires;
  std::vector<scene::Layout> layouts;
  std::vector<scene::Camera> cameras;
  std::vector<scene::WorkPlane> work_planes;
  std::optional<scene::Environment> environment;  ///< a probe without its picture
  scene::View view;
  scene::Quality quality;
};

/// Reads the whole document; faults and unknown keys go to `report`.
ProjectContent readContent(const Json& root, Report& report);

scene::LuminaireEdit readLuminaire(const Json& value, const std::string& path, Report& report);
light::Shape readShape(const Json& value, const std::string& path, Report& report);
light::Colour readColour(const Json& value, const std::string& path, Report& report);
light::Distribution readDistribution(const Json& value, const std::string& path, Report& report);
MaterialEdit readMaterial(const Json& value, const std::string& path, Report& report);
scene::Camera readCamera(const Json& value, const std::string& path, Report& report);
scene::WorkPlane readWorkPlane(const Json& value, const std::string& path, Report& report);
scene::View readView(const Json& value, const std::string& path, Report& report);
scene::Quality readQuality(const Json& value, const std::string& path, Report& report);
GeometryEntry readGeometryEntry(const Json& value, const std::string& path, Report& report);
/// The member "up" of an object: 'y' or 'z', nothing when it is absent.
std::optional<char> readUp(ObjectReader& reader, Report& report);
/// A probe's picture is still to be loaded.
Json toJson(const scene::Environment& environment);
scene::Environment readEnvironment(const Json& value, const std::string& path, Report& report);

Json toJson(const dvec3& v);
Json toJson(const light::Shape& shape);
Json toJson(const light::Colour& colour);
Json toJson(const light::Distribution& distribution);
Json toJson(const scene::Glass& glass);
Json toJson(const scene::Quality& quality);
/// Every field that is set, in the order of the format's description; no name.
Json toJson(const scene::LuminaireEdit& edit);
Json toJson(const GeometryEntry& entry);
/// Every field, the name first.
Json toJson(const scene::Camera& camera);
Json toJson(const scene::WorkPlane& plane);
Json toJson(const scene::View& view);

/// The material that a project's override makes of the file's. Glass has no paint: `daylight` knows
/// what it mirrors and lets through.
scene::Material applyMaterialEdit(const scene::Material& material, const MaterialEdit& edit);

}  // namespace soffit::io
