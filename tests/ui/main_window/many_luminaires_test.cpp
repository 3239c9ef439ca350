// SPDX-License-Identifier: MIT
#include "core/scene/equality.h"
#include "tests/ui/main_window/window_fixture.h"

#include <QLineEdit>
#include <QTableView>
#include <QUndoStack>

#include <algorithm>
#include <cmath>

namespace soffit::ui {

/// A project of 300 luminaires, from opening to opening it again.
class ManyLuminairesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    nameProgram(QStringLiteral("many-luminaires"));
    fixture_ = std::make_unique<WindowFixture>();
    writeProject();
    QVERIFY(fixture_->open());
  }
  void cleanupTestCase() { fixture_.reset(); }
  void cleanup() {
    while (document().undoStack()->canUndo()) document().undoStack()->undo();
    QVERIFY(fixture_->lit());
  }

  void allOfThemAreLit() {
    QCOMPARE(document().luminaires().size(), kCount);
    QCOMPARE(fixture_->view().frame()->emitters.size(), kCount);
    // All are alike and off the walls: the room gets 300 times the flux of one, within what depends
    // on where it hangs.
    QVERIFY(sumOf(fixture_->view().frame()->lux[1]) > 0.0);
    QVERIFY(std::ranges::all_of(fixture_->view().frame()->lux[1],
                                [](float e) { return std::isfinite(e) && e >= 0.0F; }));
  }

  void oneIsDraggedAndTakenBack() {
    SceneView& view = fixture_->view();
    const relight::Planes before = view.frame()->lux;
    const std::size_t lamp = firstInSight();
    const QString name = nameOf(lamp);
    const dvec3 from = document().luminaires()[lamp].position;
    fixture_->window->workspace().area->input().snapRules() = {false, false, false, 0.1};
    const QPoint start = pixelOf(from);
    const QPoint end = start + QPoint(40, 25);
    const LightFramePtr old = view.frame();
    QTest::mousePress(&view, Qt::LeftButton, {}, start);
    for (int i = 1; i <= 10; ++i) {
      QTest::mouseMove(&view, start + (end - start) * i / 10);
      QTest::qWait(15);
    }
    QVERIFY(document().previewing());
    QCOMPARE(document().selection(), QStringList{name});
    QTRY_VERIFY_WITH_TIMEOUT(view.frame() != old, kPatienceMs);  // its light follows the hand
    QTest::mouseRelease(&view, Qt::LeftButton, {}, end);
    QCOMPARE(document().undoStack()->count(), 1);
    QVERIFY(fixture_->lit());
    QVERIFY(glm::length(document().luminaires()[lamp].position - from) > 0.02);
    QVERIFY(unlike(view.frame()->lux, before) > 1e-4);
    for (std::size_t i = 0; i < kCount; ++i) {
      if (i != lamp) QCOMPARE(document().luminaires()[i].position, placeOf(i));
    }
    document().undoStack()->undo();
    QVERIFY(fixture_->lit());
    QCOMPARE(document().luminaires()[lamp].position, from);
    // Single precision over 300 columns, summed in another order.
    QVERIFY(unlike(view.frame()->lux, before) < 300 * kSingle);
    document().undoStack()->redo();
    document().undoStack()->undo();
  }

  void theListHasThemAllSortedAndFiltered() {
    QTableView& list = table();
    QCOMPARE(list.model()->rowCount(), static_cast<int>(kCount));
    list.sortByColumn(LightsModel::kX, Qt::AscendingOrder);
    for (int row = 1; row < list.model()->rowCount(); ++row) {
      QVERIFY(xOf(list, row - 1) <= xOf(list, row));
    }
    auto* filter = fixture_->window->workspace().lights->findChild<QLineEdit*>();
    filter->setText(QStringLiteral("Row 7"));
    QCOMPARE(list.model()->rowCount(), kAcross);
    filter->clear();
    list.sortByColumn(-1, Qt::AscendingOrder);
    QCOMPARE(list.model()->rowCount(), static_cast<int>(kCount));
    // The selection is one, whichever side it is made on.
    list.selectAll();
    QCOMPARE(document().selection().size(), static_cast<qsizetype>(kCount));
    document().setSelection({nameOf(250)});
    QCOMPARE(list.selectionModel()->selectedRows().size(), 1);
    QCOMPARE(list.selectionModel()->selectedRows().front().data().toString(), nameOf(250));
    document().setSelection({});
  }

  void allAreEditedAtOnceAsOneStep() {
    const relight::Planes before = fixture_->view().frame()->lux;
    QTableView& list = table();
    list.selectAll();
    const QModelIndex dim = list.model()->index(17, LightsModel::kDimming);
    QVERIFY(list.model()->setData(dim, QStringLiteral("*=0.5"), Qt::EditRole));
    QCOMPARE(document().undoStack()->count(), 1);
    QVERIFY(std::ranges::all_of(document().luminaires(),
                                [](const light::Luminaire& l) { return l.dimming == 0.5; }));
    const QModelIndex z = list.model()->index(3, LightsModel::kZ);
    QVERIFY(list.model()->setData(z, QStringLiteral("-=0.1"), Qt::EditRole));
    QCOMPARE(document().undoStack()->count(), 2);
    for (std::size_t i = 0; i < kCount; ++i) {
      QVERIFY(std::abs(document().luminaires()[i].position.z - placeOf(i).z + 0.1) < 1e-12);
    }
    document().undoStack()->undo();
    QVERIFY(fixture_->lit());
    relight::Planes twice = fixture_->view().frame()->lux;
    for (auto& plane : twice) {
      for (float& e : plane) e *= 2.0F;
    }
    QVERIFY(unlike(twice, before) < 300 * kSingle);
    document().setSelection({});
  }

  void savedAndOpenedAgainItIsTheSame() {
    document().editLuminaires(QStringLiteral("Turn"), {nameOf(3), nameOf(299)},
                              [](light::Luminaire& l) { l.rotation_deg.x = 12.5; });
    QVERIFY(fixture_->lit());
    QVERIFY(fixture_->trigger(QStringLiteral("&Save")));
    QVERIFY(!fixture_->window->isWindowModified());
    const auto luminaires = document().luminaires();
    const relight::Planes lux = fixture_->view().frame()->lux;
    fixture_->window->open(fixture_->project);
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session() != nullptr, kPatienceMs);
    QVERIFY(fixture_->lit());
    QCOMPARE(document().luminaires().size(), kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
      QVERIFY2(scene::same(document().luminaires()[i], luminaires[i]), qPrintable(nameOf(i)));
    }
    QVERIFY(unlike(fixture_->view().frame()->lux, lux) < 300 * kSingle);
  }

 private:
  static constexpr int kAcross = 20;
  static constexpr int kRows = 15;
  static constexpr std::size_t kCount = std::size_t{kAcross} * kRows;
  static constexpr double kSingle = 6e-8;  // rounding of single precision

  static dvec3 placeOf(std::size_t i) {
    const auto column = static_cast<double>(i % kAcross);
    const auto row = static_cast<double>(i / kAcross);
    return {0.14 + 0.13 * column, 0.14 + 0.18 * row, 2.5};
  }
  static QString nameOf(std::size_t i) {
    return QStringLiteral("Row %1 lamp %2")
        .arg(i / kAcross + 1)
        .arg(i % kAcross + 1, 2, 10, QLatin1Char('0'));
  }

  void writeProject() {
    io::LoadOptions options;
    options.text = fixture_->text.toStdString();
    auto project = io::loadProject(fixture_->project.toStdString(), options);
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    light::Luminaire lamp = project->scene.luminaires.front();
    lamp.shape = light::Rectangle{0.06, 0.06};
    lamp.flux = 40.0;
    project->scene.luminaires.clear();
    for (std::size_t i = 0; i < kCount; ++i) {
      lamp.name = nameOf(i).toStdString();
      lamp.position = placeOf(i);
      lamp.group = QStringLiteral("Group %1").arg(i % 5).toStdString();
      project->scene.luminaires.push_back(lamp);
    }
    project->scene.layouts = {{"All of them", {}}};
    const auto text = io::formatProject(*project);
    QVERIFY(text.ok());
    fixture_->text = QByteArray::fromStdString(*text);
  }

  [[nodiscard]] Document& document() { return fixture_->document(); }
  [[nodiscard]] QTableView& table() {
    return *fixture_->window->workspace().lights->findChild<QTableView*>();
  }
  static double xOf(const QTableView& list, int row) {
    return list.model()->index(row, LightsModel::kX).data(Qt::UserRole).toDouble();
  }
  [[nodiscard]] QPoint pixelOf(const dvec3& p) {
    const dvec3 at = fixture_->view().viewCamera().project(p, fixture_->view().viewSize());
    return {static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))};
  }
  /// One that the mouse finds where it is.
  std::size_t firstInSight() {
    for (std::size_t i = 0; i < kCount; ++i) {
      const PointedAt at = fixture_->view().pointAt(QPointF(pixelOf(placeOf(i))));
      if (at.luminaire == nameOf(i).toStdString()) return i;
    }
    return 0;
  }
  static double sumOf(const std::vector<float>& lux) {
    double sum = 0.0;
    for (const float e : lux) sum += static_cast<double>(e);
    return sum;
  }
  /// RMS of the difference over the mean.
  static double unlike(const relight::Planes& a, const relight::Planes& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a[1].size(); ++i) {
      const double d = static_cast<double>(a[1][i]) - static_cast<double>(b[1][i]);
      squares += d * d;
    }
    const auto count = static_cast<double>(a[1].size());
    return std::sqrt(squares / count) / (sumOf(b[1]) / count);
  }

  std::unique_ptr<WindowFixture> fixture_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::prepareProgram();
  QApplication application(argc, argv);
  soffit::ui::ManyLuminairesTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "many_luminaires_test.moc"
