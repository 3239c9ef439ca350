// SPDX-License-Identifier: MIT
#include "core/io/image/write_image.h"
#include "core/io/project/project.h"
#include "core/scene/edits.h"
#include "tests/core/io/project/example_project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

namespace soffit::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(LoadProject, ReadsEverySection) {
  const ProjectFolder folder;
  const auto project = folder.load(kFullProject);
  ASSERT_TRUE(project) << project.error().message();
  const scene::Scene& scene = project->scene;
  EXPECT_EQ(scene.name, "Room");
  EXPECT_EQ(scene.mesh->triangleCount(), 3U);
  ASSERT_EQ(scene.luminaires.size(), 2U);
  const light::Luminaire& panel = scene.luminaires[0];
  EXPECT_EQ(panel.name, "Panel 1");
  EXPECT_EQ(std::get<light::Rectangle>(panel.shape).width, 0.6);
  EXPECT_EQ(panel.position, dvec3(2, 1.5, 2.75));
  EXPECT_EQ(panel.flux, 3500.0);
  EXPECT_EQ(panel.colour.cct_k, 4000.0);
  EXPECT_EQ(panel.group, "General");
  const light::Luminaire& spot = scene.luminaires[1];
  EXPECT_FALSE(spot.flux.has_value());
  ASSERT_NE(spot.distribution.table, nullptr);
  EXPECT_EQ(spot.dimming, 0.1);
  ASSERT_EQ(scene.layouts.size(), 2U);
  EXPECT_EQ(scene.layouts[1].edits.at("Panel 1").dimming, 0.3);
  EXPECT_EQ(scene.cameras[0].vertical_fov_deg, 50.0);
  EXPECT_EQ(scene.work_planes[0].nu, 22);
  EXPECT_EQ(scene.work_planes[0].room_type, "office.writing");
  EXPECT_EQ(scene.view.exposure, 0.5);
  EXPECT_EQ(scene.view.ocio_view, "ACES");
  EXPECT_EQ(scene.quality.preset, "final");
  EXPECT_EQ(scene.quality.settings.at("gather_rays"), 2048.0);
}

TEST(LoadProject, PlacesTheGeometry) {
  const ProjectFolder folder;
  const auto project = folder.load(kFullProject);
  ASSERT_TRUE(project);
  const Box bounds = project->scene.mesh->bounds();
  EXPECT_EQ(bounds.lo, vec3(1, 2, 3));
  EXPECT_EQ(bounds.hi, vec3(2, 3, 4));
}

TEST(LoadProject, TheProjectsMaterialsOverrideTheFiles) {
  const ProjectFolder folder;
  const auto project = folder.load(kFullProject);
  ASSERT_TRUE(project);
  const auto find = [&](const char* name) {
    return *std::ranges::find(project->scene.materials, name, &scene::Material::name);
  };
  EXPECT_EQ(find("wall").diffuse, dvec3(0.8, 0.5, 0.5));
  const scene::Material floor = find("floor");
  // The file's colours pass through single precision.
  constexpr double kSingle = 1e-7;
  EXPECT_NEAR(floor.diffuse.y, 0.3, kSingle);
  EXPECT_EQ(floor.specular, 0.04);
  EXPECT_EQ(floor.roughness, 0.3);
}

TEST(LoadProject, UnknownKeysAreWarnedAbout) {
  const ProjectFolder folder;
  const auto project = folder.load(kFullProject);
  ASSERT_TRUE(project);
  const std::string rest = ": this key is not known; it is kept and has no effect";
  EXPECT_THAT(project->warnings, Contains("author" + rest));
  EXPECT_THAT(project->warnings, Contains("materials.wall.sheen" + rest));
  EXPECT_THAT(project->warnings, Contains("luminaires.Panel 1.article" + rest));
  EXPECT_THAT(project->warnings, Contains("layouts.Evening.note" + rest));
}

TEST(LoadProject, EqualMaterialNamesOfSeveralFilesAreOneMaterial) {
  const ProjectFolder folder;
  folder.write("b.obj", "mtllib b.mtl\nv 5 0 0\nv 6 0 0\nv 6 1 0\nusemtl wall\nf 1 2 3\n");
  folder.write("b.mtl", "newmtl wall\nKd 0.1 0.1 0.1\n");
  const auto project = folder.load(
      R"({"soffit": 1, "geometry": [{"file": "quad.obj"}, {"file": "b.obj"}, {"file": "b.obj", "translate": [0, 0, 2]}]})");
  ASSERT_TRUE(project) << project.error().message();
  const geometry::Mesh& mesh = *project->scene.mesh;
  EXPECT_EQ(mesh.triangleCount(), 5U);
  EXPECT_THAT(mesh.materials, ElementsAre("floor", "wall"));
  EXPECT_EQ(mesh.material_of[3], mesh.material_of[2]);
  EXPECT_THAT(project->warnings,
              Contains("materials.wall: b.obj describes it differently; the first file counts"));
}

TEST(LoadProject, AMaterialThatNobodyDescribesIsGreyWithAWarning) {
  const ProjectFolder folder;
  folder.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n");
  const std::string text = R"({"soffit": 1, "geometry": [{"file": "bare.obj"}])";
  const auto bare = folder.load(text + "}");
  ASSERT_TRUE(bare) << bare.error().message();
  EXPECT_EQ(bare->scene.materials[0].diffuse, dvec3(0.5));
  EXPECT_THAT(bare->warnings, Contains(HasSubstr("diffuse 0.5 is taken")));
  const std::string name = bare->scene.materials[0].name;
  const auto told = folder.load(text + R"(, "materials": {")" + name + R"(": {"diffuse": 0.3}}})");
  ASSERT_TRUE(told) << told.error().message();
  EXPECT_EQ(told->scene.materials[0].diffuse, dvec3(0.3)) << "one number is a grey";
  EXPECT_THAT(told->warnings, Not(Contains(HasSubstr("diffuse 0.5"))));
}

TEST(LoadProject, NoGeometryIsLegal) {
  const ProjectFolder folder;
  for (const char* text : {R"({"soffit": 1, "geometry": []})", R"({"soffit": 1})"}) {
    const auto project = folder.load(text);
    ASSERT_TRUE(project) << project.error().message();
    EXPECT_EQ(project->scene.mesh->triangleCount(), 0U);
    EXPECT_THAT(project->warnings, IsEmpty());
  }
}

TEST(LoadProject, GlassHasItsOwnOpticsAndNoPaint) {
  const ProjectFolder folder;
  const auto project = folder.load(
      R"({"soffit": 1, "geometry": [{"file": "quad.obj"}], "materials": {"wall": {"glass": {"index": 1.5, "transmittance": 0.9}}}})");
  ASSERT_TRUE(project);
  const scene::Material& wall = project->scene.materials[1];
  ASSERT_TRUE(wall.glass.has_value());
  EXPECT_EQ(wall.glass->index, 1.5);
  EXPECT_EQ(wall.diffuse, dvec3(0.0));
  EXPECT_THAT(project->warnings, IsEmpty());
}

TEST(LoadProject, GlassThatIsTooClearIsWarnedAbout) {
  const ProjectFolder folder;
  const auto project = folder.load(
      R"({"soffit": 1, "geometry": [{"file": "quad.obj"}], "materials": {"wall": {"glass": {"transmittance": 0.95}}}})");
  ASSERT_TRUE(project);
  EXPECT_THAT(
      project->warnings,
      Contains("materials.wall.glass.transmittance: a sheet of index 1.52 lets at most 0.918 "
               "through"));
}

TEST(LoadProject, TheEnvironmentIsRead) {
  const ProjectFolder folder;
  scene::Image image{2, 1, 3, {1, 2, 3, 4, 5, 6}};
  ASSERT_TRUE(writeImage(folder.path() / "probe.exr", image));
  const auto environment = [&](const std::string& text) {
    const auto project = folder.load(R"({"soffit": 1, "environment": )" + text + "}");
    EXPECT_TRUE(project) << project.error().message();
    EXPECT_THAT(project->warnings, IsEmpty());
    return project->scene.environment.value();
  };
  const auto overcast = environment(
      R"({"sky": {"cie": 16, "sun": [170, 35]}, "horizontal_illuminance": 10000, "ground_reflectance": 0.2})");
  const auto& sky = std::get<scene::Sky>(overcast.light);
  EXPECT_EQ(sky.cie, 16);
  EXPECT_EQ(sky.sun_azimuth_deg, 170.0);
  EXPECT_EQ(sky.sun_altitude_deg, 35.0);
  EXPECT_EQ(sky.horizontal_illuminance, 10000.0);
  EXPECT_EQ(sky.ground_reflectance, 0.2);
  EXPECT_EQ(sky.direct_normal_illuminance, 0.0);
  const auto clear = environment(
      R"({"sky": {"cie": 1, "sun": [0, 10], "direct_normal_illuminance": 80000}, "horizontal_illuminance": 10000})");
  EXPECT_EQ(std::get<scene::Sky>(clear.light).direct_normal_illuminance, 80000.0);
  const auto picture =
      environment(R"({"image": "probe.exr", "layout": "angular", "rotation": 90, "scale": 2})");
  const auto& probe = std::get<scene::Probe>(picture.light);
  EXPECT_EQ(probe.layout, scene::ProbeLayout::angular);
  EXPECT_EQ(probe.rotation_deg, 90.0);
  EXPECT_EQ(probe.scale, 2.0);
  ASSERT_NE(probe.image, nullptr);
  EXPECT_EQ(probe.image->pixels[4], 5.0F);
  const auto analytic = environment(R"({"analytic": {"side_azimuth": 90}, "scale": 500})");
  EXPECT_NEAR(std::get<scene::PatchLight>(analytic.light).side_azimuth_rad, radians(90.0), 1e-15);
  EXPECT_EQ(std::get<scene::PatchLight>(analytic.light).scale, 500.0);
}

TEST(LoadProject, MeshLuminairesAndMapsAreLoaded) {
  const ProjectFolder folder;
  scene::Image picture;
  picture.width = picture.height = 2;
  picture.pixels.assign(12, 0.25F);
  ASSERT_TRUE(writeImage(folder.path() / "oak.hdr", picture));
  const auto project = folder.load(
      R"({"soffit": 1, "geometry": [{"file": "quad.obj"}],
          "materials": {"floor": {"diffuse_map": "oak.hdr", "roughness_map": "oak.hdr"}},
          "luminaires": [{"name": "L", "shape": {"mesh": "quad.obj", "unit": 0.1, "up": "y"}, "flux": 10}]})");
  ASSERT_TRUE(project) << project.error().message();
  const auto& shape = std::get<light::MeshShape>(project->scene.luminaires[0].shape);
  ASSERT_NE(shape.mesh, nullptr);
  EXPECT_EQ(shape.mesh->bounds().size(), vec3(0.1F, 0.1F, 0.1F));
  ASSERT_NE(project->scene.materials[0].diffuse_image, nullptr);
  EXPECT_EQ(project->scene.materials[0].diffuse_image->width, 2);
  EXPECT_EQ(project->scene.materials[0].roughness_map, "oak.hdr");
  ASSERT_NE(project->scene.materials[0].roughness_image, nullptr);
  EXPECT_NE(project->scene.materials[0].roughness_image, project->scene.materials[0].diffuse_image);
}

TEST(LoadProject, AMapThatOnlyTheModelNamesMayBeMissing) {
  const ProjectFolder folder;
  folder.write("quad.mtl", "newmtl floor\nKd 1 1 1\nmap_Kd gone.png\nnewmtl wall\nKd 0 0 0\n");
  const auto project = folder.load(R"({"soffit": 1, "geometry": [{"file": "quad.obj"}]})");
  ASSERT_TRUE(project) << project.error().message();
  EXPECT_EQ(project->scene.materials[0].diffuse_image, nullptr);
  EXPECT_THAT(project->warnings, Contains(HasSubstr("gone.png")));
}

TEST(VariantOf, SharesTheGeometry) {
  const ProjectFolder folder;
  const auto project = folder.load(kFullProject);
  ASSERT_TRUE(project);
  LoadOptions evening;
  evening.layout = "Evening";
  const auto variant = variantOf(*project, evening);
  ASSERT_TRUE(variant) << variant.error().message();
  EXPECT_EQ(variant->scene.mesh, project->scene.mesh);
  EXPECT_EQ(variant->scene.luminaires.size(), 3U);
  EXPECT_EQ(variant->layout, "Evening");
  const Project blank;
  EXPECT_EQ(variantOf(blank, {}).error().message(),
            "the project was not loaded from a file. Save it first.");
}

TEST(LoadProject, CanBeCancelled) {
  const ProjectFolder folder;
  std::stop_source source;
  source.request_stop();
  LoadOptions options;
  options.job.stop = source.get_token();
  EXPECT_THAT(folder.errorOf(kFullProject, options), HasSubstr("cancelled"));
}

}  // namespace
}  // namespace soffit::io
