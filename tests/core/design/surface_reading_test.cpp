// SPDX-License-Identifier: MIT
#include "core/design/surface_reading.h"

#include "core/light/polygon_irradiance.h"
#include "tests/core/design/scenes.h"

namespace soffit::design {
namespace {

using namespace testing;

TEST(ReadSurfaces, DirectLightIsTheClosedFormAtThePoint) {
  scene::Scene scene = blockRoom();
  const auto solver = solverOf(scene);
  relight::Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(scene.luminaires).ok());
  // The ceiling's lamp sees the far wall without the block between.
  std::vector<SurfaceReceiver> receivers;
  for (const auto& r : drawReceivers(*solver, 300, 1)) {
    if (r.position.x > 3.999) receivers.push_back(r);
  }
  ASSERT_GT(receivers.size(), 10U);
  const light::Emitter& e = lighting.emitters()[0];
  const auto light = readSurfaces(lighting, receivers);
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const double expected = e.luminance * light::polygonIrradiance(e.outline, receivers[i].position,
                                                                   receivers[i].normal);
    // Points are handed over in single precision: 1e-7 of 5 m in a field that changes over 0.1 m.
    EXPECT_NEAR(light[i].direct.y, expected, 1e-5 * expected + 1e-4);
  }
}

TEST(ReadSurfaces, IndirectLightIsThatOfTheTexelAtItsCenter) {
  const scene::Scene scene = blockRoom();
  const auto solver = solverOf(scene);
  relight::Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(scene.luminaires).ok());
  const relight::Planes indirect = lighting.indirectTotal();
  const transfer::Texels& texels = solver->operators().texels;
  std::vector<SurfaceReceiver> receivers;
  std::vector<std::size_t> slots;
  for (std::size_t s = 0; s < texels.slotCount(); s += 31) {
    if (solver->operators().area[s] <= 0.0F) continue;
    SurfaceReceiver r;
    r.position = dvec3(texels.receivers.position(s));
    r.normal = dvec3(texels.receivers.normal(s));
    r.triangle = texels.triangle[s];
    r.front = glm::dot(r.normal, dvec3(solver->scene().normals[r.triangle])) > 0.0;
    // Whole cells alone have their texel's point in their middle.
    std::array<std::uint32_t, transfer::Texels::kMostAround> near{};
    std::array<float, transfer::Texels::kMostAround> share{};
    texels.around(r.triangle, r.front, vec3(r.position), near, share);
    if (near[0] != s || share[0] < 0.9999F) continue;
    receivers.push_back(r);
    slots.push_back(s);
  }
  ASSERT_GT(receivers.size(), 5U);
  const auto light = readSurfaces(lighting, receivers);
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    // Single precision.
    const double expected = static_cast<double>(indirect[1][slots[i]]);
    EXPECT_NEAR(light[i].indirect.y, expected, 1e-4 * expected);
  }
}

TEST(ReadSurfaces, LightOfALuminaireThatIsOffIsMissing) {
  scene::Scene scene = blockRoom();
  scene.luminaires[0].on = false;
  const auto solver = solverOf(scene);
  relight::Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(scene.luminaires).ok());
  for (const auto& l : readSurfaces(lighting, drawReceivers(*solver, 10, 1))) {
    EXPECT_EQ(l.direct, dvec3(0.0));
    EXPECT_EQ(l.indirect, dvec3(0.0));
  }
}

TEST(BodiesAgainst, AreTheOthersAndAMeshsOwn) {
  scene::Scene scene = blockRoom();
  scene.luminaires.push_back(scene.luminaires[0]);
  scene.luminaires[1].position.x += 1.0;
  scene.luminaires[1].casts_shadow = true;
  std::vector<light::Emitter> emitters;
  for (const auto& l : scene.luminaires) emitters.push_back(*light::makeEmitter(l));
  EXPECT_FALSE(bodiesAgainst(emitters, 0).empty());
  EXPECT_TRUE(bodiesAgainst(emitters, 1).empty());
}

}  // namespace
}  // namespace soffit::design
