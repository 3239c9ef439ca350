// SPDX-License-Identifier: MIT
#include "core/io/model/material_conversion.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/io/model/sample_models.h"
#include "tests/core/io/model/scratch_folder.h"

namespace soffit::io {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kSingle = 1e-7;  // round-off of single precision, at 1

// A triangle with the material "m" of the given library text.
ImportedModel objWith(const ScratchFolder& folder, const std::string& mtl) {
  folder.write("a.mtl", "newmtl m\n" + mtl);
  auto model = importModel(folder.write("a.obj",
                                        "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                        "f 1 2 3\n"),
                           {});
  EXPECT_TRUE(model);
  return model ? *std::move(model) : ImportedModel{};
}

ImportedModel gltfWith(const ScratchFolder& folder, const std::string& material,
                       const std::string& more = "") {
  auto model = importModel(folder.write("a.gltf", triangleGltf("", material, more)), {});
  EXPECT_TRUE(model) << (model ? "" : model.error().message());
  return model ? *std::move(model) : ImportedModel{};
}

void expectColor(const dvec3& c, const dvec3& expected) {
  EXPECT_LT(glm::distance(c, expected), 4 * kSingle);
}

TEST(MtlMaterials, ColorsAreLinear) {
  const ScratchFolder folder;
  const ImportedModel model = objWith(folder, "Kd 0.1 0.2 0.6\n");
  ASSERT_EQ(model.materials.size(), 1U);
  EXPECT_EQ(model.materials[0].name, "m");
  expectColor(model.materials[0].diffuse, {0.1, 0.2, 0.6});
  EXPECT_EQ(model.materials[0].specular, 0.0);
  EXPECT_EQ(model.materials[0].roughness, 0.5);
  EXPECT_FALSE(model.materials[0].glass);
  EXPECT_TRUE(model.described.at(0));
}

TEST(MtlMaterials, WithoutAColorTheyAreUndescribedGrey) {
  const ScratchFolder folder;
  const ImportedModel model = objWith(folder, "Ka 1 1 1\n");
  expectColor(model.materials.at(0).diffuse, {0.5, 0.5, 0.5});
  EXPECT_FALSE(model.described.at(0));
  // The grey that the importer would fill in, stated by the file: described.
  EXPECT_TRUE(objWith(folder, "Kd 0.6 0.6 0.6\n").described.at(0));
}

TEST(MtlMaterials, AMissingLibraryKeepsTheNames) {
  const ScratchFolder folder;
  const auto model = importModel(
      folder.write("a.obj", "mtllib none.mtl\nusemtl oak\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
      {});
  ASSERT_TRUE(model);
  EXPECT_THAT(model->mesh.materials, ElementsAre("oak"));
  EXPECT_FALSE(model->described.at(0));
}

TEST(MtlMaterials, HighlightsFollowTheConventionOfEightPercent) {
  const ScratchFolder folder;
  const ImportedModel model = objWith(folder, "Kd 0.2 0.2 0.2\nKs 0.5 0.5 0.5\nNs 250\nillum 2\n");
  EXPECT_NEAR(model.materials.at(0).specular, 0.04, kSingle);
  EXPECT_NEAR(model.materials[0].roughness, std::pow(2.0 / 252.0, 0.25), kSingle);
  EXPECT_EQ(objWith(folder, "Kd 0.2 0.2 0.2\nKs 0.5 0.5 0.5\nillum 1\n").materials.at(0).specular,
            0.0);
}

TEST(MtlMaterials, RayTracedReflectionIsTheReflectance) {
  const ScratchFolder folder;
  const ImportedModel model = objWith(folder, "Kd 0.1 0.1 0.1\nKs 0.7 0.7 0.7\nillum 3\nPr 0.2\n");
  EXPECT_NEAR(model.materials.at(0).specular, 0.7, 4 * kSingle);
  EXPECT_NEAR(model.materials[0].roughness, 0.2, kSingle);
}

TEST(MtlMaterials, EnergyIsKept) {
  const ScratchFolder folder;
  const ImportedModel model = objWith(folder, "Kd 1.5 0.2 0.2\nKs 0.7 0.7 0.7\nillum 3\n");
  expectColor(model.materials.at(0).diffuse, {1, 0.2, 0.2});
  EXPECT_EQ(model.materials[0].specular, 0.0);
  EXPECT_THAT(model.warnings, Contains(HasSubstr("material 'm': its color is above 1")));
}

TEST(MtlMaterials, MoreThanHalfTransparentIsGlass) {
  const ScratchFolder folder;
  const ImportedModel model = objWith(folder, "Kd 1 1 1\nd 0.3\n");
  EXPECT_TRUE(model.materials.at(0).glass);
  EXPECT_THAT(model.warnings, Contains(HasSubstr("becomes clear glass")));
  EXPECT_FALSE(objWith(folder, "Kd 1 1 1\nd 0.6\n").materials.at(0).glass);
}

TEST(MtlMaterials, TexturesAreFoundBesideTheModel) {
  const ScratchFolder folder;
  folder.write("maps/oak wood.png", "x");
  folder.write("n.png", "x");
  const ImportedModel model =
      objWith(folder, "map_Kd maps\\oak wood.png\nnorm n.png\nmap_Bump height.png\n");
  EXPECT_EQ(model.materials.at(0).diffuse_map, "maps/oak wood.png");
  EXPECT_EQ(model.materials[0].normal_map, "n.png");
  expectColor(model.materials[0].diffuse, {1, 1, 1});  // the texture alone is the color
  EXPECT_TRUE(model.described.at(0));
  EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(MtlMaterials, MissingTexturesAreReported) {
  const ScratchFolder folder;
  const ImportedModel model = objWith(folder, "Kd 0.3 0.3 0.3\nmap_Kd gone.png\n");
  EXPECT_EQ(model.materials.at(0).diffuse_map, "");
  expectColor(model.materials[0].diffuse, {0.3, 0.3, 0.3});
  EXPECT_THAT(model.warnings, Contains("material 'm': texture 'gone.png' does not exist, so its "
                                       "surfaces keep their plain color"));
}

TEST(GltfMaterials, DielectricsReflectFourPercentUnlessMatte) {
  const ScratchFolder folder;
  const std::string text =
      R"({{"name":"paint","pbrMetallicRoughness":{{"baseColorFactor":[0.2,0.4,0.6,1],)"
      R"("metallicFactor":0,"roughnessFactor":{}}}}})";
  ImportedModel model = gltfWith(folder, fmt::format(fmt::runtime(text), 0.3));
  expectColor(model.materials.at(0).diffuse, {0.2, 0.4, 0.6});
  EXPECT_NEAR(model.materials[0].specular, 0.04, kSingle);
  EXPECT_NEAR(model.materials[0].roughness, 0.3, kSingle);
  model = gltfWith(folder, fmt::format(fmt::runtime(text), 1.0));
  EXPECT_EQ(model.materials.at(0).specular, 0.0);
  EXPECT_EQ(model.materials[0].name, "paint");
}

TEST(GltfMaterials, MetalsReflectTheirColor) {
  const ScratchFolder folder;
  const ImportedModel model = gltfWith(
      folder,
      R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1],"roughnessFactor":0.1}})");
  expectColor(model.materials.at(0).diffuse, {0, 0, 0});
  EXPECT_NEAR(model.materials[0].specular, 0.5, 4 * kSingle);
  EXPECT_NEAR(model.materials[0].roughness, 0.1, kSingle);
}

TEST(GltfMaterials, DefaultsAloneDescribeNothing) {
  const ScratchFolder folder;
  for (const std::string material : {"", R"({"name":"m"})"}) {
    const ImportedModel model = gltfWith(folder, material);
    expectColor(model.materials.at(0).diffuse, {0.5, 0.5, 0.5});
    EXPECT_EQ(model.materials[0].specular, 0.0);
    EXPECT_FALSE(model.described.at(0)) << material;
  }
}

TEST(GltfMaterials, AlphaCountsOnlyWhereItBlends) {
  const ScratchFolder folder;
  const std::string base = R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.2],)"
                           R"("metallicFactor":0})";
  EXPECT_FALSE(gltfWith(folder, "{" + base + "}").materials.at(0).glass);
  EXPECT_TRUE(gltfWith(folder, R"({"alphaMode":"BLEND",)" + base + "}").materials.at(0).glass);
}

TEST(GltfMaterials, TexturesInsideTheFileAreHandedOver) {
  const ScratchFolder folder;
  const ImportedModel model = gltfWith(
      folder,
      R"({"name":"m","pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}})",
      R"("textures":[{"source":0}],)"
      R"("images":[{"uri":"data:image/png;base64,iVBORw0KGgo="}],)");
  EXPECT_EQ(model.materials.at(0).diffuse_map, "a_texture0.png");
  ASSERT_EQ(model.embedded_textures.size(), 1U);
  EXPECT_EQ(model.embedded_textures[0].path, "a_texture0.png");
  const std::vector<std::uint8_t> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  EXPECT_EQ(model.embedded_textures[0].bytes, signature);
}

TEST(GltfMaterials, ARoughnessTextureMultipliesTheFactor) {
  const ScratchFolder folder;
  folder.write("mr.png", "x");
  const auto with = [&](const char* factors) {
    return gltfWith(folder,
                    std::string(R"({"name":"m","pbrMetallicRoughness":{"baseColorFactor":)"
                                R"([0.5,0.5,0.5,1],"metallicRoughnessTexture":{"index":0})") +
                        factors + "}}",
                    R"("textures":[{"source":0}],"images":[{"uri":"mr.png"}],)");
  };
  const ImportedModel plain = with(R"(,"metallicFactor":0)");
  EXPECT_EQ(plain.materials.at(0).roughness_map, "mr.png");
  EXPECT_NEAR(plain.materials.at(0).roughness, 1.0, kSingle);
  EXPECT_NEAR(plain.materials.at(0).specular, 0.04, kSingle);
  EXPECT_THAT(plain.warnings, Not(Contains(HasSubstr("metal texture"))));
  const ImportedModel half = with(R"(,"metallicFactor":0,"roughnessFactor":0.5)");
  EXPECT_NEAR(half.materials.at(0).roughness, 0.5, kSingle);
}

TEST(ObjMaterials, ARoughnessPictureIsRead) {
  const ScratchFolder folder;
  folder.write("r.png", "x");
  folder.write("a.mtl", "newmtl m\nKd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nillum 2\nmap_Pr r.png\n");
  const auto model = importModel(
      folder.write("a.obj", "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), {});
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->materials.at(0).roughness_map, "r.png");
  EXPECT_NEAR(model->materials.at(0).roughness, 1.0, kSingle);
}

TEST(GltfMaterials, AMetalTextureIsReported) {
  const ScratchFolder folder;
  folder.write("mr.png", "x");
  const ImportedModel model = gltfWith(
      folder, R"({"name":"m","pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}})",
      R"("textures":[{"source":0}],"images":[{"uri":"mr.png"}],)");
  EXPECT_NEAR(model.materials.at(0).specular, 0.0, kSingle);  // its white base leaves no room
  EXPECT_THAT(model.warnings, Contains(HasSubstr("metal texture is not read")));
}

TEST(OtherMaterials, FormatsWithoutColorsAreUndescribed) {
  const ScratchFolder folder;
  for (const auto& [name, text] : {std::pair{"a.ply", kBlockPly}, {"a.stl", kTriangleStl}}) {
    const auto model = importModel(folder.write(name, text), {});
    ASSERT_TRUE(model) << model.error().message();
    EXPECT_THAT(model->mesh.materials, ElementsAre("default"));
    expectColor(model->materials.at(0).diffuse, {0.5, 0.5, 0.5});
    EXPECT_FALSE(model->described.at(0));
  }
}

TEST(OtherMaterials, EqualNamesAreNumbered) {
  const ScratchFolder folder;
  const std::string materials =
      R"x({"name":"m","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}},)x"
      R"x({"name":"m","pbrMetallicRoughness":{"baseColorFactor":[0,1,0,1]}},)x"
      R"x({"name":"m (2)","pbrMetallicRoughness":{"baseColorFactor":[0,0,1,1]}})x";
  std::string text = triangleGltf(R"("children":[1,2])", materials);
  const std::string primitive = R"x({"primitives":[{"attributes":{"POSITION":0},"material":0}]})x";
  std::string meshes = primitive;
  for (const char* index : {"1", "2"}) {
    std::string other = primitive;
    meshes += "," + other.replace(other.find("\"material\":0") + 11, 1, index);
  }
  text.replace(text.find(primitive), primitive.size(), meshes);
  text.replace(text.find("}],\"meshes\""), 2,
               R"x(},{"mesh":1,"translation":[0,0,1]},{"mesh":2,"translation":[0,0,2]}])x");
  const auto model = importModel(folder.write("a.gltf", text), {});
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_THAT(model->mesh.materials, ElementsAre("m", "m (2)", "m (2) (2)"));
}

}  // namespace
}  // namespace soffit::io
