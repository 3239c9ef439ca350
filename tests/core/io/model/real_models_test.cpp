// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "core/geometry/components.h"
#include "core/io/model/model_import.h"
#include "tests/core/io/model/scratch_folder.h"

/// Models from elsewhere, read from ../shared.
namespace soffit::io {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ImportedModel shared(const std::string& name, const ImportOptions& options = {}) {
  auto model = importModel(std::filesystem::path(SOFFIT_SHARED_DIR) / name, options);
  EXPECT_TRUE(model) << (model ? "" : model.error().message());
  return model ? *std::move(model) : ImportedModel{};
}

const std::string kHouse = "models/Ifc2x3_Duplex_Architecture.ifc";

TEST(RealModels, TheDuplexHouseStandsUprightInMetres) {
  const ImportedModel house = shared(kHouse);
  EXPECT_GT(house.mesh.triangles.size(), 20000U);
  const Box box = house.mesh.bounds();
  // By its storeys: foundation at -1.25 m, floors at 0 and 3.1 m, roof from 6.0 m on.
  EXPECT_GT(box.lo.z, -2.0F);
  EXPECT_LT(box.lo.z, -1.25F);
  EXPECT_GT(box.hi.z, 6.0F);
  EXPECT_LT(box.hi.z, 7.0F);
  EXPECT_GT(box.size().x, 8.0F);
  EXPECT_LT(box.size().x, 10.0F);
  EXPECT_GT(box.size().y, 17.0F);
  EXPECT_LT(box.size().y, 28.0F);
  EXPECT_THAT(house.mesh.materials, Contains("Wood-Flooring"));
  EXPECT_THAT(house.mesh.objects, Contains(HasSubstr("IfcWallStandardCase")));
  for (std::size_t i = 0; i < house.materials.size(); ++i) {
    const bool glass = house.materials[i].name.find("Glass") != std::string::npos;
    EXPECT_EQ(house.materials[i].glass.has_value(), glass) << house.materials[i].name;
    EXPECT_EQ(house.described[i], house.materials[i].name != "default");
  }
}

TEST(RealModels, TheDuplexHouseHasALevelFloorOnEitherStorey) {
  const ImportedModel house = shared(kHouse);
  double ground = 0.0;
  double upper = 0.0;
  for (const uvec3& t : house.mesh.triangles) {
    const vec3 a = house.mesh.positions[t.x];
    const vec3 n = glm::cross(house.mesh.positions[t.y] - a, house.mesh.positions[t.z] - a);
    if (std::abs(n.z) < 0.999F * glm::length(n)) continue;
    const double area = 0.5 * double{glm::length(n)};
    if (std::abs(a.z) < 0.02F) ground += area;
    if (std::abs(a.z - 3.1F) < 0.02F) upper += area;
  }
  EXPECT_GT(ground, 100.0);  // the footprint is about 9 x 18 m
  EXPECT_GT(upper, 80.0);
}

TEST(RealModels, MostBodiesOfTheDuplexHouseAreSolids) {
  const ImportedModel house = shared(kHouse);
  EXPECT_GT(house.cleaning.turned, 1000U);  // the file mixes windings
  const geometry::Components parts = geometry::findComponents(house.mesh);
  std::size_t solids = 0;
  for (const geometry::Component& part : parts.list) {
    if (part.solid() && part.outward()) ++solids;
  }
  EXPECT_GT(solids, 550U);
  EXPECT_GT(2 * solids, parts.list.size());
}

TEST(RealModels, AnIfcFileInMillimetresIsAThousandTimesSmaller) {
  std::ifstream in(std::filesystem::path(SOFFIT_SHARED_DIR) / kHouse, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string millimetres =
      std::regex_replace(text, std::regex(R"(LENGTHUNIT\.,\$)"), "LENGTHUNIT.,.MILLI.");
  ASSERT_NE(text, millimetres);
  const ScratchFolder folder;
  const auto small = importModel(folder.write("a.ifc", millimetres), {.unit = 1000.0});
  ASSERT_TRUE(small) << small.error().message();
  const Box box = small->mesh.bounds();
  const Box expected = shared(kHouse).mesh.bounds();
  // Round-off: the importer computes in single precision after scaling.
  EXPECT_LT(glm::distance(box.lo, expected.lo), 1e-4F);
  EXPECT_LT(glm::distance(box.hi, expected.hi), 1e-4F);
}

TEST(RealModels, SpotIsOneSolid) {
  const ImportedModel spot = shared("models/spot.obj", {.up = 'y'});
  EXPECT_EQ(spot.mesh.triangles.size(), 5856U);
  EXPECT_EQ(spot.cleaning.dropped(), 0U);
  EXPECT_EQ(spot.mesh.uvs.size(), spot.mesh.positions.size());
  const geometry::Components parts = geometry::findComponents(spot.mesh);
  ASSERT_EQ(parts.list.size(), 1U);
  EXPECT_TRUE(parts.list[0].solid());
  EXPECT_TRUE(parts.list[0].outward());
  EXPECT_TRUE(geometry::contains(spot.mesh, parts.list[0], {0, 0, 0}));
}

TEST(RealModels, TheBunnyIsOnePieceWithHolesBelow) {
  const ImportedModel bunny = shared("models/stanford-bunny.obj", {.unit = 10.0, .up = 'y'});
  EXPECT_EQ(bunny.mesh.triangles.size(), 69451U);
  EXPECT_EQ(bunny.cleaning.made_normals, 69451U);
  const geometry::Components parts = geometry::findComponents(bunny.mesh);
  EXPECT_EQ(parts.list.size(), 1U);
  EXPECT_FALSE(parts.list[0].closed);
  EXPECT_NEAR(bunny.mesh.bounds().size().z, 1.543, 0.001);  // the scan's 0.1543, measured
}

TEST(RealModels, TheTeapotHasNoUnitAndStandsOnItsBottom) {
  const ImportedModel teapot = shared("models/teapot.obj", {.up = 'y'});
  EXPECT_EQ(teapot.mesh.triangles.size(), 6320U);
  EXPECT_EQ(teapot.mesh.bounds().lo.z, 0.0F);
  EXPECT_EQ(geometry::findComponents(teapot.mesh).list.size(), 4U);  // body, lid, handle, spout
}

TEST(RealModels, TheReferenceRoomHasItsMaterials) {
  const ImportedModel room = shared("reference/cornell/cornell.obj");
  EXPECT_EQ(room.mesh.triangles.size(), 36U);
  EXPECT_THAT(room.mesh.materials,
              ElementsAre("floor", "ceiling", "wall", "wallW", "wallE", "block", "block2"));
  EXPECT_NEAR(room.materials.at(3).diffuse.x, 0.6, 1e-7);  // round-off of single precision
  EXPECT_TRUE(room.warnings.empty());
  const geometry::Components parts = geometry::findComponents(room.mesh);
  ASSERT_EQ(parts.list.size(), 3U);  // the room's shell, seen from within, and two blocks
  EXPECT_FALSE(parts.list[0].outward());
  EXPECT_TRUE(parts.list[1].outward());
}

}  // namespace
}  // namespace soffit::io
