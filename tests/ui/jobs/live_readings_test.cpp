// SPDX-License-Identifier: MIT
#include "ui/jobs/live_readings.h"

#include "core/design/compare_table.h"
#include "core/relight/engine.h"
#include "core/scene/edits.h"
#include "ui/jobs/background.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>

namespace soffit::ui {

constexpr int kPatienceMs = 120000;

io::Project smallCornell() {
  auto project = io::loadProject(SOFFIT_SOURCE_DIR "/projects/cornell");
  project->scene.quality.settings = {{"texels", 1500},   {"trainings", 8}, {"field_rays", 8},
                                     {"list_rays", 16},  {"node_rays", 4}, {"max_rank", 8},
                                     {"sensor_rays", 16}};
  light::Luminaire second = project->scene.luminaires.front();
  second.name = "Second";
  second.position += dvec3(0.6, 0.5, -0.2);
  project->scene.luminaires.push_back(second);
  return std::move(*project);
}

class LiveReadingsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<Document>(smallCornell());
    relighting_ = std::make_unique<Relighting>(*document_, false);
    readings_ = std::make_unique<LiveReadings>(*document_, *relighting_);
  }
  void cleanup() {
    readings_.reset();
    relighting_.reset();
    document_.reset();
  }

  void theyAreTheFiguresThatCompareWrites() {
    waitForReadings();
    expectFiguresOfCompare();
    document_->editLuminaires(QStringLiteral("x"), {QStringLiteral("Second")},
                              [](light::Luminaire& l) {
                                l.dimming = 0.3;
                                l.position.x -= 0.4;
                              });
    waitForReadings();
    expectFiguresOfCompare();
  }

  void theyFollowADragAndEndWithIt() {
    waitForReadings();
    const double before = shown().planes.front().lux.mean;
    const QStringList names{QStringLiteral("Second")};
    document_->setSelection(names);
    QSignalSpy changed(readings_.get(), &LiveReadings::changed);
    for (int i = 0; i < 400 && changed.size() < 3; ++i) {
      document_->preview(names, [i](light::Luminaire& l) { l.position.z -= 0.001 * i; });
      QTest::qWait(10);
    }
    QVERIFY(changed.size() >= 3);
    QVERIFY(shown().planes.front().lux.mean != before);
    document_->commitPreview(QStringLiteral("Move"));
    waitForReadings();
    expectFiguresOfCompare();
  }

  void aWorkPlaneThatMovesIsReadAnew() {
    waitForReadings();
    const double before = shown().planes.front().lux.mean;
    scene::Scene next = *document_->scene();
    next.work_planes.front().origin.z += 0.5;
    document_->edit(QStringLiteral("x"), std::move(next));
    waitForReadings();
    QVERIFY(shown().planes.front().lux.mean != before);
    expectFiguresOfCompare();
  }

  void layoutsComeAndGo() {
    waitForReadings();
    const std::size_t count = readings_->readings()->layouts.size();
    auto next = scene::withLayout(*document_->scene(), "One more", "");
    document_->edit(QStringLiteral("x"), std::move(*next));
    waitForReadings();
    QCOMPARE(readings_->readings()->layouts.size(), count + 1);
    document_->undoStack()->undo();
    waitForReadings();
    QCOMPARE(readings_->readings()->layouts.size(), count);
  }

  void theyCanGoWhileTheyWork() { readings_.reset(); }

  void backgroundWorkEndsInThisThread() {
    Background background;
    QThread* worked = nullptr;
    QThread* ended = nullptr;
    background.run([&]() -> Background::End {
      worked = QThread::currentThread();
      return [&ended] { ended = QThread::currentThread(); };
    });
    QVERIFY(background.isBusy());
    QTRY_VERIFY(!background.isBusy());
    QCOMPARE(ended, QThread::currentThread());
    QVERIFY(worked != ended);
  }

 private:
  [[nodiscard]] const design::LayoutFigures& shown() const {
    const Readings& readings = *readings_->readings();
    for (const LayoutReading& reading : readings.layouts) {
      if (reading.layout == readings.shown) return reading.figures;
    }
    return readings.layouts.front().figures;
  }
  void waitForReadings() {
    QTRY_VERIFY_WITH_TIMEOUT(
        relighting_->isCurrent() && readings_->isCurrent() && !readings_->readings()->coarse,
        kPatienceMs);
  }
  void expectFiguresOfCompare() {
    std::vector<design::LayoutCase> layouts;
    for (const scene::Layout& layout : document_->scene()->layouts) {
      layouts.push_back({layout.name, scene::resolveLayout(*document_->scene(), layout)});
    }
    const auto rays = relight::qualitySettings(document_->scene()->quality)->sensor_rays;
    const auto expected = design::compareLayouts(
        relighting_->frame()->solver, document_->scene()->work_planes, layouts, rays, 1, {});
    QVERIFY(expected.ok());
    const auto& found = readings_->readings()->layouts;
    QCOMPARE(found.size(), expected->size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const design::LayoutFigures& a = found[i].figures;
      const design::LayoutFigures& b = (*expected)[i];
      QCOMPARE(a.name, b.name);
      QCOMPARE(a.emitted_lm, b.emitted_lm);
      QCOMPARE(a.planes.size(), b.planes.size());
      for (std::size_t p = 0; p < a.planes.size(); ++p) {
        // Sums in another order, in single precision.
        constexpr double kRoundoff = 1e-4;
        QVERIFY(std::abs(a.planes[p].lux.mean - b.planes[p].lux.mean) <
                kRoundoff * b.planes[p].lux.mean);
        QVERIFY(std::abs(a.planes[p].lux.min - b.planes[p].lux.min) <
                kRoundoff * b.planes[p].lux.mean);
        QVERIFY(std::abs(a.planes[p].lux.u0 - b.planes[p].lux.u0) < kRoundoff);
      }
    }
  }

  std::unique_ptr<Document> document_;
  std::unique_ptr<Relighting> relighting_;
  std::unique_ptr<LiveReadings> readings_;
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::LiveReadingsTest)
#include "live_readings_test.moc"
