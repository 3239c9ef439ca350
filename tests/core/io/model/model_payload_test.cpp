// SPDX-License-Identifier: MIT
#include "core/io/model/model_payload.h"

#include <gtest/gtest.h>

namespace soffit::io {
namespace {

ModelPayload sample() {
  ModelPayload out;
  out.raw.positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9.5}};
  out.raw.normals.assign(3, {0, 0, 1});
  out.raw.uvs = {{0, 0}, {1, 0}, {0.5F, 1}};
  out.raw.triangles = {{0, 1, 2}};
  out.raw.material_of = {0};
  out.raw.object_of = {0};
  out.raw.materials = {"oak"};
  out.raw.objects = {""};
  scene::Material material;
  material.name = "oak";
  material.diffuse = {0.1, 0.2, 0.3};
  material.specular = 0.04;
  material.roughness = 0.7;
  material.diffuse_map = "oak.png";
  material.normal_map = "oak_n.png";
  material.roughness_map = "oak_r.png";
  material.glass = scene::Glass{1.6, 0.7};
  out.model.materials = {material};
  out.model.described = {true};
  out.model.embedded_textures = {{"a.png", {1, 2, 255}}};
  out.model.side_files = {"a.mtl", "maps/b.bin"};
  out.model.points = 1;
  out.model.lines = 2;
  out.model.lights = 3;
  out.model.cameras = 4;
  out.model.warnings = {"careful", ""};
  return out;
}

TEST(ModelPayload, ComesBackAsItWas) {
  const ModelPayload in = sample();
  const auto read = payloadFromBytes(toBytes(in));
  ASSERT_TRUE(read && *read);
  const ModelPayload& out = read->value();
  EXPECT_EQ(out.raw.positions, in.raw.positions);
  EXPECT_EQ(out.raw.normals, in.raw.normals);
  EXPECT_EQ(out.raw.uvs, in.raw.uvs);
  EXPECT_EQ(out.raw.triangles, in.raw.triangles);
  EXPECT_EQ(out.raw.material_of, in.raw.material_of);
  EXPECT_EQ(out.raw.object_of, in.raw.object_of);
  EXPECT_EQ(out.raw.materials, in.raw.materials);
  EXPECT_EQ(out.raw.objects, in.raw.objects);
  ASSERT_EQ(out.model.materials.size(), 1U);
  const scene::Material& material = out.model.materials[0];
  EXPECT_EQ(material.name, "oak");
  EXPECT_EQ(material.diffuse, in.model.materials[0].diffuse);
  EXPECT_EQ(material.specular, 0.04);
  EXPECT_EQ(material.roughness, 0.7);
  EXPECT_EQ(material.diffuse_map, "oak.png");
  EXPECT_EQ(material.normal_map, "oak_n.png");
  EXPECT_EQ(material.roughness_map, "oak_r.png");
  ASSERT_TRUE(material.glass);
  EXPECT_EQ(material.glass->transmittance, 0.7);
  EXPECT_EQ(out.model.described, in.model.described);
  ASSERT_EQ(out.model.embedded_textures.size(), 1U);
  EXPECT_EQ(out.model.embedded_textures[0].bytes, in.model.embedded_textures[0].bytes);
  EXPECT_EQ(out.model.side_files, in.model.side_files);
  EXPECT_EQ(out.model.points, 1U);
  EXPECT_EQ(out.model.lines, 2U);
  EXPECT_EQ(out.model.lights, 3U);
  EXPECT_EQ(out.model.cameras, 4U);
  EXPECT_EQ(out.model.warnings, in.model.warnings);
}

TEST(ModelPayload, ErrorsComeBackToo) {
  const auto read = payloadFromBytes(toBytes(Error{"place", "what", "hint"}));
  ASSERT_TRUE(read);
  ASSERT_FALSE(*read);
  EXPECT_EQ(read->error().message(), (Error{"place", "what", "hint"}).message());
}

TEST(ModelPayload, BytesThatAreNotWholeAreNone) {
  const std::string bytes = toBytes(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(payloadFromBytes(std::string_view(bytes).substr(0, size))) << size;
  }
  EXPECT_FALSE(payloadFromBytes(bytes + "x"));
}

}  // namespace
}  // namespace soffit::io
