// SPDX-License-Identifier: MIT
#include "core/relight/reflectance.h"

#include "tests/core/relight/rooms.h"

namespace soffit::relight {
namespace {

using namespace testing;

TEST(LobeAlbedo, OfAMirrorIsFresnelsMean) {
  // 2 int (f + (1-f)(1-m)^5) m dm = f + (1-f)/21.
  for (const double f : {0.02, 0.04, 0.25, 0.9, 1.0})
    EXPECT_NEAR(lobeAlbedo(f, 0.0), f + (1.0 - f) / 21.0, 2e-3);
}

TEST(LobeAlbedo, IsZeroWithoutSpecularAndNeverAboveOne) {
  EXPECT_EQ(lobeAlbedo(0.0, 0.3), 0.0);
  for (const double roughness : {0.0, 0.1, 0.3, 0.5, 0.8, 1.0}) {
    EXPECT_LE(lobeAlbedo(1.0, roughness), 1.0 + 1e-12);
    EXPECT_GT(lobeAlbedo(1.0, roughness),
              0.35);  // single scattering at alpha 1 loses more than half
    EXPECT_LT(lobeAlbedo(0.04, roughness), lobeAlbedo(0.25, roughness));
  }
  // Rougher lobes lose more between the facets.
  EXPECT_GT(lobeAlbedo(1.0, 0.2), lobeAlbedo(1.0, 1.0));
}

Reflectances of(const std::vector<scene::Material>& materials, const transfer::Texels& texels) {
  return makeReflectances(texels, materials);
}

transfer::Texels twoQuads() {
  auto mesh = emptyMesh();
  addQuad(*mesh, {0, 0, 0}, {1, 0, 0}, {1, 0.7F, 0}, {0, 0.7F, 0}, 0);
  addQuad(*mesh, {0, 0, 1}, {1, 0, 1}, {1, 0.7F, 1}, {0, 0.7F, 1}, 1);
  for (const vec3& p : mesh->positions) mesh->uvs.emplace_back(p.x, p.y / 0.7F);
  const std::vector<std::uint8_t> sides(mesh->triangles.size(), transfer::kFront);
  return transfer::makeTexels(*mesh, sides, 0.1, nullptr);
}

TEST(Reflectances, AreTheMaterialsPlusTheirLobe) {
  const transfer::Texels texels = twoQuads();
  std::vector<scene::Material> materials(2);
  materials[0].diffuse = dvec3(0.5);
  materials[1].diffuse = {0.1, 0.2, 0.3};
  materials[1].specular = 0.04;
  materials[1].roughness = 0.3;
  const double lobe = lobeAlbedo(0.04, 0.3);
  const Reflectances r = of(materials, texels);
  EXPECT_FALSE(r.grey);
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected =
          texels.material[s] == 0 ? 0.5 : materials[1].diffuse[static_cast<int>(c)] + lobe;
      EXPECT_NEAR(static_cast<double>(r.rho[c][s]), expected, 1e-6);
    }
  }
  materials[1].diffuse = dvec3(0.2);
  EXPECT_TRUE(of(materials, texels).grey);
  materials[1].glass = scene::Glass{};
  const Reflectances glass = of(materials, texels);
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    EXPECT_EQ(glass.rho[0][s], texels.material[s] == 1 ? 0.0F : 0.5F);
  }
  materials[0].diffuse = dvec3(1.0);
  materials[0].specular = 0.5;
  const Reflectances bright = of(materials, texels);
  for (const float rho : bright.rho[0]) EXPECT_LE(rho, 1.0F);
}

TEST(Reflectances, FollowATexture) {
  const transfer::Texels texels = twoQuads();
  std::vector<scene::Material> materials(2);
  materials[0].diffuse = dvec3(0.5);
  // Left half black, right half white; row 0 (top, v = 1) red.
  auto image = std::make_shared<scene::Image>();
  image->width = 2;
  image->height = 2;
  image->pixels = {1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 1};
  materials[0].diffuse_image = image;
  const Reflectances r = of(materials, texels);
  EXPECT_FALSE(r.grey);
  int looked = 0;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    const vec3 p = texels.receivers.position(s);
    // A texel's square stands for a place of 0.1 x 0.14 in texture coordinates.
    if (texels.material[s] != 0 || std::abs(p.x - 0.5F) < 0.08F || std::abs(p.y - 0.35F) < 0.08F)
      continue;
    const vec3 expected = p.y > 0.35F ? vec3(0.5F, 0, 0) : (p.x > 0.5F ? vec3(0.5F) : vec3(0));
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(r.rho[c][s], expected[static_cast<int>(c)], 1e-6F) << p.x << ' ' << p.y;
    ++looked;
  }
  EXPECT_GT(looked, 30);
}

}  // namespace
}  // namespace soffit::relight
