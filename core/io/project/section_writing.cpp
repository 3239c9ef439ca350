// SPDX-License-Identifier: MIT
#include "core/io/project/content.h"

#include <string>

namespace soffit::io {

Json toJson(const scene::Glass& glass) {
  return Json::object({{"index", glass.index}, {"transmittance", glass.transmittance}});
}

Json toJson(const scene::Quality& quality) {
  if (quality.settings.empty() && quality.methods.empty()) return quality.preset;
  Json json = Json::object({{"preset", quality.preset}});
  for (const auto& [key, value] : quality.settings) json[key] = value;
  for (const auto& [key, value] : quality.methods) json[key] = value;
  return json;
}

Json toJson(const GeometryEntry& entry) {
  Json json = Json::object({{"file", entry.file}});
  if (entry.unit != 1.0) json["unit"] = entry.unit;
  if (entry.up) json["up"] = std::string(1, *entry.up);
  if (entry.translate != dvec3(0.0)) json["translate"] = toJson(entry.translate);
  if (entry.rotate_deg != dvec3(0.0)) json["rotate"] = toJson(entry.rotate_deg);
  if (entry.scale != 1.0) json["scale"] = entry.scale;
  return json;
}

Json toJson(const scene::Camera& camera) {
  return Json::object({{"name", camera.name},
                       {"position", toJson(camera.position)},
                       {"target", toJson(camera.target)},
                       {"vertical_fov", camera.vertical_fov_deg}});
}

Json toJson(const scene::WorkPlane& plane) {
  Json json = Json::object({{"name", plane.name},
                            {"origin", toJson(plane.origin)},
                            {"u", toJson(plane.u)},
                            {"v", toJson(plane.v)},
                            {"grid", Json::array({plane.nu, plane.nv})}});
  if (!plane.room_type.empty()) json["room_type"] = plane.room_type;
  return json;
}

Json toJson(const scene::View& view) {
  Json json = Json::object({{"exposure", view.exposure},
                            {"ocio_display", view.ocio_display},
                            {"ocio_view", view.ocio_view},
                            {"ocio_look", view.ocio_look}});
  const scene::View usual;
  const auto add = [&](const char* key, double value, double otherwise) {
    if (value != otherwise) json[key] = value;
  };
  add("white_balance", view.white_balance, usual.white_balance);
  add("tone_key", view.tone_key, usual.tone_key);
  add("tone_white", view.tone_white, usual.tone_white);
  add("bloom_threshold", view.bloom_threshold, usual.bloom_threshold);
  add("bloom_strength", view.bloom_strength, usual.bloom_strength);
  return json;
}

}  // namespace soffit::io
