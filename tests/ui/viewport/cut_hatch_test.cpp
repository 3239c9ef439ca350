// SPDX-License-Identifier: MIT
#include "ui/viewport/cut_hatch.h"

#include "core/transfer/charts.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace soffit::ui {

/// Hatching measures what it fills: the length of all lines times their spacing is the area.
class CutHatchTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aBoxIsFilled_data() {
    QTest::addColumn<int>("axis");
    for (const int axis : {0, 1, 2}) QTest::newRow(qPrintable(QString::number(axis))) << axis;
  }
  void aBoxIsFilled() {
    QFETCH(int, axis);
    geometry::Mesh mesh;
    addBox(mesh, {0.0F, 0.0F, 0.0F}, {2.0F, 2.0F, 2.0F});
    QVERIFY(std::abs(area(mesh, axis, 0.7) - 4.0) < kTruncation * 8.0);
    QCOMPARE(area(mesh, axis, 2.5), 0.0);
    for (const vec3& p : hatch(mesh, axis, 0.7)) {
      QCOMPARE(p[axis], 0.7F);
      for (int k = 0; k < 3; ++k) QVERIFY(p[k] >= -1e-5F && p[k] <= 2.0F + 1e-5F);
    }
  }

  void aCavityIsNot() {
    geometry::Mesh mesh;
    addBox(mesh, {0.0F, 0.0F, 0.0F}, {2.0F, 2.0F, 2.0F});
    const std::size_t outer = mesh.triangles.size();
    addBox(mesh, {0.5F, 0.5F, 0.5F}, {1.5F, 1.5F, 1.5F});
    for (std::size_t t = outer; t < mesh.triangles.size(); ++t) {
      std::swap(mesh.triangles[t].y, mesh.triangles[t].z);
    }
    // Here both shells belong to one body.
    const std::vector<std::uint8_t> solid(mesh.triangles.size(), 1);
    QVERIFY(std::abs(area(mesh, solid, 2, 1.0) - 3.0) < kTruncation * 12.0);
  }

  void bodiesInOneAnotherAreFilledOnce() {
    geometry::Mesh mesh;
    addBox(mesh, {0.0F, 0.0F, 0.0F}, {2.0F, 2.0F, 2.0F});
    addBox(mesh, {1.0F, 1.0F, 0.0F}, {3.0F, 3.0F, 2.0F});
    QVERIFY(std::abs(area(mesh, 2, 1.0) - 7.0) < kTruncation * 16.0);
  }

  void roomsAndSheetsAreNoBodies() {
    geometry::Mesh room;
    addBox(room, {0.0F, 0.0F, 0.0F}, {2.0F, 2.0F, 2.0F});
    // Light inside, wound outward.
    std::vector<std::uint8_t> sides(room.triangles.size(), transfer::kBack);
    QVERIFY(!anySolid(room, sides));
    // Wound inward.
    for (uvec3& t : room.triangles) std::swap(t.y, t.z);
    sides.assign(room.triangles.size(), transfer::kFront);
    QVERIFY(!anySolid(room, sides));
    // A box without a lid.
    geometry::Mesh open;
    addBox(open, {0.0F, 0.0F, 0.0F}, {2.0F, 2.0F, 2.0F});
    open.triangles.pop_back();
    sides.assign(open.triangles.size(), transfer::kFront);
    QVERIFY(!anySolid(open, sides));
    // An outer wall carries light on some of its faces alone, and is a body.
    geometry::Mesh wall;
    addBox(wall, {0.0F, 0.0F, 0.0F}, {2.0F, 0.2F, 2.0F});
    sides.assign(wall.triangles.size(), transfer::kNoSide);
    sides.front() = transfer::kFront;
    QVERIFY(anySolid(wall, sides));
    QVERIFY(solidTriangles(wall, {}).size() == wall.triangles.size());
  }

 private:
  static constexpr double kSpacing = 0.01;
  /// Each stretch of outline may err by half a spacing over its length.
  static constexpr double kTruncation = 0.5 * kSpacing;

  static void addBox(geometry::Mesh& mesh, const vec3& lo, const vec3& hi) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int k = 0; k < 8; ++k) {
      mesh.positions.emplace_back((k & 1) != 0 ? hi.x : lo.x, (k & 2) != 0 ? hi.y : lo.y,
                                  (k & 4) != 0 ? hi.z : lo.z);
    }
    for (const auto& q :
         {std::array{0U, 2U, 3U, 1U}, std::array{4U, 5U, 7U, 6U}, std::array{0U, 1U, 5U, 4U},
          std::array{2U, 6U, 7U, 3U}, std::array{0U, 4U, 6U, 2U}, std::array{1U, 3U, 7U, 5U}}) {
      mesh.triangles.emplace_back(first + q[0], first + q[1], first + q[2]);
      mesh.triangles.emplace_back(first + q[0], first + q[2], first + q[3]);
    }
  }
  static bool anySolid(const geometry::Mesh& mesh, const std::vector<std::uint8_t>& sides) {
    const auto solid = solidTriangles(mesh, sides);
    return std::ranges::find(solid, 1) != solid.end();
  }
  static std::vector<vec3> hatch(const geometry::Mesh& mesh, int axis, double place) {
    const std::vector<std::uint8_t> sides(mesh.triangles.size(), transfer::kFront);
    return sectionHatch(mesh, solidTriangles(mesh, sides), axis, place, kSpacing);
  }
  static double measure(const std::vector<vec3>& ends) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      sum += static_cast<double>(glm::length(ends[i + 1] - ends[i]));
    }
    return sum * kSpacing;
  }
  static double area(const geometry::Mesh& mesh, int axis, double place) {
    return measure(hatch(mesh, axis, place));
  }
  static double area(const geometry::Mesh& mesh, const std::vector<std::uint8_t>& solid, int axis,
                     double place) {
    return measure(sectionHatch(mesh, solid, axis, place, kSpacing));
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::CutHatchTest)

#include "cut_hatch_test.moc"
