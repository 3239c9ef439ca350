// SPDX-License-Identifier: MIT
#include "core/render/emitter_radiance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::render {
namespace {

std::shared_ptr<const photometry::IntensityDistribution> evenTable(double candela) {
  auto table = std::make_shared<photometry::IntensityDistribution>();
  table->c_deg = {0};
  for (int g = 0; g <= 180; g += 5) {
    table->gamma_deg.push_back(g);
    table->candela.push_back(candela);
  }
  return table;
}

light::Emitter make(const light::Shape& shape, bool measured) {
  light::Luminaire l;
  l.name = "L";
  l.shape = shape;
  if (measured) {
    l.distribution = {light::DistributionKind::ies, "a.ies", evenTable(100.0)};
  } else {
    l.flux = 1000.0;
  }
  l.dimming = 0.5;
  return light::makeEmitter(l).value();
}

double seen(const light::Emitter& e, const vec3& normal, const vec3& to_eye) {
  return static_cast<double>(EmitterRadiance(e).toward(e, normal, glm::normalize(to_eye)).y);
}

TEST(EmitterRadiance, LambertianShapesShowFluxOverPiArea) {
  const light::Emitter e = make(light::Rectangle{0.6, 0.5}, false);
  const double expected = 0.5 * 1000.0 / (kPi * 0.3);
  EXPECT_NEAR(seen(e, {0, 0, -1}, {0, 0, -1}), expected, 1e-6 * expected);  // single precision
  EXPECT_NEAR(seen(e, {0, 0, -1}, {3, 0, -1}), expected, 1e-6 * expected);
  EXPECT_EQ(seen(e, {0, 0, -1}, {0, 0, 1}), 0.0);
}

TEST(EmitterRadiance, MeasuredShapesShowIntensityOverProjectedArea) {
  const vec3 slant(0, 0.8F, -0.6F);
  const light::Emitter flat = make(light::Rectangle{0.6, 0.5}, true);
  EXPECT_NEAR(seen(flat, {0, 0, -1}, slant), 50.0 / (0.3 * 0.6), 1e-3);
  EXPECT_NEAR(seen(flat, {0, 0, -1}, {0, 0, 1}), 50.0 / 0.3, 1e-3);  // both sides
  const light::Emitter ball = make(light::Sphere{0.2}, true);
  EXPECT_NEAR(seen(ball, {0, 0, -1}, slant), 50.0 / (kPi * 0.04), 1e-2);
  const light::Emitter tube = make(light::Tube{1.2, 0.05}, true);  // along x
  EXPECT_NEAR(seen(tube, {0, 0, -1}, {0.8F, 0, -0.6F}), 50.0 / (1.2 * 0.1 * 0.6), 1e-2);
}

TEST(EmitterRadiance, IsLimitedAtGrazing) {
  const light::Emitter flat = make(light::Rectangle{0.6, 0.5}, true);
  EXPECT_NEAR(seen(flat, {0, 0, -1}, {1, 0, -1e-6F}), 20.0 * 50.0 / 0.3, 0.1);
  const light::Emitter tube = make(light::Tube{1.2, 0.05}, true);
  EXPECT_NEAR(seen(tube, {0, 0, -1}, {1, 0, 0}), 20.0 * 50.0 / 0.12, 1.0);
}

TEST(EmitterRadiance, MeasuredMeshesUseTheirSilhouette) {
  auto mesh = std::make_shared<geometry::Mesh>();
  // A cube of 0.2 m: four vertices a face.
  const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-0.1F, 0.1F}) {
      const auto first = static_cast<std::uint32_t>(mesh->positions.size());
      const vec3 n = axes[axis] * side;
      const vec3 u = axes[(axis + 1) % 3] * 0.1F;
      const vec3 v = axes[(axis + 2) % 3] * 0.1F * (side > 0 ? 1.0F : -1.0F);
      for (const vec3& p : {n - u - v, n + u - v, n + u + v, n - u + v})
        mesh->positions.push_back(p);
      mesh->triangles.push_back({first, first + 1, first + 2});
      mesh->triangles.push_back({first, first + 2, first + 3});
    }
  }
  light::MeshShape shape;
  shape.mesh = mesh;
  const light::Emitter cube = make(shape, true);
  // On an axis, where the table has entries; a face is 0.04 m^2.
  EXPECT_NEAR(seen(cube, {0, 0, -1}, {0, 0, -1}), 50.0 / 0.04, 0.5);
  // On a diagonal sqrt(3) faces; truncation of a table with steps of 11 degrees.
  const double diagonal = 50.0 / (0.04 * std::sqrt(3.0));
  EXPECT_NEAR(seen(cube, {0, 0, -1}, {1, 1, -1}), diagonal, 0.02 * diagonal);
}

}  // namespace
}  // namespace soffit::render
