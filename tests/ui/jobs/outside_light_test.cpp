// SPDX-License-Identifier: MIT
#include "core/color/luminance.h"
#include "core/relight/engine.h"
#include "tests/ui/window_scene.h"
#include "ui/document/environment_edits.h"
#include "ui/jobs/live_readings.h"
#include "ui/jobs/other_lights.h"
#include "ui/jobs/verification.h"

#include <QSignalSpy>
#include <QTest>

namespace soffit::ui {

constexpr int kPatienceMs = 120000;

/// Light from outside in everything that the window shows.
class OutsideLightTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<Document>(windowProject());
    relighting_ = std::make_unique<Relighting>(*document_, false);
    readings_ = std::make_unique<LiveReadings>(*document_, *relighting_);
    QSignalSpy finished(&relighting_->worker(), &RelightWorker::bakeFinished);
    QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty(), kPatienceMs);
    waitForLight();
  }
  void cleanup() {
    readings_.reset();
    relighting_.reset();
    document_.reset();
  }

  void theSkyShinesInAsOnTheCommandLine() {
    QVERIFY(worstOf(plainLight()) < 1e-4);
    QVERIFY(relighting_->frame()->outside != nullptr);
    // The table: `soffit measure` reads the same way.
    QTRY_VERIFY_WITH_TIMEOUT(readings_->isCurrent(), kPatienceMs);
    const auto& scene = *document_->scene();
    const relight::Sensors sensors(
        *relighting_->frame()->solver, design::sensorsOfAll(scene.work_planes),
        relight::Quantity::planar, relight::qualitySettings(scene.quality)->sensor_rays, 1);
    relight::Lighting lighting(relighting_->frame()->solver);
    QVERIFY(lighting.setLuminaires(document_->luminaires()).ok());
    QVERIFY(lighting.setEnvironment(environment()).ok());
    const auto wanted = lighting.read(sensors);
    const auto& points = readings_->readings()->layouts.front().points;
    QCOMPARE(points.size(), wanted.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double lux = color::luminance(wanted[i].direct + wanted[i].indirect);
      QVERIFY(lux > 100.0);
      QVERIFY(std::abs(static_cast<double>(points[i]) - lux) < 1e-4 * lux);
    }
  }

  void aLuminaireIsDraggedInDaylight() {
    const QStringList names{QStringLiteral("Lamp")};
    document_->setSelection(names);
    document_->preview(names, [](light::Luminaire& l) { l.position.x -= 0.5; });
    waitForLight();
    QVERIFY(relighting_->frame()->times.total() > 0.0);
    QVERIFY(worstOf(plainLight()) < 1e-4);
    document_->commitPreview(QStringLiteral("Move"));
    waitForLight();
    QVERIFY(worstOf(plainLight()) < 1e-4);
  }

  void aSunThatIsHeldIsFollowedAndExactAtRest() {
    for (const double azimuth : {150.0, 165.0, 180.0}) {
      previewEnvironment(*document_, withSunAt(*document_->scene()->environment, azimuth));
    }
    QTRY_VERIFY_WITH_TIMEOUT(relighting_->frame()->revision == relighting_->revision(),
                             kPatienceMs);
    QVERIFY2(!relighting_->frame()->complete, "the exact light is still to come");
    QVERIFY(!relighting_->isCurrent());
    // Six bands: README.md of relight.
    QVERIFY(rmsOf(plainLight()) < 0.03);
    document_->commitPreview(QStringLiteral("Sun"));
    QCOMPARE(document_->undoStack()->count(), 1);
    waitForLight();
    QVERIFY(worstOf(plainLight()) < 1e-4);
    document_->undoStack()->undo();
    waitForLight();
    QVERIFY(worstOf(plainLight()) < 1e-4);
  }

  void aViewThatAddsItUpGetsTheSunInParts() {
    relighting_->setHeldInParts(true);
    int in_parts = 0;
    connect(relighting_.get(), &Relighting::frameChanged, this, [&] {
      if (relighting_->frame()->lux_late) ++in_parts;
    });
    for (const double azimuth : {150.0, 165.0, 180.0}) {
      previewEnvironment(*document_, withSunAt(*document_->scene()->environment, azimuth));
      QTRY_VERIFY_WITH_TIMEOUT(relighting_->frame()->revision == relighting_->revision(),
                               kPatienceMs);
      QVERIFY(!relighting_->frame()->complete);
    }
    QVERIFY2(in_parts > 0, "the first step is mixed at the texels, the others are not");
    const auto held = relighting_->frame()->held;
    QVERIFY(held != nullptr);
    // The hand pauses: what is read is the light that is shown.
    QTRY_VERIFY_WITH_TIMEOUT(!relighting_->frame()->lux_late, kPatienceMs);
    QCOMPARE(relighting_->frame()->held, held);
    QCOMPARE(relighting_->frame()->revision, relighting_->revision());
    QVERIFY(rmsOf(plainLight()) < 0.03);
    // Halves: 2^-11 of terms whose sizes sum to some times the light.
    QVERIFY(worstOf(relighting_->frame()->lux,
                    held->vectors->evaluate(held->weights, *held->rest)) < 2e-3);
    document_->commitPreview(QStringLiteral("Sun"));
    waitForLight();
    QVERIFY(relighting_->frame()->held == nullptr);
    QVERIFY(worstOf(plainLight()) < 1e-4);
    relighting_->setHeldInParts(false);
    in_parts = 0;
    previewEnvironment(*document_, withSunAt(*document_->scene()->environment, 140.0));
    previewEnvironment(*document_, withSunAt(*document_->scene()->environment, 130.0));
    QTRY_VERIFY_WITH_TIMEOUT(relighting_->frame()->revision == relighting_->revision(),
                             kPatienceMs);
    QCOMPARE(in_parts, 0);
  }

  void withoutSurroundingsItIsNight() {
    editEnvironment(*document_, QStringLiteral("Night"), std::nullopt);
    waitForLight();
    QVERIFY(relighting_->frame()->outside == nullptr);
    QVERIFY(worstOf(plainLight()) < 1e-4);
    QTRY_VERIFY_WITH_TIMEOUT(readings_->isCurrent(), kPatienceMs);
    const float night = readings_->readings()->layouts.front().points.front();
    document_->undoStack()->undo();
    waitForLight();
    QTRY_VERIFY_WITH_TIMEOUT(readings_->isCurrent(), kPatienceMs);
    QVERIFY(readings_->readings()->layouts.front().points.front() > 2.0F * night);
  }

  void aProbeSaysWhatComesFromOutside() {
    document_->editProbes(QStringLiteral("Probe"), {{"Floor", {2.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}});
    waitForLight();
    const auto& shares = relighting_->frame()->shares;
    QCOMPARE(shares.size(), std::size_t{1});
    QCOMPARE(shares[0].size(), std::size_t{2});
    QVERIFY2(shares[0][1] > shares[0][0], "by the window the sky gives more than the lamp");
    const auto reading =
        readProbe(*relighting_->frame(), *document_->scene(), document_->probes().front());
    QVERIFY(reading.has_value());
    // Reflected light below 0 is cut in the sum and not in its parts.
    QVERIFY(std::abs(shares[0][0] + shares[0][1] - reading->lux) < 1e-3 * reading->lux);
  }

  void anotherLayoutHasTheSameSky() {
    scene::Scene next = *document_->scene();
    next.layouts.push_back({"Dark", {}});
    next.layouts.back().edits["Lamp"].on = false;
    document_->edit(QStringLiteral("Layout"), std::move(next));
    OtherLights others(*document_, *relighting_);
    others.setWanted({QStringLiteral("Dark")});
    waitForLight();
    QTRY_VERIFY_WITH_TIMEOUT(others.isCurrent(QStringLiteral("Dark")), kPatienceMs);
    const LightFramePtr dark = others.frame(QStringLiteral("Dark"));
    QCOMPARE(dark->outside, relighting_->frame()->outside);
    relight::Lighting lighting(dark->solver);
    QVERIFY(lighting.setLuminaires({}).ok());
    QVERIFY(lighting.setEnvironment(environment()).ok());
    QVERIFY(worstOf(lighting.total(), dark->lux) < 1e-4);
    editEnvironment(*document_, QStringLiteral("Sun"),
                    withSunAt(*document_->scene()->environment, 120.0));
    waitForLight();
    QTRY_VERIFY_WITH_TIMEOUT(others.isCurrent(QStringLiteral("Dark")), kPatienceMs);
    QVERIFY(lighting.setEnvironment(environment()).ok());
    QVERIFY(worstOf(lighting.total(), others.frame(QStringLiteral("Dark"))->lux) < 1e-4);
  }

  void theReferenceKnowsTheSky() {
    Verification verification(*document_, *relighting_);
    QSignalSpy finished(&verification, &Verification::finished);
    verification.start({.error = 0.05, .time_limit_s = 30.0, .luminaire = {}});
    QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty(), kPatienceMs);
    const auto& planes = verification.result()->report.total.work_planes;
    QVERIFY(planes.has_value());
    // A draft of 1500 texels; without the sky it would be off by most of its light.
    QVERIFY(planes->rms < 0.25);
    QVERIFY(verification.isVerified());
    editEnvironment(*document_, QStringLiteral("Sun"),
                    withSunAt(*document_->scene()->environment, 120.0));
    QVERIFY(!verification.isVerified());
  }

 private:
  std::shared_ptr<const daylight::Environment> environment() const {
    const auto& wanted = document_->scene()->environment;
    return wanted ? std::make_shared<const daylight::Environment>(*wanted) : nullptr;
  }
  /// Without worker, threads or memory.
  relight::Planes plainLight() const {
    relight::Lighting lighting(relighting_->frame()->solver);
    (void)lighting.setLuminaires(document_->luminaires());
    (void)lighting.setEnvironment(environment());
    return lighting.total();
  }
  static double worstOf(const relight::Planes& wanted, const relight::Planes& found) {
    double worst = 0.0;
    double most = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t s = 0; s < wanted[c].size(); ++s) {
        worst = std::max(worst, std::abs(static_cast<double>(wanted[c][s] - found[c][s])));
        most = std::max(most, static_cast<double>(wanted[c][s]));
      }
    }
    return most > 0.0 ? worst / most : 1.0;
  }
  double worstOf(const relight::Planes& wanted) const {
    return worstOf(wanted, relighting_->frame()->lux);
  }
  double rmsOf(const relight::Planes& wanted) const {
    double error = 0.0;
    double mean = 0.0;
    const auto& found = relighting_->frame()->lux;
    for (std::size_t s = 0; s < wanted[1].size(); ++s) {
      error += std::pow(static_cast<double>(wanted[1][s] - found[1][s]), 2.0);
      mean += static_cast<double>(wanted[1][s]);
    }
    const auto n = static_cast<double>(wanted[1].size());
    return std::sqrt(error / n) / (mean / n);
  }
  void waitForLight() {
    QTRY_VERIFY_WITH_TIMEOUT(
        relighting_->isCurrent() && !relighting_->frame()->solver->operators().coarse, kPatienceMs);
  }

  std::unique_ptr<Document> document_;
  std::unique_ptr<Relighting> relighting_;
  std::unique_ptr<LiveReadings> readings_;
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::OutsideLightTest)
#include "outside_light_test.moc"

#include <algorithm>
