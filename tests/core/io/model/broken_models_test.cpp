// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/io/model/model_import.h"
#include "core/math/rng.h"
#include "tests/core/io/model/sample_models.h"
#include "tests/core/io/model/scratch_folder.h"

/// Damaged files end in an error or in a sound mesh, never in a crash.
namespace soffit::io {
namespace {

std::string damaged(std::string text, Rng& rng) {
  const auto any = [&] { return rng.below(static_cast<std::uint32_t>(text.size())); };
  switch (rng.below(4)) {
    case 0:  // cut off
      text.resize(any());
      break;
    case 1:  // flipped bytes
      for (int i = 0; i < 4; ++i) text[any()] = static_cast<char>(rng.below(256));
      break;
    case 2:  // a piece lost
      text.erase(any(), rng.below(40));
      break;
    default: {  // another number
      const char* numbers[] = {"-1", "99999999", "4294967295", "nan", "1e39", "0", "."};
      const std::size_t at = text.find_first_of("0123456789", any());
      if (at != std::string::npos) text.replace(at, 1, numbers[rng.below(7)]);
    }
  }
  return text;
}

void expectSound(const geometry::Mesh& mesh) {
  ASSERT_FALSE(mesh.triangles.empty());
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_EQ(mesh.material_of.size(), mesh.triangles.size());
  ASSERT_EQ(mesh.object_of.size(), mesh.triangles.size());
  for (const uvec3& t : mesh.triangles) {
    ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
  }
  for (const vec3& p : mesh.positions) ASSERT_TRUE(isFinite(dvec3(p)));
  for (const std::uint32_t m : mesh.material_of) ASSERT_LT(m, mesh.materials.size());
  for (const std::uint32_t o : mesh.object_of) ASSERT_LT(o, mesh.objects.size());
}

void survives(const std::string& name, std::string_view text) {
  const ScratchFolder folder;
  Rng rng(2024);
  int errors = 0;
  constexpr int kRounds = 80;
  for (int i = 0; i < kRounds; ++i) {
    const auto model = importModel(folder.write(name, damaged(std::string(text), rng)), {});
    if (model) {
      expectSound(model->mesh);
    } else {
      ++errors;
      EXPECT_FALSE(model.error().what.empty());
      EXPECT_EQ(model.error().message().find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(errors, 0);
  EXPECT_LT(errors, kRounds);
}

TEST(BrokenModels, Obj) {
  survives("a.obj", kBlockObj);
}
TEST(BrokenModels, Ply) {
  survives("a.ply", kBlockPly);
}
TEST(BrokenModels, Stl) {
  survives("a.stl", kTriangleStl);
}
TEST(BrokenModels, Ifc) {
  survives("a.ifc", kBlockIfc);
}
TEST(BrokenModels, Gltf) {
  survives("a.gltf", triangleGltf(R"("translation":[1,2,3])",
                                  R"({"pbrMetallicRoughness":{"metallicFactor":0}})"));
}

}  // namespace
}  // namespace soffit::io
