// SPDX-License-Identifier: MIT
#include "core/geometry/convex_faces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "core/geometry/weld.h"

namespace soffit::geometry {
namespace {

// A polygon under way: welded points, counter-clockwise. dead: merged into another.
struct Polygon {
  std::array<std::uint32_t, 4> points{};
  int count = 3;
  bool dead = false;
};

// Two polygons that run along a common edge in opposite ways, by their first triangles.
struct Seam {
  float length_squared;
  std::uint32_t a;
  std::uint32_t b;
};

// Rounded to 12 bits: edges that only rounding tells apart keep the order of their indices, which
// sweeps a grid row by row whichever way it is turned.
float coarse(float x) {
  constexpr std::uint32_t kDropped = 12;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(x) + (1U << (kDropped - 1));
  return std::bit_cast<float>(bits >> kDropped << kDropped);
}

class Merger {
 public:
  Merger(const Mesh& mesh, const Components& components)
      : mesh_(mesh), components_(components), slack_(2.0 * weldTolerance(mesh.bounds())) {
    owner_.resize(mesh.triangles.size());
    std::iota(owner_.begin(), owner_.end(), 0U);
    for (const uvec3& t : mesh.triangles) {
      polygons_.push_back(
          {{components.point_of[t.x], components.point_of[t.y], components.point_of[t.z], 0}});
    }
  }

  ConvexFaces run() {
    while (mergeAlong(seams())) {
    }
    return result();
  }

 private:
  [[nodiscard]] dvec3 at(std::uint32_t point) const { return dvec3(mesh_.positions[point]); }

  [[nodiscard]] std::vector<Seam> seams() const;
  [[nodiscard]] std::uint32_t ownerOf(std::uint32_t polygon) const;
  bool mergeAlong(const std::vector<Seam>& seams);
  [[nodiscard]] std::optional<Polygon> united(const Polygon& a, const Polygon& b) const;
  [[nodiscard]] std::optional<Polygon> simplified(std::span<const std::uint32_t> loop,
                                                  const dvec3& normal, double slack) const;
  [[nodiscard]] dvec3 normalOf(const Polygon& p) const;
  [[nodiscard]] double sizeOf(const Polygon& p) const;
  [[nodiscard]] bool liesIn(const Polygon& p, const dvec3& point, const dvec3& normal,
                            double slack) const;
  [[nodiscard]] ConvexFaces result() const;

  const Mesh& mesh_;
  const Components& components_;
  double slack_;                      // metres
  std::vector<Polygon> polygons_;     // index of a polygon: its first triangle
  std::vector<std::uint32_t> owner_;  // polygon that a triangle (or dead polygon) went into
};

// The unit normal; of a quadrilateral from its diagonals.
dvec3 Merger::normalOf(const Polygon& p) const {
  dvec3 n = glm::cross(at(p.points[1]) - at(p.points[0]), at(p.points[2]) - at(p.points[0]));
  if (p.count == 4) {
    n = glm::cross(at(p.points[2]) - at(p.points[0]), at(p.points[3]) - at(p.points[1]));
  }
  const double length = glm::length(n);
  return length > 0.0 ? n / length : dvec3(0.0);
}

double Merger::sizeOf(const Polygon& p) const {
  double size = 0.0;
  for (int k = 0; k < p.count; ++k) {
    size = std::max(size, glm::distance(at(p.points[k]), at(p.points[(k + 1) % p.count])));
  }
  return size;
}

bool Merger::liesIn(const Polygon& p, const dvec3& point, const dvec3& normal, double slack) const {
  for (int k = 0; k < p.count; ++k) {
    if (std::abs(glm::dot(at(p.points[k]) - point, normal)) > slack) return false;
  }
  return true;
}

std::vector<Seam> Merger::seams() const {
  struct Side {
    std::uint32_t lo, hi, polygon;
    bool forward;
  };
  std::vector<Side> sides;
  for (std::uint32_t i = 0; i < polygons_.size(); ++i) {
    const Polygon& p = polygons_[i];
    for (int k = 0; k < p.count && !p.dead; ++k) {
      const std::uint32_t a = p.points[k];
      const std::uint32_t b = p.points[(k + 1) % p.count];
      sides.push_back({std::min(a, b), std::max(a, b), i, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    if (a.lo != b.lo) return a.lo < b.lo;
    if (a.hi != b.hi) return a.hi < b.hi;
    return a.polygon < b.polygon;
  });
  std::vector<Seam> out;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      if (sides[j].lo != sides[i].lo || sides[j].hi != sides[i].hi) break;
      const std::uint32_t a = sides[i].polygon;
      const std::uint32_t b = sides[j].polygon;
      const bool alike = components_.component_of[a] == components_.component_of[b] &&
                         mesh_.material_of[a] == mesh_.material_of[b];
      if (a == b || !alike || sides[i].forward == sides[j].forward) continue;
      const dvec3 edge = at(sides[i].hi) - at(sides[i].lo);
      out.push_back({coarse(static_cast<float>(glm::dot(edge, edge))), a, b});
    }
  }
  // Longest first: the diagonal of a rectangle goes before its sides.
  std::sort(out.begin(), out.end(), [](const Seam& a, const Seam& b) {
    if (a.length_squared != b.length_squared) return a.length_squared > b.length_squared;
    return a.a != b.a ? a.a < b.a : a.b < b.b;
  });
  return out;
}

// Drops corners on straight lines and checks that the rest turns left everywhere.
std::optional<Polygon> Merger::simplified(std::span<const std::uint32_t> loop, const dvec3& normal,
                                          double slack) const {
  Polygon out;
  out.count = 0;
  const std::size_t n = loop.size();
  for (std::size_t k = 0; k < n; ++k) {
    const dvec3 before = at(loop[(k + n - 1) % n]);
    const dvec3 here = at(loop[k]);
    const dvec3 after = at(loop[(k + 1) % n]);
    const dvec3 base = after - before;
    const double length = glm::length(base);
    if (!(length > slack)) return std::nullopt;  // a spike
    // Height of this corner over the line of its neighbors, positive to the outside.
    const double height = glm::dot(glm::cross(here - before, base), normal) / length;
    if (height < -slack) return std::nullopt;
    const bool between = glm::dot(here - before, base) > 0.0 && glm::dot(after - here, base) > 0.0;
    if (height <= slack && between) continue;
    if (height <= slack || out.count == 4) return std::nullopt;
    out.points[static_cast<std::size_t>(out.count++)] = loop[k];
  }
  if (out.count < 3) return std::nullopt;
  return out;
}

std::optional<Polygon> Merger::united(const Polygon& a, const Polygon& b) const {
  const dvec3 na = normalOf(a);
  const dvec3 nb = normalOf(b);
  if (glm::dot(na, nb) < 0.999) return std::nullopt;
  constexpr double kRelative = 1e-6;
  const double slack = std::max(slack_, kRelative * std::max(sizeOf(a), sizeOf(b)));
  if (!liesIn(b, at(a.points[0]), na, slack) || !liesIn(a, at(b.points[0]), nb, slack)) {
    return std::nullopt;
  }
  // a's loop from the end of the common edge around to its start, then b's likewise.
  for (int i = 0; i < a.count; ++i) {
    for (int j = 0; j < b.count; ++j) {
      const std::uint32_t start = a.points[i];
      const std::uint32_t end = a.points[(i + 1) % a.count];
      if (b.points[j] != end || b.points[(j + 1) % b.count] != start) continue;
      std::vector<std::uint32_t> loop;
      for (int k = 1; k < a.count; ++k) loop.push_back(a.points[(i + k) % a.count]);
      for (int k = 1; k < b.count; ++k) loop.push_back(b.points[(j + k) % b.count]);
      return simplified(loop, na, slack);
    }
  }
  return std::nullopt;  // merging has changed one of them since the seam was found
}

std::uint32_t Merger::ownerOf(std::uint32_t polygon) const {
  while (owner_[polygon] != polygon) polygon = owner_[polygon];
  return polygon;
}

bool Merger::mergeAlong(const std::vector<Seam>& seams) {
  bool merged = false;
  for (const Seam& seam : seams) {
    const std::uint32_t into = ownerOf(seam.a);
    const std::uint32_t from = ownerOf(seam.b);
    if (into == from) continue;
    const std::optional<Polygon> both = united(polygons_[into], polygons_[from]);
    if (!both) continue;
    polygons_[into] = *both;
    polygons_[from].dead = true;
    owner_[from] = into;
    merged = true;
  }
  return merged;
}

ConvexFaces Merger::result() const {
  ConvexFaces out;
  std::vector<std::uint32_t> number(polygons_.size());
  for (std::uint32_t i = 0; i < polygons_.size(); ++i) {
    if (polygons_[i].dead) continue;
    number[i] = static_cast<std::uint32_t>(out.faces.size());
    ConvexFace face;
    face.count = polygons_[i].count;
    face.component = components_.component_of[i];
    face.material = mesh_.material_of[i];
    for (int k = 0; k < face.count; ++k) {
      face.corners[static_cast<std::size_t>(k)] = mesh_.positions[polygons_[i].points[k]];
    }
    out.faces.push_back(face);
  }
  for (std::uint32_t t = 0; t < polygons_.size(); ++t) {
    out.face_of.push_back(number[ownerOf(t)]);
    ++out.faces[out.face_of.back()].triangles;
  }
  return out;
}

}  // namespace

ConvexFaces mergeConvexFaces(const Mesh& mesh, const Components& components) {
  return Merger(mesh, components).run();
}

}  // namespace soffit::geometry
