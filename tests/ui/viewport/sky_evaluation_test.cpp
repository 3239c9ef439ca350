// SPDX-License-Identifier: MIT
#include "ui/viewport/sky_evaluation.h"

#include "tests/ui/viewport/cornell_view.h"
#include "tests/ui/window_scene.h"
#include "ui/viewport/picture_pass.h"

#include <QTest>

#include <algorithm>

namespace soffit::ui {

constexpr int kWide = 480;
constexpr int kHigh = 360;

/// Light of a sky in hand, added up by shaders, against the light that the processor mixes at the
/// texels: as pictures.
class SkyEvaluationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    project_ = windowProject();
    // Reflections that colour what they send on, or all channels would be alike.
    project_.scene.materials[0].diffuse = dvec3(0.7, 0.5, 0.3);
    relight::EngineReport report;
    const auto quality = relight::qualitySettings(project_.scene.quality);
    const auto solver = relight::makeSolver(project_.scene, *quality, false, {}, report);
    QVERIFY(solver.ok());
    solver_ = *solver;
  }
  void init() {
    lighting_ = std::make_unique<relight::Lighting>(solver_);
    QVERIFY(lighting_->setLuminaires(project_.scene.luminaires).ok());
    view_ = std::make_unique<SceneView>();
    view_->resize(kWide, kHigh);
    view_->setScene(std::make_shared<const scene::Scene>(project_.scene));
    view_->setViewCamera(ViewCamera::from(project_.scene.cameras.front()));
    QVERIFY(view_->setLook({}).ok());
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get(), kExposedMs));
    QSignalSpy shown(view_.get(), &SceneView::lightShown);
    view_->setFrame(dark());
    QTRY_VERIFY_WITH_TIMEOUT(!shown.isEmpty(), 20000);
    // Each sky has transfer vectors of its own lighting.
    held_.forget();
  }
  void cleanup() {
    view_.reset();
    lighting_.reset();
  }

  void shadersAndProcessorShowTheSame_data() {
    QTest::addColumn<int>("cie");
    QTest::addColumn<double>("sun");
    QTest::addColumn<double>("ground");
    QTest::newRow("overcast") << 1 << 0.0 << 0.2;
    QTest::newRow("uniform") << 5 << 0.0 << 0.0;
    QTest::newRow("cloudy") << 9 << 0.0 << 0.6;
    QTest::newRow("clear") << 12 << 0.0 << 0.2;
    QTest::newRow("sunny") << 12 << 60000.0 << 0.2;
    QTest::newRow("hazy") << 15 << 20000.0 << 0.9;
  }
  void shadersAndProcessorShowTheSame() {
    QFETCH(int, cie);
    QFETCH(double, sun);
    QFETCH(double, ground);
    for (const double azimuth : {20.0, 95.0, 165.0, 180.0, 200.0, 290.0}) {
      compare({"", scene::Sky{.cie = cie,
                              .sun_azimuth_deg = azimuth,
                              .sun_altitude_deg = 35.0,
                              .horizontal_illuminance = 12000.0,
                              .direct_normal_illuminance = sun,
                              .ground_reflectance = ground}});
    }
    QCOMPARE(view_->skyFigures().where, SkyEvaluation::Figures::Where::gpu);
    QVERIFY(view_->skyFigures().bytes > 192 * solver_->operators().texels.slotCount());
    QVERIFY(view_->skyFigures().milliseconds > 0.0);
  }

  void picturesAllRoundAreFollowedInColour() {
    auto image = std::make_shared<scene::Image>();
    image->width = 64;
    image->height = 32;
    for (int row = 0; row < 32; ++row) {
      for (int column = 0; column < 64; ++column) {
        const float wave = 1.0F + 0.8F * std::sin(0.1F * static_cast<float>(column));
        const float above = row < 16 ? 1.0F : 0.3F;
        image->pixels.insert(image->pixels.end(), {above * wave, above, above * (2.0F - wave)});
      }
    }
    for (const double turn : {0.0, 70.0, 200.0}) {
      compare({"", scene::Probe{"", scene::ProbeLayout::lat_long, turn, 3000.0, image}});
    }
    QCOMPARE(view_->skyFigures().where, SkyEvaluation::Figures::Where::gpu);
  }

  void whereBuffersAreTooSmallTheProcessorAddsUp() {
    view_->pass().building.skyEvaluation().setMost(1000);
    for (const double azimuth : {165.0, 290.0}) {
      compare(withSunAt(*project_.scene.environment, azimuth));
      QCOMPARE(view_->skyFigures().where, SkyEvaluation::Figures::Where::refused);
      QCOMPARE(view_->skyFigures().bytes, std::size_t{0});
    }
  }

  void atRestNothingStays() {
    compare(*project_.scene.environment);
    QCOMPARE(view_->skyFigures().where, SkyEvaluation::Figures::Where::gpu);
    (void)pictureOf(wholeFrame(*project_.scene.environment));
    QCOMPARE(view_->skyFigures().where, SkyEvaluation::Figures::Where::nowhere);
    QCOMPARE(view_->skyFigures().bytes, std::size_t{0});
  }

  void aSecondViewTakesItOver() {
    const LightFramePtr held = heldFrame(*project_.scene.environment);
    const QImage first = pictureOf(held);
    SceneView second;
    second.resize(kWide, kHigh);
    second.setScene(std::make_shared<const scene::Scene>(project_.scene));
    second.setViewCamera(ViewCamera::from(project_.scene.cameras.front()));
    QVERIFY(second.setLook({}).ok());
    second.show();
    QVERIFY(QTest::qWaitForWindowExposed(&second, kExposedMs));
    second.shareMesh(*view_);
    second.setFrameOf(*view_);
    const QImage other = second.picture({kWide, kHigh}, false, 1);
    QCOMPARE(second.skyFigures().where, SkyEvaluation::Figures::Where::gpu);
    QCOMPARE(mostDifference(first, other), 0);
  }

 private:
  LightFramePtr dark() {
    auto frame = std::make_shared<LightFrame>();
    frame->solver = solver_;
    for (auto& plane : frame->lux) plane.assign(solver_->operators().texels.slotCount(), 0.0F);
    return frame;
  }
  LightFramePtr wholeFrame(const scene::Environment& environment) {
    auto frame = std::make_shared<LightFrame>();
    frame->solver = solver_;
    frame->lux = *lighting_->totalUnderSky(daylight::Environment(environment));
    frame->complete = false;
    return frame;
  }
  LightFramePtr heldFrame(const scene::Environment& environment) {
    const auto parts = lighting_->partsUnderSky(daylight::Environment(environment));
    if (!parts) return nullptr;
    held_.prepare(*parts, solver_->operators(), {});
    auto frame = std::make_shared<LightFrame>(*dark());
    frame->held = held_.step(*parts);
    frame->complete = false;
    frame->lux_late = true;
    return frame;
  }
  /// From triangles first, then, in a view that rests, from what is known of it.
  QImage pictureOf(const LightFramePtr& frame, bool seen = false) {
    view_->setFrame(frame);
    if (!seen) {
      ViewCamera turned = view_->viewCamera();
      const ViewCamera camera = turned;
      turned.position.x += 0.01;
      view_->setViewCamera(turned);
      (void)view_->picture({kWide, kHigh}, false, 1);
      view_->setViewCamera(camera);
    }
    return view_->picture({kWide, kHigh}, false, 1);
  }
  static int mostDifference(const QImage& a, const QImage& b) {
    int most = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < 3 * a.width(); ++x) {
        most = std::max(most, std::abs(a.constScanLine(y)[x] - b.constScanLine(y)[x]));
      }
    }
    return most;
  }
  static double meanCode(const QImage& picture) {
    double sum = 0.0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < 3 * picture.width(); ++x) sum += picture.constScanLine(y)[x];
    }
    return sum / (3.0 * picture.width() * picture.height());
  }
  void compare(const scene::Environment& environment) {
    scene::Scene scene = project_.scene;
    scene.environment = environment;
    view_->setScene(std::make_shared<const scene::Scene>(scene));
    const LightFramePtr whole = wholeFrame(environment);
    const LightFramePtr held = heldFrame(environment);
    QVERIFY(held != nullptr);
    QVERIFY(view_->setLook(lookFor(*whole)).ok());
    for (const bool seen : {false, true}) {
      const QImage wanted = pictureOf(whole, seen);
      // Light that stayed from before would be none.
      const QImage black = pictureOf(dark(), true);
      QVERIFY(meanCode(black) < 0.8 * meanCode(wanted));
      const QImage found = pictureOf(held, seen);
      QCOMPARE(found.size(), QSize(kWide, kHigh));
      const double grey = meanCode(wanted);
      QVERIFY2(grey > 60.0 && grey < 200.0, qPrintable(QString::number(grey)));
      const int most = mostDifference(wanted, found);
      QVERIFY2(most <= 1, qPrintable(QString::number(most)));
    }
  }
  /// Neither black nor white: the mean surface becomes a middle grey.
  static Look lookFor(const LightFrame& frame) {
    double sum = 0.0;
    for (const float lux : frame.lux[1]) sum += static_cast<double>(lux);
    const double mean = sum / static_cast<double>(frame.lux[1].size());
    Look look;
    look.display.view = "sRGB";
    look.exposure_ev = std::log2(100.0 / mean);
    return look;
  }

  io::Project project_;
  std::shared_ptr<const relight::Solver> solver_;
  std::unique_ptr<relight::Lighting> lighting_;
  HeldSkies held_;
  std::unique_ptr<SceneView> view_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::wantOpenGl();
  QApplication application(argc, argv);
  soffit::ui::SkyEvaluationTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "sky_evaluation_test.moc"
