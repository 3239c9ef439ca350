// SPDX-License-Identifier: MIT
// Editing luminaires with mouse and keys in a lit view.
#include "tests/ui/viewport/cornell_view.h"
#include "ui/actions/luminaire_actions.h"
#include "ui/viewport/aiming.h"

#include "core/light/emitter.h"

namespace soffit::ui {

class LuminaireEditingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { lit_ = std::make_unique<Lit>(lightCornell()); }
  void init() {
    v_ = std::make_unique<CornellView>(*lit_);
    QVERIFY(v_->show(lit_->frame));
  }
  void cleanup() { v_.reset(); }

  void shiftAndControlAddAndRemove() {
    addSecond();
    const QPoint first = v_->pixelOf(v_->first().position);
    const QPoint second = v_->pixelOf(at(1).position);
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, {}, first);
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, Qt::ShiftModifier, second);
    QCOMPARE(v_->document->selection().size(), 2);
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, Qt::ControlModifier, first);
    QCOMPARE(v_->document->selection(), QStringList{QString::fromStdString(at(1).name)});
    // An empty place with Shift loses nothing.
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, Qt::ShiftModifier, QPoint(320, 330));
    QCOMPARE(v_->document->selection().size(), 1);
  }

  void aRubberBandTakesWhatItTouches() {
    addSecond();
    v_->drag({2, 2}, {638, 200}, Qt::ShiftModifier);
    QCOMPARE(v_->document->selection().size(), static_cast<qsizetype>(count()));
    v_->drag({2, 2}, {638, 200}, Qt::ControlModifier);
    QVERIFY(v_->document->selection().isEmpty());
    v_->drag({300, 320}, {340, 360}, Qt::ShiftModifier);
    QVERIFY(v_->document->selection().isEmpty());
    QVERIFY(!v_->input->overlay().band().has_value());
    QCOMPARE(v_->document->undoStack()->count(), 0);
  }

  void severalMoveTogetherInOneStep() {
    addSecond();
    selectAll(*v_->document);
    const dvec3 a = at(0).position;
    const dvec3 b = at(1).position;
    const QPoint from = v_->pixelOf(a);
    v_->drag(from, from + QPoint(25, 6));
    QVERIFY(glm::length(at(0).position - a) > 0.01);
    QVERIFY(glm::length((at(0).position - a) - (at(1).position - b)) < 2e-4);
    QCOMPARE(v_->document->undoStack()->count(), 1);
    v_->document->undoStack()->undo();
    QCOMPARE(at(0).position, a);
    QCOMPARE(at(1).position, b);
  }

  void shiftAndADragMakeACopyAsOneStep() {
    const std::size_t before = count();
    const dvec3 place = v_->first().position;
    const QPoint from = v_->pixelOf(place);
    v_->drag(from, from + QPoint(40, 10), Qt::ShiftModifier);
    QCOMPARE(count(), before + 1);
    QCOMPARE(at(0).position, place);
    QVERIFY(glm::length(at(before).position - place) > 0.01);
    QCOMPARE(v_->document->selection(), QStringList{QString::fromStdString(at(before).name)});
    QCOMPARE(v_->document->undoStack()->count(), 1);
    v_->document->undoStack()->undo();
    QCOMPARE(count(), before);
  }

  void escapeTakesACopyBack() {
    const std::size_t before = count();
    v_->document->setSelection({v_->firstName()});
    const QPoint from = v_->pixelOf(v_->first().position);
    v_->press(from, Qt::ShiftModifier);
    v_->moveTo(from, from + QPoint(30, 0), Qt::ShiftModifier);
    QCOMPARE(count(), before + 1);
    QTest::keyClick(v_->view.get(), Qt::Key_Escape);
    QTest::mouseRelease(v_->view.get(), Qt::LeftButton, {}, from + QPoint(30, 0));
    QCOMPARE(count(), before);
    QCOMPARE(v_->document->selection(), QStringList{v_->firstName()});
    QCOMPARE(v_->document->undoStack()->count(), 0);
  }

  void aTypedValueIsShownAndTakenByEnter() {
    const dvec3 before = v_->first().position;
    const QPoint from = v_->pixelOf(before);
    v_->press(from);
    v_->moveTo(from, from + QPoint(20, 0));
    QTest::keyClick(v_->view.get(), Qt::Key_X);
    for (const char c : {'0', '.', '3', '5'}) QTest::keyClick(v_->view.get(), c);
    const auto& labels = v_->input->overlay().content().labels;
    QVERIFY(!labels.empty());
    QVERIFY(labels.front().text.contains(QStringLiteral("0.35")));
    QTest::keyClick(v_->view.get(), Qt::Key_Return);
    QTest::mouseRelease(v_->view.get(), Qt::LeftButton, {}, from + QPoint(20, 0));
    QVERIFY(glm::length(v_->first().position - (before + dvec3(0.35, 0, 0))) < 1e-9);
    QCOMPARE(v_->document->undoStack()->count(), 1);
    QVERIFY(v_->input->overlay().content().labels.empty());
  }

  void distancesToTheWallsAreShownWhileDragging() {
    const QPoint from = v_->pixelOf(v_->first().position);
    v_->press(from);
    v_->moveTo(from, from + QPoint(14, 3));
    int measures = 0;
    for (const auto& line : v_->input->overlay().content().lines) {
      if (line.stroke == ViewOverlay::Stroke::measure) ++measures;
    }
    QVERIFY(measures >= 2);
    QTest::mouseRelease(v_->view.get(), Qt::LeftButton, {}, from);
  }

  void theRingTurnsTheSelection() {
    v_->document->setSelection({v_->firstName()});
    v_->input->setGizmoTool(GizmoTool::rotate);
    const dvec3 place = v_->first().position;
    const double r = Turning::kRingRadius *
                     Gizmo::arrowLength(place, v_->view->viewCamera(), v_->view->viewSize());
    const QPoint grip = v_->pixelOf(place + r * glm::normalize(dvec3(0.6, 0, 0.8)));
    QCOMPARE(v_->view->gizmoPartAt(grip), GizmoPart::y);
    v_->press(grip);
    v_->moveTo(grip, grip + QPoint(12, 12));
    for (const char c : {'3', '0'}) QTest::keyClick(v_->view.get(), c);
    QTest::mouseRelease(v_->view.get(), Qt::LeftButton, {}, grip + QPoint(12, 12));
    QVERIFY(std::abs(std::abs(v_->first().rotation_deg.y) - 30.0) < 1e-6);
    QCOMPARE(v_->document->undoStack()->count(), 1);
  }

  void aClickAimsAtASurface() {
    v_->document->setSelection({v_->firstName()});
    v_->input->setTool(std::make_unique<Aiming>(*v_->document));
    const QPoint target(200, 300);
    const PointedAt at_target = v_->view->pointAt(target);
    QVERIFY(at_target.surface.has_value());
    QTest::mouseMove(v_->view.get(), target);
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, {}, target);
    QVERIFY(v_->input->tool() == nullptr);
    const dvec3 emits = rotationXyz(v_->first().rotation_deg) * dvec3(0, 0, -1);
    const dvec3 way = glm::normalize(at_target.surface->position - v_->first().position);
    QVERIFY(glm::length(emits - way) < 1e-4);  // angles of a thousandth of a degree
    QCOMPARE(v_->document->undoStack()->count(), 1);
  }

  void aPanelIsFoundFromAbove() {
    const dvec3 place = v_->first().position;
    v_->view->setViewCamera(ViewCamera::from({"", place + dvec3(0, 0, 4), place, 40.0}));
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, {}, v_->pixelOf(place));
    QCOMPARE(v_->document->selection(), QStringList{v_->firstName()});
  }

  void copyPasteAndCut() {
    const std::size_t before = count();
    v_->document->setSelection({v_->firstName()});
    copySelection(*v_->document);
    QVERIFY(paste(*v_->document).ok());
    QCOMPARE(count(), before + 1);
    QVERIFY(glm::length(at(before).position - v_->first().position) > 0.1);
    cutSelection(*v_->document);
    QCOMPARE(count(), before);
    QVERIFY(paste(*v_->document).ok());
    QCOMPARE(count(), before + 1);
    QCOMPARE(v_->document->undoStack()->count(), 3);
  }

  void aFileThatTheProjectLacksIsNotPasted() {
    light::Luminaire lamp = v_->first();
    lamp.name = "Lamp";
    lamp.distribution.kind = light::DistributionKind::ies;
    lamp.distribution.file = "elsewhere.ies";
    scene::Scene next = *v_->document->scene();
    next.luminaires.push_back(lamp);
    v_->document->previewScene(next);
    v_->document->setSelection({QStringLiteral("Lamp")});
    copySelection(*v_->document);
    v_->document->cancelPreview();
    const auto pasted = paste(*v_->document);
    QVERIFY(!pasted.ok());
    QVERIFY(pasted.error().message().find("elsewhere.ies") != std::string::npos);
  }

  void whatIsHiddenIsNotSelected() {
    addSecond();
    v_->document->setSelection({v_->firstName()});
    hideOthers(*v_->document);
    QCOMPARE(v_->document->hidden().size(), static_cast<qsizetype>(count() - 1));
    selectAll(*v_->document);
    QCOMPARE(v_->document->selection(), QStringList{v_->firstName()});
    hideSelection(*v_->document);
    QVERIFY(v_->document->selection().isEmpty());
    showHidden(*v_->document);
    selectAll(*v_->document);
    QCOMPARE(v_->document->selection().size(), static_cast<qsizetype>(count()));
    QCOMPARE(v_->document->undoStack()->count(), 0);
  }

 private:
  [[nodiscard]] std::size_t count() const { return v_->document->luminaires().size(); }
  [[nodiscard]] const light::Luminaire& at(std::size_t i) const {
    return v_->document->luminaires()[i];
  }
  /// A second luminaire half a metre off, without an undo step.
  void addSecond() {
    if (count() > 1) return;
    v_->document->setSelection({v_->firstName()});
    duplicateSelection(*v_->document);
    v_->document->undoStack()->clear();
    v_->document->setSelection({});
  }

  std::unique_ptr<Lit> lit_;
  std::unique_ptr<CornellView> v_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::wantOpenGl();
  QApplication application(argc, argv);
  soffit::ui::LuminaireEditingTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "luminaire_editing_test.moc"
