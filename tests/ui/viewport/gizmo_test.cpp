// SPDX-License-Identifier: MIT
#include "ui/viewport/gizmo.h"

#include <QTest>

namespace soffit::ui {

const dvec2 kSize(1280.0, 800.0);
const dvec3 kAt(1.0, 2.0, 2.5);

ViewCamera obliqueCamera() {
  return ViewCamera::from({"", {-3.0, -2.0, 4.0}, {1.5, 2.5, 2.0}, 50.0});
}

class GizmoTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void arrowsAndPlanesAreFoundWhereTheyAreDrawn() {
    const ViewCamera camera = obliqueCamera();
    const double length = Gizmo::arrowLength(kAt, camera, kSize);
    const GizmoPart arrows[] = {GizmoPart::x, GizmoPart::y, GizmoPart::z};
    const GizmoPart planes[] = {GizmoPart::yz, GizmoPart::zx, GizmoPart::xy};
    for (int i = 0; i < 3; ++i) {
      const dvec3 tip = kAt + 0.9 * length * axisOf(i);
      QCOMPARE(Gizmo::partAt(kAt, camera, kSize, dvec2(camera.project(tip, kSize))), arrows[i]);
      const double mid = 0.5 * (Gizmo::kPlaneFrom + Gizmo::kPlaneTo) * length;
      const dvec3 plane = kAt + mid * (axisOf((i + 1) % 3) + axisOf((i + 2) % 3));
      const GizmoPart found =
          Gizmo::partAt(kAt, camera, kSize, dvec2(camera.project(plane, kSize)));
      QVERIFY(found == planes[i] || found == arrows[0] || found == arrows[1] || found == arrows[2]);
    }
    QCOMPARE(Gizmo::partAt(kAt, camera, kSize, {5.0, 5.0}), GizmoPart::none);
  }

  void anArrowMovesAlongItsAxisAloneAndStaysUnderTheMouse() {
    const ViewCamera camera = obliqueCamera();
    for (int i = 0; i < 3; ++i) {
      const dvec2 from(camera.project(kAt + 0.2 * axisOf(i), kSize));
      const dvec2 to(camera.project(kAt + 1.45 * axisOf(i), kSize));
      Gizmo gizmo(static_cast<GizmoPart>(i + 1), kAt, camera, kSize, from);
      const dvec3 moved = gizmo.moved(camera, kSize, to) - kAt;
      QVERIFY(glm::length(moved - 1.25 * axisOf(i)) < 1e-6);
    }
  }

  void aPlaneKeepsTheThirdCoordinate() {
    const ViewCamera camera = obliqueCamera();
    Gizmo gizmo(GizmoPart::xy, kAt, camera, kSize, dvec2(camera.project(kAt, kSize)));
    const dvec3 wanted = kAt + dvec3(0.7, -0.4, 0.0);
    const dvec3 moved = gizmo.moved(camera, kSize, dvec2(camera.project(wanted, kSize)));
    QVERIFY(glm::length(moved - wanted) < 1e-6);
    QCOMPARE(moved.z, kAt.z);
  }

  void theLuminaireItselfMovesInThePlaneItHangsIn() {
    const ViewCamera camera = ViewCamera::from({"", {0, -4, 1.6}, {0, 4, 1.6}, 60.0});
    const dvec3 ceiling(0.0, 2.0, 2.8);
    Gizmo gizmo(GizmoPart::free, ceiling, camera, kSize, dvec2(camera.project(ceiling, kSize)));
    const dvec3 wanted(1.0, 4.0, 2.8);
    QVERIFY(glm::length(gizmo.moved(camera, kSize, dvec2(camera.project(wanted, kSize))) - wanted) <
            1e-6);
    // Below the horizon the ceiling has no answer: the luminaire stays.
    const dvec3 last = gizmo.moved(camera, kSize, {640.0, 700.0});
    QVERIFY(glm::length(last - wanted) < 1e-6);
  }

  void partsSeenEndOnCannotBeGrabbed() {
    const ViewCamera camera = ViewCamera::from({"", {1.0, -4.0, 2.5}, {1.0, 4.0, 2.5}, 50.0});
    QVERIFY(Gizmo::isEdgeOn(GizmoPart::y, kAt, camera));
    QVERIFY(Gizmo::isEdgeOn(GizmoPart::xy, kAt, camera));
    QVERIFY(!Gizmo::isEdgeOn(GizmoPart::x, kAt, camera));
    QVERIFY(!Gizmo::isEdgeOn(GizmoPart::zx, kAt, camera));
  }

  void behindTheEyeThereIsNoGizmo() {
    const ViewCamera camera = ViewCamera::from({"", {0, 10, 2.5}, {0, 20, 2.5}, 50.0});
    QCOMPARE(Gizmo::partAt(kAt, camera, kSize, {640, 400}), GizmoPart::none);
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::GizmoTest)
#include "gizmo_test.moc"
