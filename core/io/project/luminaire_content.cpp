// SPDX-License-Identifier: MIT
#include "core/io/project/content.h"

#include <fmt/format.h>

#include <array>

namespace soffit::io {
namespace {

using light::DistributionKind;

constexpr std::array<std::string_view, 6> kShapes{"rectangle", "disk",    "sphere",
                                                  "tube",      "polygon", "mesh"};

constexpr std::string_view kShapeHint =
    "Use \"point\", or an object with one of rectangle, disk, sphere, tube, polygon, mesh.";

light::Polygon readPolygon(const Json& value, const std::string& path, Report& report) {
  light::Polygon polygon;
  const JsonArray* corners = value.asArray();
  if (corners == nullptr) {
    report.fail(path, fmt::format("expected corners, found {}", value.describe()),
                "Write them as [[x, y], [x, y], [x, y]].");
    return polygon;
  }
  for (std::size_t i = 0; i < corners->size(); ++i) {
    const auto numbers = readNumbers((*corners)[i], 2, fmt::format("{}[{}]", path, i), report);
    if (!numbers) break;
    polygon.outline.emplace_back((*numbers)[0], (*numbers)[1]);
  }
  return polygon;
}

light::Shape readMesh(ObjectReader& reader, Report& report) {
  light::MeshShape mesh;
  reader.read("mesh", mesh.file);
  reader.read("unit", mesh.unit);
  if (!(mesh.unit > 0.0)) {
    report.fail(reader.pathOf("unit"), fmt::format("expected metres above 0, found {}", mesh.unit),
                "Use 0.001 for a file in millimetres.");
  }
  mesh.up = readUp(reader, report).value_or(light::kUpAsInFile);
  return mesh;
}

/// The one key among `kinds` that an object has; fails when there is none or more than one.
template <class Kinds>
std::string_view onlyKind(const Json& value, const Kinds& kinds, const std::string& path,
                          std::string_view hint, Report& report) {
  std::string_view found;
  int count = 0;
  for (const std::string_view kind : kinds) {
    if (value.find(kind) == nullptr) continue;
    found = kind;
    ++count;
  }
  if (count == 1) return found;
  report.fail(path, fmt::format("expected one kind, found {}", count == 0 ? "none" : "several"),
              std::string(hint));
  return {};
}

}  // namespace

light::Shape readShape(const Json& value, const std::string& path, Report& report) {
  if (const std::string* text = value.asText()) {
    if (*text == "point") return light::PointShape{};
    report.fail(path, fmt::format("there is no shape {}", value.describe()),
                std::string(kShapeHint));
    return light::PointShape{};
  }
  ObjectReader reader(value, path, report);
  if (value.asObject() == nullptr) return light::PointShape{};
  const std::string_view kind = onlyKind(value, kShapes, path, kShapeHint, report);
  if (kind == "rectangle") {
    dvec2 size{0.0};
    reader.read(kind, size);
    return light::Rectangle{size.x, size.y};
  }
  if (kind == "disk" || kind == "sphere") {
    double radius = 0.0;
    reader.read(kind, radius);
    if (kind == "disk") return light::Disk{radius};
    return light::Sphere{radius};
  }
  if (kind == "tube") {
    dvec2 size{0.0};
    reader.read(kind, size);
    return light::Tube{size.x, size.y};
  }
  if (kind == "polygon") return readPolygon(*reader.get(kind), reader.pathOf(kind), report);
  if (kind == "mesh") return readMesh(reader, report);
  for (const std::string_view known : kShapes) reader.get(known);
  return light::PointShape{};
}

light::Colour readColour(const Json& value, const std::string& path, Report& report) {
  light::Colour colour;
  ObjectReader reader(value, path, report);
  if (value.asObject() == nullptr) return colour;
  constexpr std::array<std::string_view, 2> kKinds{"cct", "rgb"};
  onlyKind(value, kKinds, path, "Use { \"cct\": 4000 } or { \"rgb\": [1, 1, 1] }.", report);
  reader.read("cct", colour.cct_k);
  reader.read("rgb", colour.rgb);
  return colour;
}

light::Distribution readDistribution(const Json& value, const std::string& path, Report& report) {
  constexpr std::string_view kHint =
      "Use \"lambertian\", \"isotropic\", { \"ies\": \"file.ies\" } or { \"ldt\": \"file.ldt\" }.";
  light::Distribution distribution;
  if (const std::string* text = value.asText()) {
    if (*text == "isotropic") {
      distribution.kind = DistributionKind::isotropic;
    } else if (*text != "lambertian") {
      report.fail(path, fmt::format("there is no distribution {}", value.describe()),
                  std::string(kHint));
    }
    return distribution;
  }
  ObjectReader reader(value, path, report);
  if (value.asObject() == nullptr) return distribution;
  constexpr std::array<std::string_view, 2> kKinds{"ies", "ldt"};
  const std::string_view kind = onlyKind(value, kKinds, path, kHint, report);
  distribution.kind = kind == "ldt" ? DistributionKind::ldt : DistributionKind::ies;
  reader.read("ies", distribution.file);
  reader.read("ldt", distribution.file);
  return distribution;
}

scene::LuminaireEdit readLuminaire(const Json& value, const std::string& path, Report& report) {
  scene::LuminaireEdit edit;
  ObjectReader reader(value, path, report);
  const auto readPart = [&](std::string_view key, auto& target, auto read_part) {
    if (const Json* part = reader.get(key)) target = read_part(*part, reader.pathOf(key), report);
  };
  reader.get("name");
  readPart("shape", edit.shape, readShape);
  reader.read("position", edit.position);
  reader.read("rotation", edit.rotation_deg);
  reader.read("scale", edit.scale);
  reader.read("flux", edit.flux);
  readPart("colour", edit.colour, readColour);
  readPart("distribution", edit.distribution, readDistribution);
  reader.read("casts_shadow", edit.casts_shadow);
  reader.read("dimming", edit.dimming);
  reader.read("on", edit.on);
  reader.read("group", edit.group);
  return edit;
}

}  // namespace soffit::io
