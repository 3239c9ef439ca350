// SPDX-License-Identifier: MIT
#include "ui/viewport/view_camera.h"

#include "core/math/sampling.h"

#include <QTest>

namespace soffit::ui {

constexpr double kRoundoff = 1e-9;
const dvec2 kSize(1280.0, 800.0);

class ViewCameraTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPointAppearsWhereItsRayGoesThrough() {
    ViewCamera camera = ViewCamera::from({"", {1, 2, 1.6}, {5, 4, 1.0}, 55.0});
    for (const dvec2& pixel : {dvec2(640, 400), dvec2(3, 790), dvec2(1200, 10)}) {
      const dvec3 point = camera.position + 4.2 * camera.rayThrough(pixel, kSize);
      QVERIFY(glm::length(dvec2(camera.project(point, kSize)) - pixel) < 1e-6);
    }
  }

  void orbitKeepsTheDistanceAndThePivotsPixel() {
    ViewCamera camera = ViewCamera::from({"", {0, -5, 2}, {0, 0, 1}, 50.0});
    const dvec3 pivot(1.0, 2.0, 0.5);
    const double distance = glm::length(camera.position - pivot);
    const dvec3 before = camera.project(pivot, kSize);
    camera.orbit(pivot, 0.7, 0.2);
    QVERIFY(std::abs(glm::length(camera.position - pivot) - distance) < kRoundoff);
    QVERIFY(glm::length(camera.project(pivot, kSize) - before) < 1e-6);
  }

  void orbitStopsShortOfThePoles() {
    ViewCamera camera;
    for (int i = 0; i < 50; ++i) camera.orbit(dvec3(0.0), 0.1, 0.4);
    QVERIFY(camera.forward.z < 1.0);
    QVERIFY(std::isfinite(camera.right().x));
    QVERIFY(std::abs(glm::length(camera.forward) - 1.0) < kRoundoff);
  }

  void zoomKeepsThePointUnderTheMouse() {
    ViewCamera camera = ViewCamera::from({"", {0, -5, 2}, {0, 0, 1}, 50.0});
    const dvec2 pixel(200, 650);
    const dvec3 point = camera.position + 6.0 * camera.rayThrough(pixel, kSize);
    camera.approach(point, 0.5);
    QVERIFY(std::abs(glm::length(camera.position - point) - 3.0) < kRoundoff);
    QVERIFY(glm::length(dvec2(camera.project(point, kSize)) - pixel) < 1e-6);
  }

  void panMovesWhatLiesAtTheDepthWithTheMouse() {
    ViewCamera camera = ViewCamera::from({"", {0, -5, 2}, {0, 0, 1}, 50.0});
    const dvec3 point = camera.position + 6.0 * camera.rayThrough({700, 300}, kSize);
    const dvec3 before = camera.project(point, kSize);
    camera.pan({40, -25}, before.z, kSize);
    const dvec3 after = camera.project(point, kSize);
    QVERIFY(glm::length(dvec2(after) - dvec2(before) - dvec2(40, -25)) < 1e-6);
  }

  void frameShowsTheWholeBox() {
    Box box;
    box.add(vec3(-3, -2, 0));
    box.add(vec3(5, 6, 2.8F));
    ViewCamera camera;
    camera.frame(box, dvec3(100, 200, 0), kSize.x / kSize.y);
    for (int i = 0; i < 8; ++i) {
      const vec3 corner((i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                        (i & 4) != 0 ? box.hi.z : box.lo.z);
      const dvec3 at = camera.project(dvec3(100, 200, 0) + dvec3(corner), kSize);
      QVERIFY(at.z > 0 && at.x >= 0 && at.x <= kSize.x && at.y >= 0 && at.y <= kSize.y);
    }
  }

  void aSavedCameraComesBack() {
    const scene::Camera saved{"Entrance", {1, 2, 1.6}, {4, 6, 1.6}, 50.0};
    const scene::Camera again = ViewCamera::from(saved).toScene("Entrance", 5.0);
    QVERIFY(glm::length(again.target - saved.target) < kRoundoff);
    QVERIFY(std::abs(again.vertical_fov_deg - 50.0) < kRoundoff);
  }

  void aCameraThatLooksStraightDownIsTiltedByAHair() {
    const ViewCamera camera = ViewCamera::from({"", {0, 0, 10}, {0, 0, 0}, 50.0});
    QVERIFY(std::isfinite(camera.right().x));
    QVERIFY(camera.forward.z < -0.999);
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::ViewCameraTest)
#include "view_camera_test.moc"
