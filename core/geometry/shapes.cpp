// SPDX-License-Identifier: MIT
#include "core/geometry/shapes.h"

#include <cassert>
#include <cmath>

namespace soffit::geometry {
namespace {

std::uint32_t addVertex(Mesh& mesh, const dvec3& position, const dvec3& normal) {
  mesh.positions.emplace_back(position);
  mesh.normals.emplace_back(normal);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void addQuad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.emplace_back(a, b, c);
  mesh.triangles.emplace_back(a, c, d);
}

Mesh finished(Mesh mesh, const char* name) {
  mesh.materials = {name};
  mesh.objects = {name};
  mesh.material_of.assign(mesh.triangles.size(), 0);
  mesh.object_of.assign(mesh.triangles.size(), 0);
  return mesh;
}

// Cosine and sine of turn i of n, exactly the same for i and i + n, so that seams close.
dvec2 onCircle(int i, int n) {
  const double phi = 2.0 * kPi * (i % n) / n;
  return {std::cos(phi), std::sin(phi)};
}

// A fan of a disk at x, front to the side of `sign` along x.
void addTubeEnd(Mesh& mesh, double x, double radius, int columns, double sign) {
  const dvec3 normal(sign, 0.0, 0.0);
  const std::uint32_t middle = addVertex(mesh, {x, 0.0, 0.0}, normal);
  for (int i = 0; i < columns; ++i) {
    const dvec2 c = onCircle(i, columns);
    addVertex(mesh, {x, radius * c.x, radius * c.y}, normal);
  }
  const auto n = static_cast<std::uint32_t>(columns);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = middle + 1 + i;
    const std::uint32_t b = middle + 1 + (i + 1) % n;
    mesh.triangles.emplace_back(middle, sign > 0.0 ? a : b, sign > 0.0 ? b : a);
  }
}

}  // namespace

Mesh makeBox(const vec3& lo, const vec3& hi) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const bool upper : {false, true}) {
      dvec3 normal(0.0);
      normal[axis] = upper ? 1.0 : -1.0;
      std::uint32_t corner[4];
      for (int k = 0; k < 4; ++k) {
        dvec3 p(upper ? hi : lo);
        p[u] = (k == 1 || k == 2) ? hi[u] : lo[u];
        p[v] = k >= 2 ? hi[v] : lo[v];
        corner[k] = addVertex(mesh, p, normal);
      }
      if (upper) {
        addQuad(mesh, corner[0], corner[1], corner[2], corner[3]);
      } else {
        addQuad(mesh, corner[0], corner[3], corner[2], corner[1]);
      }
    }
  }
  return finished(std::move(mesh), "box");
}

Mesh makeSphere(const vec3& center, float radius, int bands) {
  assert(bands >= 2);
  Mesh mesh;
  const int columns = 2 * bands;
  const auto add = [&](const dvec3& n) {
    return addVertex(mesh, dvec3(center) + double{radius} * n, n);
  };
  const std::uint32_t top = add({0.0, 0.0, 1.0});
  for (int i = 1; i < bands; ++i) {
    const double theta = kPi * i / bands;
    for (int j = 0; j < columns; ++j) {
      const dvec2 c = std::sin(theta) * onCircle(j, columns);
      add({c.x, c.y, std::cos(theta)});
    }
  }
  const std::uint32_t bottom = add({0.0, 0.0, -1.0});
  const auto n = static_cast<std::uint32_t>(columns);
  const std::uint32_t last_ring = bottom - n;
  for (std::uint32_t j = 0; j < n; ++j) {
    const std::uint32_t next = (j + 1) % n;
    mesh.triangles.emplace_back(top, top + 1 + j, top + 1 + next);
    for (std::uint32_t ring = top + 1; ring < last_ring; ring += n) {
      addQuad(mesh, ring + j, ring + n + j, ring + n + next, ring + next);
    }
    mesh.triangles.emplace_back(last_ring + j, bottom, last_ring + next);
  }
  return finished(std::move(mesh), "sphere");
}

Mesh makeTube(float length, float radius, int columns, bool closed) {
  assert(columns >= 3);
  Mesh mesh;
  const double half = 0.5 * length;
  for (int i = 0; i < columns; ++i) {
    const dvec2 c = onCircle(i, columns);
    const dvec3 normal(0.0, c.x, c.y);
    addVertex(mesh, double{radius} * normal - dvec3(half, 0.0, 0.0), normal);
    addVertex(mesh, double{radius} * normal + dvec3(half, 0.0, 0.0), normal);
  }
  const auto n = static_cast<std::uint32_t>(columns);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    addQuad(mesh, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1);
  }
  if (closed) {
    addTubeEnd(mesh, -half, radius, columns, -1.0);
    addTubeEnd(mesh, half, radius, columns, 1.0);
  }
  return finished(std::move(mesh), "tube");
}

Mesh makeDisk(float radius, int columns) {
  assert(columns >= 3);
  Mesh mesh;
  const dvec3 up(0.0, 0.0, 1.0);
  addVertex(mesh, dvec3(0.0), up);
  for (int i = 0; i < columns; ++i) {
    const dvec2 c = double{radius} * onCircle(i, columns);
    addVertex(mesh, {c.x, c.y, 0.0}, up);
  }
  const auto n = static_cast<std::uint32_t>(columns);
  for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.emplace_back(0U, 1 + i, 1 + (i + 1) % n);
  return finished(std::move(mesh), "disk");
}

Mesh makeRectangle(float size_x, float size_y, int nx, int ny) {
  assert(nx >= 1 && ny >= 1);
  Mesh mesh;
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      const dvec2 p(size_x * (static_cast<double>(i) / nx - 0.5),
                    size_y * (static_cast<double>(j) / ny - 0.5));
      addVertex(mesh, {p.x, p.y, 0.0}, {0.0, 0.0, 1.0});
    }
  }
  const auto row = static_cast<std::uint32_t>(nx + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(ny); ++j) {
    for (std::uint32_t a = j * row; a < j * row + row - 1; ++a) {
      addQuad(mesh, a, a + 1, a + row + 1, a + row);
    }
  }
  return finished(std::move(mesh), "rectangle");
}

}  // namespace soffit::geometry
