// SPDX-License-Identifier: MIT
#include "ui/viewport/walking.h"

#include "ui/viewport/camera_history.h"

#include <QTest>

#include <cmath>

namespace soffit::ui {

/// A room of 8 by 6 m about the middle, with a step of 0.3 m in its right half.
class WalkingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    walking_ = {};
    camera_ = {};
    camera_.position = {0.0, 0.0, Walking::kEyeHeight};
    camera_.forward = {0.0, 1.0, 0.0};
  }

  void theWayIsTheSameHoweverOftenPicturesCome() {
    walk({{0, 1, 0}, false}, 1.0, 0.01);
    const double often = camera_.position.y;
    init();
    walk({{0, 1, 0}, false}, 1.0, 0.05);
    // The steps of a velocity that grows: half a step at the full speed.
    QVERIFY(std::abs(camera_.position.y - often) < 0.5 * 0.05 * walking_.speed());
    // What is missing from speed times time is what was lost in gathering way.
    QVERIFY(often > 0.85 * walking_.speed() && often < walking_.speed());
  }

  void itGathersAndLosesWaySmoothly() {
    walk({{0, 1, 0}, false}, 0.02, 0.01);
    QVERIFY(camera_.position.y < 0.5 * 0.02 * walking_.speed());
    walk({{0, 1, 0}, false}, 0.5, 0.01);
    const double before = camera_.position.y;
    walk({}, 0.01, 0.01);
    QVERIFY(camera_.position.y > before);
    walk({}, 1.0, 0.01);
    QVERIFY(!walking_.isMoving());
  }

  void fastIsThreeTimesAsFastAndTheSpeedCanBeSet() {
    walk({{-1, 0, 0}, false}, 1.0, 0.01);
    const double slow = -camera_.position.x;
    init();
    walk({{-1, 0, 0}, true}, 0.5, 0.01);
    QVERIFY(-camera_.position.x > 1.2 * slow);
    const double speed = walking_.speed();
    walking_.changeSpeed(2.0);
    QVERIFY(std::abs(walking_.speed() - 1.25 * 1.25 * speed) < 1e-12);
    walking_.changeSpeed(1000.0);
    QVERIFY(walking_.speed() < 50.0);
  }

  void wallsHoldAndLetSlideAlong() {
    walk({{0, 1, 0}, true}, 3.0, 0.016);
    QVERIFY(std::abs(camera_.position.y - (3.0 - Walking::kRadius)) < 1e-3);
    QVERIFY(std::abs(camera_.position.x) < 1e-6);
    // Against the wall and to the left: along it, into the corner.
    walk({{-1, 1, 0}, true}, 4.0, 0.016);
    QVERIFY(std::abs(camera_.position.y - (3.0 - Walking::kRadius)) < 1e-3);
    QVERIFY(std::abs(camera_.position.x + 4.0 - Walking::kRadius) < 1e-3);
  }

  void noStepIsSoLongThatItLeadsThroughAWall() {
    walking_.changeSpeed(100.0);
    walk({{0, 1, 0}, true}, 3.0, 0.1);
    QVERIFY(camera_.position.y < 3.0);
  }

  void theEyeStaysAtItsHeightOverTheFloor() {
    walk({{1, 0, 0}, false}, 1.5, 0.016);
    QVERIFY(camera_.position.x > 1.5);
    QVERIFY(std::abs(camera_.position.z - (0.3 + Walking::kEyeHeight)) < 0.02);
    walk({{-1, 0, 0}, false}, 2.5, 0.016);
    QVERIFY(std::abs(camera_.position.z - Walking::kEyeHeight) < 0.02);
  }

  void upAndDownSetTheHeightAndEndAtCeilingAndFloor() {
    walk({{0, 0, -1}, false}, 0.3, 0.016);
    const double crouched = camera_.position.z;
    QVERIFY(crouched < 1.5);
    walk({{0, 1, 0}, false}, 0.5, 0.016);
    QVERIFY(std::abs(camera_.position.z - crouched) < 0.1);
    walk({{0, 0, -1}, false}, 5.0, 0.016);
    QVERIFY(camera_.position.z > 0.1);
    walk({{0, 0, 1}, false}, 5.0, 0.016);
    QVERIFY(camera_.position.z < 2.6);
    walking_.standUp();
    walk({{0, -1, 0}, false}, 1.0, 0.016);
    QVERIFY(std::abs(camera_.position.z - Walking::kEyeHeight) < 0.02);
  }

  void whereOneLooksUpOrDownOneStillWalksOnTheFloor() {
    camera_.forward = glm::normalize(dvec3(0.0, 0.3, -0.95));
    walk({{0, 1, 0}, false}, 1.0, 0.016);
    QVERIFY(camera_.position.y > 1.0);
    QVERIFY(std::abs(camera_.position.z - Walking::kEyeHeight) < 0.02);
  }

  void theWayBackAndForward() {
    CameraHistory history;
    ViewCamera a;
    ViewCamera b = a;
    b.position.x += 1.0;
    ViewCamera c = b;
    c.position.x += 1.0;
    QVERIFY(!history.back(a).has_value());
    history.settle(b);
    QCOMPARE(history.back(c).value(), b);  // c was not settled yet: it is a place nonetheless
    QCOMPARE(history.back(b).value(), a);
    QVERIFY(!history.back(a).has_value());
    QCOMPARE(history.forward(a).value(), b);
    QCOMPARE(history.forward(b).value(), c);
    QVERIFY(!history.forward(c).has_value());
    QCOMPARE(history.back(c).value(), b);
    history.settle(a);  // elsewhere: what came after is gone
    QVERIFY(!history.canGoForward());
  }

 private:
  static std::optional<Walking::Met> room(const dvec3& from, const dvec3& direction) {
    std::optional<Walking::Met> nearest;
    const auto wall = [&](int axis, double place, double toward) {
      if (direction[axis] * toward <= 0.0) return;
      const double t = (place - from[axis]) / direction[axis];
      if (t < 0.0 || (nearest && nearest->distance < t)) return;
      dvec3 n(0.0);
      n[axis] = -toward;
      nearest = {t, n};
    };
    wall(0, -4.0, -1.0);
    wall(0, 4.0, 1.0);
    wall(1, -3.0, -1.0);
    wall(1, 3.0, 1.0);
    wall(2, 2.6, 1.0);
    wall(2, from.x > 1.0 ? 0.3 : 0.0, -1.0);
    return nearest;
  }
  void walk(const Walking::Wish& wish, double seconds, double step) {
    const int steps = static_cast<int>(std::lround(seconds / step));
    for (int i = 0; i < steps; ++i) walking_.advance(camera_, wish, step, room);
  }

  Walking walking_;
  ViewCamera camera_;
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::WalkingTest)
#include "walking_test.moc"
