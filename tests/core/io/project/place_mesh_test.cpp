// SPDX-License-Identifier: MIT
#include "core/io/project/place_mesh.h"

#include <gtest/gtest.h>

namespace soffit::io {
namespace {

geometry::Mesh corner() {
  geometry::Mesh mesh;
  mesh.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(PlaceMesh, ScalesThenTurnsThenMoves) {
  GeometryEntry entry;
  entry.scale = 2.0;
  entry.rotate_deg = {0, 0, 90};
  entry.translate = {10, 20, 30};
  const geometry::Mesh placed = placeMesh(corner(), entry);
  // Multiples of 90 degrees are exact.
  EXPECT_EQ(placed.origin + dvec3(placed.positions[0]), dvec3(10, 22, 30));
  EXPECT_EQ(placed.origin + dvec3(placed.positions[1]), dvec3(8, 20, 30));
  EXPECT_EQ(placed.origin + dvec3(placed.positions[2]), dvec3(10, 20, 32));
  EXPECT_EQ(placed.normals[0], vec3(0, 1, 0));
}

TEST(PlaceMesh, RotationsAreAboutFixedAxesInTheOrderXyz) {
  GeometryEntry entry;
  entry.rotate_deg = {90, 0, 90};  // y to z, and there the turn about z leaves it
  EXPECT_EQ(placeMesh(corner(), entry).positions[1], vec3(0, 0, 1));
  entry.rotate_deg = {0, -90, 0};  // down to +x: what the convention says of luminaires
  EXPECT_EQ(placeMesh(corner(), entry).positions[2], vec3(-1, 0, 0));
}

TEST(PlaceMesh, FarFromTheOriginMillimetresStay) {
  geometry::Mesh mesh = corner();
  mesh.origin = {500000, 5000000, 100};
  mesh.positions[0] = {0.001F, 0.002F, 0.003F};
  GeometryEntry entry;
  entry.translate = {-500000, -5000000, 0};
  const geometry::Mesh placed = placeMesh(mesh, entry);
  EXPECT_EQ(placed.origin, dvec3(0, 0, 100));
  EXPECT_EQ(placed.positions[0], mesh.positions[0]);
}

}  // namespace
}  // namespace soffit::io
