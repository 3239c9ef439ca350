// SPDX-License-Identifier: MIT
#include "core/light/direct_stage.h"

#include "core/light/clip_blocker.h"

#include "core/light/emitter_sampling.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace soffit::light {
namespace {

Emitter emitterOf(const Shape& shape, const dvec3& position, const dvec3& rotation = dvec3(0)) {
  Luminaire l;
  l.shape = shape;
  l.position = position;
  l.rotation_deg = rotation;
  l.flux = 1000.0;
  auto e = makeEmitter(l);
  EXPECT_TRUE(e.ok()) << (e.ok() ? "" : e.error().message());
  return *e;
}

Blocker triangle(const vec3& a, const vec3& b, const vec3& c, bool solid = false) {
  Blocker t;
  t.corners = {a, b, c, c};
  t.count = 3;
  t.solid = solid;
  t.normal = glm::normalize(glm::cross(b - a, c - a));
  return t;
}

/// Segment against a convex planar polygon, in double precision.
bool hits(const Blocker& b, const dvec3& p, const dvec3& x) {
  const dvec3 n(b.normal);
  const double hp = glm::dot(n, p - dvec3(b.corners[0]));
  const double hx = glm::dot(n, x - dvec3(b.corners[0]));
  if ((hp > 0) == (hx > 0)) return false;
  const dvec3 q = p + (x - p) * (hp / (hp - hx));
  for (int k = 0; k < b.count; ++k) {
    const dvec3 a(b.corners[static_cast<std::size_t>(k)]);
    const dvec3 c(b.corners[static_cast<std::size_t>((k + 1) % b.count)]);
    if (glm::dot(n, glm::cross(c - a, q - a)) < 0) return false;
  }
  return true;
}

/// Direct illuminance by brute force: area samples and segments against every blocker.
double bruteForce(const Emitter& e, const std::vector<Blocker>& blockers, const dvec3& p,
                  const dvec3& n, int samples) {
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const EmitterSample s = sampleByArea(e, r2Sequence(static_cast<std::uint32_t>(i)));
    const dvec3 to = s.point - p;
    const double r = glm::length(to);
    const double cos_p = glm::dot(n, to) / r;
    if (cos_p <= 0) continue;
    const double intensity = e.kind == EmitterKind::point
                                 ? e.pointIntensity(-to / r)
                                 : e.intensityPerArea(s.normal, -to / r) / s.pdf_area;
    if (intensity <= 0) continue;
    bool blocked = false;
    for (const Blocker& b : blockers) blocked = blocked || hits(b, p, s.point);
    if (!blocked) sum += intensity * cos_p / (r * r);
  }
  return sum / samples;
}

struct Case {
  const char* name;
  Shape shape;
  double tolerance;  // of the peak: statistical, see the test
};

class DirectStageShapes : public testing::TestWithParam<int> {};

std::vector<Case> cases() {
  return {
      {"rectangle", Rectangle{0.8, 0.5}, 0.01},
      {"disk", Disk{0.4}, 0.01},
      {"polygon", Polygon{{{0, 0}, {0.8, 0}, {0.8, 0.3}, {0.3, 0.3}, {0.3, 0.9}, {0, 0.9}}}, 0.012},
      {"point", PointShape{}, 1e-5},
      {"sphere", Sphere{0.25}, 0.02},
      {"tube", Tube{1.2, 0.05}, 0.02}};
}

TEST_P(DirectStageShapes, AgreesWithBruteForceAmongRandomBlockers) {
  const Case c = cases()[static_cast<std::size_t>(GetParam())];
  const Emitter e = emitterOf(c.shape, dvec3(0.1, -0.2, 2.5), dvec3(10, -20, 35));
  const PreparedLight light(e);
  Rng rng(11);
  std::vector<Blocker> list;
  for (int i = 0; i < 40; ++i) {
    const vec3 a(4 * rng.uniform() - 2, 4 * rng.uniform() - 2, 0.2F + 1.6F * rng.uniform());
    list.push_back(triangle(a, a + 0.5F * uniformSphere(rng.uniform(), rng.uniform()),
                            a + 0.5F * uniformSphere(rng.uniform(), rng.uniform())));
  }
  const Blockers blockers(list);
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  for (int i = 0; i < 400; ++i) {
    positions.emplace_back(4 * rng.uniform() - 2, 4 * rng.uniform() - 2, 0);
    normals.push_back(i % 3 == 0 ? glm::normalize(vec3(0.3F, 0.1F, 0.5F)) : vec3(0, 0, 1));
  }
  const Receivers receivers = makeReceivers(positions, normals, 64);
  std::vector<float> lux(receivers.slotCount());
  std::vector<std::uint8_t> lit(receivers.clusters.size());
  directIlluminance(light, receivers, blockers, {}, lux, lit);
  double peak = 0;
  double worst = 0;
  double square = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double expected = bruteForce(e, list, dvec3(positions[i]), dvec3(normals[i]), 2048);
    const double got = lux[receivers.slot_of[i]];
    peak = std::max(peak, expected);
    worst = std::max(worst, std::abs(got - expected));
    square += (got - expected) * (got - expected);
  }
  EXPECT_GT(peak, 0);
  // Sampling both sides: a shadow edge across 512 bits and 2048 points errs by about 1/512; the
  // worst of 400 points, some with several edges, stays below ten times that. Spheres and tubes
  // add the outline's error as seen from a group's centre rather than from each point.
  EXPECT_LT(worst, 3 * c.tolerance * peak) << c.name;
  EXPECT_LT(std::sqrt(square / 400.0), c.tolerance * peak) << c.name;
}

INSTANTIATE_TEST_SUITE_P(All, DirectStageShapes, testing::Range(0, 6));

TEST(DirectStage, TwoRoomsWithAShutDoorAreExactlyDark) {
  const Emitter e = emitterOf(Rectangle{0.6, 0.6}, dvec3(0, 0, 2.5));
  const PreparedLight light(e);
  // A wall x = 1 between the light and the receivers, of two triangles, larger than the room.
  std::vector<Blocker> wall = {triangle({1, -9, -1}, {1, 9, -1}, {1, 9, 4}),
                               triangle({1, -9, -1}, {1, 9, 4}, {1, -9, 4})};
  const Blockers blockers(wall);
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  for (int i = 0; i < 300; ++i) {
    positions.emplace_back(1.5F + 0.01F * static_cast<float>(i % 60),
                           -2.0F + 0.8F * static_cast<float>(i / 60), 0.0F);
    normals.emplace_back(0, 0, 1);
  }
  const Receivers receivers = makeReceivers(positions, normals, 256);
  std::vector<float> lux(receivers.slotCount(), 1.0F);
  std::vector<std::uint8_t> lit(receivers.clusters.size());
  directIlluminance(light, receivers, blockers, {}, lux, lit);
  for (const float v : lux) EXPECT_EQ(v, 0.0F);
}

TEST(DirectStage, AnEmptyConvexRoomNeedsNoVisibilityTest) {
  const Emitter e = emitterOf(Rectangle{0.6, 0.6}, dvec3(2, 2, 2.49));
  std::vector<Blocker> room;
  const auto quad = [&](vec3 a, vec3 b, vec3 c, vec3 d) {
    room.push_back(triangle(a, b, c));
    room.push_back(triangle(a, c, d));
  };
  quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0});
  quad({0, 0, 2.5}, {0, 4, 2.5}, {4, 4, 2.5}, {4, 0, 2.5});
  quad({0, 0, 0}, {0, 0, 2.5}, {4, 0, 2.5}, {4, 0, 0});
  quad({0, 4, 0}, {4, 4, 0}, {4, 4, 2.5}, {0, 4, 2.5});
  quad({0, 0, 0}, {0, 4, 0}, {0, 4, 2.5}, {0, 0, 2.5});
  quad({4, 0, 0}, {4, 0, 2.5}, {4, 4, 2.5}, {4, 4, 0});
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) {
      positions.emplace_back(4.0F * (static_cast<float>(i) + 0.5F) / 32,
                             4.0F * (static_cast<float>(j) + 0.5F) / 32, 0);
      normals.emplace_back(0, 0, 1);
    }
  }
  const Receivers receivers = makeReceivers(positions, normals, 256);
  std::vector<float> lux(receivers.slotCount());
  std::vector<std::uint8_t> lit(receivers.clusters.size());
  DirectCounts counts;
  directIlluminance(PreparedLight(e), receivers, Blockers(room), {}, lux, lit, &counts);
  EXPECT_EQ(counts.blocker_tests, 0U);
  EXPECT_EQ(counts.clusters_clear, counts.clusters);
}

TEST(DirectStage, ATubeInABlockIsExactlyDark) {
  // However the tube lies in a closed solid, and above all seen along its axis.
  const auto face = [](vec3 a, vec3 b, vec3 c, vec3 d) {
    Blocker q;
    q.corners = {a, b, c, d};
    q.count = 4;
    q.solid = true;
    q.normal = glm::normalize(glm::cross(b - a, c - a));
    return q;
  };
  const float h = 0.25F;
  const std::vector<Blocker> block = {face({h, -h, -h}, {h, h, -h}, {h, h, h}, {h, -h, h}),
                                      face({-h, -h, -h}, {-h, -h, h}, {-h, h, h}, {-h, h, -h}),
                                      face({-h, h, -h}, {-h, h, h}, {h, h, h}, {h, h, -h}),
                                      face({-h, -h, -h}, {h, -h, -h}, {h, -h, h}, {-h, -h, h}),
                                      face({-h, -h, h}, {h, -h, h}, {h, h, h}, {-h, h, h}),
                                      face({-h, -h, -h}, {-h, h, -h}, {h, h, -h}, {h, -h, -h})};
  for (const dvec3& rotation : {dvec3(0, 0, 0), dvec3(3, 5, 7), dvec3(0, 90, 0)}) {
    const Emitter e = emitterOf(Tube{0.4, 0.02}, dvec3(0.01, 0.02, -0.01), rotation);
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    for (int axis = 0; axis < 3; ++axis) {
      for (const float side : {-1.5F, 1.5F}) {
        for (int i = 0; i < 1024; ++i) {
          vec3 p(0.0F);
          vec3 n(0.0F);
          p[axis] = side;
          p[(axis + 1) % 3] = 0.04F * static_cast<float>(i % 32) - 0.62F;
          p[(axis + 2) % 3] = 0.04F * static_cast<float>(i / 32) - 0.62F;
          n[axis] = side > 0 ? -1.0F : 1.0F;
          positions.push_back(p);
          normals.push_back(n);
        }
      }
    }
    const Receivers receivers = makeReceivers(positions, normals, 256);
    std::vector<float> lux(receivers.slotCount(), 1.0F);
    std::vector<std::uint8_t> lit(receivers.clusters.size());
    directIlluminance(PreparedLight(e), receivers, Blockers(block), {}, lux, lit);
    for (const float v : lux) ASSERT_EQ(v, 0.0F);
    directIlluminance(PreparedLight(e), receivers, Blockers(), {}, lux, lit);
    EXPECT_GT(*std::max_element(lux.begin(), lux.end()), 10.0F);
  }
}

TEST(ClipToFront, KeepsTheAreaOnTheSide) {
  MaskBlocker b = maskBlocker(triangle({-1, 0, 0}, {1, 0, 0}, {0, 0, 2}));
  const MaskBlocker front = clipToFront(b, vec3(0, 0, 1), 1.0F);
  EXPECT_EQ(front.count, 3);
  const MaskBlocker rest = clipToFront(b, vec3(0, 0, -1), -1.0F);
  EXPECT_EQ(rest.count, 4);
  EXPECT_EQ(clipToFront(b, vec3(0, 0, 1), 2.5F).count, 0);
  EXPECT_EQ(clipToFront(b, vec3(0, 0, 1), -1.0F).count, 3);
}

TEST(ClipToFront, LeavesNoEdgeWithoutLength) {
  // A corner a rounding off the plane, on either side.
  for (const float off : {-1e-8F, 0.0F, 1e-8F}) {
    const MaskBlocker b = maskBlocker(triangle({-1, 0, 0}, {1, 0, off}, {0, 1, 1}));
    for (const float sign : {-1.0F, 1.0F}) {
      const MaskBlocker part = clipToFront(b, vec3(0, -sign, sign), 0.0F);
      for (int k = 0; k < part.count; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const auto next = static_cast<std::size_t>((k + 1) % part.count);
        EXPECT_GT(glm::length(part.corners[next] - part.corners[i]), 0.1F);
      }
    }
    const MaskBlocker quarter = clipToFront(b, vec3(1, -1, 0), 0.0F);
    EXPECT_GE(quarter.count, 3);
  }
}

}  // namespace
}  // namespace soffit::light
