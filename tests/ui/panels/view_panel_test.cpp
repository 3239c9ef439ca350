// SPDX-License-Identifier: MIT
#include "ui/panels/view_panel.h"

#include "ui/panels/library_model.h"
#include "ui/widgets/units.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

#include <memory>

namespace soffit::ui {
namespace {

io::Project warmRoom() {
  io::Project project;
  project.scene.mesh = std::make_shared<geometry::Mesh>();
  light::Luminaire l;
  l.name = "Lamp";
  l.flux = 1000.0;
  l.colour.cct_k = 2700.0;
  project.scene.luminaires.push_back(l);
  return project;
}

void choose(QComboBox* box, int index) {
  box->setCurrentIndex(index);
  Q_EMIT box->activated(index);
  Q_EMIT box->textActivated(box->currentText());
}

}  // namespace

class ViewPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

  void whiteIsThatOfTheLuminairesOrAnyTemperature() {
    Document document(warmRoom());
    ViewPanel panel;
    panel.setDocument(&document);
    auto* white = panel.findChild<QComboBox*>(QStringLiteral("white"));
    QCOMPARE(white->currentIndex(), 0);
    QCOMPARE(panel.look().display.white_balance, 0.0);
    choose(white, 1);
    QCOMPARE(document.scene()->view.white_balance, 2700.0);
    QCOMPARE(panel.look().display.white_balance, 2700.0);
    QCOMPARE(white->currentIndex(), 2);  // a number from now on: it does not follow the lamps
    choose(white, 0);
    QCOMPARE(document.scene()->view.white_balance, 0.0);
    choose(white, 2);
    QCOMPARE(document.scene()->view.white_balance, 2700.0);
    QCOMPARE(document.undoStack()->count(), 3);
    document.undoStack()->undo();
    document.undoStack()->undo();
    document.undoStack()->undo();
    QCOMPARE(document.scene()->view.white_balance, 0.0);
    QCOMPARE(white->currentIndex(), 0);
  }

  void lampsLikeDaylightLeaveDaylightWhite() {
    io::Project project = warmRoom();
    project.scene.luminaires[0].colour.cct_k.reset();
    Document document(std::move(project));
    ViewPanel panel;
    panel.setDocument(&document);
    auto* white = panel.findChild<QComboBox*>(QStringLiteral("white"));
    choose(white, 1);
    QCOMPARE(document.scene()->view.white_balance, 0.0);
    QCOMPARE(white->currentIndex(), 0);
  }

  void looksAndDisplaysOfTheConfigAreStepsThatAreUndone() {
    Document document(warmRoom());
    ViewPanel panel;
    panel.setDocument(&document);
    auto* look = panel.findChild<QComboBox*>(QStringLiteral("look"));
    auto* display = panel.findChild<QComboBox*>(QStringLiteral("display"));
    QVERIFY(look->count() > 1);
    QVERIFY(display->count() > 1);
    choose(look, look->findText(QStringLiteral("Soft")));
    choose(display, display->findText(QStringLiteral("Rec.1886")));
    QCOMPARE(panel.look().display.look, std::string("Soft"));
    QCOMPARE(panel.look().display.display, std::string("Rec.1886"));
    QCOMPARE(panel.look().display.view, std::string("Filmic"));
    document.undoStack()->undo();
    document.undoStack()->undo();
    QCOMPARE(look->currentIndex(), 0);
    QCOMPARE(display->currentText(), QStringLiteral("sRGB"));
    QCOMPARE(panel.look().display.look, std::string());
  }

  void theLibrarySaysLengthsInTheUnitsThatAreShown() {
    const LibraryModel model;
    const auto panel_text = [&] {
      return model.data(model.index(0, 0), Qt::DisplayRole).toString();
    };
    QVERIFY2(panel_text().contains(QStringLiteral("0.6 \u00d7 0.6\u00a0m")), qPrintable(panel_text()));
    applyUnits(Units::imperial);
    const QString imperial = panel_text();
    applyUnits(Units::metric);
    QVERIFY2(imperial.contains(QStringLiteral("ft")), qPrintable(imperial));
    QVERIFY2(!imperial.contains(QStringLiteral("0.6")), qPrintable(imperial));
  }
};

}  // namespace soffit::ui

QTEST_MAIN(soffit::ui::ViewPanelTest)
#include "view_panel_test.moc"
