// SPDX-License-Identifier: MIT
#include "core/daylight/environment.h"
#include "core/daylight/slab.h"
#include "tests/ui/viewport/cornell_view.h"
#include "tests/ui/window_scene.h"
#include "ui/viewport/still_renderer.h"

#include <QTest>

namespace soffit::ui {

constexpr int kWide = 480;
constexpr int kHigh = 360;

/// What a view shows beyond the building, against the radiance that the engine computes with.
class OutsideViewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    project_ = windowProject();
    relight::EngineReport report;
    const auto quality = relight::qualitySettings(project_.scene.quality);
    const auto solver = relight::makeSolver(project_.scene, *quality, false, {}, report);
    QVERIFY(solver.ok());
    relight::Lighting lighting(*solver);
    QVERIFY(lighting.setLuminaires(project_.scene.luminaires).ok());
    auto frame = std::make_shared<LightFrame>();
    frame->solver = *solver;
    frame->lux = lighting.total();
    frame_ = std::move(frame);
  }
  void init() {
    view_ = std::make_unique<SceneView>();
    view_->resize(kWide, kHigh);
  }
  void cleanup() { view_.reset(); }

  void skiesAreThoseOfTheEngineSeenThroughThePane_data() {
    QTest::addColumn<int>("cie");
    for (const int cie : {1, 5, 12, 14, 16}) QTest::newRow(qPrintable(QString::number(cie))) << cie;
  }
  void skiesAreThoseOfTheEngineSeenThroughThePane() {
    QFETCH(int, cie);
    scene::Sky sky = std::get<scene::Sky>(project_.scene.environment->light);
    sky.cie = cie;
    show({"", sky});
    compare();
  }

  void picturesAndTheAnalyticLightAreTurnedAlike_data() {
    QTest::addColumn<int>("layout");
    QTest::newRow("lat-long") << 0;
    QTest::newRow("angular") << 1;
    QTest::newRow("cross") << 2;
    QTest::newRow("analytic") << 3;
  }
  void picturesAndTheAnalyticLightAreTurnedAlike() {
    QFETCH(int, layout);
    if (layout == 3) {
      scene::PatchLight patches;
      patches.scale = 300.0;
      patches.side_azimuth_rad = -1.5;
      patches.side_threshold = 1.0;
      patches.rotation_deg = 20.0;
      show({"", patches});
    } else {
      const int width = layout == 0 ? 256 : layout == 1 ? 256 : 192;
      const int height = layout == 2 ? 256 : layout == 1 ? 256 : 128;
      show({"", scene::Probe{"", static_cast<scene::ProbeLayout>(layout), 70.0, 500.0,
                             smoothPicture(width, height)}});
    }
    // Resampled at 0.2 degrees, half floats: a hundredth where neighbours are so much alike.
    compare(0.02);
  }

  void anotherSunMovesAtOnceAndStillsShowIt() {
    show(*project_.scene.environment);
    scene::Scene next = project_.scene;
    next.environment = withSunAt(*next.environment, 120.0);
    view_->setScene(std::make_shared<const scene::Scene>(next));
    environment_ = std::make_shared<const daylight::Environment>(*next.environment);
    compare();
    Shot shot;
    shot.pixels = {kWide, kHigh};
    shot.linear = true;
    shot.samples = 1;
    const auto still = view_->still(shot);
    QVERIFY(still.has_value());
    StillRenderer renderer;
    const auto picture = renderer.render(*still, {});
    QVERIFY(picture.ok());
    const Picture own = view_->take(shot);
    QCOMPARE(picture->linear.size(), own.linear.size());
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < own.linear.size(); ++i) {
      const float most = 1e-3F * own.linear[i].y + 1e-3F;
      unlike += std::abs(picture->linear[i].y - own.linear[i].y) > most ? 1 : 0;
    }
    QVERIFY2(unlike < own.linear.size() / 1000, qPrintable(QString::number(unlike)));
  }

  void falseColoursAreDarkGreyOutside() {
    show(*project_.scene.environment);
    Look look;
    look.false_color = true;
    QVERIFY(view_->setLook(look).ok());
    const QImage shown = view_->picture({kWide, kHigh}, false, 1);
    const QColor outside = shown.pixelColor(kWide / 2, kHigh / 2);
    QVERIFY(outside.red() == outside.green() && outside.green() == outside.blue());
    QVERIFY(std::abs(outside.red() - 33) <= 1);  // 0.13
  }

  void flatViewsShowNoSky() {
    show(*project_.scene.environment);
    ViewCamera flat = view_->viewCamera();
    flat.parallel_height = 4.0;
    flat.position = {2.0, 30.0, 10.0};
    Shot shot;
    shot.pixels = {kWide, kHigh};
    shot.linear = true;
    shot.samples = 1;
    shot.camera = flat;
    const Picture picture = view_->take(shot);
    QCOMPARE(picture.linear.size(), std::size_t{kWide * kHigh});
    // The lamp has 1770 cd/m^2, the sky more.
    for (const vec3& pixel : picture.linear) QVERIFY(pixel.y < 1800.0F);
  }

 private:
  static std::shared_ptr<const scene::Image> smoothPicture(int width, int height) {
    auto image = std::make_shared<scene::Image>();
    image->width = width;
    image->height = height;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const float u = static_cast<float>(x) / static_cast<float>(width);
        const float v = static_cast<float>(y) / static_cast<float>(height);
        image->pixels.insert(image->pixels.end(),
                             {1.0F + std::sin(6.2832F * u) * 0.5F, 1.0F + v, 2.0F - v});
      }
    }
    return image;
  }

  void show(const scene::Environment& environment) {
    scene::Scene scene = project_.scene;
    scene.environment = environment;
    environment_ = std::make_shared<const daylight::Environment>(environment);
    view_->setScene(std::make_shared<const scene::Scene>(scene));
    view_->setViewCamera(ViewCamera::from(scene.cameras.front()));
    QVERIFY(view_->setLook({}).ok());
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get(), kExposedMs));
    QSignalSpy shown(view_.get(), &SceneView::lightShown);
    view_->setFrame(frame_);
    QTRY_VERIFY_WITH_TIMEOUT(!shown.isEmpty(), 20000);
  }

  /// Pixels whose rays go through the window against radiance times transmittance.
  void compare(double tolerance = 2e-3) {
    (void)view_->picture({kWide, kHigh}, false, 1);
    const std::vector<vec3> pixels = view_->readLinear();
    QCOMPARE(pixels.size(), std::size_t{kWide * kHigh});
    const ViewCamera& camera = view_->viewCamera();
    const daylight::Slab slab(*project_.scene.materials[1].glass);
    int compared = 0;
    for (int y = 2; y < kHigh; y += 7) {
      for (int x = 2; x < kWide; x += 7) {
        const dvec3 d = camera.rayThrough({x + 0.5, y + 0.5}, {kWide, kHigh});
        if (d.y >= 0.0) continue;
        const dvec3 hit = camera.position - camera.position.y / d.y * d;
        const bool through = hit.x > 1.03 && hit.x < 2.97 && hit.z > 1.03 && hit.z < 2.47;
        if (!through || std::abs(d.z) < 0.01) continue;
        // Rows of what was read go upward.
        const vec3& found = pixels[static_cast<std::size_t>((kHigh - 1 - y) * kWide + x)];
        const dvec3 wanted = slab.at(-d.y).transmitted * environment_->radiance(d);
        for (int c = 0; c < 3; ++c) {
          const double most = tolerance * wanted[c] + 1e-3 * environment_->radiance({0, 0, 1}).y;
          QVERIFY2(std::abs(static_cast<double>(found[c]) - wanted[c]) <= most,
                   qPrintable(QStringLiteral("%1 %2: %3 instead of %4")
                                  .arg(x)
                                  .arg(y)
                                  .arg(static_cast<double>(found[c]))
                                  .arg(wanted[c])));
        }
        ++compared;
      }
    }
    QVERIFY(compared > 200);
  }

  io::Project project_;
  LightFramePtr frame_;
  std::shared_ptr<const daylight::Environment> environment_;
  std::unique_ptr<SceneView> view_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::wantOpenGl();
  QApplication application(argc, argv);
  soffit::ui::OutsideViewTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "outside_view_test.moc"
