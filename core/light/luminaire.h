// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/math/vec.h"
#include "core/photometry/intensity_distribution.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Luminaires as the project describes them. Local frame: unrotated it emits down; gamma 0 is
/// -z, C0 is +x, C90 is +y. Lengths in metres, before `scale`.
namespace soffit::light {

struct PointShape {};
struct Rectangle { double width = 0.6; double height = 0.6; };  ///< along x, along y; in the xy plane, emits to -z
struct Disk { double radius = 0.3; };                            ///< in the xy plane, emits to -z
struct Sphere { double radius = 0.1; };                          ///< emits outwards
struct Tube { double length = 1.2; double radius = 0.013; };     ///< axis x, centred, lateral surface only
struct Polygon { std::vector<dvec2> outline; };                  ///< simple, any winding, emits to -z
/// MeshShape::up of a mesh that stands as its file or the file's format says.
inline constexpr char kUpAsInFile = '\0';

/// Any mesh; emits where its counter-clockwise winding faces. `mesh` holds metres, z up.
struct MeshShape {
  std::string file;  ///< relative to the project
  double unit = 1.0;
  char up = 'z';  ///< 'y', 'z' or kUpAsInFile
  std::shared_ptr<const geometry::Mesh> mesh;
};
using Shape = std::variant<PointShape, Rectangle, Disk, Sphere, Tube, Polygon, MeshShape>;

/// Chromaticity only: the flux stays the flux.
struct Colour {
  std::optional<double> cct_k;  ///< Planckian, kelvin
  dvec3 rgb{1.0};               ///< linear Rec.709, used when cct_k is absent
};

enum class DistributionKind { lambertian, isotropic, ies, ldt };
struct Distribution {
  DistributionKind kind = DistributionKind::lambertian;
  std::string file;  ///< relative to the project, for ies and ldt
  std::shared_ptr<const photometry::IntensityDistribution> table;
};

struct Luminaire {
  std::string name;
  Shape shape = Rectangle{};
  dvec3 position{0.0};      ///< world, of the shape's own origin
  dvec3 rotation_deg{0.0};  ///< about fixed x, y, z in that order
  double scale = 1.0;
  std::optional<double> flux;  ///< lumens over the whole shape; absent with a file: the file's candela
  Colour colour;
  Distribution distribution;
  bool casts_shadow = false;
  double dimming = 1.0;
  bool on = true;
  std::string group;
};

}  // namespace soffit::light
