// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

/// Tessellated solids and sheets: bodies of luminaires, and rooms for tests.
///
/// Each mesh has shading normals, one material and one object, both called after the shape.
/// Curved shapes are inscribed: their vertices lie on the true surface. Sizes in metres, positive.
namespace soffit::geometry {

/// A closed box from lo to hi, 12 triangles, fronts outward, each face with vertices of its own.
Mesh makeBox(const vec3& lo, const vec3& hi);

/// A closed sphere about `center`, fronts outward, of `bands` >= 2 bands of latitude about z with
/// 2 bands columns each. The volume falls short by 5 pi^2 / (12 bands^2) = 4.1 / bands^2 of it.
Mesh makeSphere(const vec3& center, float radius, int bands);

/// A tube about the x axis, centered on the origin: `columns` >= 3 flat faces, fronts outward,
/// with ends closed if `closed`.
Mesh makeTube(float length, float radius, int columns, bool closed);

/// A disk in the xy plane about the origin, front to +z, a fan of `columns` >= 3 triangles.
Mesh makeDisk(float radius, int columns);

/// A rectangle in the xy plane, centered on the origin, front to +z, 2 nx ny triangles;
/// nx, ny >= 1 cells along x and y.
Mesh makeRectangle(float size_x, float size_y, int nx = 1, int ny = 1);

}  // namespace soffit::geometry
