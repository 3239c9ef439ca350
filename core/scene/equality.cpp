// SPDX-License-Identifier: MIT
#include "core/scene/equality.h"

#include <memory>
#include <optional>

namespace soffit::scene {
namespace {

template <class T>
bool sameOptional(const std::optional<T>& a, const std::optional<T>& b) {
  if (a.has_value() != b.has_value()) return false;
  if (!a) return true;
  if constexpr (requires { same(*a, *b); }) {
    return same(*a, *b);
  } else {
    return *a == *b;
  }
}

template <class T>
bool sameTable(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  if (a == b) return true;
  return a != nullptr && b != nullptr && same(*a, *b);
}

struct ShapeEquality {
  const light::Shape& other;

  bool operator()(const light::PointShape&) const { return true; }
  bool operator()(const light::Rectangle& a) const {
    const auto& b = std::get<light::Rectangle>(other);
    return a.width == b.width && a.height == b.height;
  }
  bool operator()(const light::Disk& a) const {
    return a.radius == std::get<light::Disk>(other).radius;
  }
  bool operator()(const light::Sphere& a) const {
    return a.radius == std::get<light::Sphere>(other).radius;
  }
  bool operator()(const light::Tube& a) const {
    const auto& b = std::get<light::Tube>(other);
    return a.length == b.length && a.radius == b.radius;
  }
  bool operator()(const light::Polygon& a) const {
    return a.outline == std::get<light::Polygon>(other).outline;
  }
  bool operator()(const light::MeshShape& a) const {
    const auto& b = std::get<light::MeshShape>(other);
    return a.file == b.file && a.unit == b.unit && a.up == b.up && sameTable(a.mesh, b.mesh);
  }
};

}  // namespace

bool same(const photometry::IntensityDistribution& a, const photometry::IntensityDistribution& b) {
  return a.c_deg == b.c_deg && a.gamma_deg == b.gamma_deg && a.candela == b.candela &&
         a.opening == b.opening && a.name == b.name;
}

bool same(const Glass& a, const Glass& b) {
  return a.index == b.index && a.transmittance == b.transmittance;
}

bool same(const geometry::Mesh& a, const geometry::Mesh& b) {
  if (&a == &b) return true;
  return a.origin == b.origin && a.positions == b.positions && a.normals == b.normals &&
         a.uvs == b.uvs && a.triangles == b.triangles && a.material_of == b.material_of &&
         a.object_of == b.object_of && a.materials == b.materials && a.objects == b.objects;
}

bool same(const light::Shape& a, const light::Shape& b) {
  return a.index() == b.index() && std::visit(ShapeEquality{b}, a);
}

bool same(const light::Colour& a, const light::Colour& b) {
  if (a.cct_k != b.cct_k) return false;
  return a.cct_k.has_value() || a.rgb == b.rgb;
}

bool same(const light::Distribution& a, const light::Distribution& b) {
  return a.kind == b.kind && a.file == b.file && sameTable(a.table, b.table);
}

bool same(const Image& a, const Image& b) {
  if (&a == &b) return true;
  return a.width == b.width && a.height == b.height && a.channels == b.channels &&
         a.pixels == b.pixels;
}

bool sameReflectance(const Material& a, const Material& b) {
  return a.diffuse == b.diffuse && a.specular == b.specular && a.roughness == b.roughness &&
         a.diffuse_map == b.diffuse_map && a.normal_map == b.normal_map &&
         a.roughness_map == b.roughness_map && sameTable(a.roughness_image, b.roughness_image) &&
         sameTable(a.diffuse_image, b.diffuse_image) && sameTable(a.normal_image, b.normal_image) &&
         sameOptional(a.glass, b.glass);
}

bool same(const Environment& a, const Environment& b) {
  if (a.light.index() != b.light.index()) return false;
  if (const auto* sky = std::get_if<Sky>(&a.light)) {
    const auto& other = std::get<Sky>(b.light);
    return sky->cie == other.cie && sky->sun_azimuth_deg == other.sun_azimuth_deg &&
           sky->sun_altitude_deg == other.sun_altitude_deg &&
           sky->horizontal_illuminance == other.horizontal_illuminance &&
           sky->direct_normal_illuminance == other.direct_normal_illuminance &&
           sky->ground_reflectance == other.ground_reflectance;
  }
  if (const auto* probe = std::get_if<Probe>(&a.light)) {
    const auto& other = std::get<Probe>(b.light);
    return probe->file == other.file && probe->layout == other.layout &&
           probe->rotation_deg == other.rotation_deg && probe->scale == other.scale &&
           sameTable(probe->image, other.image);
  }
  const auto& patch = std::get<PatchLight>(a.light);
  const auto& other = std::get<PatchLight>(b.light);
  return patch.overhead_gain == other.overhead_gain &&
         patch.overhead_threshold == other.overhead_threshold &&
         patch.side_gain == other.side_gain && patch.side_threshold == other.side_threshold &&
         patch.side_azimuth_rad == other.side_azimuth_rad &&
         patch.rotation_deg == other.rotation_deg && patch.scale == other.scale;
}

bool same(const Camera& a, const Camera& b) {
  return a.name == b.name && a.position == b.position && a.target == b.target &&
         a.vertical_fov_deg == b.vertical_fov_deg;
}

bool same(const WorkPlane& a, const WorkPlane& b) {
  return a.name == b.name && a.origin == b.origin && a.u == b.u && a.v == b.v && a.nu == b.nu &&
         a.nv == b.nv && a.room_type == b.room_type;
}

bool same(const View& a, const View& b) {
  return a.exposure == b.exposure && a.ocio_display == b.ocio_display &&
         a.ocio_view == b.ocio_view && a.ocio_look == b.ocio_look && a.tone_key == b.tone_key &&
         a.tone_white == b.tone_white && a.white_balance == b.white_balance &&
         a.bloom_threshold == b.bloom_threshold && a.bloom_strength == b.bloom_strength;
}

bool same(const Quality& a, const Quality& b) {
  return a.preset == b.preset && a.settings == b.settings && a.methods == b.methods;
}

bool same(const light::Luminaire& a, const light::Luminaire& b) {
  return a.name == b.name && same(a.shape, b.shape) && a.position == b.position &&
         a.rotation_deg == b.rotation_deg && a.scale == b.scale && a.flux == b.flux &&
         same(a.colour, b.colour) && same(a.distribution, b.distribution) &&
         a.casts_shadow == b.casts_shadow && a.dimming == b.dimming && a.on == b.on &&
         a.group == b.group;
}

bool same(const LuminaireEdit& a, const LuminaireEdit& b) {
  return sameOptional(a.shape, b.shape) && a.position == b.position &&
         a.rotation_deg == b.rotation_deg && a.scale == b.scale && a.flux == b.flux &&
         sameOptional(a.colour, b.colour) && sameOptional(a.distribution, b.distribution) &&
         a.casts_shadow == b.casts_shadow && a.dimming == b.dimming && a.on == b.on &&
         a.group == b.group;
}

bool same(const Layout& a, const Layout& b) {
  if (a.name != b.name || a.edits.size() != b.edits.size()) return false;
  for (auto left = a.edits.begin(), right = b.edits.begin(); left != a.edits.end();
       ++left, ++right) {
    if (left->first != right->first || !same(left->second, right->second)) return false;
  }
  return true;
}

bool sameReflectances(const std::vector<Material>& a, const std::vector<Material>& b) {
  return std::ranges::equal(
      a, b, [](const Material& x, const Material& y) { return sameReflectance(x, y); });
}

}  // namespace soffit::scene
