// SPDX-License-Identifier: MIT
#include "core/render/lamp_choice.h"

#include "tests/core/render/lit_room.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace soffit::render {
namespace {

using testing::LitRoom;
using testing::material;
using testing::spot;

constexpr int kDraws = 20000;

std::vector<light::Luminaire> threeLamps() {
  std::vector<light::Luminaire> lamps{spot(), spot(), spot()};
  lamps[0].position = {0.5, 0.5, 2.0};
  lamps[1].position = {3.5, 3.5, 2.5};
  lamps[1].flux = 3000.0;
  lamps[2].position = {2.0, 3.0, 1.0};
  lamps[2].on = false;
  return lamps;
}

TEST(LampChoice, DrawsSourcesAsOftenAsItSays) {
  const LitRoom room(material(0.4, 0.0, 0.5), material(0.5, 0.0, 0.5), threeLamps());
  const LampChoice choice(*room.lighting);
  for (std::uint32_t slot = 0; slot < room.texels().slotCount(); slot += 97) {
    std::array<int, 3> drawn{};
    std::array<double, 3> stated{};
    for (int k = 0; k < kDraws; ++k) {
      const LampChoice::Pick pick = choice.pick(slot, (k + 0.5) / kDraws);
      ASSERT_LT(pick.source, 2U) << "a source that is off";
      ++drawn[pick.source];
      stated[pick.source] = pick.probability;
    }
    EXPECT_NEAR(stated[0] + stated[1], 1.0, 1.0e-5);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(drawn[i] / static_cast<double>(kDraws), stated[i], 3.0 / kDraws);
      EXPECT_GE(stated[i], 0.05 - 1.0e-6) << "any source may come up";
    }
  }
}

TEST(LampChoice, FollowsTheLightThatArrives) {
  const LitRoom room(material(0.4, 0.0, 0.5), material(0.5, 0.0, 0.5), threeLamps());
  const LampChoice choice(*room.lighting);
  int near = 0;
  for (std::uint32_t slot = 0; slot < room.texels().slotCount(); ++slot) {
    const vec3 p = room.texels().receivers.position(slot);
    if (p.z > 1.0e-3F || glm::length(p - vec3(0.5F, 0.5F, 0.0F)) > 0.5F) continue;
    ++near;
    const LampChoice::Pick pick = choice.pick(slot, 0.12);  // the first source's part
    EXPECT_EQ(pick.source, 0U);
    // Its share of the light is 0.9 and more; neighbours and even draws dilute it.
    EXPECT_GT(pick.probability, 0.7);
  }
  EXPECT_GT(near, 5);
}

TEST(LampChoice, SaysWhereThereIsNoSource) {
  std::vector<light::Luminaire> lamps{spot()};
  lamps[0].on = false;
  const LitRoom room(material(0.4, 0.0, 0.5), material(0.5, 0.0, 0.5), lamps);
  EXPECT_EQ(LampChoice(*room.lighting).pick(0, 0.5).probability, 0.0);
}

}  // namespace
}  // namespace soffit::render
