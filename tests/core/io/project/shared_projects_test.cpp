// SPDX-License-Identifier: MIT
#include "core/io/project/csv.h"
#include "core/io/project/import_project.h"
#include "core/io/project/project.h"
#include "tests/core/io/project/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <variant>

namespace soffit::io {
namespace {

const std::filesystem::path kShared = SOFFIT_SHARED_DIR;

TEST(SharedProjects, TheReferenceScenesLoad) {
  const auto cornell = loadProject(kShared / "reference/cornell");
  ASSERT_TRUE(cornell) << cornell.error().message();
  EXPECT_EQ(cornell->scene.mesh->triangleCount(), 36U);
  ASSERT_EQ(cornell->scene.luminaires.size(), 1U);
  EXPECT_TRUE(cornell->scene.luminaires[0].casts_shadow);
  EXPECT_EQ(cornell->scene.luminaires[0].flux, 3500.0);
  const auto flat = loadProject(kShared / "reference/flat/flat.soffit");
  ASSERT_TRUE(flat) << flat.error().message();
  EXPECT_EQ(flat->scene.mesh->triangleCount(), 184U);
}

TEST(SharedProjects, TheirPointsLoad) {
  const auto sensors = readSensors(kShared / "reference/cornell/sensors.csv");
  ASSERT_TRUE(sensors) << sensors.error().message();
  EXPECT_EQ(sensors->size(), 600U);
  const auto path = readPath(kShared / "reference/flat/path.csv");
  ASSERT_TRUE(path) << path.error().message();
  EXPECT_EQ(path->size(), 10U);
}

TEST(SharedProjects, TheHouseIsImportedWithACameraInside) {
  const TemporaryFolder folder;
  const auto made = importProject(kShared / "models/Ifc2x3_Duplex_Architecture.ifc",
                                  folder.path() / "house.soffit", {});
  ASSERT_TRUE(made) << made.error().message();
  const auto house = loadProject(folder.path());
  ASSERT_TRUE(house) << house.error().message();
  EXPECT_GT(house->scene.mesh->triangleCount(), 10000U);
  const Box bounds = house->scene.mesh->bounds();
  const dvec3 eye = house->scene.cameras.at(0).position - house->scene.mesh->origin;
  EXPECT_TRUE(bounds.contains(vec3(eye)));
  EXPECT_EQ(house->scene.work_planes.size(), 14U);  // one a room
}

}  // namespace
}  // namespace soffit::io
