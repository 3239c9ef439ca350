// SPDX-License-Identifier: MIT
#include "ui/jobs/relighting.h"

#include "core/relight/engine.h"

#include <QSignalSpy>
#include <QTest>

namespace soffit::ui {

constexpr int kPatienceMs = 120000;

io::Project smallCornell() {
  auto project = io::loadProject(SOFFIT_SOURCE_DIR "/projects/cornell");
  project->scene.quality.settings = {{"texels", 1500},  {"trainings", 8}, {"field_rays", 8},
                                     {"list_rays", 16}, {"node_rays", 4}, {"max_rank", 8}};
  light::Luminaire second = project->scene.luminaires.front();
  second.name = "Second";
  second.position += dvec3(0.6, 0.5, -0.2);
  project->scene.luminaires.push_back(second);
  return std::move(*project);
}

/// The same light without worker, threads or memory.
relight::Planes plainLight(const std::shared_ptr<const relight::Solver>& solver,
                           const std::vector<light::Luminaire>& luminaires) {
  relight::Lighting lighting(solver);
  (void)lighting.setLuminaires(luminaires);
  return lighting.total();
}

/// Sums in another order differ by rounding: a few hundred single-precision additions.
bool sameLight(const relight::Planes& a, const relight::Planes& b) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (a[c].size() != b[c].size()) return false;
    for (std::size_t s = 0; s < a[c].size(); ++s) {
      if (std::abs(a[c][s] - b[c][s]) > 1e-4F * std::max(1.0F, std::abs(b[c][s]))) return false;
    }
  }
  return true;
}

class RelightingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<Document>(smallCornell());
    document_->setLayout({});
    relighting_ = std::make_unique<Relighting>(*document_, false);
  }
  void cleanup() {
    relighting_.reset();
    document_.reset();
  }

  void theLightOfTheSceneArrivesPreviewFirst() {
    QSignalSpy finished(&relighting_->worker(), &RelightWorker::bakeFinished);
    QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty(), kPatienceMs);
    waitForLight();
    QVERIFY(sameLight(relighting_->frame()->lux,
                      plainLight(relighting_->frame()->solver, document_->luminaires())));
  }

  void aDragOf200StepsEndsInTheLightOfItsLastPlace() {
    waitForLight();
    const QStringList names{QStringLiteral("Second")};
    document_->setSelection(names);
    for (int i = 0; i < 200; ++i) {
      document_->preview(names, [i](light::Luminaire& l) { l.position.x -= 0.004 * i; });
      if (i % 10 == 0) QTest::qWait(5);
    }
    waitForLight();
    QVERIFY(sameLight(relighting_->frame()->lux,
                      plainLight(relighting_->frame()->solver, document_->luminaires())));
    document_->commitPreview(QStringLiteral("Move"));
    waitForLight();
    QVERIFY(sameLight(relighting_->frame()->lux,
                      plainLight(relighting_->frame()->solver, document_->luminaires())));
    QCOMPARE(document_->undoStack()->count(), 1);
  }

  void dimmingColourAndSwitchAreRemixed() {
    waitForLight();
    document_->editLuminaires(QStringLiteral("x"), {QStringLiteral("Second")},
                              [](light::Luminaire& l) {
                                l.dimming = 0.3;
                                l.colour.cct_k = 2700.0;
                              });
    waitForLight();
    QVERIFY(sameLight(relighting_->frame()->lux,
                      plainLight(relighting_->frame()->solver, document_->luminaires())));
    document_->editLuminaires(QStringLiteral("x"), {QStringLiteral("Second")},
                              [](light::Luminaire& l) { l.on = false; });
    waitForLight();
    QVERIFY(sameLight(relighting_->frame()->lux,
                      plainLight(relighting_->frame()->solver, document_->luminaires())));
  }

  void paintNeedsNoBake() {
    waitForLight();
    QSignalSpy finished(&relighting_->worker(), &RelightWorker::bakeFinished);
    const double before = sum(relighting_->frame()->lux);
    scene::Scene next = *document_->scene();
    for (scene::Material& material : next.materials) material.diffuse *= 0.5;
    document_->edit(QStringLiteral("Paint"), std::move(next));
    waitForLight();
    QVERIFY(sum(relighting_->frame()->lux) < 0.95 * before);
    QVERIFY(finished.isEmpty());
  }

  void layoutsAreKeptApart() {
    waitForLight();
    const double base = sum(relighting_->frame()->lux);
    auto next = scene::withLayout(*document_->scene(), "Dark", "");
    document_->edit(QStringLiteral("x"), std::move(*next));
    document_->setLayout(QStringLiteral("Dark"));
    document_->editLuminaires(QStringLiteral("x"), {QStringLiteral("Second")},
                              [](light::Luminaire& l) { l.on = false; });
    waitForLight();
    QVERIFY(sum(relighting_->frame()->lux) < base);
    document_->setLayout({});
    waitForLight();
    QVERIFY(std::abs(sum(relighting_->frame()->lux) - base) < 1e-5 * base);
  }

  void cancellingLeavesNoCrashAndNoHang() {
    relighting_->worker().cancelBake();
    QSignalSpy finished(&relighting_->worker(), &RelightWorker::bakeFinished);
    QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty() || relighting_->frame() != nullptr, kPatienceMs);
  }

  void aWorkerCanGoWhileItWorks() { relighting_.reset(); }

  void theCursorReadsTheSurfaceInFront() {
    waitForLight();
    const auto& frame = *relighting_->frame();
    const dvec3 lamp = document_->luminaires().front().position - document_->scene()->mesh->origin;
    geometry::Ray down;
    down.origin = vec3(lamp - dvec3(0.0, 0.0, 0.05));
    down.direction = vec3(0.0F, 0.0F, -1.0F);
    const auto reading = readSurface(frame, *document_->scene(), down);
    QVERIFY(reading.has_value());
    QVERIFY(reading->lux > 10.0);
    QVERIFY(reading->normal.z > 0.9F);
    QVERIFY(reading->luminance > 0.0 && reading->luminance < reading->lux);
  }

 private:
  static double sum(const relight::Planes& lux) {
    double total = 0.0;
    for (const auto& plane : lux) {
      for (const float e : plane) total += static_cast<double>(e);
    }
    return total;
  }
  void waitForLight() {
    QTRY_VERIFY_WITH_TIMEOUT(relighting_->isCurrent() && relighting_->frame()->solver != nullptr &&
                                 !relighting_->frame()->solver->operators().coarse,
                             kPatienceMs);
  }

  std::unique_ptr<Document> document_;
  std::unique_ptr<Relighting> relighting_;
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::RelightingTest)
#include "relighting_test.moc"

#include <algorithm>
