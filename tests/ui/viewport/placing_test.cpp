// SPDX-License-Identifier: MIT
// Placing, drawing and arranging luminaires in a lit view.
#include "ui/viewport/placing.h"
#include "tests/ui/viewport/cornell_view.h"
#include "ui/document/luminaire_type_mime.h"
#include "ui/viewport/arraying.h"
#include "ui/viewport/drawing_polygon.h"
#include "ui/viewport/making_luminous.h"

#include <QDropEvent>

#include <algorithm>

namespace soffit::ui {

/// A pixel of the floor, before the boxes.
const QPoint kFloor(175, 372);

class PlacingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    lit_ = std::make_unique<Lit>(lightCornell());
    types_ = builtInTypes();
    const Box box = lit_->project.scene.mesh->bounds();
    ceiling_ = lit_->project.scene.mesh->origin.z + static_cast<double>(box.hi.z);
  }
  void init() {
    v_ = std::make_unique<CornellView>(*lit_);
    QVERIFY(v_->show(lit_->frame));
    before_ = count();
  }
  void cleanup() { v_.reset(); }

  void aClickOnTheFloorHangsItFromTheCeiling() {
    startPlacing(types_.front());
    const QPoint floor = kFloor;
    QVERIFY(v_->view->pointAt(floor).surface->normal.z > 0.9F);
    QTest::mouseMove(v_->view.get(), floor);
    QVERIFY(!v_->input->overlay().content().lines.empty());
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, {}, floor);
    QCOMPARE(count(), before_ + 1);
    const light::Luminaire& placed = v_->document->luminaires().back();
    // Whole millimetres, and rays in single precision.
    QVERIFY(std::abs(placed.position.z - (ceiling_ - kCeilingGap)) < 1e-3);
    QCOMPARE(v_->document->selection(), QStringList{QString::fromStdString(placed.name)});
    QVERIFY(v_->input->tool() == nullptr);
    QCOMPARE(v_->document->undoStack()->count(), 1);
    v_->document->undoStack()->undo();
    QCOMPARE(count(), before_);
  }

  void aPendantHangsLower() {
    const auto pendant = std::ranges::find_if(
        types_, [](const auto& t) { return t.mounting == Mounting::suspended; });
    startPlacing(*pendant);
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, {}, kFloor);
    const light::Luminaire& placed = v_->document->luminaires().back();
    QVERIFY(placed.position.z < ceiling_ - pendant->drop);
  }

  void onAWallItShinesAwayFromIt() {
    startPlacing(types_.front());
    const QPoint wall(160, 190);
    const auto at = v_->view->pointAt(wall);
    QVERIFY(at.surface && std::abs(at.surface->normal.z) < 0.1F);
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, Qt::AltModifier, wall);
    const light::Luminaire& placed = v_->document->luminaires().back();
    const dvec3 emits = rotationXyz(placed.rotation_deg) * dvec3(0, 0, -1);
    QVERIFY(glm::length(emits - dvec3(at.surface->normal)) < 1e-4);
  }

  void shiftPlacesSeveral() {
    startPlacing(types_.front());
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, Qt::ShiftModifier, kFloor);
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, Qt::ShiftModifier, (kFloor + QPoint(30, 0)));
    QCOMPARE(count(), before_ + 2);
    QVERIFY(v_->input->tool() != nullptr);
    QTest::keyClick(v_->view.get(), Qt::Key_Escape);
    QVERIFY(v_->input->tool() == nullptr);
  }

  void spaceTurnsIt() {
    startPlacing(types_[1]);
    QTest::mouseMove(v_->view.get(), kFloor);
    QTest::keyClick(v_->view.get(), Qt::Key_Space);
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, {}, kFloor);
    QCOMPARE(v_->document->luminaires().back().rotation_deg.z, 90.0);
  }

  void aKindDraggedFromTheLibraryIsDropped() {
    LuminaireTypeMime mime(types_.front());
    const QPoint at = kFloor;
    QDragEnterEvent enter(at, Qt::CopyAction, &mime, Qt::LeftButton, {});
    QApplication::sendEvent(v_->view.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(at, Qt::CopyAction, &mime, Qt::LeftButton, {});
    QApplication::sendEvent(v_->view.get(), &drop);
    QCOMPARE(count(), before_ + 1);
  }

  void cornersAndEnterMakeAPolygon() {
    v_->input->setTool(std::make_unique<DrawingPolygon>(*v_->document, *v_->view));
    for (const QPoint& p : {QPoint(290, 40), QPoint(350, 40), QPoint(350, 60)}) {
      const auto at = v_->view->pointAt(p);
      QVERIFY(at.surface && at.surface->normal.z < -0.9F);
      QTest::mouseClick(v_->view.get(), Qt::LeftButton, Qt::AltModifier, p);
    }
    QTest::keyClick(v_->view.get(), Qt::Key_Return);
    QCOMPARE(count(), before_ + 1);
    const light::Luminaire& drawn = v_->document->luminaires().back();
    QCOMPARE(std::get<light::Polygon>(drawn.shape).outline.size(), std::size_t{3});
    QVERIFY(std::abs(drawn.position.z - (ceiling_ - kCeilingGap)) < 1e-3);
    QCOMPARE(v_->document->undoStack()->count(), 1);
  }

  void aPartOfTheBuildingGivesLight() {
    v_->input->setTool(std::make_unique<MakingLuminous>(*v_->document, *v_->view));
    const QPoint on_box(250, 290);
    const auto at = v_->view->pointAt(on_box);
    QVERIFY(at.surface.has_value());
    QTest::mouseClick(v_->view.get(), Qt::LeftButton, {}, on_box);
    QCOMPARE(count(), before_ + 1);
    const light::Luminaire& made = v_->document->luminaires().back();
    const auto& mesh = std::get<light::MeshShape>(made.shape);
    QVERIFY(mesh.mesh->triangles.size() >= 2);
    QVERIFY(v_->document->hasFile(mesh.file));
    QVERIFY(*made.flux > 0.0);
    const auto emitter = light::makeEmitter(made);
    QVERIFY(emitter.ok());
  }

  void anArrayIsLiveAndOneStep() {
    v_->document->setSelection({v_->firstName()});
    auto tool = std::make_unique<Arraying>(*v_->document, *v_->view, ArrayKind::rectangle);
    Arraying* array = tool.get();
    v_->input->setTool(std::move(tool));
    ArraySettings settings = array->wanted();
    settings.columns = 2;
    settings.rows = 2;
    array->setSettings(settings);
    const std::size_t fits = array->plan().places.size();
    QCOMPARE(count(), before_ + fits - 1);
    QVERIFY(v_->document->previewing());
    QCOMPARE(v_->document->undoStack()->count(), 0);
    QTest::keyClick(v_->view.get(), Qt::Key_Return);
    QCOMPARE(v_->document->undoStack()->count(), 1);
    QCOMPARE(count(), before_ + fits - 1);
    QVERIFY(v_->input->tool() == nullptr);
    v_->document->undoStack()->undo();
    QCOMPARE(count(), before_);
  }

  void anArrayThatIsGivenUpLeavesNothing() {
    v_->document->setSelection({v_->firstName()});
    const dvec3 place = v_->first().position;
    v_->input->setTool(std::make_unique<Arraying>(*v_->document, *v_->view, ArrayKind::circle));
    QVERIFY(count() > before_);
    QTest::keyClick(v_->view.get(), Qt::Key_Escape);
    QCOMPARE(count(), before_);
    QCOMPARE(v_->first().position, place);
    QCOMPARE(v_->document->undoStack()->count(), 0);
  }

  void theSpacingHandleIsDragged() {
    v_->document->setSelection({v_->firstName()});
    auto tool = std::make_unique<Arraying>(*v_->document, *v_->view, ArrayKind::line_x);
    Arraying* array = tool.get();
    v_->input->setTool(std::move(tool));
    ArraySettings settings = array->wanted();
    settings.columns = 2;
    array->setSettings(settings);
    QCOMPARE(array->plan().places.size(), std::size_t{2});
    const double z = v_->first().position.z;
    const double before = array->plan().settings.spacing.x;
    const dvec3 last(array->plan().places.back(), z);
    const QPoint grip = v_->pixelOf(last);
    v_->drag(grip, v_->pixelOf(last - dvec3(0.1 * before, 0, 0)));
    QVERIFY(array->plan().settings.spacing.x < before);
    QVERIFY(array->plan().settings.spacing.x > 0.6 * before);
    v_->input->setTool(nullptr);
  }

 private:
  [[nodiscard]] std::size_t count() const { return v_->document->luminaires().size(); }
  void startPlacing(const LuminaireType& type) {
    v_->input->setTool(
        std::make_unique<Placing>(*v_->document, *v_->view, type, v_->input->snapRules()));
  }

  std::unique_ptr<Lit> lit_;
  std::unique_ptr<CornellView> v_;
  std::vector<LuminaireType> types_;
  std::size_t before_ = 0;
  double ceiling_ = 0.0;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::wantOpenGl();
  QApplication application(argc, argv);
  soffit::ui::PlacingTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "placing_test.moc"
