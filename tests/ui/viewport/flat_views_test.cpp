// SPDX-License-Identifier: MIT
#include "core/geometry/shapes.h"
#include "tests/ui/viewport/cornell_view.h"
#include "ui/viewport/cutting.h"
#include "ui/viewport/standard_view.h"

#include <QMainWindow>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>

namespace soffit::ui {

constexpr double kRoundoff = 1e-9;
const dvec2 kSize(640.0, 400.0);

/// Plans, elevations and sections: their arithmetic, and what the mouse does in them.
class FlatViewsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { lit_ = std::make_unique<Lit>(lightCornell()); }
  void init() {
    v_ = std::make_unique<CornellView>(*lit_);
    QVERIFY(v_->show(lit_->frame));
  }
  void cleanup() { v_.reset(); }

  void everyViewShowsAllOfTheBuilding_data() {
    QTest::addColumn<int>("view");
    for (const StandardView view : kStandardViews) {
      if (view != StandardView::perspective)
        QTest::newRow(qPrintable(nameOf(view))) << static_cast<int>(view);
    }
  }
  void everyViewShowsAllOfTheBuilding() {
    QFETCH(int, view);
    const auto standard = static_cast<StandardView>(view);
    Box box;
    box.add(vec3(-3, -2, 0));
    box.add(vec3(9, 6, 2.8F));
    const dvec3 origin(100, 200, 10);
    const ViewCamera camera = standardCamera(standard, box, origin, 10.0, kSize.x / kSize.y);
    QVERIFY(camera.isParallel());
    for (int i = 0; i < 8; ++i) {
      const dvec3 corner((i & 1) != 0 ? 9 : -3, (i & 2) != 0 ? 6 : -2, (i & 4) != 0 ? 2.8 : 0);
      const dvec3 at = camera.project(origin + corner, kSize);
      QVERIFY(at.z > 0.0 && at.x >= 0.0 && at.x <= kSize.x && at.y >= 0.0 && at.y <= kSize.y);
    }
    QCOMPARE(standardViewOf(camera, box, origin), standard);
    QVERIFY(std::abs(glm::dot(camera.right(), camera.up())) < kRoundoff);
    QVERIFY(std::abs(glm::dot(camera.right(), camera.forward)) < kRoundoff);
  }

  void aPointAppearsWhereItsRayGoesThrough() {
    const ViewCamera camera = flat(StandardView::front);
    const dvec2 pixel(123.0, 45.0);
    const dvec3 p = camera.rayOrigin(pixel, kSize) + 7.0 * camera.rayThrough(pixel, kSize);
    QVERIFY(glm::length(dvec2(camera.project(p, kSize)) - pixel) < 1e-6);
    QVERIFY(glm::length(camera.eyeFor(p) - camera.rayOrigin(pixel, kSize)) < 1e-9);
  }

  void zoomKeepsThePointUnderTheMouseAndTheCut() {
    ViewCamera camera = flat(StandardView::plan);
    const double cut = camera.cutPlace();
    const dvec2 pixel(500.0, 80.0);
    const dvec3 p = camera.rayOrigin(pixel, kSize) + 12.0 * camera.forward;
    const double height = camera.parallel_height;
    camera.approach(p, 0.5);
    QVERIFY(std::abs(camera.parallel_height - 0.5 * height) < kRoundoff);
    QVERIFY(glm::length(dvec2(camera.project(p, kSize)) - pixel) < 1e-6);
    QVERIFY(std::abs(camera.cutPlace() - cut) < kRoundoff);
  }

  void aPlaneMeetsASolidInAClosedOutline() {
    const std::vector<vec3> lines = sectionLines(geometry::makeSphere({2, 1, 0}, 1.5F, 12), 2, 1.0);
    QVERIFY(!lines.empty());
    for (const vec3& p : lines) {
      QCOMPARE(p.z, 1.0F);
      // Every end is the end of an even number of lines: outlines are closed.
      const auto count =
          std::ranges::count_if(lines, [&](const vec3& q) { return glm::length(q - p) < 1e-4F; });
      QVERIFY(count % 2 == 0);
    }
  }

  void aPlanSeesTheFloorThroughTheCeilingAndReadsItsLight() {
    v_->view->setViewCamera(flat(StandardView::plan));
    const dvec3 middle = v_->document->scene()->mesh->origin + dvec3(v_->view->bounds().center());
    const PointedAt at = v_->view->pointAt(QPointF(v_->pixelOf(middle + dvec3(0.3, -0.6, 0.0))));
    QVERIFY(at.surface.has_value());
    QVERIFY(at.surface->normal.z > 0.9F);
    QVERIFY(at.surface->position.z < kPlanCut);
    QVERIFY(at.surface->lux > 1.0);
    QVERIFY(meanOf(picture()) > 10.0);
  }

  void whatTheCutTakesAwayIsNotDrawn() {
    ViewCamera camera = flat(StandardView::section_front);
    v_->view->setViewCamera(camera);
    const double before = meanOf(picture());
    camera.setCutPlace(camera.cutPlace() + 100.0);
    v_->view->setViewCamera(camera);
    QVERIFY(before > 10.0);
    // What is left are the lines of the luminaires.
    QVERIFY(meanOf(picture()) < 0.1 * before);
  }

  void bodiesAreHatchedWhereTheyAreCut() {
    // The tall block reaches through the cut of the plan, the short one ends below it.
    v_->view->setViewCamera(flat(StandardView::plan));
    Shot shot;
    shot.pixels = {640, 400};
    const auto still = v_->view->still(shot);
    QVERIFY(still.has_value());
    const std::vector<vec3>& ends = still->lines.front().ends;
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      QVERIFY(ends[i].x > 0.41F && ends[i].x < 1.47F && ends[i].y > 1.22F && ends[i].y < 2.29F);
      length += static_cast<double>(glm::length(ends[i + 1] - ends[i]));
    }
    // Its foot is 0.827 m by 0.837 m; every line may err by its spacing of 5 cm.
    QVERIFY2(std::abs(0.05 * length - 0.827 * 0.837) < 0.05 * 2.0 * (0.827 + 0.837) / 2.0,
             qPrintable(QString::number(0.05 * length)));
    v_->view->setViewCamera(flat(StandardView::front));  // before all there is
    QVERIFY(v_->view->still(shot)->lines.front().ends.empty());
  }

  /// Light of triangles seen in parallel, from what is known of the pixels: as in perspective.
  void whatIsKnownOfAViewGivesTheSamePicture() {
    v_->view->setViewCamera(flat(StandardView::plan));
    const QImage by_triangles = picture();
    (void)picture();
    const QImage by_pixels = picture();
    int unlike = 0;
    for (int y = 0; y < 400; ++y) {
      for (int x = 0; x < 640; ++x) {
        unlike +=
            std::abs(qGray(by_pixels.pixel(x, y)) - qGray(by_triangles.pixel(x, y))) > 2 ? 1 : 0;
      }
    }
    QVERIFY2(unlike < 640 * 400 / 1000, qPrintable(QString::number(unlike)));
  }

  void aLuminaireAboveTheCutIsDraggedInThePlan() {
    v_->view->setViewCamera(flat(StandardView::plan));
    const dvec3 before = v_->first().position;
    QVERIFY(before.z > kPlanCut);
    QCOMPARE(v_->view->pointAt(QPointF(v_->pixelOf(before))).luminaire, v_->first().name);
    v_->input->snapRules() = {false, false, false, 0.1};
    v_->drag(v_->pixelOf(before), v_->pixelOf(before + dvec3(0.3, 0.2, 0.0)));
    const dvec3 after = v_->first().position;
    const double pixel = v_->view->viewCamera().pixelSize(1.0, kSize);
    QVERIFY(glm::length(after - before - dvec3(0.3, 0.2, 0.0)) < 4.0 * pixel);
    QCOMPARE(v_->document->undoStack()->count(), 1);
  }

  void inAnElevationALuminaireMovesAlongTheWall() {
    v_->view->setViewCamera(flat(StandardView::front));
    const dvec3 before = v_->first().position;
    QCOMPARE(freePart(v_->view->viewCamera()), GizmoPart::zx);
    // Seen edge on, and found nonetheless.
    QCOMPARE(v_->view->pointAt(QPointF(v_->pixelOf(before))).luminaire, v_->first().name);
    v_->input->snapRules() = {false, false, false, 0.1};
    v_->drag(v_->pixelOf(before), v_->pixelOf(before + dvec3(0.4, 0.0, -0.5)));
    const dvec3 after = v_->first().position;
    const double pixel = v_->view->viewCamera().pixelSize(1.0, kSize);
    QVERIFY(glm::length(after - before - dvec3(0.4, 0.0, -0.5)) < 4.0 * pixel);
    QCOMPARE(after.y, before.y);
  }

  void arrowsAlongTheViewAreNotThere() {
    v_->view->setViewCamera(flat(StandardView::plan));
    const ViewCamera& camera = v_->view->viewCamera();
    QVERIFY(Gizmo::isEdgeOn(GizmoPart::z, v_->first().position, camera));
    QVERIFY(Gizmo::isEdgeOn(GizmoPart::yz, v_->first().position, camera));
    QVERIFY(!Gizmo::isEdgeOn(GizmoPart::x, v_->first().position, camera));
    QVERIFY(!Gizmo::isEdgeOn(GizmoPart::xy, v_->first().position, camera));
  }

  void aSectionTakesAwayTheLuminairesBeforeItAndAPlanThoseOfOtherStoreys() {
    const EmitterSet set(v_->document->luminaires(), dvec3(0.0));
    ViewCamera section = flat(StandardView::section_front);
    section.setCutPlace(v_->first().position.y + 0.5);
    Surroundings nothing;
    QVERIFY(cutAway(set, section, nothing).front());
    section.setCutPlace(v_->first().position.y - 0.5);
    QVERIFY(!cutAway(set, section, nothing).front());
    // A floor between the luminaire and the cut.
    const std::vector<vec3> corners{{-50, -50, 2}, {50, -50, 2}, {0, 50, 2}};
    const std::vector<uvec3> triangles{{0, 1, 2}};
    const geometry::RayCaster caster(corners, triangles);
    Surroundings floor;
    floor.caster = &caster;
    ViewCamera plan = flat(StandardView::plan);
    QVERIFY(!cutAway(set, plan, nothing).front());
    plan.setCutPlace(1.0);
    QVERIFY(cutAway(set, plan, floor).front() == (v_->first().position.z > 2.05));
  }

  void dragsAndWheelStayInThePlane() {
    const ViewCamera before = flat(StandardView::plan);
    v_->view->setViewCamera(before);
    v_->drag({600, 380}, {560, 350});
    const ViewCamera panned = v_->view->viewCamera();
    QCOMPARE(panned.forward, before.forward);
    QVERIFY(glm::length(panned.position - before.position) > 0.01);
    QVERIFY(std::abs(panned.position.z - before.position.z) < kRoundoff);
    wheel(Qt::ControlModifier);
    QVERIFY(std::abs(v_->view->viewCamera().cutPlace() - (kPlanCut + 0.1)) < 1e-6);
    QCOMPARE(v_->view->viewCamera().parallel_height, panned.parallel_height);
    wheel({});
    QVERIFY(v_->view->viewCamera().parallel_height < panned.parallel_height);
  }

  void theWayBackLeadsThroughTheViews() {
    const ViewCamera first = v_->view->viewCamera();
    const ViewCamera plan = flat(StandardView::plan);
    QTest::qWait(500);
    v_->view->setViewCamera(plan);
    QTest::qWait(500);
    v_->input->camera().back();
    QCOMPARE(v_->view->viewCamera(), first);
    v_->input->camera().forward();
    QCOMPARE(v_->view->viewCamera(), plan);
    QCOMPARE(v_->document->undoStack()->count(), 0);
  }

  void aNarrowerWidgetGoesOnShowingAllThatItShowed() {
    SceneView& view = *v_->view;
    const auto resize = [&](int width, int height) {
      view.resize(width, height);
      (void)QTest::qWaitFor([&] { return view.viewSize() == dvec2(width, height); });
      QTest::qWait(50);
      return view.viewCamera().parallel_height;
    };
    view.setViewCamera(flat(StandardView::plan));
    const double height = view.viewCamera().parallel_height;
    QVERIFY(std::abs(resize(320, 400) - 2.0 * height) < kRoundoff);
    // What was seen comes back, and no more is lost on the way.
    QVERIFY(std::abs(resize(500, 400) - 1.28 * height) < kRoundoff);
    QVERIFY(std::abs(resize(640, 400) - height) < kRoundoff);
    QVERIFY(std::abs(resize(900, 400) - height) < kRoundoff);
    // After a zoom there is another extent to keep.
    ViewCamera closer = view.viewCamera();
    closer.parallel_height = 0.5 * height;
    view.setViewCamera(closer);
    QVERIFY(std::abs(resize(450, 400) - height) < kRoundoff);
  }

 private:
  [[nodiscard]] QImage picture() const {
    Shot shot;
    shot.pixels = {640, 400};
    shot.samples = 1;
    return v_->view->take(shot).image;
  }
  [[nodiscard]] ViewCamera flat(StandardView view) const {
    return standardCamera(view, v_->view->bounds(), v_->view->origin(), 0.0, kSize.x / kSize.y);
  }
  void wheel(Qt::KeyboardModifiers keys) const {
    const QPointF at(300, 200);
    QWheelEvent event(at, v_->view->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(v_->view.get(), &event);
  }
  static double meanOf(const QImage& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
    }
    return sum / std::max(1, image.width() * image.height());
  }

  std::unique_ptr<Lit> lit_;
  std::unique_ptr<CornellView> v_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::wantOpenGl();
  QApplication application(argc, argv);
  soffit::ui::FlatViewsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "flat_views_test.moc"
