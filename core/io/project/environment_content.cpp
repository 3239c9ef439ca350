// SPDX-License-Identifier: MIT
#include "core/io/project/content.h"

#include <fmt/format.h>

namespace soffit::io {
namespace {

void checkRange(const ObjectReader& reader, std::string_view key, double value, double lowest,
                double highest, Report& report) {
  if (value >= lowest && value <= highest) return;
  report.fail(reader.pathOf(key),
              fmt::format("expected a number from {} to {}, found {}", lowest, highest, value),
              "Correct the number.");
}

void readSky(const Json& value, const std::string& path, Report& report, scene::Sky& sky) {
  ObjectReader reader(value, path, report);
  reader.require("cie", "1");
  reader.read("cie", sky.cie);
  checkRange(reader, "cie", sky.cie, 1, 16, report);
  dvec2 sun{sky.sun_azimuth_deg, sky.sun_altitude_deg};
  reader.read("sun", sun);
  if (sun.y < -90.0 || sun.y > 90.0) {
    report.fail(reader.pathOf("sun"),
                fmt::format("expected an altitude from -90 to 90 degrees, found {}", sun.y),
                "Write [azimuth, altitude] in degrees.");
  }
  sky.sun_azimuth_deg = sun.x;
  sky.sun_altitude_deg = sun.y;
  std::optional<double> direct;
  reader.read("direct_normal_illuminance", direct);
  if (direct && *direct < 0.0) {
    report.fail(reader.pathOf("direct_normal_illuminance"),
                fmt::format("expected lux, not negative, found {}", *direct),
                "Correct the number.");
  }
  sky.direct_normal_illuminance = direct.value_or(0.0);
}

scene::Probe readProbe(ObjectReader& reader, Report& report) {
  scene::Probe probe;
  reader.read("image", probe.file);
  std::string layout = "latlong";
  reader.read("layout", layout);
  if (layout == "angular") {
    probe.layout = scene::ProbeLayout::angular;
  } else if (layout == "cross") {
    probe.layout = scene::ProbeLayout::cross;
  } else if (layout != "latlong") {
    report.fail(reader.pathOf("layout"),
                fmt::format("expected \"latlong\", \"angular\" or \"cross\", found \"{}\"", layout),
                "Name how the picture is laid out; a cross may stand or lie.");
  }
  reader.read("rotation", probe.rotation_deg);
  reader.read("scale", probe.scale);
  checkRange(reader, "scale", probe.scale, 0.0, 1e12, report);
  return probe;
}

scene::PatchLight readPatches(const Json& value, ObjectReader& outer, Report& report) {
  scene::PatchLight light;
  ObjectReader reader(value, outer.pathOf("analytic"), report);
  reader.read("overhead_gain", light.overhead_gain);
  reader.read("overhead_threshold", light.overhead_threshold);
  reader.read("side_gain", light.side_gain);
  reader.read("side_threshold", light.side_threshold);
  double azimuth_deg = degrees(light.side_azimuth_rad);
  reader.read("side_azimuth", azimuth_deg);
  light.side_azimuth_rad = radians(azimuth_deg);
  outer.read("rotation", light.rotation_deg);
  outer.read("scale", light.scale);
  checkRange(outer, "scale", light.scale, 0.0, 1e12, report);
  return light;
}

Json fieldsOf(const scene::Sky& sky) {
  Json inner = Json::object(
      {{"cie", sky.cie}, {"sun", Json::array({sky.sun_azimuth_deg, sky.sun_altitude_deg})}});
  if (sky.direct_normal_illuminance > 0.0) {
    inner["direct_normal_illuminance"] = sky.direct_normal_illuminance;
  }
  return Json::object({{"sky", inner},
                       {"horizontal_illuminance", sky.horizontal_illuminance},
                       {"ground_reflectance", sky.ground_reflectance}});
}

Json fieldsOf(const scene::Probe& probe) {
  const char* layout = probe.layout == scene::ProbeLayout::angular ? "angular"
                       : probe.layout == scene::ProbeLayout::cross ? "cross"
                                                                   : "latlong";
  return Json::object({{"image", probe.file},
                       {"layout", layout},
                       {"rotation", probe.rotation_deg},
                       {"scale", probe.scale}});
}

Json fieldsOf(const scene::PatchLight& light) {
  return Json::object(
      {{"analytic", Json::object({{"overhead_gain", light.overhead_gain},
                                  {"overhead_threshold", light.overhead_threshold},
                                  {"side_gain", light.side_gain},
                                  {"side_threshold", light.side_threshold},
                                  {"side_azimuth", degrees(light.side_azimuth_rad)}})},
       {"rotation", light.rotation_deg},
       {"scale", light.scale}});
}

}  // namespace

Json toJson(const scene::Environment& environment) {
  return std::visit([](const auto& light) { return fieldsOf(light); }, environment.light);
}

scene::Environment readEnvironment(const Json& value, const std::string& path, Report& report) {
  scene::Environment environment;
  ObjectReader reader(value, path, report);
  if (value.asObject() == nullptr) return environment;
  const Json* sky = reader.get("sky");
  const Json* analytic = reader.get("analytic");
  const bool probe = reader.get("image") != nullptr;
  if ((sky != nullptr ? 1 : 0) + (analytic != nullptr ? 1 : 0) + (probe ? 1 : 0) != 1) {
    report.fail(path, "expected either a sky or an image",
                "Write { \"sky\": { \"cie\": 1 }, \"horizontal_illuminance\": 10000 } or "
                "{ \"image\": \"probe.hdr\" }.");
  }
  if (probe) {
    scene::Probe made = readProbe(reader, report);
    environment.description = fmt::format("image {}", made.file);
    environment.light = std::move(made);
  }
  if (analytic != nullptr) {
    environment.light = readPatches(*analytic, reader, report);
    environment.description = "analytic light";
  }
  if (sky != nullptr) {
    scene::Sky made;
    readSky(*sky, reader.pathOf("sky"), report, made);
    reader.require("horizontal_illuminance", "10000");
    reader.read("horizontal_illuminance", made.horizontal_illuminance);
    checkRange(reader, "horizontal_illuminance", made.horizontal_illuminance, 0.0, 1e7, report);
    reader.read("ground_reflectance", made.ground_reflectance);
    checkRange(reader, "ground_reflectance", made.ground_reflectance, 0.0, 1.0, report);
    environment.description = fmt::format("CIE sky {}, {} lx, ground {}", made.cie,
                                          made.horizontal_illuminance, made.ground_reflectance);
    environment.light = made;
  }
  return environment;
}

}  // namespace soffit::io
