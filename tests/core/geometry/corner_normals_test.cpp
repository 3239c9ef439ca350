// SPDX-License-Identifier: MIT
#include "core/geometry/corner_normals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/shapes.h"

namespace soffit::geometry {
namespace {

// Round-off: a few operations in double, stored in single precision.
constexpr float kRoundoff = 4 * 0x1p-24F;

TEST(CornerNormals, SphereNormalsPointAwayFromItsCenter) {
  const Mesh sphere = makeSphere({0, 0, 0}, 2, 16);
  const std::vector<vec3> normals =
      cornerNormals({sphere.positions, sphere.triangles, sphere.object_of}, 40.0);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const vec3 p = sphere.positions[sphere.triangles[i / 3][static_cast<int>(i % 3)]];
    // Truncation: facets turn by 11 degrees, and the mean errs by a small part of that.
    EXPECT_GT(glm::dot(normals[i], p / 2.0F), std::cos(radians(1.0)));
  }
}

// Two unit squares that share the y axis as an edge, folded by `fold_deg`, as welded triangles.
struct Fold {
  explicit Fold(double fold_deg) {
    const auto c = static_cast<float>(std::cos(radians(fold_deg)));
    const auto s = static_cast<float>(std::sin(radians(fold_deg)));
    points = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {c, 0, s}, {c, 1, s}};
    triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  }
  std::vector<vec3> points;
  std::vector<uvec3> triangles;
  std::vector<std::uint32_t> object_of{0, 0, 0, 0};
};

TEST(CornerNormals, GentleFoldsAreSmoothAndSharpOnesHard) {
  const Fold gentle(39.0);
  const vec3 middle(-std::sin(radians(19.5)), 0.0, std::cos(radians(19.5)));
  const std::vector<vec3> smooth =
      cornerNormals({gentle.points, gentle.triangles, gentle.object_of}, 40.0);
  EXPECT_LT(glm::distance(smooth[1], middle), kRoundoff);  // both right angles weigh the same
  EXPECT_EQ(smooth[1], smooth[6]);                         // either side, bit for bit
  EXPECT_EQ(smooth[0], vec3(0, 0, 1));
  const Fold sharp(41.0);
  const std::vector<vec3> hard =
      cornerNormals({sharp.points, sharp.triangles, sharp.object_of}, 40.0);
  EXPECT_EQ(hard[1], vec3(0, 0, 1));
  EXPECT_GT(glm::distance(hard[1], hard[6]), 0.5F);
}

TEST(CornerNormals, ObjectsAreNotSmoothedInto) {
  Fold fold(20.0);
  fold.object_of = {0, 0, 1, 1};
  const std::vector<vec3> normals =
      cornerNormals({fold.points, fold.triangles, fold.object_of}, 40.0);
  EXPECT_EQ(normals[1], vec3(0, 0, 1));
}

TEST(CornerNormals, TheAngleIsTheWeightHoweverFacesAreCut) {
  // One face of the fold cut finer at the shared corner: the normal must not move.
  const Fold plain(30.0);
  Fold cut(30.0);
  cut.points.emplace_back(0.5F * (cut.points[4] + cut.points[5]));
  cut.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 6}, {1, 6, 5}, {1, 5, 2}};
  cut.object_of.push_back(0);
  const vec3 a = cornerNormals({plain.points, plain.triangles, plain.object_of}, 40.0)[1];
  const vec3 b = cornerNormals({cut.points, cut.triangles, cut.object_of}, 40.0)[1];
  EXPECT_LT(glm::distance(a, b), 2 * kRoundoff);
}

TEST(CornerNormals, HugeFansKeepTheirFaceNormals) {
  const int columns = 5000;  // above the limit of 4096 triangles about one point
  const Mesh disk = makeDisk(1.0F, columns);
  const std::vector<vec3> normals =
      cornerNormals({disk.positions, disk.triangles, disk.object_of}, 40.0);
  for (const vec3& n : normals) ASSERT_LT(glm::distance(n, vec3(0, 0, 1)), kRoundoff);
}

}  // namespace
}  // namespace soffit::geometry
