// SPDX-License-Identifier: MIT
#include "core/io/project/content.h"

#include "core/color/white_balance.h"
#include "core/scene/checks.h"

#include <fmt/format.h>

namespace soffit::io {
namespace {

void checkPositive(const ObjectReader& reader, std::string_view key, double value, Report& report) {
  if (value > 0.0) return;
  report.fail(reader.pathOf(key), fmt::format("expected a number above 0, found {}", value),
              "Correct the number, or leave it out for 1.");
}

scene::Glass readGlass(const Json& value, const std::string& path, Report& report) {
  scene::Glass glass;
  ObjectReader reader(value, path, report);
  reader.read("index", glass.index);
  reader.read("transmittance", glass.transmittance);
  const double most = scene::losslessTransmittance(glass.index);
  if (glass.index >= 1.0 && glass.transmittance > most && glass.transmittance <= 1.0) {
    report.warn(reader.pathOf("transmittance"),
                fmt::format("a sheet of index {} lets at most {:.3f} through", glass.index, most));
  }
  return glass;
}

}  // namespace

std::optional<char> readUp(ObjectReader& reader, Report& report) {
  std::optional<std::string> up;
  reader.read("up", up);
  if (!up) return std::nullopt;
  if (*up == "y" || *up == "z") return up->front();
  report.fail(reader.pathOf("up"), fmt::format("expected \"y\" or \"z\", found \"{}\"", *up),
              "Name the axis of the file that points up.");
  return std::nullopt;
}

GeometryEntry readGeometryEntry(const Json& value, const std::string& path, Report& report) {
  GeometryEntry entry;
  ObjectReader reader(value, path, report);
  reader.require("file", "\"room.obj\"");
  reader.read("file", entry.file);
  reader.read("unit", entry.unit);
  checkPositive(reader, "unit", entry.unit, report);
  entry.up = readUp(reader, report);
  reader.read("translate", entry.translate);
  reader.read("rotate", entry.rotate_deg);
  reader.read("scale", entry.scale);
  checkPositive(reader, "scale", entry.scale, report);
  return entry;
}

MaterialEdit readMaterial(const Json& value, const std::string& path, Report& report) {
  MaterialEdit edit;
  ObjectReader reader(value, path, report);
  const Json* diffuse = reader.get("diffuse");
  if (diffuse != nullptr && diffuse->asNumber() != nullptr) {
    // One number is a grey.
    if (const auto grey = readNumber(*diffuse, reader.pathOf("diffuse"), report)) {
      edit.diffuse = dvec3(*grey);
    }
  } else {
    reader.read("diffuse", edit.diffuse);
  }
  reader.read("specular", edit.specular);
  reader.read("roughness", edit.roughness);
  reader.read("diffuse_map", edit.diffuse_map);
  reader.read("normal_map", edit.normal_map);
  reader.read("roughness_map", edit.roughness_map);
  const Json* glass = reader.get("glass");
  edit.opaque = glass != nullptr && glass->isNull();
  if (glass != nullptr && !edit.opaque) {
    edit.glass = readGlass(*glass, reader.pathOf("glass"), report);
  }
  return edit;
}

scene::Camera readCamera(const Json& value, const std::string& path, Report& report) {
  scene::Camera camera;
  ObjectReader reader(value, path, report);
  reader.get("name");
  reader.require("position", "[1, 1, 1.6]");
  reader.require("target", "[4, 3, 1.2]");
  reader.read("position", camera.position);
  reader.read("target", camera.target);
  reader.read("vertical_fov", camera.vertical_fov_deg);
  return camera;
}

scene::WorkPlane readWorkPlane(const Json& value, const std::string& path, Report& report) {
  scene::WorkPlane plane;
  ObjectReader reader(value, path, report);
  reader.get("name");
  reader.require("origin", "[0.5, 0.5, 0.8]");
  reader.require("u", "[4, 0, 0]");
  reader.require("v", "[0, 3, 0]");
  reader.require("grid", "[8, 6]");
  reader.read("origin", plane.origin);
  reader.read("u", plane.u);
  reader.read("v", plane.v);
  dvec2 grid{1.0};
  reader.read("grid", grid);
  if (grid != glm::trunc(grid) || grid.x < 1.0 || grid.y < 1.0 || grid.x > 1e7 || grid.y > 1e7) {
    report.fail(reader.pathOf("grid"),
                fmt::format("expected two whole numbers from 1, found {} and {}", grid.x, grid.y),
                "Write the number of cells along u and v.");
  } else {
    plane.nu = static_cast<int>(grid.x);
    plane.nv = static_cast<int>(grid.y);
  }
  reader.read("room_type", plane.room_type);
  return plane;
}

scene::View readView(const Json& value, const std::string& path, Report& report) {
  scene::View view;
  ObjectReader reader(value, path, report);
  reader.read("exposure", view.exposure);
  reader.read("ocio_display", view.ocio_display);
  reader.read("ocio_view", view.ocio_view);
  reader.read("ocio_look", view.ocio_look);
  const auto within = [&](const char* key, double& number, double most) {
    reader.read(key, number);
    if (number >= 0.0 && number <= most) return;
    report.fail(reader.pathOf(key), fmt::format("expected 0 to {:g}, found {:g}", most, number),
                "Correct the number, or leave it out.");
  };
  reader.read("white_balance", view.white_balance);
  if (view.white_balance != 0.0 &&
      !(view.white_balance >= color::kWarmestWhite && view.white_balance <= color::kCoolestWhite)) {
    report.fail(reader.pathOf("white_balance"),
                fmt::format("expected 0 or {:g} to {:g}, found {:g}", color::kWarmestWhite,
                            color::kCoolestWhite, view.white_balance),
                "Give the colour temperature that is to look white, in kelvin, or leave it out.");
  }
  within("tone_key", view.tone_key, 100.0);
  within("tone_white", view.tone_white, 1e6);
  within("bloom_threshold", view.bloom_threshold, 1e9);
  within("bloom_strength", view.bloom_strength, 1.0);
  return view;
}

scene::Quality readQuality(const Json& value, const std::string& path, Report& report) {
  scene::Quality quality;
  if (const std::string* preset = value.asText()) {
    quality.preset = *preset;
    return quality;
  }
  ObjectReader reader(value, path, report);
  reader.read("preset", quality.preset);
  const JsonObject* object = value.asObject();
  if (object == nullptr) return quality;
  for (const JsonMember& member : *object) {
    if (member.key == "preset") continue;
    if (member.value.asText() != nullptr) {
      reader.read(member.key, quality.methods[member.key]);
      continue;
    }
    reader.read(member.key, quality.settings[member.key]);
  }
  return quality;
}

}  // namespace soffit::io
