// SPDX-License-Identifier: MIT
#include "core/light/emitter_sampling.h"

#include "core/math/sampling.h"

#include <gtest/gtest.h>

namespace soffit::light {
namespace {

constexpr std::uint32_t kSamples = 1U << 14U;

Emitter emitterOf(Shape shape) {
  Luminaire l;
  l.shape = std::move(shape);
  l.flux = 1.0;
  l.position = {1.0, 2.0, 3.0};
  l.rotation_deg = {20.0, 30.0, 40.0};
  return makeEmitter(l).value();
}

dvec3 local(const Emitter& e, const dvec3& world) {
  return glm::transpose(e.world_from_light) * (world - e.position);
}

struct Moments {
  dvec3 mean{0.0};
  dvec3 square{0.0};
};

/// First and second moments of the local coordinates over low-discrepancy points.
Moments momentsOf(const Emitter& e) {
  Moments m;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const EmitterSample s = sampleByArea(e, r2Sequence(i));
    EXPECT_NEAR(s.pdf_area * e.area, 1.0, 1e-12);
    EXPECT_NEAR(glm::length(s.normal), 1.0, 1e-6);
    const dvec3 p = local(e, s.point);
    m.mean += p / double(kSamples);
    m.square += p * p / double(kSamples);
  }
  return m;
}

void expectNear(const dvec3& found, const dvec3& expected) {
  // Truncation of the R2 sequence: below 10 / N for smooth moments of unit-sized shapes.
  constexpr double kTolerance = 20.0 / kSamples;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], kTolerance) << "component " << k;
}

TEST(SampleByArea, RectangleHasTheMomentsOfItsArea) {
  const Moments m = momentsOf(emitterOf(Rectangle{2.0, 1.0}));
  expectNear(m.mean, {0, 0, 0});
  expectNear(m.square, {1.0 / 3, 1.0 / 12, 0});
}

TEST(SampleByArea, DiskHasTheMomentsOfItsArea) {
  const Moments m = momentsOf(emitterOf(Disk{1.0}));
  expectNear(m.mean, {0, 0, 0});
  expectNear(m.square, {0.25, 0.25, 0});
}

TEST(SampleByArea, SphereHasTheMomentsOfItsSurface) {
  const Emitter e = emitterOf(Sphere{1.0});
  const Moments m = momentsOf(e);
  expectNear(m.mean, {0, 0, 0});
  expectNear(m.square, dvec3(1.0 / 3));
  const EmitterSample s = sampleByArea(e, {0.3, 0.6});
  EXPECT_NEAR(glm::dot(s.normal, s.point - e.position), 1.0, 1e-12);
}

TEST(SampleByArea, TubeHasTheMomentsOfItsLateralSurface) {
  const Emitter e = emitterOf(Tube{2.0, 0.5});
  const Moments m = momentsOf(e);
  expectNear(m.mean, {0, 0, 0});
  expectNear(m.square, {1.0 / 3, 0.125, 0.125});
  EXPECT_NEAR(glm::dot(sampleByArea(e, {0.3, 0.6}).normal, e.axis), 0.0, 1e-12);
}

TEST(SampleByArea, NonConvexPolygonHasTheMomentsOfItsArea) {
  // An L of three unit squares.
  const Moments m = momentsOf(emitterOf(Polygon{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}));
  expectNear(m.mean, {5.0 / 6, 5.0 / 6, 0});
  expectNear(m.square, {(1.0 / 3 + 7.0 / 3 + 1.0 / 3) / 3, (1.0 / 3 + 7.0 / 3 + 1.0 / 3) / 3, 0});
}

TEST(SampleByArea, MeshChoosesTrianglesByArea) {
  auto mesh = std::make_shared<geometry::Mesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 0, 1}, {0, 1, 1}};
  mesh->triangles = {{0, 1, 2}, {3, 4, 5}};
  const Emitter e = emitterOf(MeshShape{"m.obj", 1.0, 'z', mesh});
  // The second triangle has three quarters of the area and lies at z = 1.
  EXPECT_NEAR(momentsOf(e).mean.z, 0.75, 20.0 / kSamples);
}

TEST(SampleByArea, PointIsThePoint) {
  const Emitter e = emitterOf(PointShape{});
  EXPECT_EQ(sampleByArea(e, {0.1, 0.9}).point, e.position);
  EXPECT_EQ(sampleByArea(e, {0.1, 0.9}).pdf_area, 1.0);
}

}  // namespace
}  // namespace soffit::light
