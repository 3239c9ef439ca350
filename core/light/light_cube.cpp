// SPDX-License-Identifier: MIT
#include "core/light/light_cube.h"

#include "core/base/parallel.h"
#include "core/light/emitter_hit.h"
#include "core/sh/basis.h"
#include "core/sh/cube_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>

namespace soffit::light {
namespace {

/// Texels [begin, end) of one axis of a face.
struct Span1 {
  int begin = 0, end = 0;
  [[nodiscard]] int size() const { return std::max(0, end - begin); }
};

/// Which texels along an axis a ball may touch: its place across and forward of the face, metres.
Span1 reach(double across, double forward, double radius, int side) {
  const double distance = std::hypot(across, forward);
  if (distance <= radius) return {0, side};
  const double middle = std::atan2(across, forward);
  const double half = std::asin(radius / distance);
  const double low = std::max(middle - half, -kPi / 4.0);
  const double high = std::min(middle + half, kPi / 4.0);
  if (low >= high) return {};
  const auto texel = [side](double angle) { return 0.5 * (std::tan(angle) + 1.0) * side; };
  return {std::clamp(static_cast<int>(std::floor(texel(low) - 1e-9)), 0, side),
          std::clamp(static_cast<int>(std::ceil(texel(high) + 1e-9)), 0, side)};
}

struct Window {
  int face = 0;
  Span1 columns, rows;
};

std::vector<Window> windowsOf(const EmitterPart& part, const dvec3& probe, int side) {
  std::vector<Window> windows;
  const dvec3 to = part.center - probe;
  for (int face = 0; face < 6; ++face) {
    const sh::CubeFace& f = sh::kCubeFaces[static_cast<std::size_t>(face)];
    const double forward = glm::dot(to, f.forward);
    const Window w{face, reach(glm::dot(to, f.right), forward, part.radius, side),
                   reach(-glm::dot(to, f.up), forward, part.radius, side)};
    if (w.columns.size() > 0 && w.rows.size() > 0) windows.push_back(w);
  }
  return windows;
}

/// Sums over the lines of sight of one texel.
struct Pieces {
  dvec3 point{0.0}, normal{0.0};
  double area = 0.0, solid_angle = 0.0;

  void add(const Pieces& o, double scale) {
    point += scale * o.point;
    normal += scale * o.normal;
    area += scale * o.area;
    solid_angle += scale * o.solid_angle;
  }
};

/// Draws parts of one emitter.
class Drawing {
 public:
  Drawing(const DepthCube& depth, const Emitter& emitter, std::uint32_t index)
      : depth_(depth), emitter_(emitter), index_(index) {}

  void draw(const EmitterPart& part, double lines_of_sight) {
    const auto exact = solidAngleOf(emitter_, part, depth_.probe);
    if (exact && *exact <= 0.0) return;  // its dark side
    const std::vector<Window> windows = windowsOf(part, depth_.probe, depth_.side);
    double texels = 0.0;
    for (const Window& w : windows) texels += double(w.columns.size()) * w.rows.size();
    if (texels <= 0.0) return;
    const double lines = std::sqrt(lines_of_sight / texels);
    const int grid = std::clamp(static_cast<int>(std::ceil(lines)), 2, 64);
    drawn_.clear();
    drawn_angle_ = 0.0;
    for (const Window& w : windows) {
      for (int row = w.rows.begin; row < w.rows.end; ++row) {
        for (int column = w.columns.begin; column < w.columns.end; ++column) {
          drawTexel(part, {w.face, column, row}, grid);
        }
      }
    }
    // Lines of sight along a border are in or out together: the whole, hidden or not, is known.
    const double scale = exact && drawn_angle_ > 0.0 ? *exact / drawn_angle_ : 1.0;
    for (const auto& [texel, sum] : drawn_) pieces_[texel].add(sum, scale);
    if (drawn_angle_ <= 0.0 && exact) drawWhole(part, *exact);
  }

  [[nodiscard]] std::vector<LightTexel> texels() const {
    std::vector<LightTexel> all;
    for (const auto& [texel, sum] : pieces_) {
      const double length = glm::length(sum.normal);
      if (!(sum.area > 0.0) || !(length > 0.0)) continue;
      // Where surfaces of different normals meet in a texel, a Lambertian emits sum of area (n .
      // d); measured light does not ask for normals.
      const double area = emitter_.table != nullptr ? sum.area : length;
      all.push_back(
          {texel, index_, sum.point / sum.area, sum.normal / length, area, sum.solid_angle});
    }
    return all;
  }

 private:
  struct Place {
    int face, column, row;
  };

  [[nodiscard]] double texelAngle(const Place& at) const {
    const sh::CubePoint c = sh::texelCenter(at.face, at.column, at.row, depth_.side);
    const double half = 1.0 / depth_.side;
    return sh::rectangleSolidAngle(c.u - half, c.v - half, c.u + half, c.v + half);
  }

  void drawTexel(const EmitterPart& part, const Place& at, int grid) {
    const int side = depth_.side;
    const auto texel = static_cast<std::size_t>((at.face * side + at.row) * side + at.column);
    const dvec3 center = sh::cubeDirection(sh::texelCenter(at.face, at.column, at.row, side));
    Pieces sum;
    double seen = 0.0, all = 0.0;  // of the texel: by the luminaire, and whole
    for (int i = 0; i < grid; ++i) {
      for (int j = 0; j < grid; ++j) {
        // Sheared: no two lines of sight share a column or a row.
        const double u = (at.column + (i + (j + 0.5) / grid) / grid) * 2.0 / side - 1.0;
        const double v = (at.row + (j + (i + 0.5) / grid) / grid) * 2.0 / side - 1.0;
        const double r2 = 1.0 + u * u + v * v;
        const double share = 1.0 / (r2 * std::sqrt(r2));
        all += share;
        const dvec3 direction = sh::cubeDirection({at.face, u, v});
        const auto hit = hitPart(emitter_, part, depth_.probe, direction);
        if (!hit) continue;
        seen += share;
        if (hidden(texel, center, direction, *hit)) continue;
        const double facing = -glm::dot(hit->normal, direction);
        const double area = share * hit->t * hit->t / std::max(facing, 1e-4);
        sum.add({depth_.probe + hit->t * direction, hit->normal, 1.0, share / area}, area);
      }
    }
    if (seen <= 0.0) return;
    const double scale = texelAngle(at) / all;
    drawn_angle_ += scale * seen;
    if (sum.area > 0.0) drawn_[static_cast<std::uint32_t>(texel)].add(sum, scale);
  }

  /// A part that slips through between the lines of sight: its middle stands for all of it.
  void drawWhole(const EmitterPart& part, double solid_angle) {
    if (emitter_.kind != EmitterKind::mesh) return;  // seen edge on
    const std::span<const dvec3> corners =
        std::span(emitter_.corners).subspan(3 * part.triangle, 3);
    const dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const dvec3 to = middle - depth_.probe;
    const double distance = glm::length(to);
    const std::size_t texel = sh::texelOf(to, depth_.side);
    if (depth_.hides(texel, distance)) return;
    const dvec3& normal = emitter_.triangle_normals[part.triangle];
    const double area = emitter_.triangle_areas[part.triangle];
    const double side = glm::dot(normal, to) < 0.0 ? 1.0 : -1.0;
    pieces_[static_cast<std::uint32_t>(texel)].add({middle, side * normal, 1.0, solid_angle / area},
                                                   area);
  }

  /// The depth is known at the texel's centre: compare it with the luminaire's surface there.
  [[nodiscard]] bool hidden(std::size_t texel, const dvec3& center, const dvec3& direction,
                            const EmitterHit& hit) const {
    const double facing = glm::dot(hit.normal, center);
    const double moved = facing * glm::dot(hit.normal, direction) > 0.0
                             ? hit.t * glm::dot(hit.normal, direction) / facing
                             : hit.t;
    // At a grazing view the surface runs away within the texel: no further than its own point.
    return depth_.hides(texel, std::min(hit.t, moved));
  }

  const DepthCube& depth_;
  const Emitter& emitter_;
  std::uint32_t index_;
  std::map<std::uint32_t, Pieces> drawn_;   ///< of the part at hand
  double drawn_angle_ = 0.0;                ///< of the part at hand, hidden or not
  std::map<std::uint32_t, Pieces> pieces_;  ///< ordered: sums do not depend on chance
};

std::vector<LightTexel> drawPoint(const DepthCube& depth, const Emitter& emitter,
                                  std::uint32_t index) {
  const dvec3 to = emitter.position - depth.probe;
  const double distance = glm::length(to);
  if (!(distance > 0.0)) return {};
  const std::size_t texel = sh::texelOf(to, depth.side);
  if (depth.hides(texel, distance)) return {};
  return {{static_cast<std::uint32_t>(texel), index, emitter.position, dvec3(0.0), 0.0, 0.0}};
}

/// Candela of a piece toward the unit `direction` away from it.
double intensityOf(const LightTexel& piece, const Emitter& emitter, const dvec3& direction) {
  if (emitter.kind == EmitterKind::point) return emitter.pointIntensity(direction);
  return emitter.intensityPerArea(piece.normal, direction) * piece.area;
}

/// Light of a piece that arrives at the probe, luminance times solid angle; `to`: its place from
/// there.
double seenFrom(const LightTexel& piece, const Emitter& emitter, const dvec3& to) {
  const double r2 = glm::dot(to, to);
  const dvec3 away = -to / std::sqrt(r2);
  const double facing = glm::dot(piece.normal, away);
  if (facing < 1e-3) return intensityOf(piece, emitter, away) / r2;
  return emitter.intensityPerArea(piece.normal, away) / facing * piece.solid_angle;
}

}  // namespace

LightCube drawLights(const DepthCube& depth, std::span<const Emitter> emitters,
                     const LightCubeOptions& options) {
  assert(options.lines_of_sight >= 1);
  std::vector<std::vector<LightTexel>> drawn(emitters.size());
  parallelFor(emitters.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto index = static_cast<std::uint32_t>(i);
      if (emitters[i].kind == EmitterKind::point) {
        drawn[i] = drawPoint(depth, emitters[i], index);
        continue;
      }
      Drawing drawing(depth, emitters[i], index);
      const std::vector<EmitterPart> parts = partsOf(emitters[i]);
      const double lines = options.lines_of_sight / std::max(1.0, double(parts.size()));
      for (const EmitterPart& part : parts) drawing.draw(part, lines);
      drawn[i] = drawing.texels();
    }
  });
  LightCube cube{depth.probe, depth.side, {}};
  for (const auto& texels : drawn)
    cube.texels.insert(cube.texels.end(), texels.begin(), texels.end());
  return cube;
}

std::array<std::vector<float>, 3> LightCube::radiance(std::span<const Emitter> emitters) const {
  const auto row = static_cast<std::size_t>(side);
  std::array<std::vector<float>, 3> planes;
  for (auto& plane : planes) plane.assign(6 * row * row, 0.0F);
  for (const LightTexel& piece : texels) {
    const Emitter& emitter = emitters[piece.emitter];
    const dvec3 to = piece.point - probe;
    const auto center = sh::texelCenter(static_cast<int>(piece.texel / (row * row)),
                                        static_cast<int>(piece.texel % row),
                                        static_cast<int>(piece.texel / row % row), side);
    const double half = 1.0 / side;
    const double whole =
        sh::rectangleSolidAngle(center.u - half, center.v - half, center.u + half, center.v + half);
    const double value = emitter.gain * seenFrom(piece, emitter, to) / whole;
    for (int c = 0; c < 3; ++c) {
      planes[static_cast<std::size_t>(c)][piece.texel] +=
          static_cast<float>(value * emitter.color[c]);
    }
  }
  return planes;
}

sh::RgbCoefficients coefficientsAtProbe(const LightCube& cube, std::span<const Emitter> emitters,
                                        const sh::ProjectionTable& table) {
  const auto planes = cube.radiance(emitters);
  return table.project(planes[0], planes[1], planes[2]);
}

sh::RgbCoefficients coefficientsAt(const LightCube& cube, std::span<const Emitter> emitters,
                                   const dvec3& receiver, int bands) {
  sh::RgbCoefficients sum;
  for (sh::Coefficients& channel : sum) channel.assign(sh::coefficientCount(bands), 0.0);
  std::array<double, sh::kMaxCoefficients> basis;
  for (const LightTexel& piece : cube.texels) {
    const Emitter& emitter = emitters[piece.emitter];
    const dvec3 to = piece.point - receiver;
    const double r2 = glm::dot(to, to);
    if (!(r2 > 0.0)) continue;
    const dvec3 direction = to / std::sqrt(r2);
    const double value = emitter.gain * intensityOf(piece, emitter, -direction) / r2;
    if (value == 0.0) continue;
    sh::evaluate(direction, bands, basis);
    for (std::size_t c = 0; c < 3; ++c) {
      const double light = value * emitter.color[static_cast<int>(c)];
      for (std::size_t i = 0; i < sum[c].size(); ++i) sum[c][i] += light * basis[i];
    }
  }
  return sum;
}

}  // namespace soffit::light
