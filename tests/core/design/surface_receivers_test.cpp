// SPDX-License-Identifier: MIT
#include "core/design/surface_receivers.h"

#include "tests/core/design/scenes.h"

#include <algorithm>
#include <cmath>

namespace soffit::design {
namespace {

using namespace testing;

TEST(DrawReceivers, IsUniformByArea) {
  const scene::Scene scene = blockRoom();
  const auto solver = solverOf(scene);
  constexpr std::size_t kCount = 4000;
  const auto receivers = drawReceivers(*solver, kCount, 1);
  ASSERT_EQ(receivers.size(), kCount);
  // Floor: 4 x 5 of 2 (4*5 + 4*3 + 5*3) = 94 m^2 of room; the block has 2 (1.2 + 1 + 1.2) = 6.8.
  const auto on_floor = std::count_if(receivers.begin(), receivers.end(),
                                      [](const auto& r) { return std::abs(r.position.z) < 1e-6; });
  const double share = 20.0 / (94.0 + 6.8);
  // Statistical: 4 sigma of a binomial count, 6e-5 of false alarms.
  const double sigma = std::sqrt(share * (1.0 - share) / kCount);
  EXPECT_NEAR(static_cast<double>(on_floor) / kCount, share, 4.0 * sigma);
}

TEST(DrawReceivers, LooksIntoTheRoomAndOutOfSolids) {
  const scene::Scene scene = blockRoom();
  const auto solver = solverOf(scene);
  for (const SurfaceReceiver& r : drawReceivers(*solver, 500, 2)) {
    const dvec3 p = r.position + 0.01 * r.normal;
    EXPECT_TRUE(p.x > 0 && p.x < 4 && p.y > 0 && p.y < 5 && p.z > 0 && p.z < 3);
    EXPECT_FALSE(p.x > 1 && p.x < 2 && p.y > 1 && p.y < 2.2 && p.z > 0.3 && p.z < 1.3);
    EXPECT_NEAR(glm::length(r.normal), 1.0, 1e-12);
  }
}

TEST(DrawReceivers, LeavesOutWhatStandsUnderMatter) {
  // A cabinet that sinks 2 mm into the floor: nobody sees the floor beneath it.
  scene::Scene scene = blockRoom();
  auto mesh = std::make_shared<geometry::Mesh>(*scene.mesh);
  relight::testing::addBox(*mesh, {2.4F, 3.1F, -0.002F}, {3.37F, 4.46F, 0.9F}, false, 0);
  scene.mesh = mesh;
  constexpr std::size_t kCount = 4000;
  const auto receivers = drawReceivers(*solverOf(scene), kCount, 1);
  ASSERT_EQ(receivers.size(), kCount);
  int floor = 0;
  int top = 0;
  for (const SurfaceReceiver& r : receivers) {
    const bool over =
        r.position.x > 2.4 && r.position.x < 3.37 && r.position.y > 3.1 && r.position.y < 4.46;
    if (std::abs(r.position.z) < 1e-3 && r.normal.z > 0) {
      ++floor;
      EXPECT_FALSE(over) << r.position.x << ' ' << r.position.y;
    }
    top += over && std::abs(r.position.z - 0.9) < 1e-3 ? 1 : 0;
  }
  // What is left is still uniform by area: the floor without the footprint against the top.
  const double footprint = 0.97 * 1.36;
  const double share = footprint / (20.0 - footprint + footprint);
  const double sigma = std::sqrt(share * (1.0 - share) / (floor + top));
  // Statistical: 4 sigma of a binomial count, 6e-5 of false alarms.
  EXPECT_NEAR(static_cast<double>(top) / (floor + top), share, 4.0 * sigma);
}

TEST(DrawReceivers, KeepsTheFloorUnderATable) {
  // Dark, but seen: a table of 5 cm thickness, 70 cm above.
  scene::Scene scene = blockRoom();
  auto mesh = std::make_shared<geometry::Mesh>(*scene.mesh);
  relight::testing::addBox(*mesh, {2.4F, 3.1F, 0.7F}, {3.4F, 4.4F, 0.75F}, false, 0);
  scene.mesh = mesh;
  const auto receivers = drawReceivers(*solverOf(scene), 2000, 1);
  const auto below =
      std::count_if(receivers.begin(), receivers.end(), [](const SurfaceReceiver& r) {
        return std::abs(r.position.z) < 1e-3 && r.position.x > 2.4 && r.position.x < 3.4 &&
               r.position.y > 3.1 && r.position.y < 4.4;
      });
  EXPECT_GT(below, 10);  // 1.3 of 105 m^2: 25 expected
}

TEST(DrawReceivers, DependsOnTheSeedAlone) {
  const auto solver = solverOf(blockRoom());
  const auto a = drawReceivers(*solver, 50, 3);
  const auto b = drawReceivers(*solver, 50, 3);
  const auto c = drawReceivers(*solver, 50, 4);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(),
                         [](const auto& x, const auto& y) { return x.position == y.position; }));
  EXPECT_NE(a[0].position, c[0].position);
}

TEST(DrawReceivers, IsEmptyWithoutGeometry) {
  scene::Scene scene = blockRoom();
  scene.mesh = std::make_shared<geometry::Mesh>();
  EXPECT_TRUE(drawReceivers(*solverOf(scene), 10, 1).empty());
}

TEST(LitReceivers, KeepsWhatTheReferenceLights) {
  const auto solver = solverOf(blockRoom());
  const auto receivers = drawReceivers(*solver, 40, 1);
  const auto every_other = [](std::span<const SurfaceReceiver> all) {
    std::vector<bool> lit(all.size());
    for (std::size_t i = 0; i < all.size(); i += 2) lit[i] = true;
    return lit;
  };
  const auto kept = litReceivers(receivers, 1000, every_other);
  ASSERT_EQ(kept.size(), (receivers.size() + 1) / 2);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].position, receivers[2 * i].position);
  EXPECT_EQ(litReceivers(receivers, 3, every_other).size(), 3U);
}

TEST(ToSensor, StandsInTheWorld) {
  SurfaceReceiver r;
  r.position = {1, 2, 3};
  r.normal = {0, 1, 0};
  const scene::Sensor s = toSensor(r, {1e6, 0, -5});
  EXPECT_EQ(s.position, dvec3(1000001, 2, -2));
  EXPECT_EQ(s.normal, r.normal);
}

}  // namespace
}  // namespace soffit::design
