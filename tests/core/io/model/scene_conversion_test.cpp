// SPDX-License-Identifier: MIT
#include "core/io/model/scene_conversion.h"

#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "core/geometry/components.h"
#include "core/io/model/model_import.h"
#include "tests/core/io/model/sample_models.h"
#include "tests/core/io/model/scratch_folder.h"

namespace soffit::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Round-off of single precision at 5 m, some operations.
constexpr double kRoundoff = 8 * 4 * 0x1p-24;

void expectBounds(const std::filesystem::path& file, const ImportOptions& options, const dvec3& lo,
                  const dvec3& hi) {
  const auto model = importModel(file, options);
  ASSERT_TRUE(model) << model.error().message();
  const Box box = model->mesh.bounds();
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(box.lo[k], lo[k], kRoundoff) << file << k;
    EXPECT_NEAR(box.hi[k], hi[k], kRoundoff) << file << k;
  }
}

// Writes the block in another format, in its own coordinates: z up, whatever the format says.
std::filesystem::path exported(const ScratchFolder& folder, const char* format, const char* name) {
  const auto source = folder.write("source.obj", kBlockObj);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(source.string(), 0);
  EXPECT_NE(scene, nullptr);
  const auto file = folder.path() / name;
  EXPECT_EQ(Assimp::Exporter().Export(scene, format, file.string()), AI_SUCCESS);
  return file;
}

void replaceIn(const std::filesystem::path& file, const std::string& pattern,
               const std::string& with) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string changed = std::regex_replace(text, std::regex(pattern), with);
  EXPECT_NE(text, changed);
  std::ofstream(file, std::ios::binary) << changed;
}

const dvec3 kLo(0, 0, 0);
const dvec3 kHi(4, 5, 2.8);
const dvec3 kTurnedLo(0, -2.8, 0);  // after turning y up
const dvec3 kTurnedHi(4, 0, 5);

TEST(Axes, FormatsWithoutAnAxisAreZUp) {
  const ScratchFolder folder;
  expectBounds(folder.write("a.obj", kBlockObj), {}, kLo, kHi);
  expectBounds(folder.write("a.ply", kBlockPly), {}, kLo, kHi);
  expectBounds(folder.write("a.stl", kTriangleStl), {}, kLo, kHi);
  expectBounds(folder.write("b.stl", kTriangleStl), {.up = 'y'}, kTurnedLo, kTurnedHi);
}

TEST(Axes, ThreeDsIsZUp) {
  const ScratchFolder folder;
  const auto file = exported(folder, "3ds", "a.3ds");
  expectBounds(file, {}, kLo, kHi);
  expectBounds(file, {.up = 'z'}, kLo, kHi);
  expectBounds(file, {.up = 'y'}, kTurnedLo, kTurnedHi);
}

TEST(Axes, GltfIsYUpUnlessTold) {
  const ScratchFolder folder;
  const auto file = exported(folder, "glb2", "a.glb");
  expectBounds(file, {}, kTurnedLo, kTurnedHi);
  expectBounds(file, {.up = 'z'}, kLo, kHi);
}

TEST(Axes, ColladaStatesAxisAndUnit) {
  const ScratchFolder folder;
  const auto file = exported(folder, "collada", "a.dae");
  expectBounds(file, {}, kTurnedLo, kTurnedHi);
  replaceIn(file, "Y_UP", "Z_UP");
  expectBounds(file, {}, kLo, kHi);
  expectBounds(file, {.up = 'z'}, kLo, kHi);
  expectBounds(file, {.up = 'y'}, kTurnedLo, kTurnedHi);
  replaceIn(file, "meter=\"1\"", "meter=\"0.01\"");
  expectBounds(file, {.scale = 100.0}, kLo, kHi);
}

TEST(Axes, FbxStatesAxisAndCentimetres) {
  const ScratchFolder folder;
  const auto file = exported(folder, "fbxa", "a.fbx");
  expectBounds(file, {.unit = 100.0}, kTurnedLo, kTurnedHi);
  replaceIn(file, "\"UnitScaleFactor\", \"double\", \"Number\", \"\", 1",
            "\"UnitScaleFactor\", \"double\", \"Number\", \"\", 100");
  expectBounds(file, {}, kTurnedLo, kTurnedHi);
  replaceIn(file, "\"UpAxis\", \"int\", \"Integer\", \"\", 1",
            "\"UpAxis\", \"int\", \"Integer\", \"\", 2");
  expectBounds(file, {}, kLo, kHi);
  expectBounds(file, {.up = 'y'}, kTurnedLo, kTurnedHi);
  replaceIn(file, "\"UpAxis\", \"int\", \"Integer\", \"\", 2",
            "\"UpAxis\", \"int\", \"Integer\", \"\", 0");
  expectBounds(file, {}, {-2.8, 0, 0}, {0, 5, 4});
}

TEST(Axes, IfcComesInMetresAndZUp) {
  const ScratchFolder folder;
  const auto file = folder.write("a.ifc", kBlockIfc);
  expectBounds(file, {}, {-2, -2.5, 0}, {2, 2.5, 2.8});
  expectBounds(file, {.up = 'z'}, {-2, -2.5, 0}, {2, 2.5, 2.8});
  const auto model = importModel(file, {});
  ASSERT_TRUE(model);
  EXPECT_THAT(model->mesh.materials, ElementsAre("Brick"));
  EXPECT_NEAR(model->materials[0].diffuse.y, 0.4, 1e-7);  // round-off of single precision
  EXPECT_THAT(model->mesh.objects, ElementsAre(HasSubstr("Block")));
  // Exact, although the importer turns by a rounded sine: the floor is level.
  std::set<float> heights;
  for (const vec3& p : model->mesh.positions) heights.insert(p.z);
  EXPECT_EQ(heights.size(), 2U);
}

TEST(Nodes, TransformsAreApplied) {
  const ScratchFolder folder;
  const auto file =
      folder.write("a.gltf", triangleGltf(R"("translation":[10,20,30],"scale":[2,3,1])", ""));
  expectBounds(file, {.up = 'z'}, {10, 20, 30}, {12, 23, 30});
}

TEST(Nodes, MirroredOnesKeepTheirFronts) {
  const ScratchFolder folder;
  const auto plain = importModel(folder.write("a.gltf", triangleGltf("", "")), {.up = 'z'});
  const auto mirrored =
      importModel(folder.write("b.gltf", triangleGltf(R"("scale":[-1,1,1])", "")), {.up = 'z'});
  ASSERT_TRUE(plain);
  ASSERT_TRUE(mirrored);
  for (const vec3& n : plain->mesh.normals) EXPECT_EQ(n, vec3(0, 0, 1));
  for (const vec3& n : mirrored->mesh.normals) EXPECT_EQ(n, vec3(0, 0, 1));
  EXPECT_EQ(mirrored->mesh.bounds().lo.x, -1.0F);
}

TEST(Nodes, NormalsTurnAsSurfacesDo) {
  // A plane at 45 degrees, stretched along x: its normal leans the other way.
  const ScratchFolder folder;
  const auto file = exported(folder, "gltf2", "a.gltf");
  const auto model = importModel(file, {.up = 'z'});
  ASSERT_TRUE(model);
  EXPECT_EQ(model->mesh.triangles.size(), 12U);
  aiScene scene;
  scene.mRootNode = new aiNode("root");
  scene.mRootNode->mMeshes = new unsigned[1]{0};
  scene.mRootNode->mNumMeshes = 1;
  scene.mMeshes = new aiMesh* [1] { new aiMesh };
  scene.mNumMeshes = 1;
  aiMesh& mesh = *scene.mMeshes[0];
  mesh.mNumVertices = 3;
  mesh.mVertices = new aiVector3D[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.mNormals = new aiVector3D[3]{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  mesh.mFaces = new aiFace[1];
  mesh.mNumFaces = 1;
  mesh.mFaces[0].mNumIndices = 3;
  mesh.mFaces[0].mIndices = new unsigned[3]{0, 1, 2};
  glm::dmat4 stretch(1.0);
  stretch[0][0] = 4.0;
  const auto converted = convertScene(scene, stretch, false, "m");
  ASSERT_TRUE(converted);
  const vec3 expected = glm::normalize(vec3(0.25F, 1, 1));
  for (const vec3& n : converted->raw.normals) {
    EXPECT_LT(glm::distance(n, expected), 4 * 0x1p-24F);  // round-off
  }
  EXPECT_THAT(converted->raw.objects, ElementsAre("root"));
}

TEST(Names, PartsWithoutOneAreCalledAfterTheFile) {
  const ScratchFolder folder;
  const std::string nameless = std::string(kBlockObj).substr(8);  // without "o block"
  const auto model = importModel(folder.write("shelf.obj", nameless), {});
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_THAT(model->mesh.objects, ElementsAre("shelf"));
}

TEST(Names, LightsAndCamerasAreCounted) {
  const ScratchFolder folder;
  const auto file = folder.write(
      "a.gltf",
      triangleGltf(R"("camera":0)", "",
                   R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}],)"));
  const auto model = importModel(file, {});
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->cameras, 1U);
  EXPECT_EQ(model->lights, 0U);
  EXPECT_THAT(model->warnings, ElementsAre("1 cameras of the file ignored"));
}

}  // namespace
}  // namespace soffit::io
