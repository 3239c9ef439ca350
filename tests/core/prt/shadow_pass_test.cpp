// SPDX-License-Identifier: MIT
#include "core/prt/shadow_pass.h"

#include "core/base/parallel.h"
#include "core/math/rng.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stop_token>
#include <string_view>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;
using testing::pointReceivers;

Directions hammersley(int n, int bands = 3) {
  return {sh::hammersleySamples(n), bands};
}

std::size_t blockedCount(const VisibilityFlags& flags) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < flags.receivers(); ++i) count += flags.countBlocked(i);
  return count;
}

TEST(ShadowPass, FlatSurfacesHaveNoAcne) {
  // Turned any way, near the frame's zero and 3 km from it: no receiver of a plane sees the plane.
  Rng rng(5);
  for (int k = 0; k < 12; ++k) {
    const dvec3 turn(360.0 * rng.uniformDouble(), 360.0 * rng.uniformDouble(),
                     360.0 * rng.uniformDouble());
    const vec3 by(k % 2 == 0 ? vec3(0.0F) : vec3(3000.0F, -2000.0F, 700.0F));
    const auto plane =
        testing::moved(testing::turned(geometry::makeRectangle(5, 3, 6, 5), turn), by);
    const auto surfaces = Builder().add(plane, matte(vec3(0.5F))).surfaces();
    const VertexReceivers set(surfaces);
    const auto pass = traceShadows(*surfaces, set.receivers(), hammersley(512)).value();
    EXPECT_EQ(blockedCount(pass.flags), 0U) << k;
    EXPECT_GT(pass.rays, 200U * set.receivers().size());
  }
}

/// The tutorial's listing: an absolute threshold on the determinant, hits at any t.
bool listingHits(const vec3& p, const vec3& d, const vec3& a, const vec3& b, const vec3& c) {
  const vec3 e1 = b - a;
  const vec3 e2 = c - a;
  const vec3 h = glm::cross(d, e2);
  const float det = glm::dot(e1, h);
  if (det > -1e-5F && det < 1e-5F) return false;
  const vec3 s = p - a;
  const float u = glm::dot(s, h) / det;
  if (u < 0.0F || u > 1.0F) return false;
  const vec3 q = glm::cross(s, e1);
  const float v = glm::dot(d, q) / det;
  return v >= 0.0F && u + v <= 1.0F;
}

TEST(ShadowPass, SmallTrianglesBlockAndThoseBehindDoNot) {
  // A shade of 2 mm triangles over the point; the listing sees through it.
  const auto shade = testing::moved(geometry::makeRectangle(0.2F, 0.2F, 100, 100), {0, 0, 0.02F});
  const auto surfaces = Builder().add(shade, matte(vec3(0.5F))).surfaces();
  const Receivers at = pointReceivers({{0.0001F, 0.0002F, 0}}, {0, 0, 1});
  const Directions up({{dvec3(0, 0, 1)}, {4 * kPi}}, 1);
  EXPECT_TRUE(traceShadows(*surfaces, at, up).value().flags.blocked(0, 0));
  bool listing = false;
  for (const uvec3& t : shade.triangles) {
    listing |= listingHits(at.positions[0], {0, 0, 1}, shade.positions[t.x], shade.positions[t.y],
                           shade.positions[t.z]);
  }
  EXPECT_FALSE(listing);
  // A large triangle behind the point is none of its business, though the listing says so.
  const auto below = testing::moved(geometry::makeRectangle(2, 2), {0, 0, -1});
  const auto behind = Builder().add(below, matte(vec3(0.5F))).surfaces();
  EXPECT_FALSE(traceShadows(*behind, at, up).value().flags.blocked(0, 0));
  const uvec3& t = below.triangles[0];
  const uvec3& o = below.triangles[1];
  EXPECT_TRUE(listingHits(at.positions[0], {0, 0, 1}, below.positions[t.x], below.positions[t.y],
                          below.positions[t.z]) ||
              listingHits(at.positions[0], {0, 0, 1}, below.positions[o.x], below.positions[o.y],
                          below.positions[o.z]));
}

TEST(ShadowPass, VerticesAtTheFootOfAWallSeeNothingBeyondIt) {
  // Inside a box every direction of every corner is blocked: no light leaks in through its edges.
  const auto room = testing::turned(geometry::makeBox({0, 0, 0}, {4, 3, 2.5F}), {10, 20, 30});
  const vec3 middle(rotationXyz({10, 20, 30}) * dvec3(2, 1.5, 1.2));
  const auto surfaces = Builder().add(room, matte(vec3(0.5F))).surfaces({middle});
  const VertexReceivers set(surfaces);
  const auto pass = traceShadows(*surfaces, set.receivers(), hammersley(1000)).value();
  EXPECT_EQ(blockedCount(pass.flags), pass.rays);
}

TEST(ShadowPass, MemoryIsKnownBefore) {
  const Receivers r = pointReceivers(std::vector<vec3>(100, vec3(0.0F)), {0, 0, 1});
  const auto pass = traceShadows(*Builder().surfaces(), r, hammersley(1000)).value();
  EXPECT_EQ(pass.flags.bytes(), VisibilityFlags::predictBytes(100, 1000));
  EXPECT_EQ(pass.flags.bytes(), 100U * 16U * 8U);
  EXPECT_EQ(blockedCount(pass.flags), 0U);
}

TEST(ShadowPass, ThreadsChangeNothing) {
  const auto surfaces = testing::blockOnFloor(12, vec3(0.5F), vec3(0.3F)).surfaces();
  const VertexReceivers set(surfaces);
  const auto all = traceShadows(*surfaces, set.receivers(), hammersley(300)).value();
  setThreadCount(1);
  const auto one = traceShadows(*surfaces, set.receivers(), hammersley(300)).value();
  setThreadCount(0);
  EXPECT_TRUE(all.flags == one.flags);
  EXPECT_GT(blockedCount(all.flags), 0U);
}

TEST(ShadowPass, AnEditTracesTheRaysThatCrossItAlone) {
  const auto blockAt = [](const vec3& by) {
    Builder b;
    b.add(geometry::makeRectangle(6, 6, 12, 12), matte(vec3(0.5F)));
    b.add(testing::moved(geometry::makeBox({-0.3F, -0.2F, 0.1F}, {0.3F, 0.2F, 0.6F}), by),
          matte(vec3(0.5F)));
    b.add(geometry::makeSphere({-1.5F, 1, 0.6F}, 0.5F, 8), matte(vec3(0.5F)));
    return b;
  };
  const auto boxAt = [](const vec3& by) {
    Box box;
    box.add(vec3(-0.3F, -0.2F, 0.1F) + by);
    box.add(vec3(0.3F, 0.2F, 0.6F) + by);
    return box;
  };
  const vec3 from(0.5F, 0.2F, 0);
  const vec3 to(1.1F, -0.7F, 0.3F);
  const auto before = blockAt(from).surfaces();
  const auto after = blockAt(to).surfaces();
  // The floor's and the sphere's receivers, which stay.
  const auto staying = Builder()
                           .add(geometry::makeRectangle(6, 6, 12, 12), matte(vec3(0.5F)))
                           .add(geometry::makeSphere({-1.5F, 1, 0.6F}, 0.5F, 8), matte(vec3(0.5F)))
                           .surfaces();
  const Receivers r = VertexReceivers(staying).receivers();
  const Directions directions = hammersley(700);
  const auto old = traceShadows(*before, r, directions).value();
  const auto wanted = traceShadows(*after, r, directions).value();
  const std::vector<Box> edited{boxAt(from), boxAt(to)};
  const auto update = retraceShadows(old.flags, *after, r, directions, edited).value();
  EXPECT_TRUE(update.flags == wanted.flags);
  EXPECT_LT(update.rays, wanted.rays / 8);
  bool any = false;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const auto a = old.flags.words(i);
    const auto b = wanted.flags.words(i);
    const bool differs = !std::equal(a.begin(), a.end(), b.begin());
    EXPECT_EQ(update.changed[i] != 0, differs) << i;
    any |= differs;
  }
  EXPECT_TRUE(any);
}

TEST(ShadowPass, GlassDimsWhatPassesIt) {
  scene::Material glass;
  glass.glass = scene::Glass{1.52, 0.8};
  Builder b;
  b.add(testing::quad({-9, -9, 1}, {18, 0, 0}, {0, 18, 0}), glass);
  const auto surfaces = b.surfaces();
  const Receivers at = pointReceivers({{0, 0, 0}}, {0, 0, 1});
  const Directions up({{dvec3(0, 0, 1), dvec3(0, 0, -1)}, {2 * kPi, 2 * kPi}}, 1);
  const auto pass = traceShadows(*surfaces, at, up).value();
  EXPECT_EQ(blockedCount(pass.flags), 0U);
  ASSERT_EQ(pass.flags.dimmed(0).size(), 1U);
  EXPECT_NEAR(pass.flags.dimmed(0)[0].share, 0.8F, 1e-6F);
  const auto rows = shadowedTransfer(at, up, pass.flags).value();
  EXPECT_NEAR(rows.vector(0)[0], 0.8 * std::sqrt(kPi) / 2, 1e-6);
}

TEST(ShadowPass, StopsWhenAsked) {
  class Stopper final : public ProgressObserver {
   public:
    explicit Stopper(std::stop_source& stop) : stop_(stop) {}
    void onProgress(std::string_view, double) override { stop_.request_stop(); }

   private:
    std::stop_source& stop_;
  };
  const auto surfaces = testing::blockOnFloor(40, vec3(0.5F), vec3(0.3F)).surfaces();
  const VertexReceivers set(surfaces);
  std::stop_source stop;
  Stopper stopper(stop);
  const auto pass =
      traceShadows(*surfaces, set.receivers(), hammersley(500), {&stopper, stop.get_token()});
  ASSERT_FALSE(pass.ok());
  EXPECT_EQ(pass.error().message(), "transfer: cancelled");
}

}  // namespace
}  // namespace soffit::prt
