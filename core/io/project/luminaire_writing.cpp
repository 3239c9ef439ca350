// SPDX-License-Identifier: MIT
#include "core/io/project/content.h"

#include <optional>
#include <variant>

namespace soffit::io {
namespace {

struct ShapeWriter {
  Json operator()(const light::PointShape& /*shape*/) const { return "point"; }
  Json operator()(const light::Rectangle& shape) const {
    return Json::object({{"rectangle", Json::array({shape.width, shape.height})}});
  }
  Json operator()(const light::Disk& shape) const { return Json::object({{"disk", shape.radius}}); }
  Json operator()(const light::Sphere& shape) const {
    return Json::object({{"sphere", shape.radius}});
  }
  Json operator()(const light::Tube& shape) const {
    return Json::object({{"tube", Json::array({shape.length, shape.radius})}});
  }
  Json operator()(const light::Polygon& shape) const {
    JsonArray corners;
    for (const dvec2& p : shape.outline) corners.push_back(Json::array({p.x, p.y}));
    return Json::object({{"polygon", corners}});
  }
  Json operator()(const light::MeshShape& shape) const {
    Json json = Json::object({{"mesh", shape.file}});
    if (shape.unit != 1.0) json["unit"] = shape.unit;
    if (shape.up != light::kUpAsInFile) json["up"] = std::string(1, shape.up);
    return json;
  }
};

template <class T>
void put(Json& object, std::string_view key, const std::optional<T>& value) {
  if (!value) return;
  if constexpr (requires { toJson(*value); }) {
    object[key] = toJson(*value);
  } else {
    object[key] = *value;
  }
}

}  // namespace

Json toJson(const dvec3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json toJson(const light::Shape& shape) {
  return std::visit(ShapeWriter{}, shape);
}

Json toJson(const light::Colour& colour) {
  if (colour.cct_k) return Json::object({{"cct", *colour.cct_k}});
  return Json::object({{"rgb", toJson(colour.rgb)}});
}

Json toJson(const light::Distribution& distribution) {
  switch (distribution.kind) {
    case light::DistributionKind::isotropic:
      return "isotropic";
    case light::DistributionKind::ies:
      return Json::object({{"ies", distribution.file}});
    case light::DistributionKind::ldt:
      return Json::object({{"ldt", distribution.file}});
    case light::DistributionKind::lambertian:
      break;
  }
  return "lambertian";
}

Json toJson(const scene::LuminaireEdit& edit) {
  Json json = Json::object();
  put(json, "shape", edit.shape);
  put(json, "position", edit.position);
  put(json, "rotation", edit.rotation_deg);
  put(json, "scale", edit.scale);
  put(json, "flux", edit.flux);
  put(json, "colour", edit.colour);
  put(json, "distribution", edit.distribution);
  put(json, "casts_shadow", edit.casts_shadow);
  put(json, "dimming", edit.dimming);
  put(json, "on", edit.on);
  put(json, "group", edit.group);
  return json;
}

}  // namespace soffit::io
