// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/ray_caster.h"
#include "core/light/emitter.h"
#include "core/math/vec.h"

#include <array>
#include <limits>
#include <memory>
#include <vector>

/// The surfaces of luminaires as the path tracer meets them: crossed by rays where they shine, and
/// black bodies where they cast shadows. Exact shapes in double precision; only meshes go through
/// a ray caster of their own.
namespace soffit::reference {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A ray in double precision, direction unit.
struct Line {
  dvec3 origin{0.0};
  dvec3 direction{0.0, 0.0, 1.0};
};

/// Where a line meets an emitting surface.
struct Crossing {
  double t = 0.0;  ///< metres along the line
  dvec3 normal{0.0};
};

/// An emitter with what intersecting and sampling it needs.
class LightShape {
 public:
  /// The emitter must outlive the shape.
  explicit LightShape(const light::Emitter& emitter);

  [[nodiscard]] const light::Emitter& emitter() const { return *emitter_; }
  [[nodiscard]] const dvec3& center() const { return center_; }  ///< of the bounding sphere
  [[nodiscard]] double radius() const { return radius_; }        ///< of the bounding sphere, m

  /// Planar with an outline that is a rectangle: corner and edges; edge_x x edge_y is along the
  /// emitter's normal.
  [[nodiscard]] bool isRectangle() const { return rectangle_; }
  [[nodiscard]] const dvec3& corner() const { return corner_; }
  [[nodiscard]] const dvec3& edgeX() const { return edge_x_; }
  [[nodiscard]] const dvec3& edgeY() const { return edge_y_; }

  /// Appends the crossings of the emitting surface (either face) with 0 < t < t_max. A mesh that
  /// casts shadows hides what lies behind its first crossing.
  void cross(const Line& line, double t_max, std::vector<Crossing>& out) const;

  /// The distance at which the opaque body is met, or infinity if not before t_max. A planar body
  /// is hit from both sides, a tube is closed at its ends. A point has no body.
  [[nodiscard]] double bodyDistance(const Line& line, double t_max) const;

  /// Whether the emitter's own mesh shades the point on its surface from `origin`; `normal` is
  /// the surface's there. Only meshes that cast shadows shade themselves.
  [[nodiscard]] bool shadesItself(const dvec3& origin, const dvec3& point,
                                  const dvec3& normal) const;

 private:
  /// At most two crossings of a shape that is not a mesh; the count is returned.
  int crossExact(const Line& line, double t_max, std::array<Crossing, 2>& out) const;
  int crossPlane(const Line& line, double t_max, std::array<Crossing, 2>& out) const;
  int crossSphere(const Line& line, double t_max, std::array<Crossing, 2>& out) const;
  int crossTube(const Line& line, double t_max, std::array<Crossing, 2>& out) const;
  void crossMesh(const Line& line, double t_max, std::vector<Crossing>& out) const;
  [[nodiscard]] bool insideOutline(const dvec3& p) const;
  [[nodiscard]] double capDistance(const Line& line, double t_max) const;
  [[nodiscard]] bool missesBounds(const Line& line, double t_max) const;

  const light::Emitter* emitter_;
  dvec3 center_{0.0};
  double radius_ = 0.0;
  bool rectangle_ = false;
  dvec3 corner_{0.0};
  dvec3 edge_x_{0.0};
  dvec3 edge_y_{0.0};
  std::shared_ptr<const geometry::RayCaster> mesh_;
};

}  // namespace soffit::reference
