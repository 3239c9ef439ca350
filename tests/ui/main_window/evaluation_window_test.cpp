// SPDX-License-Identifier: MIT
#include "tests/ui/main_window/window_fixture.h"
#include "ui/document/environment_edits.h"
#include "ui/viewport/picture_pass.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTest>

namespace soffit::ui {

/// Which processor evaluates light, as chosen in the menu, told in the status bar, and done.
class EvaluationWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theChoiceIsToldAndDone() {
    WindowFixture fixture;
    QVERIFY(fixture.open());
    const auto* label = fixture.window->findChild<QLabel*>(QStringLiteral("evaluation"));
    QVERIFY(label != nullptr);
    QVERIFY(label->text() == QStringLiteral("CPU") || label->text() == QStringLiteral("GPU"));
    QVERIFY(fixture.trigger(QStringLiteral("&Graphics processor")));
    QCOMPARE(label->text(), QStringLiteral("GPU"));
    QVERIFY(label->toolTip().contains(QStringLiteral("chosen")));
    editEnvironment(fixture.document(), QStringLiteral("Sky"), sky(100.0));
    QVERIFY(fixture.lit());
    fixture.view().setMoving(true);
    hold(fixture, 110.0);
    hold(fixture, 120.0);
    hold(fixture, 130.0);
    QVERIFY(fixture.view().frame()->held != nullptr);
    QCOMPARE(fixture.view().skyFigures().where, SkyEvaluation::Figures::Where::gpu);
    QVERIFY(fixture.trigger(QStringLiteral("&Processor")));
    QCOMPARE(label->text(), QStringLiteral("CPU"));
    hold(fixture, 140.0);
    QVERIFY(fixture.view().frame()->held == nullptr);
    QCOMPARE(fixture.view().skyFigures().where, SkyEvaluation::Figures::Where::nowhere);
    // Buffers that do not fit.
    QVERIFY(fixture.trigger(QStringLiteral("&Graphics processor")));
    fixture.view().pass().building.skyEvaluation().setMost(10);
    hold(fixture, 150.0);
    hold(fixture, 160.0);
    QTRY_COMPARE(label->text(), QStringLiteral("CPU"));
    QVERIFY(label->toolTip().contains(QStringLiteral("do not fit")));
    hold(fixture, 170.0);
    QVERIFY(fixture.view().frame()->held == nullptr);
    fixture.view().setMoving(false);
    fixture.document().commitPreview(QStringLiteral("Sky"));
    QVERIFY(fixture.lit());
    fixture.document().undoStack()->setClean();
  }

 private:
  static scene::Environment sky(double azimuth) {
    return {"", scene::Sky{.cie = 12,
                           .sun_azimuth_deg = azimuth,
                           .sun_altitude_deg = 40.0,
                           .horizontal_illuminance = 10000.0,
                           .direct_normal_illuminance = 40000.0,
                           .ground_reflectance = 0.2}};
  }
  /// A step of a slider, and its light on the screen.
  static void hold(WindowFixture& fixture, double azimuth) {
    quint64 shown = 0;
    const auto connection = connect(&fixture.view(), &SceneView::lightShown,
                                    [&](quint64 revision, double) { shown = revision; });
    previewEnvironment(fixture.document(), sky(azimuth));
    QTRY_COMPARE_WITH_TIMEOUT(shown, fixture.window->session()->relighting().revision(),
                              kPatienceMs);
    disconnect(connection);
  }
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::prepareProgram();
  QApplication application(argc, argv);
  soffit::ui::nameProgram(QStringLiteral("soffit-evaluation"));
  soffit::ui::EvaluationWindowTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "evaluation_window_test.moc"
