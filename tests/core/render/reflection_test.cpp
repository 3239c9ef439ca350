// SPDX-License-Identifier: MIT
#include "core/render/microfacet.h"
#include "core/render/view_renderer.h"
#include "tests/core/render/test_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265F;

RenderOptions options(int side = 24) {
  RenderOptions o;
  o.width = side;
  o.height = side;
  return o;
}

light::Luminaire lamp(const light::Shape& shape, const dvec3& position, double flux) {
  light::Luminaire l;
  l.name = "L";
  l.shape = shape;
  l.position = position;
  l.flux = flux;
  return l;
}

/// Mean luminance of the middle of a picture.
double middle(const Film& film, int half = 4) {
  double sum = 0.0;
  for (int y = film.height / 2 - half; y < film.height / 2 + half; ++y)
    for (int x = film.width / 2 - half; x < film.width / 2 + half; ++x)
      sum += static_cast<double>(film.radiance[film.at(x, y)].y);
  return sum / (4.0 * half * half);
}

/// A floor of one material, nothing else.
std::unique_ptr<ViewScene> floorWith(const scene::Material& material,
                                     const std::vector<light::Luminaire>& lamps) {
  SceneBuilder builder;
  builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, builder.addMaterial(material));
  return builder.build(lamps);
}

TEST(Mirror, ShowsALuminaireByItsFresnelReflectance) {
  // Under 45 degrees, towards a panel that stands where the reflection goes.
  auto panel = lamp(light::Rectangle{4.0, 4.0}, {0, 3, 3}, 1000.0);
  panel.rotation_deg = {-45, 0, 0};  // faces the origin
  const auto scene =
      floorWith({.diffuse = dvec3(0.0), .specular = 0.04, .roughness = 0.0}, {panel});
  const scene::Camera camera{"A", {0, -3, 3}, {0, 0, 0}, 10.0};
  const auto film = renderView(*scene, camera, EvenLight(vec3(100)), options()).value();
  const double luminance = 1000.0 / (kPi * 16.0);
  const double fresnel = static_cast<double>(schlick(0.04F, std::sqrt(0.5F)));
  EXPECT_NEAR(film.radiance[film.at(12, 12)].y, luminance * fresnel,
              4e-3 * luminance * fresnel);  // half a pixel off the axis
}

TEST(Mirror, ShowsTheDiffuseLightOfSurfaces) {
  SceneBuilder builder;
  builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0},
                  builder.addMaterial({.diffuse = dvec3(0.0), .specular = 1.0, .roughness = 0.0}));
  builder.addQuad({-50, 5, 0}, {100, 0, 0}, {0, 0, 50},
                  builder.addMaterial({.diffuse = dvec3(0.1, 0.6, 0.3)}));
  const auto scene = builder.build();
  const scene::Camera camera{"A", {0, -3, 3}, {0, 0, 0}, 10.0};
  const auto film = renderView(*scene, camera, EvenLight(vec3(100 * kPiF)), options()).value();
  const vec3& p = film.radiance[film.at(12, 12)];
  EXPECT_NEAR(p.x, 10.0F, 1e-3F);  // round-off
  EXPECT_NEAR(p.y, 60.0F, 1e-2F);
  EXPECT_NEAR(p.z, 30.0F, 1e-2F);
}

TEST(Mirror, FacingMirrorsShowEachOtherTwice) {
  // Down into one mirror, up into another, and down on a white strip beside the first.
  SceneBuilder builder;
  const auto mirror =
      builder.addMaterial({.diffuse = dvec3(0.0), .specular = 0.8, .roughness = 0.0});
  const auto white = builder.addMaterial({.diffuse = dvec3(1.0)});
  builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 51, 0}, mirror);  // y < 1
  builder.addQuad({-50, 1, 0}, {100, 0, 0}, {0, 50, 0}, white);     // y > 1
  builder.addQuad({-50, 0.1F, 3}, {100, 0, 0}, {0, 50, 0}, mirror);
  const auto scene = builder.build();
  const scene::Camera camera{
      "A", {0, -1, 2}, {0, 0, 0}, 5.0};  // 1.5 m up, y = 1.5; then y = 3 on the floor
  RenderOptions o = options();
  const EvenLight light{vec3(kPiF)};
  const double direction = std::atan2(1.0, 2.0);
  const double once = static_cast<double>(schlick(0.8F, static_cast<float>(std::cos(direction))));
  const auto film = renderView(*scene, camera, light, o).value();
  EXPECT_NEAR(middle(film), once * once, 2e-3);  // the angle differs over the pixels
  o.max_reflections = 1;
  EXPECT_NEAR(middle(renderView(*scene, camera, light, o).value()), 0.0, 1e-6);
}

TEST(RoughReflection, InAnEvenlyBrightRoomIsTheLobesAlbedo) {
  // Furnace: whatever the lobe sees has luminance 100, so it shows 100 times its albedo.
  for (const double roughness : {0.2, 0.4, 0.7}) {
    const auto scene = furnace(roughness);
    const scene::Camera camera{"A", {0, -2, 3}, {0, 0, 0}, 4.0};
    const auto film = renderView(*scene, camera, EvenLight(vec3(100 * kPiF)), options(48)).value();
    const double cosine = 3.0 / std::sqrt(13.0);
    const vec3 wo(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    double albedo = 0.0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
      albedo += static_cast<double>(sampleGgx(wo, 0.5F, static_cast<float>(roughness * roughness),
                                              vec2(r2Sequence(i)))
                                        .weight) /
                4096;
    }
    // Truncation: 16 pixels of 8 rays each make one set of 128 low-discrepancy rays, 16 sets here.
    EXPECT_NEAR(middle(film, 8), 100.0 * albedo, 1.0) << roughness;
  }
}

TEST(RoughReflection, OfALampMatchesQuadratureOverTheLamp) {
  for (const double roughness : {0.2, 0.35, 0.6}) {
    const double radius = 0.15;
    const auto scene = floorWith({.diffuse = dvec3(0.0), .specular = 0.1, .roughness = roughness},
                                 {lamp(light::Sphere{radius}, {0, 1.2, 1.5}, 1000.0)});
    const scene::Camera camera{"A", {0, -1.5, 1.5}, {0, 0, 0}, 2.0};
    const auto film = renderView(*scene, camera, EvenLight(vec3(0)), options(48)).value();
    // Quadrature over the cone of the sphere as seen from the origin.
    const dvec3 d(0, 1.2, 1.5);
    const double r = glm::length(d);
    const double cos_max = std::sqrt(1.0 - radius * radius / (r * r));
    vec3 t, b;
    const vec3 axis(d / r);
    orthonormalBasis(axis, t, b);
    const vec3 wo = glm::normalize(vec3(0, -1.5F, 1.5F));
    double sum = 0.0;
    constexpr std::uint32_t kPoints = 20000;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const dvec2 u = r2Sequence(i);
      const double z = 1.0 - u.x * (1.0 - cos_max);
      const double s = std::sqrt(1.0 - z * z);
      const vec3 wi = static_cast<float>(s * std::cos(2 * kPi * u.y)) * t +
                      static_cast<float>(s * std::sin(2 * kPi * u.y)) * b +
                      static_cast<float>(z) * axis;
      sum += static_cast<double>(
                 ggxReflection(wo, wi, 0.1F, static_cast<float>(roughness * roughness))) /
             kPoints;
    }
    const double luminance = 1000.0 / (kPi * 4 * kPi * radius * radius);
    const double expected = sum * 2 * kPi * (1.0 - cos_max) * luminance;
    // Truncation: 16 shadow rays and 64 lobe rays make one set, over an integrand that varies
    // little.
    EXPECT_NEAR(middle(film, 8), expected, 0.04 * expected) << roughness;
  }
}

TEST(RoughReflection, OfAPointSourceIsTheBrdf) {
  auto source = lamp(light::PointShape{}, {0, 1.5, 2}, 4 * kPi * 100.0);
  source.distribution.kind = light::DistributionKind::isotropic;
  const auto scene =
      floorWith({.diffuse = dvec3(0.0), .specular = 0.1, .roughness = 0.5}, {source});
  const scene::Camera camera{"A", {0, -1.5, 1.5}, {0, 0, 0}, 1.0};
  const auto film = renderView(*scene, camera, EvenLight(vec3(0)), options()).value();
  const vec3 wo = glm::normalize(vec3(0, -1.5F, 1.5F));
  const vec3 wi = glm::normalize(vec3(0, 1.5F, 2.0F));
  const double expected =
      100.0 / (1.5 * 1.5 + 4.0) * static_cast<double>(ggxReflection(wo, wi, 0.1F, 0.25F));
  EXPECT_NEAR(middle(film, 2), expected, 5e-3 * expected);  // the angles differ over the pixels
}

TEST(RoughReflection, EachPartOfARoughnessMapIsThatMaterial) {
  // A wide floor under a lamp, seen from above; the map parts it at x = 0: 0.2 to the left, 0.6 to
  // the right.
  const auto picture = [](double roughness, const std::shared_ptr<const scene::Image>& map) {
    SceneBuilder builder;
    builder.addQuad({-4, -2, 0}, {8, 0, 0}, {0, 4, 0},
                    builder.addMaterial({.diffuse = dvec3(0.0),
                                         .specular = 0.1,
                                         .roughness = roughness,
                                         .roughness_image = map}));
    const auto scene = builder.build({lamp(light::Sphere{0.1}, {0, 1, 1.5}, 8000.0)});
    const scene::Camera camera{"A", {0, -2, 3}, {0, 0, 0}, 50.0};
    return renderView(*scene, camera, EvenLight(vec3(100)), options(48)).value();
  };
  scene::Image halves{64, 1, 3, {}};
  for (int x = 0; x < 64; ++x)
    halves.pixels.insert(halves.pixels.end(), {0, x < 32 ? 0.25F : 0.75F, 0});
  const Film both = picture(0.8, std::make_shared<const scene::Image>(std::move(halves)));
  const Film left = picture(0.8 * 0.25, nullptr);
  const Film right = picture(0.8 * 0.75, nullptr);
  double apart = 0.0;
  for (int y = 4; y < 44; ++y) {
    for (int x = 4; x < 44; ++x) {
      if (std::abs(x - 24) < 6) continue;  // the seam, and the blocks that are smoothed across it
      const float found = both.radiance[both.at(x, y)].y;
      const float same = (x < 24 ? left : right).radiance[both.at(x, y)].y;
      EXPECT_NEAR(found, same, 2e-5F * same + 1e-5F) << x << ' ' << y;
      apart = std::max(apart, std::abs(static_cast<double>(left.radiance[both.at(x, y)].y -
                                                           right.radiance[both.at(x, y)].y)));
    }
  }
  EXPECT_GT(apart, 1.0) << "the halves differ at all, cd/m^2";
}

TEST(RoughReflection, LampsAreHiddenByWalls) {
  SceneBuilder builder;
  builder.addQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0},
                  builder.addMaterial({.diffuse = dvec3(0.0), .specular = 0.1, .roughness = 0.4}));
  builder.addQuad({-50, 0.6F, 0}, {100, 0, 0}, {0, 0, 50},
                  builder.addMaterial({.diffuse = dvec3(0.0)}));
  const auto scene = builder.build({lamp(light::Sphere{0.15}, {0, 1.2, 1.5}, 1000.0)});
  const scene::Camera camera{"A", {0, -1.5, 1.5}, {0, 0, 0}, 2.0};
  const auto film = renderView(*scene, camera, EvenLight(vec3(0)), options()).value();
  EXPECT_EQ(middle(film), 0.0);
}

TEST(Reflections, AreLeftOutOfIlluminancePictures) {
  const auto scene = floorWith({.diffuse = dvec3(0.0), .specular = 0.9, .roughness = 0.3},
                               {lamp(light::Sphere{0.5}, {0, 0, 3}, 1000.0)});
  RenderOptions o = options();
  o.quantity = Quantity::illuminance;
  const scene::Camera camera{"A", {0, -3, 3}, {0, 0, 0}, 5.0};
  const auto film = renderView(*scene, camera, EvenLight(vec3(120)), o).value();
  EXPECT_EQ(middle(film), 0.0);
  EXPECT_NEAR(film.lux[film.at(12, 12)], 120.0F, 1e-3F);
}

TEST(RoughReflection, OfACurvedBodyIsTheSameInASmallPicture) {
  // A ball of rough metal under a small bright lamp, 24 pixels across: its highlight is a few
  // pixels wide. Each pixel against the mean of the same place in a picture eight times as large.
  SceneBuilder builder;
  const auto metal =
      builder.addMaterial({.diffuse = dvec3(0.05), .specular = 0.5, .roughness = 0.45});
  builder.addBox({-3, -3, -1}, {3, 3, 3}, builder.addMaterial({.diffuse = dvec3(0.5)}), true);
  builder.addSphere({0, 0, 0}, 0.5F, 64, metal);
  const auto scene = builder.build({lamp(light::Rectangle{0.1, 0.1}, {0.8, -1.5, 2.5}, 3000.0)});
  const scene::Camera camera{"A", {0, -2.5, 0.6}, {0, 0, 0}, 25.0};
  const SampledLight light(*scene, 16, vec3(20));
  const auto small = renderView(*scene, camera, light, options(28)).value();
  constexpr int kTimes = 8;
  const auto large = renderView(*scene, camera, light, options(28 * kTimes)).value();
  double squares = 0.0;
  double mean = 0.0;
  int counted = 0;
  for (int y = 8; y < 20; ++y) {
    for (int x = 8; x < 20; ++x) {  // well inside of the ball
      // The pixel's own filter, a tent over it and its neighbours.
      double sum = 0.0;
      double weights = 0.0;
      for (int j = -kTimes; j < kTimes; ++j) {
        for (int i = -kTimes; i < kTimes; ++i) {
          const double w = (1.0 - std::abs(i + 0.5) / kTimes) * (1.0 - std::abs(j + 0.5) / kTimes);
          const int column = x * kTimes + kTimes / 2 + i;
          const int row = y * kTimes + kTimes / 2 + j;
          sum += w * static_cast<double>(large.radiance[large.at(column, row)].y);
          weights += w;
        }
      }
      const double wanted = sum / weights;
      squares += std::pow(static_cast<double>(small.radiance[small.at(x, y)].y) - wanted, 2.0);
      mean += wanted;
      ++counted;
    }
  }
  // 128 rays into the lobes of 16 places per pixel, where the highlight may double from pixel to
  // pixel: 5.3 %, of which 4.2 stay with 64 places; four places missed by 17 %.
  EXPECT_LT(std::sqrt(squares / counted) / (mean / counted), 0.07);
}

}  // namespace
}  // namespace soffit::render
