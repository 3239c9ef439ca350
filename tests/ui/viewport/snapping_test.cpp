// SPDX-License-Identifier: MIT
#include "ui/viewport/snapping.h"

#include "core/geometry/shapes.h"

#include <QTest>

namespace soffit::ui {

/// A room of 6 m x 4 m x 2.8 m from the origin.
Surroundings room(std::vector<dvec3> neighbours) {
  const geometry::Mesh box = geometry::makeBox(vec3(0), vec3(6.0F, 4.0F, 2.8F));
  auto caster = std::make_shared<geometry::RayCaster>(box.positions, box.triangles);
  Surroundings around;
  around.caster = caster.get();
  around.owner = caster;
  int i = 0;
  for (const dvec3& p : neighbours) around.neighbours.push_back({std::to_string(++i), p});
  return around;
}

/// Distances come from rays in single precision across 6 m.
constexpr double kRayRoundoff = 8.0 * 6.0 * 6e-8;
const glm::bvec3 kFlat(true, true, false);
const dvec3 kHalf(0.3, 0.3, 0.0);

class SnappingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theAxesOfOthersAttract() {
    const auto around = room({{1.5, 1.0, 2.79}, {4.5, 3.2, 2.79}});
    const Snapped s = snap(around, {}, {1.46, 3.13, 2.79}, kFlat, kHalf, 0.1);
    QCOMPARE(s.place, dvec3(1.5, 3.2, 2.79));
    QCOMPARE(s.guides.size(), std::size_t{2});
  }

  void spacingIsCarriedOnAndHalved() {
    const auto around = room({{1.0, 2.0, 2.79}, {2.5, 2.0, 2.79}});
    QVERIFY(std::abs(snap(around, {}, {4.07, 2.02, 2.79}, kFlat, kHalf, 0.1).place.x - 4.0) <
            1e-12);
    QVERIFY(std::abs(snap(around, {}, {1.71, 2.0, 2.79}, kFlat, kHalf, 0.1).place.x - 1.75) <
            1e-12);
  }

  void wallsStopTheEdgeAndTheirMiddleAttracts() {
    const auto around = room({});
    QVERIFY(std::abs(snap(around, {}, {0.34, 1.3, 2.79}, kFlat, kHalf, 0.1).place.x - 0.3) <
            kRayRoundoff);
    const dvec3 middle = snap(around, {}, {2.95, 2.06, 2.79}, kFlat, kHalf, 0.1).place;
    QVERIFY(glm::length(dvec2(middle) - dvec2(3.0, 2.0)) < kRayRoundoff);
  }

  void halfTheSpacingFromAWallAttracts() {
    const auto around = room({{2.4, 1.3, 2.79}});
    // 0.8 from the wall and 1.6 from the neighbour.
    QVERIFY(std::abs(snap(around, {}, {0.85, 1.3, 2.79}, kFlat, kHalf, 0.1).place.x - 0.8) <
            kRayRoundoff);
  }

  void theCeilingKeepsItsGap() {
    const auto around = room({});
    const glm::bvec3 up(false, false, true);
    for (const double z : {2.74, 2.83}) {
      const Snapped s = snap(around, {}, {1.3, 1.3, z}, up, kHalf, 0.1);
      QVERIFY(std::abs(s.place.z - (2.8 - kCeilingGap)) < kRayRoundoff);
    }
    const dvec3 tall(0.1, 0.1, 0.2);
    QVERIFY(std::abs(snap(around, {}, {1.3, 1.3, 2.55}, up, tall, 0.1).place.z -
                     (2.6 - kCeilingGap)) < kRayRoundoff);
  }

  void theGridTakesWhatNothingElseAttracts() {
    SnapRules rules;
    rules.grid = true;
    const auto around = room({{1.5, 1.0, 2.79}});
    const Snapped s = snap(around, rules, {1.52, 2.68, 2.79}, kFlat, kHalf, 0.05);
    QCOMPARE(s.place.x, 1.5);
    QVERIFY(std::abs(s.place.y - 2.7) < 1e-12);
  }

  void freeMeansFree() {
    const auto around = room({{1.5, 1.0, 2.79}});
    const dvec3 place(1.49, 1.01, 2.79);
    QCOMPARE(snap(around, {}, place, kFlat, kHalf, 0.0).place, place);
  }

  void whatLiesBehindAWallDoesNotAttract() {
    auto around = room({{1.5, 6.0, 2.79}});
    const Snapped s = snap(around, {}, {1.46, 1.2, 2.79}, {true, false, false}, kHalf, 0.1);
    QCOMPARE(s.place.x, 1.46);
  }

  void clearancesGoToWhatComesFirst() {
    const auto around = room({{4.5, 2.0, 2.79}});
    const auto all = clearances(around, {1.5, 2.0, 2.79}, kFlat);
    QCOMPARE(all.size(), std::size_t{4});
    QVERIFY(std::abs(glm::length(all[0].to - all[0].from) - 1.5) < kRayRoundoff);
    QVERIFY(all[0].wall);
    QVERIFY(std::abs(glm::length(all[1].to - all[1].from) - 3.0) < kRayRoundoff);
    QVERIFY(!all[1].wall);
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::SnappingTest)
#include "snapping_test.moc"
