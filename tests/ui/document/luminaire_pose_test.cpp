// SPDX-License-Identifier: MIT
#include "ui/document/luminaire_pose.h"

#include <QTest>

namespace soffit::ui {

/// Angles are whole thousandths of a degree; a matrix entry then errs by at most three of their
/// halves.
constexpr double kAngleRounding = 3.0 * 0.5e-3 * kPi / 180.0;

double difference(const dmat3& a, const dmat3& b) {
  double most = 0.0;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) most = std::max(most, std::abs(a[c][r] - b[c][r]));
  }
  return most;
}

class LuminairePoseTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anglesOfARotationGiveTheRotation() {
    for (const dvec3& angles : {dvec3(0, 0, 0), dvec3(10, 20, 30), dvec3(-170, 80, 120),
                                dvec3(33, 90, 12), dvec3(0, -90, -45), dvec3(180, 0, 90)}) {
      const dmat3 rotation = rotationXyz(angles);
      QVERIFY(difference(rotationXyz(rotationDegOf(rotation)), rotation) < kAngleRounding);
    }
  }

  void anAimedLuminaireEmitsTowardItsTarget() {
    for (const dvec3& way : {dvec3(1, 2, -3), dvec3(-1, 0.2, 0.5), dvec3(0, -1, 0)}) {
      const dvec3 direction = glm::normalize(way);
      const dvec3 emits = rotationXyz(aimedAlong(direction, dvec3(0))) * dvec3(0, 0, -1);
      QVERIFY(glm::length(emits - direction) < 2.0 * kAngleRounding);
    }
    QCOMPARE(aimedAlong({0, 0, -1}, {0, 0, 35}), dvec3(0, 0, 35));
  }

  void turningAboutZKeepsTheOtherAngles() {
    light::Luminaire l;
    l.rotation_deg = {15, -40, 170};
    l.position = {2, 0, 1};
    turn(l, 2, 30.0, {1, 0, 0});
    QCOMPARE(l.rotation_deg, dvec3(15, -40, -160));
    QVERIFY(glm::length(l.position - dvec3(1 + std::cos(kPi / 6), 0.5, 1)) < 1e-4);
  }

  void turningAboutAnyAxisTurnsTheFrame() {
    for (int axis = 0; axis < 3; ++axis) {
      light::Luminaire l;
      l.rotation_deg = {12, 34, 56};
      dvec3 by(0);
      by[axis] = 25.0;
      const dmat3 expected = rotationXyz(by) * rotationXyz(l.rotation_deg);
      turn(l, axis, 25.0, l.position);
      QVERIFY(difference(rotationXyz(l.rotation_deg), expected) < kAngleRounding);
    }
  }

  void sizesGrowAlongTheirOwnAxes() {
    light::Luminaire l;
    l.shape = light::Rectangle{0.6, 1.2};
    resize(l, {2.0, 1.0, 1.0});
    QCOMPARE(std::get<light::Rectangle>(l.shape).width, 1.2);
    QCOMPARE(std::get<light::Rectangle>(l.shape).height, 1.2);
    l.shape = light::Tube{1.2, 0.02};
    resize(l, {1.5, 1.0, 1.0});
    QCOMPARE(std::get<light::Tube>(l.shape).length, 1.8);
    QCOMPARE(std::get<light::Tube>(l.shape).radius, 0.02);
    l.shape = light::Disk{0.2};
    resize(l, {1.0, 0.5, 1.0});
    QCOMPARE(std::get<light::Disk>(l.shape).radius, 0.1);
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::LuminairePoseTest)
#include "luminaire_pose_test.moc"

#include <algorithm>
