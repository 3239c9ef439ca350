// SPDX-License-Identifier: MIT
#include "core/daylight/open_sky.h"

#include "core/daylight/hemisphere_cells.h"
#include "core/light/polygon_irradiance.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace soffit::daylight {
namespace {

/// A hall with a rectangular hole in its wall at x = 0, glazed or not.
struct WindowWall {
  geometry::Mesh mesh;
  std::vector<scene::Material> materials{2};
  std::array<dvec3, 4> hole;

  void quad(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, std::uint32_t m) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const dvec3& p : {a, b, c, d}) mesh.positions.emplace_back(p);
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
    mesh.material_of.insert(mesh.material_of.end(), {m, m});
  }
  WindowWall(double y0, double y1, double z0, double z1, bool glazed) {
    const auto at = [](double y, double z) { return dvec3(0.0, y, z); };
    constexpr double kFar = 100.0;
    const auto corner = [](int x, int y, int z) {
      return dvec3(kFar * x, kFar * (2 * y - 1), kFar * (2 * z - 1));
    };
    quad(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1), 0);
    for (const int k : {0, 1}) {
      quad(corner(0, k, 0), corner(1, k, 0), corner(1, k, 1), corner(0, k, 1), 0);
      quad(corner(0, 0, k), corner(1, 0, k), corner(1, 1, k), corner(0, 1, k), 0);
    }
    quad(at(-kFar, -kFar), at(kFar, -kFar), at(kFar, z0), at(-kFar, z0), 0);
    quad(at(-kFar, z1), at(kFar, z1), at(kFar, kFar), at(-kFar, kFar), 0);
    quad(at(-kFar, z0), at(y0, z0), at(y0, z1), at(-kFar, z1), 0);
    quad(at(y1, z0), at(kFar, z0), at(kFar, z1), at(y1, z1), 0);
    hole = {at(y0, z0), at(y1, z0), at(y1, z1), at(y0, z1)};
    materials[1].glass = scene::Glass{1.52, 0.88};
    if (glazed) quad(hole[0], hole[1], hole[2], hole[3], 1);
  }
};

/// E / L of the hole at p by Lambert's formula, whichever way the hole faces.
double formFactor(const WindowWall& wall, const dvec3& p, const dvec3& n) {
  std::vector<dvec3> outline(wall.hole.begin(), wall.hole.end());
  const double one = light::polygonIrradiance(outline, p, n);
  std::reverse(outline.begin(), outline.end());
  return std::max(one, light::polygonIrradiance(outline, p, n));
}

const Environment& even() {
  static const Environment e(
      {"", scene::Sky{.cie = 5, .horizontal_illuminance = kPi, .ground_reflectance = 1.0}});
  return e;  // 1 cd/m^2 from everywhere
}

TEST(HemisphereCells, PlacesAreTheInverseOfTheMap) {
  Rng rng(4);
  for (int i = 0; i < 5000; ++i) {
    const vec2 u(rng.uniform(), rng.uniform());
    const vec2 back = hemispherePlace(cosineHemisphere(u.x, u.y));
    EXPECT_LT(glm::length(back - u), 2e-5F) << u.x << ' ' << u.y;
  }
}

TEST(OpenSky, AnOpenPlaneGetsPiL) {
  const geometry::Mesh none;
  const geometry::RayCaster caster(none.positions, none.triangles);
  const std::vector<vec3> p(3, vec3(0.0F));
  const std::vector<vec3> n{vec3(0, 0, 1), glm::normalize(vec3(1, 2, 3)), vec3(0.0F)};
  const OpenSky sky(p, n, caster, nullptr, {});
  const auto e = sky.illuminance(even());
  EXPECT_NEAR(e[0].x, kPi, 1e-5);
  EXPECT_NEAR(e[1].y, kPi, 1e-5);
  EXPECT_EQ(e[2], vec3(0.0F));
  // A horizontal plane under every standard sky: the illuminance that it is scaled to.
  for (int type = 1; type <= 16; ++type) {
    const Environment cie({"", scene::Sky{.cie = type,
                                          .sun_azimuth_deg = 70.0,
                                          .sun_altitude_deg = 35.0,
                                          .horizontal_illuminance = 10000.0}});
    // Truncation of the midpoint rule at steps of 1.4 degrees: the sun's cusp.
    EXPECT_NEAR(sky.illuminance(cie)[0].x, 10000.0, 10000.0 * 2e-3) << type;
  }
}

TEST(OpenSky, AWindowFollowsLambertsFormula) {
  const WindowWall wall(-0.6, 0.6, 0.9, 2.1, false);
  const geometry::RayCaster caster(wall.mesh.positions, wall.mesh.triangles);
  Rng rng(6);
  std::vector<vec3> p;
  std::vector<vec3> n;
  for (int i = 0; i < 200; ++i) {
    p.emplace_back(0.8F + 2.2F * rng.uniform(), 3.0F * rng.uniform() - 1.5F, 2.5F * rng.uniform());
    n.push_back(i % 2 == 0 ? vec3(0, 0, 1) : vec3(-1, 0, 0));
  }
  const OpenSky sky(p, n, caster, nullptr, {.coarse = 64, .levels = 3});
  const auto e = sky.illuminance(even());
  double mean = 0.0;
  double error = 0.0;
  double bias = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double wanted = formFactor(wall, dvec3(p[i]), dvec3(n[i]));
    mean += wanted / double(p.size());
    error += std::pow(double(e[i].x) - wanted, 2.0) / double(p.size());
    bias += (double(e[i].x) - wanted) / double(p.size());
  }
  // Statistical: sqrt(P N) / 2 cells of N^2 (open_sky.h), at most 0.5 % of the mean here.
  EXPECT_LT(std::sqrt(error), 0.005 * mean);
  EXPECT_LT(std::abs(bias), 0.001 * mean);
}

TEST(OpenSky, GlassDimsByItsAngle) {
  const WindowWall wall(-0.6, 0.6, 0.9, 2.1, true);
  const auto panes = Panes::make(wall.mesh, wall.materials);
  const geometry::RayCaster caster = opaqueCaster(wall.mesh, panes.get());
  const vec3 p(1.5F, 0.2F, 0.8F);
  const vec3 n = glm::normalize(vec3(-1, 0, 1));
  const OpenSky sky(std::vector{p}, std::vector{n}, caster, panes.get(),
                    {.coarse = 64, .levels = 3});
  // The same integral over the pane by a product rule.
  const Slab slab(*wall.materials[1].glass);
  double wanted = 0.0;
  constexpr int kSteps = 400;
  for (int j = 0; j < kSteps; ++j) {
    for (int i = 0; i < kSteps; ++i) {
      const dvec3 q = wall.hole[0] + (wall.hole[1] - wall.hole[0]) * ((i + 0.5) / kSteps) +
                      (wall.hole[3] - wall.hole[0]) * ((j + 0.5) / kSteps);
      const dvec3 to = q - dvec3(p);
      const double r = glm::length(to);
      wanted += slab.at(to.x / r).transmitted * std::max(0.0, glm::dot(to, dvec3(n)) / r) *
                std::abs(to.x) / (r * r * r) * (1.2 * 1.2 / (kSteps * kSteps));
    }
  }
  EXPECT_NEAR(sky.illuminance(even())[0].x, wanted, 0.005 * wanted);
}

TEST(OpenSky, ASmallFarPaneIsFound) {
  // 0.2 x 0.2 m at 8 m: 1/15 of a cell of the first look.
  const WindowWall wall(-0.1, 0.1, 1.4, 1.6, true);
  const auto panes = Panes::make(wall.mesh, wall.materials);
  const geometry::RayCaster caster = opaqueCaster(wall.mesh, panes.get());
  std::vector<vec3> p;
  Rng rng(8);
  for (int i = 0; i < 100; ++i)
    p.emplace_back(7.0F + 2.0F * rng.uniform(), 2.0F * rng.uniform() - 1.0F, 1.0F + rng.uniform());
  const std::vector<vec3> n(p.size(), vec3(-1, 0, 0));
  const OpenSky sky(p, n, caster, panes.get(), {.coarse = 64, .levels = 3});
  const auto e = sky.illuminance(even());
  double sum = 0.0;
  double wanted = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum += double(e[i].x);
    wanted += 0.88 * formFactor(wall, dvec3(p[i]), dvec3(n[i]));
  }
  EXPECT_NEAR(sum, wanted, 0.02 * wanted);
}

TEST(OpenSky, AClosedRoomSeesNothing) {
  WindowWall wall(-0.6, 0.6, 0.9, 2.1, false);
  wall.quad(wall.hole[0], wall.hole[1], wall.hole[2], wall.hole[3], 0);
  const geometry::RayCaster caster(wall.mesh.positions, wall.mesh.triangles);
  const OpenSky sky(std::vector{vec3(0.5F, 0, 1)}, std::vector{vec3(-1, 0, 0)}, caster, nullptr,
                    {});
  EXPECT_FALSE(sky.any());
}

}  // namespace
}  // namespace soffit::daylight
