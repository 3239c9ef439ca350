// SPDX-License-Identifier: MIT
// What files bring along must not change the light: triangles without area, the same triangle
// twice, faces in one plane.
#include "core/geometry/cleaning.h"
#include "tests/core/relight/readings.h"

#include <limits>

namespace soffit::relight {
namespace {

using namespace testing;

constexpr double kRho = 0.6;

const std::vector<light::Luminaire> kLamp = {panel({2.6, 2.9, 2.6})};

const Readings& ordinary() {
  static const Readings readings =
      readIn(solverFor(blockRoom(), {dvec3(kRho)}, fineSettings()), kLamp, blockRoomSensors());
  return readings;
}

// A texel more or less changes the random rays of all that follow: the noise of a bounce with 4000
// texels and 4096 rays a sensor.
constexpr double kOtherRays = 6e-3;

void expectAsOrdinary(const std::shared_ptr<geometry::Mesh>& mesh, double direct_tolerance = 0.0) {
  const Readings found = readIn(solverFor(mesh, {dvec3(kRho)}, fineSettings()), kLamp, blockRoomSensors());
  EXPECT_LE(relativeRms(found.direct, ordinary().direct), direct_tolerance);
  EXPECT_LT(relativeRms(found.indirect, ordinary().indirect), kOtherRays);
}

void addTriangle(geometry::Mesh& mesh, const vec3& a, const vec3& b, const vec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.triangles.push_back(uvec3(0, 1, 2) + first);
  mesh.material_of.push_back(0);
  mesh.object_of.push_back(0);
}

TEST(DamagedMesh, TrianglesWithoutAreaDoNothing) {
  auto mesh = blockRoom();
  for (int i = 0; i < 20; ++i) {
    const vec3 p(0.1F + 0.18F * static_cast<float>(i), 3.0F, 1.8F);
    addTriangle(*mesh, p, p, p);                                            // a point
    addTriangle(*mesh, p, p + vec3(0, 1, 0), p);                            // two corners in one
    addTriangle(*mesh, p, p + vec3(0, 0.5F, 0.25F), p + vec3(0, 1, 0.5F));  // on a line
  }
  expectAsOrdinary(mesh);
}

TEST(DamagedMesh, AfterCleaningItIsTheSameRoom) {
  const auto room = blockRoom();
  geometry::RawMesh raw;
  for (const vec3& p : room->positions) raw.positions.emplace_back(p);
  raw.triangles = room->triangles;
  raw.material_of = room->material_of;
  raw.object_of = room->object_of;
  raw.materials = room->materials;
  raw.objects = room->objects;
  const auto add = [&](const uvec3& t) {
    raw.triangles.push_back(t);
    raw.material_of.push_back(0);
    raw.object_of.push_back(0);
  };
  const std::size_t whole = room->triangles.size();
  for (std::size_t i = 0; i < whole; ++i) {
    const uvec3 t = raw.triangles[i];
    add(t);                // everything twice
    add({t.y, t.z, t.x});  // and a third time, from another corner on
    add({t.x, t.x, t.z});  // without area
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  raw.positions.emplace_back(nan, 0, 0);
  raw.positions.emplace_back(std::numeric_limits<double>::infinity(), 0, 0);
  add({0, 1, static_cast<std::uint32_t>(raw.positions.size() - 1)});
  add({0, 1, static_cast<std::uint32_t>(raw.positions.size() - 2)});
  auto cleaned = geometry::cleanMesh(raw);
  EXPECT_EQ(cleaned.report.triangles_out, whole);
  expectAsOrdinary(std::make_shared<geometry::Mesh>(std::move(cleaned.mesh)));
}

TEST(DamagedMesh, ABlockInManySmallTrianglesIsTheSameBlock) {
  // The ceiling again as 800 triangles: coplanar ones are one chart.
  auto mesh = emptyMesh();
  addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
  mesh->triangles.erase(mesh->triangles.begin() + 2, mesh->triangles.begin() + 4);
  mesh->material_of.resize(mesh->triangles.size());
  mesh->object_of.resize(mesh->triangles.size());
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 20; ++i) {
      const auto at = [&](int a, int b) {
        return vec3(4.0F * static_cast<float>(a) / 20, 5.0F * static_cast<float>(b) / 20, 3.0F);
      };
      addQuad(*mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j), 0);
    }
  }
  addBox(*mesh, {1, 1, 0.3F}, {2, 2.2F, 1.3F}, false, 0);
  // Its outline's corners no longer meet those of the walls: shadows at the seams by a bit of a
  // mask.
  expectAsOrdinary(mesh, 1.0 / 512);
}

/// A room with a cabinet that stands on the floor; the difference is how the touching faces lie.
Readings withCabinet(float sunk) {
  auto mesh = blockRoom();
  addBox(*mesh, {2.5F, 3.5F, -sunk}, {3.3F, 4.3F, 0.8F}, false, 0);
  return readIn(solverFor(mesh, {dvec3(kRho)}, fineSettings()), kLamp, blockRoomSensors());
}

TEST(CoincidentFaces, AFootInTheFloorsPlaneIsLikeOneThatSinksIn) {
  const Readings sunk = withCabinet(0.002F);
  const Readings flush = withCabinet(0.0F);
  EXPECT_LT(relativeRms(flush.direct, sunk.direct), 1e-6);
  EXPECT_LT(relativeRms(flush.indirect, sunk.indirect), kOtherRays);
}

TEST(CoincidentFaces, TwoBoxesSideBySideAreOne) {
  const auto boxes = [](bool split) {
    auto mesh = blockRoom();
    if (split) {
      addBox(*mesh, {2.4F, 3.2F, -0.002F}, {2.9F, 4.4F, 0.8F}, false, 0);
      addBox(*mesh, {2.9F, 3.2F, -0.002F}, {3.4F, 4.4F, 0.8F}, false, 0);
    } else {
      addBox(*mesh, {2.4F, 3.2F, -0.002F}, {3.4F, 4.4F, 0.8F}, false, 0);
    }
    return readIn(solverFor(mesh, {dvec3(kRho)}, fineSettings()), kLamp, blockRoomSensors());
  };
  const Readings one = boxes(false);
  const Readings two = boxes(true);
  EXPECT_LT(relativeRms(two.direct, one.direct), 1.0 / 512);
  EXPECT_LT(relativeRms(two.indirect, one.indirect), kOtherRays);
}

TEST(CoincidentFaces, ASheetOnTheWallIsTheWall) {
  // A picture without thickness in the plane of the wall x = 0, as dark or bright as the wall.
  auto mesh = blockRoom();
  addQuad(*mesh, {0, 2, 1}, {0, 3.2F, 1}, {0, 3.2F, 2}, {0, 2, 2}, 0);
  const Readings found = readIn(solverFor(mesh, {dvec3(kRho)}, fineSettings()), kLamp, blockRoomSensors());
  EXPECT_LT(relativeRms(found.direct, ordinary().direct), 1e-6);
  EXPECT_LT(relativeRms(found.indirect, ordinary().indirect), kOtherRays);
}

}  // namespace
}  // namespace soffit::relight
