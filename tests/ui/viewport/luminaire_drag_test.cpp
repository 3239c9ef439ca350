// SPDX-License-Identifier: MIT
#include "ui/viewport/luminaire_drag.h"

#include <QTest>

namespace soffit::ui {

const dvec2 kSize(1280.0, 800.0);
const dvec3 kAt(1.0, 2.0, 2.5);

class LuminaireDragTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    camera_ = ViewCamera::from({"", {-3.0, -2.0, 4.0}, {1.5, 2.5, 2.0}, 50.0});
    luminaire_ = {};
    luminaire_.position = kAt;
  }

  void anAxisLockKeepsTheOtherCoordinates() {
    LuminaireDrag drag = begin(GizmoTool::move, GizmoPart::free, kAt);
    drag.moveTo(pixel(kAt + dvec3(0.7, 0.4, 0)), false, true);
    drag.lockAxis(1);
    drag.apply(luminaire_);
    QCOMPARE(luminaire_.position.x, kAt.x);
    QCOMPARE(luminaire_.position.z, kAt.z);
    QVERIFY(luminaire_.position.y != kAt.y);
    drag.lockAxis(1);
    light::Luminaire again;
    again.position = kAt;
    drag.apply(again);
    QVERIFY(glm::length(again.position - (kAt + dvec3(0.7, 0.4, 0))) < 2e-4);
  }

  void aTypedLengthIsTheWay() {
    LuminaireDrag drag = begin(GizmoTool::move, GizmoPart::x, kAt + dvec3(0.2, 0, 0));
    drag.moveTo(pixel(kAt + dvec3(0.5, 0, 0)), false, false);
    type(drag, QStringLiteral("-120cm"));
    drag.apply(luminaire_);
    QVERIFY(std::abs(luminaire_.position.x - (kAt.x - 1.2)) < 1e-9);
    QVERIFY(drag.readout().text.contains(QStringLiteral("-120cm")));
    // Taken back to "-12": metres.
    for (int i = 0; i < 3; ++i) QVERIFY(drag.type(QLatin1Char('\b')));
    light::Luminaire again;
    again.position = kAt;
    drag.apply(again);
    QVERIFY(std::abs(again.position.x - (kAt.x - 12.0)) < 1e-9);
  }

  void inAPlaneATypedLengthGoesTheWayOfTheMouse() {
    LuminaireDrag drag = begin(GizmoTool::move, GizmoPart::free, kAt);
    drag.moveTo(pixel(kAt + dvec3(0.3, 0.4, 0)), false, true);
    type(drag, QStringLiteral("2"));
    drag.apply(luminaire_);
    // The way is known to a tenth of a millimetre in half a metre.
    QVERIFY(glm::length(luminaire_.position - (kAt + dvec3(1.2, 1.6, 0))) < 2e-3);
  }

  void aRingTurnsByTheAngleOfTheMouse() {
    const double r = Turning::kRingRadius * Gizmo::arrowLength(kAt, camera_, kSize);
    const auto onRing = [&](double deg) {
      return kAt + r * dvec3(std::cos(radians(deg)), std::sin(radians(deg)), 0);
    };
    QCOMPARE(Turning::partAt(kAt, camera_, kSize, pixel(onRing(200))), GizmoPart::z);
    LuminaireDrag drag = begin(GizmoTool::rotate, GizmoPart::z, onRing(200));
    for (int deg = 200; deg <= 250; deg += 10) drag.moveTo(pixel(onRing(deg)), false, false);
    drag.apply(luminaire_);
    QCOMPARE(luminaire_.rotation_deg, dvec3(0, 0, 50));
    QCOMPARE(luminaire_.position, kAt);
    drag.moveTo(pixel(onRing(240)), true, false);
    light::Luminaire stepped;
    drag.apply(stepped);
    QCOMPARE(stepped.rotation_deg.z, 45.0);
  }

  void severalTurnAboutTheirMiddle() {
    LuminaireDrag drag = begin(GizmoTool::rotate, GizmoPart::z, kAt + dvec3(0.1, 0, 0));
    type(drag, QStringLiteral("90"));
    light::Luminaire aside;
    aside.position = kAt + dvec3(1, 0, 0);
    drag.apply(aside);
    QCOMPARE(aside.position, kAt + dvec3(0, 1, 0));
    QCOMPARE(aside.rotation_deg, dvec3(0, 0, 90));
  }

  void handlesResizeOneSideTheMiddleAll() {
    luminaire_.shape = light::Rectangle{0.6, 1.2};
    const double length = Gizmo::arrowLength(kAt, camera_, kSize);
    const dvec3 tip = kAt + length * axisOf(0);
    QCOMPARE(Scaling::partAt(kAt, dmat3(1.0), camera_, kSize, pixel(tip)), GizmoPart::x);
    QCOMPARE(Scaling::partAt(kAt, dmat3(1.0), camera_, kSize, pixel(kAt)), GizmoPart::free);
    LuminaireDrag one = begin(GizmoTool::scale, GizmoPart::x, tip);
    type(one, QStringLiteral("1.5"));
    one.apply(luminaire_);
    QCOMPARE(std::get<light::Rectangle>(luminaire_.shape).width, 0.9);
    QCOMPARE(std::get<light::Rectangle>(luminaire_.shape).height, 1.2);
    LuminaireDrag all = begin(GizmoTool::scale, GizmoPart::free, kAt);
    all.moveTo(pixel(kAt) + dvec2(100, 0), false, false);
    all.apply(luminaire_);
    QCOMPARE(std::get<light::Rectangle>(luminaire_.shape).width, 1.8);
    QCOMPARE(std::get<light::Rectangle>(luminaire_.shape).height, 2.4);
  }

 private:
  LuminaireDrag begin(GizmoTool tool, GizmoPart part, const dvec3& grip) {
    LuminaireDrag::Start start;
    start.tool = tool;
    start.part = part;
    start.pivot = kAt;
    start.camera = camera_;
    start.view_size = kSize;
    start.mouse = pixel(grip);
    return LuminaireDrag(start, {}, {});
  }
  static void type(LuminaireDrag& drag, const QString& text) {
    for (const QChar c : text) QVERIFY(drag.type(c));
  }
  [[nodiscard]] dvec2 pixel(const dvec3& p) const { return dvec2(camera_.project(p, kSize)); }

  ViewCamera camera_;
  light::Luminaire luminaire_;
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::LuminaireDragTest)
#include "luminaire_drag_test.moc"
