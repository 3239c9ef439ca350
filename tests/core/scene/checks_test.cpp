// SPDX-License-Identifier: MIT
#include "core/scene/checks.h"

#include "tests/core/scene/example_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace soffit::scene {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The only fault after a change, as one line.
template <class Change>
std::string faultAfter(const Change& change) {
  Scene scene = exampleScene();
  change(scene);
  const auto faults = findFaults(scene);
  if (faults.size() != 1) return std::to_string(faults.size()) + " faults";
  return faults.front().message();
}

TEST(FindFaults, ASoundSceneHasNone) {
  EXPECT_TRUE(findFaults(exampleScene()).empty());
}

TEST(FindFaults, NamesMustBeThereAndUnique) {
  EXPECT_EQ(faultAfter([](Scene& s) { s.luminaires[1].name = "Panel"; }),
            "luminaires[1].name: the name 'Panel' occurs twice. Names must be unique: rename one.");
  EXPECT_EQ(faultAfter([](Scene& s) { s.cameras[0].name.clear(); }),
            "cameras[0].name: the name is empty. Give it a name.");
  EXPECT_EQ(faultAfter([](Scene& s) { s.layouts[1].name = "Base"; }),
            "layouts[1].name: the name 'Base' occurs twice. Names must be unique: rename one.");
  EXPECT_EQ(
      faultAfter([](Scene& s) { s.work_planes.push_back(s.work_planes[0]); }),
      "work_planes[1].name: the name 'Desks' occurs twice. Names must be unique: rename one.");
}

TEST(FindFaults, LuminairesAreCheckedInTheBase) {
  const std::string flux = faultAfter([](Scene& s) { s.luminaires[1].flux = -1.0; });
  EXPECT_TRUE(flux.starts_with("luminaires.Lamp.flux: ")) << flux;
  const std::string place = faultAfter([](Scene& s) { s.luminaires[1].position.y = kNan; });
  EXPECT_TRUE(place.starts_with("luminaires.Lamp.position: ")) << place;
  const std::string shape = faultAfter([](Scene& s) { s.luminaires[1].shape = light::Disk{0.0}; });
  EXPECT_TRUE(shape.starts_with("luminaires.Lamp.shape.disk: ")) << shape;
}

TEST(FindFaults, LuminairesAreCheckedUnderEveryLayout) {
  const std::string dimming =
      faultAfter([](Scene& s) { s.layouts[1].edits["Panel"].dimming = -1.0; });
  EXPECT_TRUE(dimming.starts_with("layouts.Evening.luminaires.Panel.dimming: ")) << dimming;
  const std::string flux =
      faultAfter([](Scene& s) { s.layouts[1].edits["Candle"].flux = std::nullopt; });
  EXPECT_TRUE(flux.starts_with("layouts.Evening.luminaires.Candle.flux: ")) << flux;
}

TEST(FindFaults, ReflectancesKeepEnergy) {
  EXPECT_EQ(
      faultAfter([](Scene& s) { s.materials[0].diffuse.y = 1.1; }),
      "materials.wall.diffuse: expected a number from 0 to 1, found 1.1. Correct the number.");
  EXPECT_EQ(
      faultAfter([](Scene& s) { s.materials[0].diffuse.y = kNan; }),
      "materials.wall.diffuse: expected a number from 0 to 1, found nan. Correct the number.");
  EXPECT_EQ(
      faultAfter([](Scene& s) { s.materials[0].roughness = -0.1; }),
      "materials.wall.roughness: expected a number from 0 to 1, found -0.1. Correct the number.");
  EXPECT_EQ(
      faultAfter([](Scene& s) { s.materials[0].specular = 1.5; }),
      "materials.wall.specular: expected a number from 0 to 1, found 1.5. Correct the number.");
  EXPECT_EQ(faultAfter([](Scene& s) { s.materials[0].specular = 0.6; }),
            "materials.wall.specular: diffuse and specular together reflect 1.1, more than 1. "
            "Lower one of them.");
}

TEST(FindFaults, ASumOfOneInDecimalsIsLegal) {
  Scene scene = exampleScene();
  for (int percent = 0; percent <= 100; ++percent) {
    scene.materials[0].diffuse = dvec3(percent / 100.0);
    scene.materials[0].specular = (100 - percent) / 100.0;
    EXPECT_TRUE(findFaults(scene).empty()) << percent;
  }
}

TEST(FindFaults, GlassHasRanges) {
  const auto glass = [](double index, double transmittance) {
    return faultAfter([&](Scene& s) { s.materials[0].glass = Glass{index, transmittance}; });
  };
  EXPECT_EQ(glass(0.9, 0.8),
            "materials.wall.glass.index: expected a refractive index from 1 to 5, found 0.9. "
            "Window glass has 1.52.");
  EXPECT_EQ(glass(1.5, 1.2),
            "materials.wall.glass.transmittance: expected a number from 0 to 1, found 1.2. "
            "Correct the number.");
}

TEST(FindFaults, CamerasLookSomewhere) {
  EXPECT_EQ(faultAfter([](Scene& s) { s.cameras[0].target = s.cameras[0].position; }),
            "cameras.Entrance.target: the target is where the camera stands. Move one of them.");
  EXPECT_EQ(faultAfter([](Scene& s) { s.cameras[0].vertical_fov_deg = 180; }),
            "cameras.Entrance.vertical_fov: expected degrees from 0.1 to 175, found 180. A room is "
            "usually shown with 40 to 70.");
  EXPECT_EQ(faultAfter([](Scene& s) { s.cameras[0].position.x = kInfinity; }),
            "cameras.Entrance.position: expected finite numbers. Correct the numbers.");
}

TEST(FindFaults, NothingIsFartherThanTheEarthIsWide) {
  const std::string rest =
      ": expected coordinates within 1e+07 m of the origin. Correct the numbers; they are metres.";
  EXPECT_EQ(faultAfter([](Scene& s) { s.cameras[0].position.x = 1e30; }),
            "cameras.Entrance.position" + rest);
  EXPECT_EQ(faultAfter([](Scene& s) { s.cameras[0].target.y = -2e7; }),
            "cameras.Entrance.target" + rest);
  EXPECT_EQ(faultAfter([](Scene& s) { s.work_planes[0].origin.z = 1e8; }),
            "work_planes.Desks.origin" + rest);
  EXPECT_EQ(faultAfter([](Scene& s) { s.work_planes[0].u.x = 1e8; }), "work_planes.Desks.u" + rest);
  EXPECT_EQ(faultAfter([](Scene& s) { s.luminaires[1].position.x = 1e8; }),
            "luminaires.Lamp.position" + rest);
}

TEST(FindFaults, WorkPlanesHaveAnAreaAndCells) {
  const std::string no_area =
      "work_planes.Desks.u: u and v span no area. Give both a length, in different directions.";
  EXPECT_EQ(faultAfter([](Scene& s) { s.work_planes[0].u = dvec3(0); }), no_area);
  EXPECT_EQ(faultAfter([](Scene& s) { s.work_planes[0].v = 2.0 * s.work_planes[0].u; }), no_area);
  EXPECT_EQ(faultAfter([](Scene& s) { s.work_planes[0].nu = 0; }),
            "work_planes.Desks.grid: expected two counts from 1 and at most 10000000 points, found "
            "0 x 2. Correct the counts.");
  EXPECT_EQ(faultAfter([](Scene& s) { s.work_planes[0].origin.z = kNan; }),
            "work_planes.Desks.origin: expected finite numbers. Correct the numbers.");
}

TEST(FindFaults, QualityAndViewAreChecked) {
  EXPECT_EQ(
      faultAfter([](Scene& s) { s.quality.preset = "best"; }),
      "quality: expected draft, interactive or final, found 'best'. Choose one of the three.");
  EXPECT_EQ(faultAfter([](Scene& s) { s.view.exposure = kNan; }),
            "view.exposure: expected finite numbers. Correct the numbers.");
}

TEST(FindFaults, ADamagedMeshIsFound) {
  const auto damaged = [](auto&& change) {
    return faultAfter([&](Scene& s) {
      geometry::Mesh mesh = *s.mesh;
      change(mesh);
      s.mesh = std::make_shared<const geometry::Mesh>(mesh);
    });
  };
  const std::string message =
      "geometry: the mesh is damaged (indices, materials or coordinates). Export the geometry "
      "again.";
  EXPECT_EQ(damaged([](geometry::Mesh& m) { m.triangles[0].z = 3; }), message);
  EXPECT_EQ(damaged([](geometry::Mesh& m) { m.material_of[0] = 2; }), message);
  EXPECT_EQ(damaged([](geometry::Mesh& m) { m.positions[0].x = static_cast<float>(kNan); }),
            message);
  EXPECT_EQ(faultAfter([](Scene& s) { s.mesh = nullptr; }),
            "geometry: the scene has no mesh. Give it one, even if it is empty.");
}

TEST(LosslessTransmittance, IsTheSumOfItsInternalReflections) {
  // T = t^2 sum r^2k, t = 1 - r: summed until nothing is added.
  for (const double index : {1.0, 1.33, 1.52, 2.4}) {
    const double r = std::pow((index - 1) / (index + 1), 2);
    double sum = 0.0;
    for (double term = (1 - r) * (1 - r); term > 1e-18; term *= r * r) sum += term;
    constexpr double kRoundoff = 32 * std::numeric_limits<double>::epsilon();
    EXPECT_NEAR(losslessTransmittance(index), sum, kRoundoff);
  }
}

}  // namespace
}  // namespace soffit::scene
