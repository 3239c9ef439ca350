// SPDX-License-Identifier: MIT
#include "core/io/project/project.h"
#include "tests/core/io/project/example_project.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace soffit::io {
namespace {

/// The error of a project with these members beside the version.
std::string errorOf(const std::string& members) {
  const ProjectFolder folder;
  return folder.errorOf(R"({"soffit": 1, )" + members + "}");
}

std::string luminaireError(const std::string& members) {
  return errorOf(R"("luminaires": [{"name": "A", "shape": "point", "flux": 1}, {)" + members +
                 "}]");
}

TEST(LoadErrors, NameTheVersion) {
  const ProjectFolder folder;
  EXPECT_EQ(
      folder.errorOf("[]"),
      "p.soffit: expected a project, found an array of 0 elements. A project file starts with "
      "{ \"soffit\": 1, ... }.");
  EXPECT_EQ(folder.errorOf("{}"),
            "p.soffit: soffit: the format version is missing. A project file starts with "
            "{ \"soffit\": 1, ... }.");
  EXPECT_EQ(
      folder.errorOf(R"({"soffit": "1"})"),
      "p.soffit: soffit: expected the format version 1, found \"1\". A project file starts with "
      "{ \"soffit\": 1, ... }.");
  EXPECT_EQ(
      folder.errorOf(R"({"soffit": 2, "anything": 1})"),
      "p.soffit: soffit: the file has format version 2, this program reads version 1. Open it "
      "with a newer version of Soffit.");
}

TEST(LoadErrors, NameLineAndColumnOfSyntaxErrors) {
  const ProjectFolder folder;
  const std::string error = folder.errorOf("{\n  \"soffit\": 1,\n  \"name\": \"x\",\n}");
  EXPECT_TRUE(error.starts_with("p.soffit:4:1: this is not JSON: ")) << error;
}

TEST(LoadErrors, NameTheSectionOfTheWrongKind) {
  EXPECT_EQ(errorOf(R"("luminaires": {})"),
            "p.soffit: luminaires: expected an array, found an object. Write it as [ ... ].");
  EXPECT_EQ(
      errorOf(R"("materials": [])"),
      "p.soffit: materials: expected an object by name, found an array of 0 elements. Write it "
      "as { \"wall\": { \"diffuse\": [0.7, 0.7, 0.7] } }.");
  EXPECT_EQ(
      errorOf(R"("luminaires": [3])"),
      "p.soffit: luminaires[0]: expected an object, found 3. Write it as { \"key\": value, ... }.");
  EXPECT_EQ(errorOf(R"("name": 3)"),
            "p.soffit: name: expected text, found 3. Write it in double quotes.");
  EXPECT_EQ(
      errorOf(R"("layouts": [{"name": "L", "luminaires": []}])"),
      "p.soffit: layouts.L.luminaires: expected an object by luminaire name, found an array of 0 "
      "elements. Write it as { \"Panel 1\": { \"on\": false } }.");
}

TEST(LoadErrors, NameLuminairesByNameOrPlace) {
  EXPECT_EQ(luminaireError(R"("shape": "point")"),
            "p.soffit: luminaires[1].name: this key is missing. Give it a unique name.");
  EXPECT_EQ(
      luminaireError(R"("name": 5, "shape": "point")"),
      "p.soffit: luminaires[1].name: expected a name, found 5. Give it a unique name in double "
      "quotes.");
  EXPECT_EQ(
      luminaireError(R"("name": "A", "shape": "point", "flux": 1)"),
      "p.soffit: luminaires[1].name: the name 'A' occurs twice. Names must be unique: rename one.");
  EXPECT_EQ(
      luminaireError(R"("name": "B")"),
      "p.soffit: luminaires.B.shape: this key is missing. Add \"shape\": { \"rectangle\": [0.6, "
      "0.6] }, or another one.");
  EXPECT_EQ(
      luminaireError(R"("name": "B", "shape": "point", "flux": "much")"),
      "p.soffit: luminaires.B.flux: expected a finite number, found \"much\". Write it without "
      "quotes, with a decimal point.");
  EXPECT_EQ(
      luminaireError(R"("name": "B", "shape": "point", "position": [1, 2])"),
      "p.soffit: luminaires.B.position: expected 3 numbers, found an array of 2 elements. Write "
      "them as [a, b, c].");
  EXPECT_EQ(luminaireError(R"("name": "B", "shape": "point", "position": [1, null, 2])"),
            "p.soffit: luminaires.B.position[1]: expected a finite number, found null. Write it "
            "without quotes, with a decimal point.");
  EXPECT_EQ(luminaireError(R"("name": "B", "shape": "point", "on": 1)"),
            "p.soffit: luminaires.B.on: expected true or false, found 1. Write it without quotes.");
}

TEST(LoadErrors, OfShapes) {
  const auto shape = [](const std::string& text) {
    return luminaireError(R"("name": "B", "flux": 1, "shape": )" + text);
  };
  const std::string kinds =
      "Use \"point\", or an object with one of rectangle, disk, sphere, tube, polygon, mesh.";
  EXPECT_EQ(shape(R"("cube")"),
            "p.soffit: luminaires.B.shape: there is no shape \"cube\". " + kinds);
  EXPECT_EQ(shape("{}"), "p.soffit: luminaires.B.shape: expected one kind, found none. " + kinds);
  EXPECT_EQ(shape(R"({"disk": 1, "sphere": 1})"),
            "p.soffit: luminaires.B.shape: expected one kind, found several. " + kinds);
  EXPECT_EQ(
      shape(R"({"polygon": 3})"),
      "p.soffit: luminaires.B.shape.polygon: expected corners, found 3. Write them as [[x, y], [x, "
      "y], [x, y]].");
  EXPECT_EQ(
      shape(R"({"polygon": [[1, 2], [3]]})"),
      "p.soffit: luminaires.B.shape.polygon[1]: expected 2 numbers, found an array of 1 element. "
      "Write them as [a, b].");
  EXPECT_EQ(shape(R"({"mesh": "none.obj"})"),
            "p.soffit: luminaires.B.shape.mesh: there is no file \"none.obj\". Put it beside the "
            "project, or correct the name.");
  EXPECT_EQ(
      shape(R"({"mesh": "quad.obj", "unit": 0})"),
      "p.soffit: luminaires.B.shape.unit: expected metres above 0, found 0. Use 0.001 for a file "
      "in millimetres.");
  EXPECT_EQ(
      shape(R"({"mesh": "quad.obj", "up": "x"})"),
      "p.soffit: luminaires.B.shape.up: expected \"y\" or \"z\", found \"x\". Name the axis of the "
      "file that points up.");
  EXPECT_TRUE(
      shape(R"({"rectangle": [0, 1]})").starts_with("p.soffit: luminaires.B.shape.rectangle: "))
      << shape(R"({"rectangle": [0, 1]})");
}

TEST(LoadErrors, OfEmission) {
  const auto light = [](const std::string& text) {
    return luminaireError(R"("name": "B", "shape": "point", )" + text);
  };
  EXPECT_TRUE(light(R"("flux": -1)").starts_with("p.soffit: luminaires.B.flux: "))
      << light(R"("flux": -1)");
  EXPECT_TRUE(light(R"("dimming": 1)").starts_with("p.soffit: luminaires.B.flux: "))
      << light(R"("dimming": 1)");
  EXPECT_EQ(
      light(R"("flux": 1, "colour": {})"),
      "p.soffit: luminaires.B.colour: expected one kind, found none. Use { \"cct\": 4000 } or { "
      "\"rgb\": [1, 1, 1] }.");
  EXPECT_EQ(
      light(R"("distribution": "narrow")"),
      "p.soffit: luminaires.B.distribution: there is no distribution \"narrow\". Use "
      "\"lambertian\", \"isotropic\", { \"ies\": \"file.ies\" } or { \"ldt\": \"file.ldt\" }.");
  EXPECT_EQ(
      light(R"("distribution": {"ies": "../spot.ies"})"),
      "p.soffit: luminaires.B.distribution.ies: \"../spot.ies\" leaves the project's folder. Copy "
      "the file beside the project and name it there.");
  EXPECT_EQ(
      light(R"("distribution": {"ldt": "gone.ldt"})"),
      "p.soffit: luminaires.B.distribution.ldt: there is no file \"gone.ldt\". Put it beside the "
      "project, or correct the name.");
  EXPECT_TRUE(light(R"("distribution": {"ies": "quad.obj"})")
                  .starts_with("p.soffit: luminaires.B.distribution.ies: quad.obj"))
      << light(R"("distribution": {"ies": "quad.obj"})");
}

TEST(LoadErrors, OfLayouts) {
  EXPECT_EQ(
      errorOf(R"("layouts": [{"name": "L", "luminaires": {"Panl": {"on": false}}}])"),
      "p.soffit: layouts.L.luminaires.Panl: the base has no luminaire of this name, and as one of "
      "this layout alone it lacks its shape. Correct the name, or add shape, position and flux.");
  EXPECT_EQ(errorOf(R"("layouts": [{}])"),
            "p.soffit: layouts[0].name: this key is missing. Give it a unique name.");
}

TEST(LoadErrors, OfGeometry) {
  EXPECT_EQ(errorOf(R"("geometry": [{}])"),
            "p.soffit: geometry[0].file: this key is missing. Add \"file\": \"room.obj\".");
  EXPECT_EQ(
      errorOf(R"("geometry": [{"file": "none.obj"}])"),
      "p.soffit: geometry[0].file: there is no file \"none.obj\". Put it beside the project, or "
      "correct the name.");
  EXPECT_EQ(
      errorOf(R"("geometry": [{"file": "quad.obj", "scale": 0}])"),
      "p.soffit: geometry[0].scale: expected a number above 0, found 0. Correct the number, or "
      "leave it out for 1.");
  EXPECT_EQ(
      errorOf(R"("geometry": [{"file": "quad.obj", "unit": -1}])"),
      "p.soffit: geometry[0].unit: expected a number above 0, found -1. Correct the number, or "
      "leave it out for 1.");
  EXPECT_EQ(
      errorOf(R"("geometry": [{"file": "quad.obj", "up": "x"}])"),
      "p.soffit: geometry[0].up: expected \"y\" or \"z\", found \"x\". Name the axis of the file "
      "that points up.");
  const ProjectFolder folder;
  folder.write("empty.obj", "v 0 0 0\n");
  const std::string empty = folder.errorOf(R"({"soffit": 1, "geometry": [{"file": "empty.obj"}]})");
  EXPECT_TRUE(empty.starts_with("p.soffit: geometry[0].file: empty.obj: ")) << empty;
}

TEST(LoadErrors, OfMaterials) {
  const auto wall = [](const std::string& text) {
    return errorOf(R"("geometry": [{"file": "quad.obj"}], "materials": {"wall": {)" + text + "}}");
  };
  EXPECT_EQ(
      wall(R"("diffuse": [0.5, 1.5, 0.5])"),
      "p.soffit: materials.wall.diffuse: expected a number from 0 to 1, found 1.5. Correct the "
      "number.");
  EXPECT_EQ(
      wall(R"("specular": 0.5)"),
      "p.soffit: materials.wall.specular: diffuse and specular together reflect 1.2, more than 1. "
      "Lower one of them.");
  EXPECT_EQ(
      wall(R"("diffuse_map": "gone.png")"),
      "p.soffit: materials.wall.diffuse_map: there is no file \"gone.png\". Put it beside the "
      "project, or correct the name.");
  EXPECT_EQ(
      wall(R"("glass": {"index": 0.5})"),
      "p.soffit: materials.wall.glass.index: expected a refractive index from 1 to 5, found 0.5. "
      "Window glass has 1.52.");
}

TEST(LoadErrors, OfTheEnvironment) {
  const auto outside = [](const std::string& text) {
    return errorOf(R"("environment": {)" + text + "}");
  };
  EXPECT_EQ(
      outside(R"("ground_reflectance": 0.1)"),
      "p.soffit: environment: expected either a sky or an image. Write { \"sky\": { \"cie\": 1 }, "
      "\"horizontal_illuminance\": 10000 } or { \"image\": \"probe.hdr\" }.");
  EXPECT_EQ(outside(R"("sky": {"cie": 17}, "horizontal_illuminance": 1)"),
            "p.soffit: environment.sky.cie: expected a number from 1 to 16, found 17. Correct the "
            "number.");
  EXPECT_EQ(
      outside(R"("sky": {"cie": 1.5}, "horizontal_illuminance": 1)"),
      "p.soffit: environment.sky.cie: expected a whole number, found 1.5. Write it without quotes "
      "and decimals.");
  EXPECT_EQ(outside(R"("sky": {"cie": 1})"),
            "p.soffit: environment.horizontal_illuminance: this key is missing. Add "
            "\"horizontal_illuminance\": 10000.");
  EXPECT_EQ(
      outside(R"("sky": {"cie": 1, "sun": [0, 91]}, "horizontal_illuminance": 1)"),
      "p.soffit: environment.sky.sun: expected an altitude from -90 to 90 degrees, found 91. Write "
      "[azimuth, altitude] in degrees.");
  EXPECT_EQ(
      outside(R"("sky": {"cie": 1, "direct_normal_illuminance": -1}, "horizontal_illuminance": 1)"),
      "p.soffit: environment.sky.direct_normal_illuminance: expected lux, not negative, found -1. "
      "Correct the number.");
  EXPECT_EQ(
      outside(R"("sky": {"cie": 1}, "horizontal_illuminance": 1, "ground_reflectance": 2)"),
      "p.soffit: environment.ground_reflectance: expected a number from 0 to 1, found 2. Correct "
      "the number.");
  EXPECT_EQ(
      outside(R"("image": "gone.hdr")"),
      "p.soffit: environment.image: there is no file \"gone.hdr\". Put it beside the project, or "
      "correct the name.");
  EXPECT_EQ(outside(R"("image": "quad.obj", "layout": "spiral")"),
            "p.soffit: environment.layout: expected \"latlong\", \"angular\" or \"cross\", found "
            "\"spiral\". Name how the picture is laid out; a cross may stand or lie.");
}

TEST(LoadErrors, OfCamerasAndWorkPlanes) {
  EXPECT_EQ(errorOf(R"("cameras": [{"name": "C", "position": [0, 0, 0]}])"),
            "p.soffit: cameras.C.target: this key is missing. Add \"target\": [4, 3, 1.2].");
  EXPECT_EQ(
      errorOf(R"("work_planes": [{"name": "W", "origin": [0,0,0], "u": [1,0,0], "v": [0,1,0]}])"),
      "p.soffit: work_planes.W.grid: this key is missing. Add \"grid\": [8, 6].");
  EXPECT_EQ(
      errorOf(
          R"("work_planes": [{"name": "W", "origin": [0,0,0], "u": [1,0,0], "v": [0,1,0], "grid": [2.5, 1]}])"),
      "p.soffit: work_planes.W.grid: expected two whole numbers from 1, found 2.5 and 1. Write the "
      "number of cells along u and v.");
  EXPECT_EQ(
      errorOf(
          R"("work_planes": [{"name": "W", "origin": [0,0,0], "u": [1,0,0], "v": [2,0,0], "grid": [2, 1]}])"),
      "p.soffit: work_planes.W.u: u and v span no area. Give both a length, in different "
      "directions.");
  EXPECT_EQ(
      errorOf(R"("quality": "best")"),
      "p.soffit: quality: expected draft, interactive or final, found 'best'. Choose one of the "
      "three.");
}

}  // namespace
}  // namespace soffit::io
