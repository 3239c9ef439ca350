// SPDX-License-Identifier: MIT
#include "tests/ui/main_window/window_fixture.h"
#include "ui/viewport/comparison_mode.h"

#include <QListWidget>
#include <QMainWindow>
#include <QSettings>
#include <QSignalSpy>

namespace soffit::ui {

using Arrangement = ViewGrid::Arrangement;

/// One to four views of one project, and the cameras it keeps.
class ViewsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    nameProgram(QStringLiteral("views-test"));
    fixture_ = std::make_unique<WindowFixture>();
    QVERIFY(fixture_->open());
  }
  void cleanup() {
    if (fixture_->window == nullptr) return;
    grid().setArrangement(Arrangement::one);
    while (fixture_->document().undoStack()->canUndo()) fixture_->document().undoStack()->undo();
    QVERIFY(fixture_->lit());
  }

  void fourViewsShowOneLightFromFourSides() {
    show(Arrangement::four);
    QCOMPARE(grid().count(), std::size_t{4});
    QCOMPARE(grid().pane(0).standardView(), StandardView::perspective);
    QCOMPARE(grid().pane(1).standardView(), StandardView::plan);
    QCOMPARE(grid().pane(2).standardView(), StandardView::section_front);
    QCOMPARE(grid().pane(3).standardView(), StandardView::section_right);
    for (std::size_t i = 0; i < 4; ++i) {
      SceneView& view = grid().pane(i).view();
      QVERIFY(view.isVisible());
      QCOMPARE(view.frame(), grid().first().view().frame());
      QCOMPARE(view.meshSolver(), grid().first().view().meshSolver());
      QVERIFY2(meanOf(pictureOf(view)) > 5.0, qPrintable(QString::number(i)));
    }
    // None lies over another.
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        QVERIFY(!grid().pane(i).view().geometry().intersects(grid().pane(k).view().geometry()));
      }
    }
  }

  void selectionAndLookAreTheSameInAll() {
    show(Arrangement::beside);
    const QStringList first{name()};
    fixture_->document().setSelection(first);
    QVERIFY(grid().pane(1).view().gizmoPlace().has_value());
    fixture_->window->workspace().view->setFalseColor(true);
    QVERIFY(grid().pane(1).view().look().false_color);
    fixture_->window->workspace().view->setFalseColor(false);
    fixture_->document().setSelection({});
    QVERIFY(!grid().pane(1).view().gizmoPlace().has_value());
  }

  void aDragInThePlanMovesTheLightOfTheOthers() {
    show(Arrangement::beside);
    SceneView& plan = grid().pane(1).view();
    grid().pane(1).input().snapRules() = {false, false, false, 0.1};
    grid().first().input().snapRules() = {false, false, false, 0.1};
    const dvec3 before = fixture_->document().luminaires().front().position;
    const dvec3 from = plan.viewCamera().project(before, plan.viewSize());
    const dvec3 to = plan.viewCamera().project(before + dvec3(0.3, 0.2, 0.0), plan.viewSize());
    const auto at = [](const dvec3& p) {
      return QPoint(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
    };
    const LightFramePtr old = grid().first().view().frame();
    QTest::mousePress(&plan, Qt::LeftButton, {}, at(from));
    QCOMPARE(&grid().active(), &grid().pane(1));
    for (int i = 1; i <= 10; ++i) {
      QTest::mouseMove(&plan, at(from + (to - from) * (i / 10.0)));
      QTest::qWait(20);
    }
    QVERIFY(fixture_->document().previewing());
    // The others follow while the mouse is down.
    QTRY_VERIFY_WITH_TIMEOUT(grid().first().view().frame() != old, 20000);
    QTest::mouseRelease(&plan, Qt::LeftButton, {}, at(to));
    QVERIFY(glm::length(fixture_->document().luminaires().front().position - before) > 0.1);
    QCOMPARE(fixture_->document().undoStack()->count(), 1);
    QVERIFY(fixture_->lit());
    QTRY_COMPARE(grid().first().view().frame(), fixture_->window->session()->relighting().frame());
    QTRY_COMPARE(plan.frame(), grid().first().view().frame());
    QVERIFY(!grid().first().view().isMoving());
  }

  void aViewThatIsNotShownIsToldNothing() {
    show(Arrangement::beside);
    SceneView& plan = grid().pane(1).view();
    const ViewCamera camera = plan.viewCamera();
    grid().setArrangement(Arrangement::one);
    QVERIFY(!plan.isVisible());
    const int frames = plan.frameCount();
    const LightFramePtr before = plan.frame();
    fixture_->switchFirst();
    QVERIFY(fixture_->lit());
    QCOMPARE(plan.frame(), before);
    QCOMPARE(plan.frameCount(), frames);
    // It catches up when it comes back, and looks from where it did.
    show(Arrangement::beside);
    QCOMPARE(plan.frame(), grid().first().view().frame());
    QCOMPARE(plan.viewCamera().cutPlace(), camera.cutPlace());
    QTRY_VERIFY(plan.frameCount() > frames);
  }

  void commandsAreForTheViewThatWasUsedLast() {
    show(Arrangement::beside);
    QTest::mouseClick(&grid().pane(1).view(), Qt::LeftButton, {}, QPoint(3, 100));
    QVERIFY(fixture_->trigger(QStringLiteral("&Front")));
    QCOMPARE(grid().pane(1).standardView(), StandardView::front);
    QCOMPARE(grid().pane(0).standardView(), StandardView::perspective);
    grid().setArrangement(Arrangement::one);
    QCOMPARE(&grid().active(), &grid().first());
  }

  void aViewCanShowAnotherLayoutAndNothingIsEditedInIt() {
    show(Arrangement::beside);
    Document& document = fixture_->document();
    const QString edited = document.layout();
    const QString other = edited.isEmpty()
                              ? QString::fromStdString(document.scene()->layouts.front().name)
                              : QString();
    OtherLights& lights = fixture_->window->session()->comparison().lights();
    QTRY_VERIFY_WITH_TIMEOUT(lights.isCurrent(other), kPatienceMs);
    ViewPane& second = grid().pane(1);
    Q_EMIT second.bar().layoutChosen(other);
    QCOMPARE(second.layout(), std::optional(other));
    QCOMPARE(second.view().frame(), lights.frame(other));
    QVERIFY(second.view().frame() != grid().first().view().frame());
    const dvec3 place = document.luminaires().front().position;
    const dvec3 at = second.view().viewCamera().project(place, second.view().viewSize());
    const ViewCamera before = second.view().viewCamera();
    const QPoint from(static_cast<int>(at.x), static_cast<int>(at.y));
    QTest::mousePress(&second.view(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i) QTest::mouseMove(&second.view(), from + QPoint(8 * i, 0));
    QTest::mouseRelease(&second.view(), Qt::LeftButton, {}, from + QPoint(40, 0));
    QVERIFY(document.selection().isEmpty());
    QVERIFY(!document.undoStack()->canUndo());
    QVERIFY(!(second.view().viewCamera() == before));
    // Tools go where one can work.
    QCOMPARE(&grid().active(), &second);
    QCOMPARE(&grid().working(), &grid().first());
    const LightFramePtr shown = second.view().frame();
    Q_EMIT second.bar().layoutChosen(std::nullopt);
    QCOMPARE(second.view().frame(), grid().first().view().frame());
    QVERIFY(shown != second.view().frame());
    QCOMPARE(&grid().working(), &second);
  }

  void aComparisonTakesTheWholeCentreAndGivesItBack() {
    show(Arrangement::four);
    fixture_->window->session()->comparison().setMode(ComparisonMode::side_by_side);
    QCOMPARE(grid().count(), std::size_t{1});
    QVERIFY(!grid().pane(1).view().isVisible());
    const ViewArea& area = *fixture_->window->workspace().area;
    QCOMPARE(grid().first().view().height(), area.height());
    fixture_->window->session()->comparison().setMode(ComparisonMode::off);
    QCOMPARE(grid().count(), std::size_t{4});
    QVERIFY(grid().pane(3).view().isVisible());
    QVERIFY(grid().first().view().height() < area.height());
  }

  void theLegendHidesNoViewNorTheBarOfAComparison() {
    ViewArea& area = *fixture_->window->workspace().area;
    show(Arrangement::four);
    fixture_->window->workspace().view->setFalseColor(true);
    for (std::size_t i = 0; i < 4; ++i) {
      QVERIFY(!area.legend().geometry().intersects(grid().pane(i).view().geometry()));
    }
    fixture_->window->session()->comparison().setMode(ComparisonMode::side_by_side);
    const QRect bar = area.comparison().bar().geometry();
    QVERIFY(area.rect().contains(bar));
    QVERIFY(!area.legend().geometry().intersects(bar));
    QVERIFY(!grid().first().bar().geometry().intersects(bar));
    fixture_->window->session()->comparison().setMode(ComparisonMode::off);
    fixture_->window->workspace().view->setFalseColor(false);
    QCOMPARE(grid().pane(1).view().geometry().right() + 2, area.width());
  }

  void viewsComeBackWithTheWindow() {
    show(Arrangement::over);
    grid().pane(1).show(StandardView::back);
    QSettings settings;
    grid().save(settings);
    QWidget area;
    area.resize(600, 400);
    ViewGrid other(area);
    other.restore(settings);
    QCOMPARE(other.arrangement(), Arrangement::over);
    other.layOut(area.rect(), false);
    const auto& scene = fixture_->document().scene();
    other.setScene(scene);
    other.setLuminaires(
        std::make_shared<const EmitterSet>(fixture_->document().luminaires(), scene->mesh->origin));
    QCOMPARE(other.pane(1).standardView(), StandardView::back);
    QVERIFY(other.pane(1).view().geometry().top() > other.first().view().geometry().bottom());
  }

  void theViewsOutliveAnotherProject() {
    show(Arrangement::four);
    grid().pane(2).show(StandardView::right);
    QVERIFY(fixture_->window->session() != nullptr);
    fixture_->window->open(fixture_->project);
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session() != nullptr, 20000);
    QVERIFY(fixture_->lit());
    QCOMPARE(grid().count(), std::size_t{4});
    QCOMPARE(grid().pane(2).standardView(), StandardView::right);
    QTRY_COMPARE(grid().pane(3).view().frame(), grid().first().view().frame());
    QVERIFY(meanOf(pictureOf(grid().pane(2).view())) > 5.0);
  }

  void theViewsOutliveDockingElsewhere() {
    const auto& scene = fixture_->document().scene();
    auto area = std::make_unique<ViewArea>();
    auto window = std::make_unique<QMainWindow>();
    window->resize(640, 480);
    window->setCentralWidget(area.get());
    ViewGrid& views = area->grid();
    views.setArrangement(Arrangement::four);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get(), kPatienceMs));
    QVERIFY(views.setLook({}).ok());
    views.setScene(scene);
    views.setLuminaires(
        std::make_shared<const EmitterSet>(fixture_->document().luminaires(), scene->mesh->origin));
    const LightFramePtr frame = fixture_->window->session()->relighting().frame();
    views.setFrame(frame);
    QTRY_COMPARE_WITH_TIMEOUT(views.pane(3).view().frame(), frame, 20000);
    area->setParent(nullptr);
    area->show();
    QVERIFY(QTest::qWaitForWindowExposed(area.get(), kPatienceMs));
    window.reset();
    for (std::size_t i = 0; i < 4; ++i) {
      SceneView& view = views.pane(i).view();
      const int before = view.frameCount();
      view.update();
      QTRY_VERIFY(view.frameCount() > before);
      QVERIFY2(meanOf(pictureOf(view)) > 5.0, qPrintable(QString::number(i)));
    }
    area.reset();  // with all its views, while the others go on
    QVERIFY(meanOf(pictureOf(fixture_->view())) > 5.0);
  }

  void camerasAreSavedFromTheViewAndChosenInTheDock() {
    CamerasPanel& panel = *fixture_->window->workspace().cameras;
    const auto count = fixture_->document().scene()->cameras.size();
    ViewCamera camera = grid().active().view().viewCamera();
    camera.position.z += 0.25;
    grid().active().view().setViewCamera(camera);
    Q_EMIT panel.saveRequested();
    QCOMPARE(fixture_->document().scene()->cameras.size(), count + 1);
    const QString name = QString::fromStdString(fixture_->document().scene()->cameras.back().name);
    grid().active().view().setViewCamera(ViewCamera());
    Q_EMIT panel.cameraChosen(name);
    QVERIFY(glm::length(grid().active().view().viewCamera().position - camera.position) < 1e-9);
    camera.position.z += 0.25;
    grid().active().view().setViewCamera(camera);
    Q_EMIT panel.updateRequested(name);
    QCOMPARE(fixture_->document().scene()->cameras.back().position.z, camera.position.z);
    // A plan is no camera.
    grid().active().show(StandardView::plan);
    Q_EMIT panel.saveRequested();
    QCOMPARE(fixture_->document().scene()->cameras.size(), count + 1);
    grid().active().show(StandardView::perspective);
    auto* list = panel.findChild<QListWidget*>();
    QCOMPARE(list->count(), static_cast<int>(count) + 1);
    list->item(list->count() - 1)->setText(QStringLiteral("Corner"));
    QTRY_COMPARE(fixture_->document().scene()->cameras.back().name, std::string("Corner"));
    list->item(0)->setText(QStringLiteral("Corner"));  // is taken
    QTRY_VERIFY(list->item(0)->text() != QStringLiteral("Corner"));
  }

 private:
  [[nodiscard]] ViewGrid& grid() const { return fixture_->window->workspace().area->grid(); }
  [[nodiscard]] QString name() const {
    return QString::fromStdString(fixture_->document().luminaires().front().name);
  }
  void show(Arrangement arrangement) {
    grid().setArrangement(arrangement);
    for (std::size_t i = 0; i < grid().count(); ++i) {
      QTRY_VERIFY(grid().pane(i).view().isValid());
    }
  }
  static QImage pictureOf(SceneView& view) {
    Shot shot;
    shot.pixels = {160, 100};
    shot.samples = 1;
    return view.take(shot).image;
  }
  static double meanOf(const QImage& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
    }
    return sum / std::max(1, image.width() * image.height());
  }

  std::unique_ptr<WindowFixture> fixture_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::prepareProgram();
  QApplication application(argc, argv);
  soffit::ui::ViewsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "views_test.moc"

#include <algorithm>
