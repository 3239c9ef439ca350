// SPDX-License-Identifier: MIT
#include "core/io/project/overrides.h"

#include "core/io/project/project.h"
#include "core/scene/edits.h"
#include "core/scene/equality.h"
#include "tests/core/io/project/example_project.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace soffit::io {
namespace {

Result<Project> load(const std::vector<std::string>& sets, const std::string& layout = "") {
  const ProjectFolder folder;
  LoadOptions options;
  options.sets = sets;
  options.layout = layout;
  return folder.load(kFullProject, options);
}

light::Luminaire panelAfter(const std::string& set) {
  const auto project = load({set});
  EXPECT_TRUE(project) << project.error().message();
  return project ? project->scene.luminaires[0] : light::Luminaire{};
}

std::string errorOf(const std::string& set, const std::string& layout = "") {
  const ProjectFolder folder;
  LoadOptions options;
  options.sets = {set};
  options.layout = layout;
  return folder.errorOf(kFullProject, options);
}

TEST(ParseSetValue, KnowsNumbersListsFlagsJsonAndText) {
  EXPECT_EQ(*parseSetValue("3"), Json(3));
  EXPECT_EQ(*parseSetValue("+.5"), Json(0.5));
  EXPECT_EQ(*parseSetValue("1,2, -3e-1"), Json::array({1, 2, -0.3}));
  EXPECT_EQ(*parseSetValue("true"), Json(true));
  EXPECT_EQ(*parseSetValue("null"), Json());
  EXPECT_EQ(*parseSetValue("{\"cct\": 4000}"), Json::object({{"cct", 4000}}));
  EXPECT_EQ(*parseSetValue("False colour"), Json("False colour"));
  EXPECT_EQ(*parseSetValue("\"3\""), Json("3"));
  EXPECT_EQ(*parseSetValue("1,2,x"), Json("1,2,x"));
  EXPECT_EQ(*parseSetValue("nan"), Json("nan")) << "not a number, so no number";
  EXPECT_EQ(*parseSetValue(""), Json(""));
  EXPECT_FALSE(parseSetValue("{broken"));
}

TEST(Set, ChangesAnyFieldOfALuminaire) {
  EXPECT_EQ(panelAfter("luminaires.Panel 1.position=2,1,2.7").position, dvec3(2, 1, 2.7));
  EXPECT_EQ(panelAfter("luminaires.Panel 1.flux=100").flux, 100.0);
  EXPECT_EQ(panelAfter("luminaires[0].flux=100").flux, 100.0);
  EXPECT_EQ(panelAfter("luminaires.Panel 1.on=false").on, false);
  EXPECT_EQ(panelAfter("luminaires.Panel 1.casts_shadow=true").casts_shadow, true);
  EXPECT_EQ(panelAfter("luminaires.Panel 1.group=5").group, "5") << "text stays text";
  EXPECT_EQ(panelAfter("luminaires.Panel 1.scale=2").scale, 2.0) << "a field the file leaves out";
}

TEST(Set, OfOneKindReplacesTheOther) {
  const auto disk = panelAfter("luminaires.Panel 1.shape.disk=0.2");
  EXPECT_EQ(std::get<light::Disk>(disk.shape).radius, 0.2);
  EXPECT_EQ(panelAfter("luminaires.Panel 1.colour.cct=2700").colour.cct_k, 2700.0);
  const auto rgb = panelAfter("luminaires.Panel 1.colour.rgb=1,0.5,0.25");
  EXPECT_FALSE(rgb.colour.cct_k.has_value());
  EXPECT_EQ(rgb.colour.rgb, dvec3(1, 0.5, 0.25));
  EXPECT_EQ(panelAfter("luminaires.Panel 1.distribution.ies=spot.ies").distribution.kind,
            light::DistributionKind::ies);
  EXPECT_TRUE(std::holds_alternative<light::PointShape>(
      panelAfter("luminaires.Panel 1.shape=point").shape));
  const auto scaled =
      load({"luminaires.Panel 1.shape.mesh=quad.obj", "luminaires.Panel 1.shape.unit=0.1"});
  ASSERT_TRUE(scaled) << scaled.error().message();
  EXPECT_EQ(std::get<light::MeshShape>(scaled->scene.luminaires[0].shape).unit, 0.1);
}

TEST(Set, ANameWithDotsIsMatchedLongestFirst) {
  const auto project = load({"luminaires.Spot 1.2.dimming=0.7"});
  ASSERT_TRUE(project) << project.error().message();
  EXPECT_EQ(project->scene.luminaires[1].dimming, 0.7);
  const ProjectFolder folder;
  LoadOptions options;
  options.sets = {"luminaires.A.flux.flux=9", "luminaires.A.flux=8"};
  const auto both = folder.load(
      R"({"soffit": 1, "luminaires": [{"name": "A", "shape": "point", "flux": 1},
                                      {"name": "A.flux", "shape": "point", "flux": 2}]})",
      options);
  // "A.flux" is the longer name: the second setting names that luminaire as a whole.
  ASSERT_FALSE(both);
  EXPECT_EQ(
      folder.local(both.error().message()),
      "p.soffit: --set luminaires.A.flux: this names the whole, not one of its fields. Add the "
      "field: luminaires.Panel 1.flux.");
}

TEST(Set, ChangesMaterialsThatOnlyTheGeometryKnows) {
  const ProjectFolder folder;
  folder.write("dots.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib quad.mtl\nusemtl floor\nf 1 2 3\n");
  LoadOptions options;
  options.sets = {"materials.floor.diffuse=0.8,0.7,0.6", "materials.floor.specular=0.1"};
  const auto project = folder.load(R"({"soffit": 1, "geometry": [{"file": "dots.obj"}]})", options);
  ASSERT_TRUE(project) << project.error().message();
  EXPECT_EQ(project->scene.materials[0].diffuse, dvec3(0.8, 0.7, 0.6));
  EXPECT_EQ(project->scene.materials[0].specular, 0.1);
}

TEST(Set, ChangesTheOtherSections) {
  const auto project =
      load({"view.exposure=2", "view.ocio_view=False colour", "quality.gather_rays=64",
            "cameras.Entrance.vertical_fov=70", "work_planes.Desks.grid=2,3",
            "environment.sky.cie=16", "environment.horizontal_illuminance=500", "name=Other"});
  ASSERT_TRUE(project) << project.error().message();
  EXPECT_EQ(project->scene.view.exposure, 2.0);
  EXPECT_EQ(project->scene.view.ocio_view, "False colour");
  EXPECT_EQ(project->scene.quality.preset, "final");
  EXPECT_EQ(project->scene.quality.settings.at("gather_rays"), 64.0);
  EXPECT_EQ(project->scene.cameras[0].vertical_fov_deg, 70.0);
  EXPECT_EQ(project->scene.work_planes[0].nv, 3);
  EXPECT_TRUE(project->scene.environment.has_value());
  EXPECT_EQ(project->scene.name, "Other");
  const auto preset = load({"quality=draft", "quality.gather_rays=64"});
  ASSERT_TRUE(preset) << preset.error().message();
  EXPECT_EQ(preset->scene.quality.preset, "draft");
  EXPECT_EQ(preset->scene.quality.settings.at("gather_rays"), 64.0);
}

TEST(Set, ErrorsSayWhatThereIs) {
  EXPECT_EQ(
      errorOf("luminaires.Panel 2.flux=1"),
      "p.soffit: --set luminaires.Panel 2.flux: nothing in luminaires has this name. There is: "
      "Panel 1, Spot 1.2.");
  EXPECT_EQ(
      errorOf("luminaires.Panel 1.fluxx=1"),
      "p.soffit: luminaires.Panel 1.fluxx: --set names a field that does not exist. Check the "
      "spelling of the path.");
  EXPECT_EQ(errorOf("materials.wall.colour=1"),
            "p.soffit: --set materials.wall.colour: this is no field of a material. Name one: "
            "materials.wall.diffuse, .specular, .roughness, .glass.index.");
  EXPECT_EQ(
      errorOf("materials.ceiling.diffuse=0.5"),
      "p.soffit: materials.ceiling: --set names a material that the geometry does not have. There "
      "is: floor, wall.");
  EXPECT_EQ(
      errorOf("view.expo=1"),
      "p.soffit: view.expo: --set names a field that does not exist. Check the spelling of the "
      "path.");
  EXPECT_EQ(errorOf("lights.Panel 1.flux=1"),
            "p.soffit: lights: --set names a field that does not exist. Check the spelling of the "
            "path.");
  for (const char* set :
       {"luminaires.Panel 1.[0]=1", "luminaires.Panel 1..flux=1", "view.=1", "[0]=1"}) {
    EXPECT_NE(errorOf(set).find("--set"), std::string::npos) << set << ": " << errorOf(set);
  }
}

TEST(Set, ErrorsOfForm) {
  EXPECT_EQ(errorOf("view.=1"),
            "p.soffit: --set view.: the path ends in a dot. Name the field after it.");
  EXPECT_EQ(errorOf("luminaires.Panel 1.flux"),
            "p.soffit: --set luminaires.Panel 1.flux: expected KEY=VALUE. Write --set "
            "\"luminaires.Panel 1.flux=3000\".");
  EXPECT_EQ(
      errorOf("luminaires.Panel 1=3"),
      "p.soffit: --set luminaires.Panel 1: this names the whole, not one of its fields. Add the "
      "field: luminaires.Panel 1.flux.");
  EXPECT_EQ(errorOf("luminaires.Panel 1.flux=nan"),
            "p.soffit: luminaires.Panel 1.flux: expected a finite number, found \"nan\". Write it "
            "without "
            "quotes, with a decimal point.");
  const std::string fixed =
      ": this part of a project cannot be set from outside. Set fields of luminaires, materials, "
      "environment, cameras, work_planes, view or quality.";
  EXPECT_EQ(errorOf("soffit=1"), "p.soffit: --set soffit" + fixed);
  EXPECT_EQ(errorOf("layouts=1"), "p.soffit: --set layouts" + fixed);
  EXPECT_TRUE(errorOf("view={broken").starts_with("--set:1:")) << errorOf("view={broken");
}

TEST(Layout, GivesWhatResolveLayoutGives) {
  const auto base = load({});
  ASSERT_TRUE(base);
  for (const scene::Layout& layout : base->scene.layouts) {
    const auto applied = load({}, layout.name);
    ASSERT_TRUE(applied) << applied.error().message();
    const auto expected = scene::resolveLayout(base->scene, layout);
    ASSERT_EQ(applied->scene.luminaires.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_TRUE(scene::same(applied->scene.luminaires[i], expected[i])) << expected[i].name;
    }
    ASSERT_EQ(applied->scene.layouts.size(), 1U);
    EXPECT_EQ(applied->scene.layouts[0].name, layout.name);
    EXPECT_TRUE(applied->scene.layouts[0].edits.empty()) << "resolving again changes nothing";
  }
}

TEST(Layout, SettingsActAfterIt) {
  const auto project =
      load({"luminaires.Panel 1.dimming=0.9", "luminaires.Candle.flux=20"}, "Evening");
  ASSERT_TRUE(project) << project.error().message();
  EXPECT_EQ(project->scene.luminaires[0].dimming, 0.9);
  EXPECT_EQ(project->scene.luminaires[2].flux, 20.0);
  EXPECT_FALSE(load({"luminaires.Candle.flux=20"})) << "the base has no candle";
}

TEST(Layout, ErrorsNameTheLayouts) {
  const ProjectFolder folder;
  LoadOptions options;
  options.layout = "Noon";
  EXPECT_EQ(folder.errorOf(kFullProject, options),
            "p.soffit: layouts: there is no layout \"Noon\". Choose one of: As planned, Evening.");
  EXPECT_EQ(folder.errorOf(R"({"soffit": 1})", options),
            "p.soffit: layouts: there is no layout \"Noon\". The project has no layouts.");
  EXPECT_EQ(
      folder.errorOf(R"({"soffit": 1, "layouts": [{"name": "Noon", "luminaires": {"A": 5}}]})",
                     options),
      "p.soffit: layouts.Noon.luminaires.A: expected an object, found 5. Write it as { \"key\": "
      "value, ... }.");
}

}  // namespace
}  // namespace soffit::io
