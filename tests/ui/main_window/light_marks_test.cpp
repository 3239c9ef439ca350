// SPDX-License-Identifier: MIT
#include "ui/main_window/light_marks.h"

#include "tests/ui/main_window/window_fixture.h"
#include "ui/document/text.h"
#include "ui/widgets/units.h"

#include <QComboBox>
#include <QLabel>
#include <QStatusBar>
#include <QTableWidget>

#include <algorithm>
#include <numeric>

namespace soffit::ui {

class LightMarksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    nameProgram(QStringLiteral("light-marks"));
    fixture_ = std::make_unique<WindowFixture>();
    QVERIFY(fixture_->open());
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session()->readings().isCurrent(), kPatienceMs);
  }
  void cleanupTestCase() {
    while (document().undoStack()->canUndo()) document().undoStack()->undo();
    fixture_.reset();
  }
  void cleanup() {
    applyUnits(Units::metric);
    workspace().view->setIsolines(false);
    workspace().view->setValues(false);
    while (document().undoStack()->canUndo()) document().undoStack()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session()->relighting().isCurrent(), kPatienceMs);
  }

  void valuesOfTheWorkPlanesAreThoseOfTheTable() {
    QVERIFY(overlay().marks().numbers.empty());
    QVERIFY(fixture_->trigger(QStringLiteral("Wor&k plane values")));
    const auto& numbers = overlay().marks().numbers;
    const auto& planes = document().scene()->work_planes;
    QVERIFY(!planes.empty());
    std::size_t count = 0;
    for (const scene::WorkPlane& p : planes) count += static_cast<std::size_t>(p.nu * p.nv);
    QCOMPARE(numbers.size(), count);
    const auto& plane =
        fixture_->window->session()->readings().readings()->layouts.front().figures.planes.front();
    const auto first = static_cast<std::ptrdiff_t>(planes.front().nu * planes.front().nv);
    const double sum = std::accumulate(numbers.begin(), numbers.begin() + first, 0.0,
                                       [](double s, const auto& n) { return s + n.lux; });
    // Single precision of each value.
    QVERIFY(std::abs(sum / static_cast<double>(first) - plane.lux.mean) < 1e-5 * plane.lux.mean);
    QVERIFY(legend().isVisible());
    QVERIFY(!overlay().seen().numbers.empty());
  }

  void isoluxLinesComeAndGoWithTheirLegend() {
    QVERIFY(!legend().isVisible());
    QVERIFY(fixture_->trigger(QStringLiteral("&Isolux lines")));
    QVERIFY(!fixture_->view().look().levels.empty());
    QVERIFY(overlay().marks().lines.empty());  // on surfaces at first
    QVERIFY(legend().isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!overlay().seen().labels.empty(), kPatienceMs);
    auto* where = workspace().view->findChild<QComboBox*>(QStringLiteral("lines_on"));
    QVERIFY(where != nullptr);
    where->setCurrentIndex(1);
    Q_EMIT where->activated(1);
    QVERIFY(fixture_->view().look().levels.empty());
    QVERIFY(!overlay().marks().lines.empty());
    where->setCurrentIndex(0);
    Q_EMIT where->activated(0);
    QVERIFY(fixture_->trigger(QStringLiteral("&Isolux lines")));
    QVERIFY(!legend().isVisible());
  }

  void aProbeIsPinnedNamedAndTakenBack() {
    pin();
    QCOMPARE(document().probes().size(), std::size_t{1});
    QCOMPARE(overlay().marks().pins.size(), std::size_t{1});
    QCOMPARE(probes().chosen(), 0);
    auto* table = probes().findChildren<QTableWidget*>().front();
    table->item(0, 0)->setText(QStringLiteral("Desk"));
    QCOMPARE(document().probes().front().name, std::string("Desk"));
    document().undoStack()->undo();
    QCOMPARE(document().probes().front().name, std::string("Probe 1"));
    document().undoStack()->undo();
    QVERIFY(document().probes().empty());
    QVERIFY(overlay().marks().pins.empty());
    document().undoStack()->redo();
    probes().removeChosen();
    QVERIFY(document().probes().empty());
  }

  void aProbeReadsTheLightOfTheMomentAndWhoGivesIt() {
    pin();
    QTRY_VERIFY_WITH_TIMEOUT(
        fixture_->view().frame() != nullptr && fixture_->view().frame()->shares.size() == 1,
        kPatienceMs);
    const double before = reading();
    QVERIFY(before > 1.0);
    const auto& shares = fixture_->view().frame()->shares.front();
    QCOMPARE(shares.size(), document().luminaires().size());
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    // Round-off of single precision sums over luminaires.
    QVERIFY(std::abs(sum - before) < 1e-4 * before);
    // In a drag the probe follows the same frame that the picture shows.
    document().setSelection({QString::fromStdString(document().luminaires().front().name)});
    document().preview(document().selection(), [](light::Luminaire& l) { l.position.x += 0.3; });
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session()->relighting().isCurrent(), kPatienceMs);
    QVERIFY(std::abs(reading() - before) > 1e-3 * before);
    const auto& moved = fixture_->view().frame()->shares.front();
    QVERIFY(std::abs(std::accumulate(moved.begin(), moved.end(), 0.0) - reading()) < 1e-4 * before);
    document().cancelPreview();
  }

  void aPinIsDraggedOverTheSurfacesAsOneStep() {
    pin();
    const dvec3 from = document().probes().front().position;
    const QPoint start = pixelOf(from);
    QTest::mousePress(&fixture_->view(), Qt::LeftButton, {}, start);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(&fixture_->view(), start + QPoint(6 * i, 0));
    QCOMPARE(document().undoStack()->count(), 1);
    QVERIFY(glm::length(overlay().marks().pins.front().at - from) > 0.01);
    QTest::mouseRelease(&fixture_->view(), Qt::LeftButton, {}, start + QPoint(48, 0));
    QCOMPARE(document().undoStack()->count(), 2);
    QVERIFY(glm::length(document().probes().front().position - from) > 0.01);
    document().undoStack()->undo();
    QCOMPARE(document().probes().front().position, from);
  }

  void probesAreKeptWithTheProject() {
    pin();
    const auto text = io::formatProject(document().current());
    QVERIFY(text.ok());
    QVERIFY(text->find("\"probes\"") != std::string::npos);
    io::LoadOptions options;
    options.text = *text;
    const auto again = io::loadProject(fixture_->project.toStdString(), options);
    QVERIFY(again.ok());
    QVERIFY(again->probes == document().probes());
    QVERIFY(std::ranges::none_of(again->warnings, [](const std::string& w) {
      return w.find("probes") != std::string::npos;
    }));
  }

  void footcandlesAreShownEverywhere() {
    QVERIFY(fixture_->trigger(QStringLiteral("Wor&k plane values")));
    SceneView& view = fixture_->view();
    QTest::mouseMove(&view, QPoint(view.width() / 2, view.height() * 4 / 5));
    applyUnits(Units::imperial);
    const auto labels = fixture_->window->statusBar()->findChildren<QLabel*>();
    QVERIFY(std::ranges::any_of(
        labels, [](const QLabel* l) { return l->text().contains(QStringLiteral(" fc ")); }));
    QCOMPARE(legend().scale().unit, color::LuxUnit::footcandle);
    QCOMPARE(overlay().marks().scale.unit, color::LuxUnit::footcandle);
    QCOMPARE(fixture_->view().look().scale.unit, color::LuxUnit::footcandle);
  }

  void allViewsHaveTheirNumbersAndPins() {
    // On the floor before the blocks: seen from above, too.
    document().editProbes(QStringLiteral("Pin"), {{"Floor", {1.39, 0.15, 0.0}, {0.0, 0.0, 1.0}}});
    QVERIFY(fixture_->trigger(QStringLiteral("Wor&k plane values")));
    ViewGrid& grid = workspace().area->grid();
    grid.setArrangement(ViewGrid::Arrangement::four);
    for (std::size_t i = 0; i < 4; ++i) {
      QTRY_VERIFY(grid.pane(i).view().isValid());
      const LuxMarks& marks = workspace().area->marks(i).marks();
      QCOMPARE(marks.numbers.size(), overlay().marks().numbers.size());
      QCOMPARE(marks.pins.size(), std::size_t{1});
    }
    // From above, the floor's values have their place.
    QTRY_VERIFY(!workspace().area->marks(1).seen().numbers.empty());
    // A pin is taken hold of in any of them.
    SceneView& plan = grid.pane(1).view();
    const dvec3 from = document().probes().front().position;
    const dvec3 at = plan.viewCamera().project(from, plan.viewSize());
    const QPoint start(static_cast<int>(at.x), static_cast<int>(at.y));
    QVERIFY(plan.isSeen(plan.viewCamera(), from));
    QTest::mousePress(&plan, Qt::LeftButton, {}, start);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(&plan, start + QPoint(2 * i, 0));
    QTest::mouseRelease(&plan, Qt::LeftButton, {}, start + QPoint(16, 0));
    QVERIFY(glm::length(document().probes().front().position - from) > 0.01);
    QCOMPARE(overlay().marks().pins.front().at, document().probes().front().position);
    // Another layout has its own values and none of the probes of this one.
    const QString other = toQt(document().scene()->layouts[1].name);
    Q_EMIT grid.pane(2).bar().layoutChosen(other);
    QVERIFY(workspace().area->marks(2).marks().pins.empty());
    Q_EMIT grid.pane(2).bar().layoutChosen(std::nullopt);
    QCOMPARE(workspace().area->marks(2).marks().pins.size(), std::size_t{1});
    grid.setArrangement(ViewGrid::Arrangement::one);
  }

 private:
  [[nodiscard]] Document& document() { return fixture_->document(); }
  [[nodiscard]] Workspace& workspace() { return fixture_->window->workspace(); }
  [[nodiscard]] LuxOverlay& overlay() { return workspace().area->marks(); }
  [[nodiscard]] Legend& legend() { return workspace().area->legend(); }
  [[nodiscard]] ProbesPanel& probes() { return *workspace().probes; }
  [[nodiscard]] QPoint pixelOf(const dvec3& p) {
    const dvec3 at = fixture_->view().viewCamera().project(p, fixture_->view().viewSize());
    return {static_cast<int>(at.x), static_cast<int>(at.y)};
  }
  [[nodiscard]] double reading() {
    const auto light =
        readProbe(*fixture_->view().frame(), *document().scene(), document().probes().front());
    return light ? light->lux : 0.0;
  }
  /// On the floor, in the lower middle of the picture.
  void pin() {
    SceneView& view = fixture_->view();
    QTest::mouseMove(&view, QPoint(view.width() / 2, view.height() * 4 / 5));
    QVERIFY(fixture_->trigger(QStringLiteral("&Pin a probe")));
  }

  std::unique_ptr<WindowFixture> fixture_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::prepareProgram();
  QApplication application(argc, argv);
  soffit::ui::LightMarksTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "light_marks_test.moc"
