// SPDX-License-Identifier: MIT
#include "tests/core/relight/rooms.h"

#include <algorithm>

namespace soffit::relight {
namespace {

using namespace testing;

/// Area mean of the total over what takes part in the bounce.
double areaMean(const Lighting& lighting) {
  const Planes total = lighting.total();
  const transfer::Operators& op = lighting.solver().operators();
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t s = 0; s < op.area.size(); ++s) {
    sum += static_cast<double>(op.area[s]) * luminance(total, s);
    area += static_cast<double>(op.area[s]);
  }
  return sum / area;
}

class ClosedRoom : public ::testing::TestWithParam<double> {};

TEST_P(ClosedRoom, MeanIlluminanceIsFluxOverAbsorbingArea) {
  const double rho = GetParam();
  auto mesh = emptyMesh();
  addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
  const auto solver = solverFor(mesh, {dvec3(rho)});
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{panel({2.1, 2.7, 1.6})}).ok());
  const double surface = 2 * (4 * 5 + 4 * 3 + 5 * 3);
  const double expected = 1000.0 / (surface * (1.0 - rho));
  // The bounces conserve energy to rounding; what is left is the midpoint rule of 4000 texels for
  // the direct light (cells of 15 cm at 1.4 m and more: h^2/d^2/24), amplified alike.
  EXPECT_NEAR(areaMean(lighting) / expected, 1.0, 5e-4) << "rho " << rho;
}

INSTANTIATE_TEST_SUITE_P(Reflectances, ClosedRoom, ::testing::Values(0.0, 0.3, 0.7, 0.9));

TEST(Energy, AClosedRoomWithASolidInItConservesToo) {
  auto mesh = emptyMesh();
  addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
  addBox(*mesh, {1, 1, 0.4F}, {2, 2.2F, 1.3F}, false, 0);
  const auto solver = solverFor(mesh, {dvec3(0.6)});
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{panel({2.6, 3.0, 2.3})}).ok());
  const double surface = 2 * (4 * 5 + 4 * 3 + 5 * 3) + 2 * (1 * 1.2 + 1 * 0.9 + 1.2 * 0.9);
  // As above, plus shadow edges that cross texels: their share of the flux is a random 1e-3.
  EXPECT_NEAR(areaMean(lighting) * surface * 0.4 / 1000.0, 1.0, 2e-3);
}

TEST(Energy, BlackRoomHasDirectLightOnly) {
  auto mesh = emptyMesh();
  addBox(*mesh, {0, 0, 0}, {3, 3, 3}, true, 0);
  const auto solver = solverFor(mesh, {dvec3(0.0)});
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{panel({1.5, 1.5, 2.5})}).ok());
  for (const auto& plane : lighting.indirectTotal()) {
    for (const float e : plane) ASSERT_EQ(e, 0.0F);
  }
}

TEST(Energy, TwoRoomsWithAShutDoorShareNothing) {
  auto mesh = emptyMesh();
  addBox(*mesh, {0, 0, 0}, {3, 3, 2.5F}, true, 0);
  addBox(*mesh, {3.2F, 0, 0}, {6, 3, 2.5F}, true, 0);
  const auto solver = solverFor(mesh, {dvec3(0.8)}, quickSettings(), {{1, 1, 1}, {4, 1, 1}});
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{panel({1.5, 1.5, 2.4})}).ok());
  const Planes total = lighting.total();
  const transfer::Texels& texels = solver->operators().texels;
  double lit = 0.0;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    if (texels.receivers.x[s] > 3.1F) {
      ASSERT_EQ(luminance(total, s), 0.0) << s;
    } else {
      lit = std::max(lit, luminance(total, s));
    }
  }
  EXPECT_GT(lit, 10.0);
}

}  // namespace
}  // namespace soffit::relight
