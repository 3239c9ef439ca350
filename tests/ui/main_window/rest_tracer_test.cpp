// SPDX-License-Identifier: MIT
#include "ui/main_window/rest_tracer.h"

#include "core/color/luminance.h"
#include "tests/ui/main_window/window_fixture.h"

#include <QSignalSpy>

#include <cmath>

namespace soffit::ui {

class RestTracerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    fixture_ = std::make_unique<WindowFixture>();
    QVERIFY(fixture_->open());
  }
  void cleanupTestCase() { fixture_.reset(); }
  void cleanup() { tracer().setWanted(false); }

  void nothingIsTracedUnasked() {
    QVERIFY(!RestTracer::isWanted());
    QTest::qWait(1200);
    QVERIFY(!tracer().isBusy());
    QVERIFY(!fixture_->view().showsTraced());
  }

  void theViewIsTracedOnceItRests() {
    SceneView& view = fixture_->view();
    const std::vector<vec3> drawn = view.readLinear();
    QVERIFY(wait());
    QVERIFY(view.showsTraced());
    QVERIFY(painted());
    const std::vector<vec3> traced = view.readLinear();
    QCOMPARE(traced.size(), drawn.size());
    QVERIFY(traced != drawn);
    // The same room in the same light.
    QVERIFY2(std::abs(meanOf(traced) / meanOf(drawn) - 1.0) < 0.03,
             qPrintable(QString::number(meanOf(traced) / meanOf(drawn))));
  }

  void exposureNeedsNoOtherTrace() {
    QVERIFY(wait());
    QVERIFY(painted());
    SceneView& view = fixture_->view();
    const std::vector<vec3> before = view.readLinear();
    fixture_->window->workspace().view->stepExposure(0.5);
    QVERIFY(fixture_->lit());
    QVERIFY(view.showsTraced());
    QVERIFY(painted());
    QVERIFY(view.readLinear() == before);
    fixture_->document().undoStack()->undo();
    QVERIFY(fixture_->lit());
  }

  void anotherPlaceAndOtherLightBringTheLivePictureBack() {
    QVERIFY(wait());
    SceneView& view = fixture_->view();
    ViewCamera camera = view.viewCamera();
    const ViewCamera before = camera;
    camera.position.x += 0.01;
    view.setViewCamera(camera);
    QVERIFY(!view.showsTraced());
    view.setViewCamera(before);
    QVERIFY(view.showsTraced());  // the old place again
    fixture_->switchFirst();
    QVERIFY(fixture_->lit());
    QVERIFY(!view.showsTraced());
    // And is traced again when it rests.
    QTRY_VERIFY_WITH_TIMEOUT(view.showsTraced(), kPatienceMs);
    fixture_->document().undoStack()->undo();
    QVERIFY(fixture_->lit());
  }

  void numbersAreShownLive() {
    QVERIFY(wait());
    SceneView& view = fixture_->view();
    fixture_->window->workspace().view->setFalseColor(true);
    QVERIFY(!view.showsTraced());
    fixture_->window->workspace().view->setFalseColor(false);
    QVERIFY(view.showsTraced());
  }

  void itIsGoneWhenItIsNoLongerWanted() {
    QVERIFY(wait());
    tracer().setWanted(false);
    QVERIFY(!fixture_->view().showsTraced());
    QVERIFY(!RestTracer::isWanted());
  }

 private:
  RestTracer& tracer() { return fixture_->window->session()->tracer(); }
  bool wait() {
    QSignalSpy shown(&tracer(), &RestTracer::shown);
    tracer().setWanted(true);
    return QTest::qWaitFor([&] { return !shown.isEmpty(); }, kPatienceMs);
  }
  bool painted() {
    SceneView& view = fixture_->view();
    const int frames = view.frameCount();
    view.update();
    return QTest::qWaitFor([&] { return view.frameCount() > frames; }, kPatienceMs);
  }
  static double meanOf(const std::vector<vec3>& picture) {
    double sum = 0.0;
    for (const vec3& v : picture) {
      sum += std::min(static_cast<double>(color::luminance(v)), 500.0);  // luminaires aside
    }
    return sum / static_cast<double>(picture.size());
  }

  std::unique_ptr<WindowFixture> fixture_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::prepareProgram();
  QApplication application(argc, argv);
  soffit::ui::nameProgram(QStringLiteral("soffit-tracer-test"));
  soffit::ui::RestTracerTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "rest_tracer_test.moc"
