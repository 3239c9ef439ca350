// SPDX-License-Identifier: MIT
#include "core/base/parallel.h"
#include "tests/core/relight/rooms.h"

#include <cmath>

namespace soffit::relight {
namespace {

using namespace testing;

std::shared_ptr<geometry::Mesh> furnishedRoom() {
  auto mesh = emptyMesh();
  mesh->materials = {"walls", "red"};
  addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
  addBox(*mesh, {1, 1, 0.3F}, {2, 2.2F, 1.3F}, false, 1);
  return mesh;
}

const std::vector<dvec3> kPaint = {dvec3(0.7, 0.65, 0.6), dvec3(0.6, 0.1, 0.1)};

TEST(Lighting, IsTheSumOfItsLuminaires) {
  const auto solver = solverFor(furnishedRoom(), kPaint);
  auto a = panel({1, 1.5, 2.9});
  auto b = panel({3, 4, 2.5}, 0.4, 2500);
  b.colour.cct_k = 2700;
  Lighting both(solver);
  Lighting only_a(solver);
  Lighting only_b(solver);
  ASSERT_TRUE(both.setLuminaires(std::vector{a, b}).ok());
  ASSERT_TRUE(only_a.setLuminaires(std::vector{a}).ok());
  ASSERT_TRUE(only_b.setLuminaires(std::vector{b}).ok());
  const Planes sum = both.total();
  const Planes pa = only_a.total();
  const Planes pb = only_b.total();
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t s = 0; s < sum[c].size(); ++s) {
      // Round-off of single precision sums.
      ASSERT_NEAR(sum[c][s], pa[c][s] + pb[c][s], 1e-5F * (std::abs(sum[c][s]) + 1.0F));
    }
  }
}

TEST(Lighting, DimmingAndColourAreAMixWithoutRays) {
  const auto solver = solverFor(furnishedRoom(), kPaint);
  auto a = panel({1, 1.5, 2.9});
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{a}).ok());
  const std::uint64_t before = lighting.counts().points;
  const Planes full = lighting.total();
  lighting.setMix(0, 0.25, dvec3(1.0));
  const Planes dimmed = lighting.total();
  EXPECT_EQ(lighting.counts().points, before);
  for (std::size_t s = 0; s < full[0].size(); ++s) {
    ASSERT_NEAR(dimmed[0][s], 0.25F * full[0][s], 1e-6F * (full[0][s] + 1.0F));
  }
  // A coloured light in a coloured room: the mix equals the computation from scratch.
  a.colour.rgb = dvec3(1.0, 0.4, 0.2);
  Lighting fresh(solver);
  ASSERT_TRUE(fresh.setLuminaires(std::vector{a}).ok());
  lighting.setMix(0, 1.0, fresh.emitters()[0].color);
  const Planes mixed = lighting.total();
  const Planes expected = fresh.total();
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t s = 0; s < mixed[c].size(); ++s) ASSERT_EQ(mixed[c][s], expected[c][s]);
  }
}

TEST(Lighting, ALuminaireThatChangesItsNumberKeepsItsLight) {
  const auto solver = solverFor(furnishedRoom(), kPaint);
  auto a = panel({1, 1.5, 2.9});
  auto b = panel({3, 4, 2.5}, 0.4, 2500);
  b.casts_shadow = true;
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{a, b}).ok());
  const std::uint64_t before = lighting.counts().points;
  // Dimming a body is no reason for rays, nor is another order.
  b.dimming = 0.5;
  ASSERT_TRUE(lighting.setLuminaires(std::vector{b, a}).ok());
  EXPECT_EQ(lighting.counts().points, before);
  Lighting fresh(solver);
  ASSERT_TRUE(fresh.setLuminaires(std::vector{b, a}).ok());
  EXPECT_EQ(lighting.total(), fresh.total());
  // A body that goes changes all shadows.
  ASSERT_TRUE(lighting.setLuminaires(std::vector{a}).ok());
  EXPECT_GT(lighting.counts().points, before);
}

TEST(Lighting, OtherReflectancesKeepTheDirectLight) {
  const auto solver = solverFor(furnishedRoom(), kPaint);
  const std::vector luminaires{panel({1, 1.5, 2.9})};
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  const std::uint64_t before = lighting.counts().points;
  std::vector<scene::Material> darker(2);
  for (scene::Material& m : darker) m.diffuse = dvec3(0.2);
  const auto painted = solver->repainted(darker);
  ASSERT_TRUE(lighting.repaint(painted).ok());
  EXPECT_EQ(lighting.counts().points, before);
  Lighting fresh(painted);
  ASSERT_TRUE(fresh.setLuminaires(luminaires).ok());
  EXPECT_EQ(lighting.total(), fresh.total());
}

TEST(Lighting, OtherReflectancesAreShownAtOnce) {
  const auto solver = solverFor(furnishedRoom(), kPaint);
  std::vector luminaires{panel({1, 1.5, 2.9}), panel({3, 4, 2.5}), panel({2, 3, 2.9})};
  luminaires[1].colour.rgb = dvec3(1.0, 0.4, 0.2);
  luminaires[2].dimming = 0.3;
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  std::vector<scene::Material> darker(2);
  for (scene::Material& m : darker) m.diffuse = dvec3(0.3, 0.2, 0.1);
  const auto painted = solver->repainted(darker);
  const auto quick = lighting.totalUnder(*painted);
  ASSERT_TRUE(quick.has_value());
  ASSERT_TRUE(lighting.repaint(painted).ok());
  const Planes whole = lighting.total();
  for (std::size_t c = 0; c < 3; ++c) {
    double squares = 0.0;
    double mean = 0.0;
    for (std::size_t s = 0; s < whole[c].size(); ++s) {
      squares += std::pow((*quick)[c][s] - whole[c][s], 2.0);
      mean += whole[c][s];
    }
    const auto count = static_cast<double>(whole[c].size());
    EXPECT_LT(std::sqrt(squares / count), 1e-3 * mean / count) << c;
  }
}

TEST(Lighting, PaintThatIsGivenUpKeepsTheDirectLight) {
  const auto solver = solverFor(furnishedRoom(), kPaint);
  const std::vector luminaires{panel({1, 1.5, 2.9}), panel({3, 4, 2.5})};
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  const std::uint64_t before = lighting.counts().points;
  std::vector<scene::Material> darker(2);
  for (scene::Material& m : darker) m.diffuse = dvec3(0.2);
  const auto painted = solver->repainted(darker);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(lighting.repaint(painted, Job{nullptr, stop.get_token()}).ok());
  EXPECT_TRUE(lighting.totalUnder(*painted).has_value());
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  EXPECT_EQ(lighting.counts().points, before);
  Lighting fresh(painted);
  ASSERT_TRUE(fresh.setLuminaires(luminaires).ok());
  EXPECT_EQ(lighting.total(), fresh.total());
}

TEST(Lighting, MovingLeadsToTheSameLightAsStartingThere) {
  const auto solver = solverFor(furnishedRoom(), kPaint);
  Lighting moving(solver);
  ASSERT_TRUE(moving.setLuminaires(std::vector{panel({1, 1.5, 2.9}), panel({3, 4, 2.5})}).ok());
  moving.grab(0);
  Planes last;
  for (const double x : {1.2, 1.9, 2.6}) {
    const auto emitter = light::makeEmitter(panel({x, 1.5, 2.9}));
    ASSERT_TRUE(emitter.ok());
    moving.move(*emitter);
    last = moving.moved();
  }
  Lighting there(solver);
  ASSERT_TRUE(there.setLuminaires(std::vector{panel({2.6, 1.5, 2.9}), panel({3, 4, 2.5})}).ok());
  const Planes expected = there.total();
  for (std::size_t s = 0; s < expected[0].size(); ++s) {
    ASSERT_NEAR(last[0][s], expected[0][s], 1e-5F * (expected[0][s] + 1.0F));
  }
}

TEST(Lighting, DoesNotDependOnTheNumberOfThreads) {
  const auto run = [](int threads) {
    setThreadCount(threads);
    auto settings = quickSettings();
    settings.texels = 1500;
    const auto solver = solverFor(furnishedRoom(), kPaint, settings);
    Lighting lighting(solver);
    EXPECT_TRUE(lighting.setLuminaires(std::vector{panel({1, 1.5, 2.9})}).ok());
    return lighting.total();
  };
  const Planes one = run(1);
  const Planes three = run(3);
  setThreadCount(0);
  EXPECT_EQ(one, three);
}

TEST(Lighting, RotatingTheWholeSceneChangesNothingBeyondItsError) {
  const scene::Sensor sensor{dvec3(2.7, 3.1, 0.8), dvec3(0, 0, 1)};
  const auto reading = [&](const dmat3& turn, const dvec3& rotation_deg) {
    auto mesh = furnishedRoom();
    transform(*mesh, turn, dvec3(0));
    const auto solver = solverFor(mesh, kPaint);
    auto l = panel(turn * dvec3(1, 1.5, 2.6));
    l.rotation_deg = rotation_deg;
    Lighting lighting(solver);
    EXPECT_TRUE(lighting.setLuminaires(std::vector{l}).ok());
    const scene::Sensor turned{turn * sensor.position, turn * sensor.normal};
    const Sensors sensors(*solver, std::span(&turned, 1), Quantity::planar, 64, 1);
    const SensorLight light = lighting.read(sensors)[0];
    return dvec2(light.direct.y, light.indirect.y);
  };
  const dvec2 straight = reading(dmat3(1.0), dvec3(0));
  const dvec3 angles(20, -35, 50);
  const dvec2 turned = reading(rotationXyz(angles), angles);
  EXPECT_GT(straight.x, 1.0);
  EXPECT_NEAR(turned.x, straight.x,
              2e-5 * straight.x);  // closed form: round-off of the rotated coordinates
  EXPECT_NEAR(turned.y, straight.y,
              0.01 * straight.y);  // 4000 texels, 4096 rays: some parts in a thousand
}

TEST(Lighting, AReflectanceChangesWithoutABake) {
  const auto mesh = furnishedRoom();
  const auto scene = transfer::makeStaticScene(mesh, {});
  const auto operators = transfer::bake(*scene, quickSettings(), {}, {});
  ASSERT_TRUE(operators.ok());
  std::vector<scene::Material> dark(2);
  dark[0].diffuse = dvec3(0.3);
  dark[1].diffuse = dvec3(0.3);
  std::vector<scene::Material> bright = dark;
  bright[0].diffuse = dvec3(0.8);
  auto edited = std::make_shared<Solver>(scene, *operators, dark);
  edited->setMaterials(bright);
  const auto fresh = std::make_shared<Solver>(scene, *operators, bright);
  Lighting a(edited);
  Lighting b(fresh);
  ASSERT_TRUE(a.setLuminaires(std::vector{panel({1, 1.5, 2.9})}).ok());
  ASSERT_TRUE(b.setLuminaires(std::vector{panel({1, 1.5, 2.9})}).ok());
  EXPECT_EQ(a.total(), b.total());
}

}  // namespace
}  // namespace soffit::relight
