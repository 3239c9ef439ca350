// SPDX-License-Identifier: MIT
// The same room at other sizes and places, and things a million times smaller than it.
#include "tests/core/relight/readings.h"

namespace soffit::relight {
namespace {

using namespace testing;

constexpr double kRho = 0.6;

light::Luminaire lamp(double scale = 1.0, const dvec3& shift = dvec3(0.0)) {
  light::Luminaire l = panel(scale * dvec3(2.6, 2.9, 2.6) + shift);
  l.scale = scale;
  l.rotation_deg = {10, -15, 20};
  return l;
}

std::vector<scene::Sensor> sensorsAt(double scale, const dvec3& shift = dvec3(0.0)) {
  std::vector<scene::Sensor> sensors = blockRoomSensors();
  for (scene::Sensor& s : sensors) s.position = scale * s.position + shift;
  return sensors;
}

std::shared_ptr<geometry::Mesh> scaledRoom(float scale) {
  auto mesh = blockRoom();
  for (vec3& p : mesh->positions) p *= scale;
  return mesh;
}

const Readings& ordinary() {
  static const Readings readings =
      readIn(solverFor(blockRoom(), {dvec3(kRho)}, fineSettings()), {lamp()}, sensorsAt(1.0));
  return readings;
}

class Scale : public ::testing::TestWithParam<double> {};

TEST_P(Scale, LuxGoesWithTheInverseSquare) {
  const double scale = GetParam();
  auto settings = fineSettings();
  settings.least_cell *= scale;  // the wish for cells of 3 cm means something else here
  const auto solver = solverFor(scaledRoom(static_cast<float>(scale)), {dvec3(kRho)}, settings);
  const Readings found = readIn(solver, {lamp(scale)}, sensorsAt(scale));
  // Shapes and rays are the same up to rounding, which may turn a bit of a mask (1/512 of a
  // sensor's light) at a shadow's edge, and put some rays of the bounce on the other side of an
  // edge.
  EXPECT_LT(relativeRms(found.direct, ordinary().direct, scale * scale), 1.0 / 512);
  EXPECT_LT(relativeRms(found.indirect, ordinary().indirect, scale * scale), 5e-3);
}

// 4 mm and 4 cm (a file in metres that was meant in millimetres), 4 km (the other way round).
INSTANTIATE_TEST_SUITE_P(Sizes, Scale, ::testing::Values(0.001, 0.01, 30.0, 1000.0));

TEST(FarOut, TenKilometresFromTheZeroWithAnOriginNothingChanges) {
  const dvec3 far(7000.0, -7000.0, 120.0);
  auto mesh = blockRoom();
  mesh->origin = far;  // as the importers set it (frame_origin.h)
  const auto solver = solverFor(mesh, {dvec3(kRho)}, fineSettings());
  const Readings found = readIn(solver, {lamp(1.0, far)}, sensorsAt(1.0, far));
  // Positions differ by the rounding of 10 km in double precision.
  EXPECT_LT(relativeRms(found.direct, ordinary().direct), 1e-6);
  EXPECT_LT(relativeRms(found.indirect, ordinary().indirect), 1e-6);
}

TEST(FarOut, TenKilometresFromTheZeroInSinglePrecision) {
  // Without an origin, as it has to be when a site plan reaches from the zero to the building.
  const dvec3 far(7000.0, -7000.0, 0.0);
  auto mesh = blockRoom();
  transform(*mesh, dmat3(1.0), far);
  const Readings found =
      readIn(solverFor(mesh, {dvec3(kRho)}, fineSettings()), {lamp(1.0, far)}, sensorsAt(1.0, far));
  // Corners, sensors and texels are rounded to 0.5 mm there: at the metre between light and sensor
  // a thousandth, and as much of a shadow's edge. Where rays start is rounded as coarsely, which
  // costs the bounce some per cent at edges (measured: 2 %).
  EXPECT_LT(relativeRms(found.direct, ordinary().direct), 3e-3);
  EXPECT_LT(relativeRms(found.indirect, ordinary().indirect), 0.03);
}

/// How far the readings are from the ordinary room's when `change` is made to its mesh.
template <class Change>
dvec2 after(const Change& change) {
  auto mesh = blockRoom();
  change(*mesh);
  const Readings found = readIn(solverFor(mesh, {dvec3(kRho)}, fineSettings()), {lamp()}, sensorsAt(1.0));
  for (const double e : found.indirect) EXPECT_TRUE(std::isfinite(e));
  return {relativeRms(found.direct, ordinary().direct),
          relativeRms(found.indirect, ordinary().indirect)};
}

// The bake's random numbers go by texel, so that one texel more changes the rays of all that
// follow: the bounce may differ by the noise of 7000 texels and 4096 rays, some parts in a
// thousand.
constexpr double kOtherRays = 6e-3;

TEST(SizeRatio, ABoltOfFiveMicrometresInFiveMetres) {
  const dvec2 off = after([](geometry::Mesh& mesh) {
    const vec3 p(2.6F, 3.0F, 1.0F);
    addBox(mesh, p, p + vec3(5e-6F), false, 0);
  });
  EXPECT_EQ(off.x, 0.0);
  EXPECT_LT(off.y, kOtherRays);
}

TEST(SizeRatio, ManyOfThem) {
  const dvec2 off = after([](geometry::Mesh& mesh) {
    for (int i = 0; i < 200; ++i) {
      const vec3 p(0.2F + 0.017F * static_cast<float>(i), 3.0F,
                   0.5F + 0.003F * static_cast<float>(i));
      addBox(mesh, p, p + vec3(1e-5F), false, 0);
    }
  });
  EXPECT_EQ(off.x, 0.0);
  EXPECT_LT(off.y, kOtherRays);
}

TEST(SizeRatio, ASliverFourMetresLongAndAMicrometreWide) {
  const dvec2 off = after([](geometry::Mesh& mesh) {
    addQuad(mesh, {0.1F, 3.0F, 2.0F}, {3.9F, 3.0F, 2.0F}, {3.9F, 3.000001F, 2.0F},
            {0.1F, 3.000001F, 2.0F}, 0);
  });
  // It hides 1e-6 / 0.6 of the light at most.
  EXPECT_LT(off.x, 1e-5);
  EXPECT_LT(off.y, kOtherRays);
}

TEST(SizeRatio, ARoomOverAPlainOfAHundredKilometres) {
  const dvec2 off = after([](geometry::Mesh& mesh) {
    addQuad(mesh, {-5e4F, -5e4F, -0.3F}, {5e4F, -5e4F, -0.3F}, {5e4F, 5e4F, -0.3F},
            {-5e4F, 5e4F, -0.3F}, 0);
  });
  // Direct light is as it was. The bounce is not asked for: texels go by area, and the plain has it
  // all.
  EXPECT_LT(off.x, 1e-5);
}

}  // namespace
}  // namespace soffit::relight
