// SPDX-License-Identifier: MIT
#include "core/io/model/model_format.h"

#include <gtest/gtest.h>

namespace soffit::io {
namespace {

TEST(ModelFormat, GoesByTheExtensionInAnyCase) {
  EXPECT_EQ(modelFormat("a/house.obj"), ModelFormat::kObj);
  EXPECT_EQ(modelFormat("HOUSE.OBJ"), ModelFormat::kObj);
  EXPECT_EQ(modelFormat("house.gltf"), ModelFormat::kGltf);
  EXPECT_EQ(modelFormat("house.v2.Glb"), ModelFormat::kGltf);
  EXPECT_EQ(modelFormat("house.ply"), ModelFormat::kPly);
  EXPECT_EQ(modelFormat("house.stl"), ModelFormat::kStl);
  EXPECT_EQ(modelFormat("house.3ds"), ModelFormat::k3ds);
  EXPECT_EQ(modelFormat("house.fbx"), ModelFormat::kFbx);
  EXPECT_EQ(modelFormat("house.dae"), ModelFormat::kCollada);
  EXPECT_EQ(modelFormat("house.ifc"), ModelFormat::kIfc);
  EXPECT_FALSE(modelFormat("house.dwg"));
  EXPECT_FALSE(modelFormat("obj"));
  EXPECT_FALSE(modelFormat(""));
}

}  // namespace
}  // namespace soffit::io
