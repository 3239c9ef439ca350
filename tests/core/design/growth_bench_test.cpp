// SPDX-License-Identifier: MIT
#include "core/design/growth_bench.h"

#include "core/design/growth_room.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::design {
namespace {

TEST(GrowthRoom, HasAboutTheTrianglesThatAreAskedFor) {
  for (const std::size_t wanted : {1000U, 10000U, 100000U}) {
    const scene::Scene room = growthRoom(wanted, 12);
    const auto found = static_cast<double>(room.mesh->triangleCount());
    EXPECT_NEAR(found / static_cast<double>(wanted), 1.0, 0.2) << wanted;
    EXPECT_EQ(room.luminaires.size(), 12U);
  }
}

TEST(GrowthRoom, LuminairesHangInTheRoomAndShareTheFlux) {
  for (const std::size_t count : {1U, 7U, 1000U}) {
    const scene::Scene room = growthRoom(1000, count);
    double flux = 0.0;
    for (const light::Luminaire& l : room.luminaires) {
      flux += *l.flux;
      EXPECT_GT(l.position.x, 0.0);
      EXPECT_LT(l.position.x, 16.0);
      EXPECT_GT(l.position.y, 0.0);
      EXPECT_LT(l.position.y, 12.0);
    }
    EXPECT_NEAR(flux, 60000.0, 1.0e-6);
  }
}

TEST(GrowthBench, MeasuresBothTasks) {
  GrowthOptions options;
  options.most_triangles = 1000;
  options.most_luminaires = 10;
  options.quality = "draft";
  options.moves = 3;
  const auto rows = measureGrowth(options, {});
  ASSERT_TRUE(rows.ok()) << rows.error().message();
  ASSERT_EQ(rows->size(), 3U);
  for (const GrowthRow& row : *rows) {
    EXPECT_GT(row.texels, 1000U);
    EXPECT_GT(row.move_ms, 0.0);
    EXPECT_GT(row.all_ms, 0.0);
  }
  EXPECT_GT(rows->front().bake_s, 0.0);
  const auto exponents = growthExponents(*rows);
  EXPECT_EQ(exponents.size(), 4U) << "of luminaires alone: one room of triangles has none";
}

TEST(GrowthBench, FindsTheExponentOfAPowerLaw) {
  std::vector<GrowthRow> rows;
  for (const std::size_t n : {1000U, 10000U, 100000U}) {
    GrowthRow row;
    row.task = "triangles";
    row.triangles = n;
    row.bake_s = 3.0 * std::pow(static_cast<double>(n), 0.7);
    rows.push_back(row);
  }
  const auto exponents = growthExponents(rows);
  ASSERT_EQ(exponents.size(), 1U);
  EXPECT_EQ(exponents.front().figure, "bake_s");
  EXPECT_NEAR(exponents.front().exponent, 0.7, 1.0e-9);
}

}  // namespace
}  // namespace soffit::design
