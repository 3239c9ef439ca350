// SPDX-License-Identifier: MIT
#include "ui/document/luminaire_array.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace soffit::ui {

constexpr double kRoundoff = 1e-12;

class LuminaireArrayTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void wallsAreHalfASpacingAway() {
    const ArrayPlan plan = planArray({ArrayKind::rectangle, 3, 2}, room_, {0.6, 0.6});
    QCOMPARE(plan.places.size(), std::size_t{6});
    QVERIFY(glm::length(plan.settings.spacing - dvec2(2.0, 2.0)) < kRoundoff);
    QVERIFY(glm::length(plan.wall_distance - dvec2(1.0, 1.0)) < kRoundoff);
    QVERIFY(glm::length(plan.places.front() - dvec2(2.0, 2.0)) < kRoundoff);
    QVERIFY(glm::length(plan.places.back() - dvec2(6.0, 4.0)) < kRoundoff);
  }

  void nothingEverOverhangs() {
    for (const double spacing : {0.0, 0.3, 1.0, 5.0, 100.0}) {
      for (int count = 1; count <= 40; ++count) {
        const dvec2 size(0.6, 1.2);
        const ArrayPlan plan =
            planArray({ArrayKind::rectangle, count, count, dvec2(spacing)}, room_, size);
        for (const dvec2& p : plan.places) {
          QVERIFY(p.x - 0.5 * size.x >= room_.lo.x - kRoundoff);
          QVERIFY(p.y - 0.5 * size.y >= room_.lo.y - kRoundoff);
          QVERIFY(p.x + 0.5 * size.x <= room_.hi.x + kRoundoff);
          QVERIFY(p.y + 0.5 * size.y <= room_.hi.y + kRoundoff);
        }
      }
    }
  }

  void aTypedSpacingStaysInTheMiddle() {
    const ArrayPlan plan = planArray({ArrayKind::rectangle, 3, 1, {1.5, 0.0}}, room_, {0.6, 0.6});
    QVERIFY(std::abs(plan.places[1].x - 4.0) < kRoundoff);
    QVERIFY(std::abs(plan.places[2].x - 5.5) < kRoundoff);
  }

  void aLineRunsThroughItsLuminaire() {
    const ArrayPlan x = planArray({ArrayKind::line_x, 4, 7}, room_, {0.6, 0.6});
    QCOMPARE(x.places.size(), std::size_t{4});
    for (const dvec2& p : x.places) QCOMPARE(p.y, room_.through.y);
    const ArrayPlan y = planArray({ArrayKind::line_y, 2, 7}, room_, {0.6, 0.6});
    QCOMPARE(y.places.size(), std::size_t{2});
    for (const dvec2& p : y.places) QCOMPARE(p.x, room_.through.x);
    QVERIFY(std::abs(y.places[1].y - y.places[0].y - 2.0) < kRoundoff);
  }

  void aCircleStaysInTheRoom() {
    const ArrayPlan plan = planArray({ArrayKind::circle, 8, 1, dvec2(0), 50.0}, room_, {0.2, 0.2});
    QCOMPARE(plan.places.size(), std::size_t{8});
    for (const dvec2& p : plan.places) {
      QVERIFY(std::abs(glm::length(p - dvec2(4.0, 3.0)) - plan.settings.radius) < kRoundoff);
    }
    QVERIFY(plan.settings.radius < 2.0 && plan.settings.radius > 1.8);
    QCOMPARE(plan.turn_deg[2], 90.0);
  }

 private:
  const ArrayField room_{{1.0, 1.0}, {7.0, 5.0}, {2.5, 1.5}};
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::LuminaireArrayTest)
#include "luminaire_array_test.moc"
