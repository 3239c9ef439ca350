// SPDX-License-Identifier: MIT
#include "core/light/emitter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace soffit::light {
namespace {

constexpr double kRoundoff = 1e-13;  // tens of operations on numbers of order 1 to 10

std::shared_ptr<const photometry::IntensityDistribution> downTable() {
  auto table = std::make_shared<photometry::IntensityDistribution>();
  table->c_deg = {0.0};
  table->gamma_deg = {0.0, 90.0};
  table->candela = {100.0, 100.0};  // constant over the lower hemisphere: 200 pi lumens
  return table;
}

std::shared_ptr<const geometry::Mesh> tetrahedron() {
  auto mesh = std::make_shared<geometry::Mesh>();
  mesh->origin = dvec3(10.0, 0.0, 0.0);
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh->triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {1, 1, 3}};
  return mesh;
}

Luminaire luminaireOf(Shape shape) {
  Luminaire l;
  l.name = "L";
  l.shape = std::move(shape);
  l.flux = 1000.0;
  return l;
}

void expectNear(const dvec3& found, const dvec3& expected, double tolerance = kRoundoff) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], tolerance) << "component " << k;
}

dvec3 outlineNormal(const Emitter& e) {
  dvec3 sum(0.0);
  for (std::size_t i = 0; i < e.outline.size(); ++i) {
    sum += glm::cross(e.outline[i] - e.outline[0],
                      e.outline[(i + 1) % e.outline.size()] - e.outline[0]);
  }
  return glm::normalize(sum);
}

TEST(MakeEmitter, RectangleEmitsDownUnrotatedAndIsCounterClockwiseFromThere) {
  Luminaire l = luminaireOf(Rectangle{2.0, 0.5});
  l.position = {1.0, 2.0, 3.0};
  const auto e = makeEmitter(l, dvec3(1.0, 0.0, 0.0));
  ASSERT_TRUE(e.ok());
  EXPECT_EQ(e->kind, EmitterKind::planar);
  expectNear(e->position, {0.0, 2.0, 3.0});
  expectNear(e->normal, {0, 0, -1});
  expectNear(outlineNormal(*e), {0, 0, -1});
  EXPECT_NEAR(e->area, 1.0, kRoundoff);
  EXPECT_NEAR(e->luminance, 1000.0 / kPi, kRoundoff * 1000.0);
  for (const dvec3& p : e->outline) EXPECT_TRUE(e->bounds.contains(vec3(p)));
}

TEST(MakeEmitter, RotationTurnsTheEmissionAsTheConventionsSay) {
  Luminaire l = luminaireOf(Rectangle{1.0, 1.0});
  l.rotation_deg = {0, -90, 0};
  const auto e = makeEmitter(l);
  ASSERT_TRUE(e.ok());
  expectNear(e->normal, {1, 0, 0});
  expectNear(outlineNormal(*e), {1, 0, 0});
  l.rotation_deg = {0, 0, 90};
  expectNear(makeEmitter(l)->world_from_light * dvec3(1, 0, 0), {0, 1, 0});
}

TEST(MakeEmitter, PolygonOfEitherWindingFacesTheSameWay) {
  for (const bool reversed : {false, true}) {
    std::vector<dvec2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    if (reversed) std::reverse(outline.begin(), outline.end());
    const auto e = makeEmitter(luminaireOf(Polygon{outline}));
    ASSERT_TRUE(e.ok());
    EXPECT_NEAR(e->area, 3.0, kRoundoff);
    expectNear(outlineNormal(*e), {0, 0, -1});
    ASSERT_EQ(e->outline_triangles.size(), 4U);
    for (const uvec3& t : e->outline_triangles) {
      const dvec3 n =
          glm::cross(e->outline[t.y] - e->outline[t.x], e->outline[t.z] - e->outline[t.x]);
      EXPECT_LT(n.z, 0.0);
    }
    EXPECT_NEAR(e->area_sums.back(), 3.0, kRoundoff);
  }
}

TEST(MakeEmitter, ScaleChangesSizesButNotFlux) {
  const struct {
    Shape shape;
    double area;
  } cases[] = {{Rectangle{1.0, 2.0}, 2.0},
               {Disk{1.0}, kPi},
               {Sphere{1.0}, 4.0 * kPi},
               {Tube{2.0, 0.5}, 2.0 * kPi},
               {Polygon{{{0, 0}, {1, 0}, {0, 1}}}, 0.5},
               {MeshShape{"t.obj", 1.0, 'z', tetrahedron()}, 1.5 + std::sqrt(3.0) / 2}};
  for (const auto& c : cases) {
    Luminaire l = luminaireOf(c.shape);
    l.scale = 3.0;
    const auto e = makeEmitter(l);
    ASSERT_TRUE(e.ok()) << e.error().message();
    EXPECT_NEAR(e->area, 9.0 * c.area, 9.0 * c.area * 1e-7);  // mesh corners are floats
    EXPECT_NEAR(e->luminance * kPi * e->area, 1000.0, 1e-9);
    EXPECT_EQ(e->flux, 1000.0);
    EXPECT_FALSE(e->bounds.empty());
  }
}

TEST(MakeEmitter, MeshKeepsItsOriginWindingAndDropsEmptyTriangles) {
  Luminaire l = luminaireOf(MeshShape{"t.obj", 1.0, 'z', tetrahedron()});
  l.position = {0, 0, 5};
  const auto e = makeEmitter(l);
  ASSERT_TRUE(e.ok());
  ASSERT_EQ(e->triangle_areas.size(), 4U);
  ASSERT_EQ(e->corners.size(), 12U);
  expectNear(e->corners[0], {10, 0, 5});
  expectNear(e->triangle_normals[0], {0, 0, -1});
  expectNear(e->triangle_normals[3], dvec3(1, 1, 1) / std::sqrt(3.0));
}

TEST(MakeEmitter, TubeAxisIsX) {
  Luminaire l = luminaireOf(Tube{1.2, 0.02});
  l.rotation_deg = {0, 0, 90};
  const auto e = makeEmitter(l);
  ASSERT_TRUE(e.ok());
  expectNear(e->axis, {0, 1, 0});
  EXPECT_DOUBLE_EQ(e->half_length, 0.6);
  EXPECT_NEAR(e->bounds.hi.y, 0.6, 1e-6);  // float
  EXPECT_NEAR(e->bounds.hi.x, 0.02, 1e-6);
}

TEST(MakeEmitter, PointsHaveTheirIntensities) {
  Luminaire l = luminaireOf(PointShape{});
  const auto lambertian = makeEmitter(l);
  ASSERT_TRUE(lambertian.ok());
  EXPECT_NEAR(lambertian->pointIntensity({0, 0, -1}), 1000.0 / kPi, 1e-10);
  EXPECT_EQ(lambertian->pointIntensity({0, 0, 1}), 0.0);
  l.distribution.kind = DistributionKind::isotropic;
  EXPECT_NEAR(makeEmitter(l)->pointIntensity({0.6, 0, 0.8}), 1000.0 / (4 * kPi), 1e-10);
  l.casts_shadow = true;
  EXPECT_FALSE(makeEmitter(l)->casts_shadow);
}

TEST(MakeEmitter, MeasuredLightKeepsTheFilesCandelaOrIsScaledToTheFlux) {
  Luminaire l = luminaireOf(Rectangle{2.0, 1.0});
  l.distribution = {DistributionKind::ies, "a.ies", downTable()};
  l.flux.reset();
  const auto as_stored = makeEmitter(l);
  ASSERT_TRUE(as_stored.ok());
  EXPECT_DOUBLE_EQ(as_stored->flux, downTable()->flux());
  EXPECT_DOUBLE_EQ(as_stored->table_scale, 1.0);
  EXPECT_TRUE(as_stored->twoSided());
  EXPECT_NEAR(as_stored->pointIntensity({0, 0, -1}), 100.0, 1e-10);
  // Per area, whatever the normal.
  EXPECT_NEAR(as_stored->intensityPerArea({0, 0, 1}, {0, 0, -1}), 50.0, 1e-10);

  l.flux = 2.0 * downTable()->flux();
  EXPECT_NEAR(makeEmitter(l)->pointIntensity({0, 0, -1}), 200.0, 1e-9);
  l.rotation_deg = {0, -90, 0};
  EXPECT_NEAR(makeEmitter(l)->pointIntensity({1, 0, 0}), 200.0, 1e-9);
}

TEST(MakeEmitter, DimmingSwitchAndColourStayApartFromTheLight) {
  Luminaire l = luminaireOf(Sphere{0.1});
  l.dimming = 0.3;
  EXPECT_EQ(makeEmitter(l)->gain, 0.3);
  l.on = false;
  EXPECT_EQ(makeEmitter(l)->gain, 0.0);
  EXPECT_EQ(makeEmitter(l)->flux, 1000.0);
}

TEST(EmissionColor, HasUnitLuminanceAndNoNegativeChannel) {
  for (const double cct_k : {600.0, 1500.0, 2700.0, 6500.0, 40000.0}) {
    const dvec3 rgb = emissionColor({.cct_k = cct_k, .rgb = dvec3(1.0)});
    EXPECT_NEAR(glm::dot(rgb, kLuminance), 1.0, kRoundoff);
    EXPECT_GE(std::min({rgb.x, rgb.y, rgb.z}), 0.0);
  }
  expectNear(emissionColor({.cct_k = {}, .rgb = dvec3(5.0)}), dvec3(1.0), 1e-9);
  EXPECT_GT(emissionColor({.cct_k = 2700.0, .rgb = {}}).x,
            emissionColor({.cct_k = 2700.0, .rgb = {}}).z);
}

std::string errorOf(const Luminaire& l) {
  const auto e = makeEmitter(l);
  return e.ok() ? "no error" : e.error().message();
}

TEST(MakeEmitter, RefusesBadNumbersWithPlaceAndRemedy) {
  using testing::AllOf;
  using testing::HasSubstr;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto broken = [](auto&& change) {
    Luminaire l = luminaireOf(Rectangle{1.0, 1.0});
    change(l);
    return errorOf(l);
  };
  EXPECT_THAT(broken([&](Luminaire& l) { l.position.y = nan; }),
              HasSubstr("luminaires.L.position"));
  EXPECT_THAT(broken([&](Luminaire& l) { l.rotation_deg.x = nan; }),
              HasSubstr("luminaires.L.rotation"));
  EXPECT_THAT(broken([](Luminaire& l) { l.scale = 0.0; }),
              HasSubstr("a finite factor above 0, found 0"));
  EXPECT_THAT(broken([](Luminaire& l) { l.flux = -1.0; }), HasSubstr("not negative, found -1"));
  EXPECT_THAT(broken([](Luminaire& l) { l.dimming = -1.0; }), HasSubstr("luminaires.L.dimming"));
  EXPECT_THAT(broken([](Luminaire& l) { l.colour.cct_k = 0.0; }),
              HasSubstr("luminaires.L.colour.cct"));
  EXPECT_THAT(broken([](Luminaire& l) { l.colour.rgb = dvec3(0.0); }),
              HasSubstr("luminaires.L.colour.rgb"));
  EXPECT_THAT(broken([](Luminaire& l) { l.flux.reset(); }),
              AllOf(HasSubstr("luminaires.L.flux"), HasSubstr("Add \"flux\": LUMENS")));
  EXPECT_THAT(broken([](Luminaire& l) { l.distribution.kind = DistributionKind::isotropic; }),
              HasSubstr("Use \"lambertian\""));
  EXPECT_THAT(broken([](Luminaire& l) { l.distribution.kind = DistributionKind::ies; }),
              HasSubstr("the photometric file is not loaded"));
}

TEST(MakeEmitter, RefusesDarkFilesThatShouldShine) {
  auto table = std::make_shared<photometry::IntensityDistribution>(*downTable());
  table->candela = {0.0, 0.0};
  Luminaire l = luminaireOf(PointShape{});
  l.distribution = {DistributionKind::ldt, "dark.ldt", table};
  EXPECT_THAT(errorOf(l), testing::HasSubstr("gives no light that could be scaled"));
}

TEST(MakeEmitter, RefusesShapesWithoutSize) {
  using testing::HasSubstr;
  EXPECT_THAT(errorOf(luminaireOf(Rectangle{0.0, 1.0})), HasSubstr("shape.rectangle"));
  EXPECT_THAT(errorOf(luminaireOf(Disk{-1.0})),
              HasSubstr("shape.disk: expected sizes above 0 (after scale) and finite, found -1"));
  EXPECT_THAT(errorOf(luminaireOf(Sphere{0.0})), HasSubstr("shape.sphere"));
  EXPECT_THAT(errorOf(luminaireOf(Tube{0.0, 0.1})), HasSubstr("shape.tube"));
  EXPECT_THAT(errorOf(luminaireOf(Tube{1.0, 0.0})), HasSubstr("shape.tube"));
  EXPECT_THAT(errorOf(luminaireOf(Polygon{{{0, 0}, {1, 1}}})),
              HasSubstr("shape.polygon: expected a polygon"));
  EXPECT_THAT(errorOf(luminaireOf(MeshShape{"m.obj", 1.0, 'z', nullptr})), HasSubstr("not loaded"));
  EXPECT_THAT(
      errorOf(luminaireOf(MeshShape{"m.obj", 1.0, 'z', std::make_shared<geometry::Mesh>()})),
      HasSubstr("expected triangles with a finite area"));
}

}  // namespace
}  // namespace soffit::light
