// SPDX-License-Identifier: MIT
#include "ui/panels/results_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

namespace soffit::ui {

LayoutReading reading(const std::string& name, double mean) {
  LayoutReading r;
  r.layout = name;
  r.figures.name = name.empty() ? "Base" : name;
  r.figures.planes = {{"Desks", {.count = 4, .mean = mean, .min = 50.0, .max = 800.0, .u0 = 0.1}},
                      {"Floor\tnorth", {.count = 4, .mean = 20.24, .min = 0.0, .max = 40.0}}};
  r.figures.emitted_lm = 4200.0;
  r.figures.lm_per_m2 = 210.0;
  return r;
}

ReadingsPtr twoLayouts() {
  auto readings = std::make_shared<Readings>();
  readings->layouts = {reading("A", 500.4), reading("B", 300.0)};
  readings->layouts[1].watts = 50.0;
  readings->layouts[1].unknown_power = 1;
  readings->shown = "B";
  readings->area_m2 = 20.0;
  return readings;
}

class ResultsPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aRowPerLayoutAndPlaneWithFluxInTheFirst() {
    ResultsModel model;
    model.setReadings(twoLayouts());
    QCOMPARE(model.rowCount(), 4);
    const auto text = [&](int row, int column) {
      return model.index(row, column).data().toString();
    };
    QCOMPARE(text(0, ResultsModel::kMean), QStringLiteral("500"));
    QCOMPARE(text(1, ResultsModel::kMean), QStringLiteral("20.2"));
    QCOMPARE(text(0, ResultsModel::kFlux), QStringLiteral("4200"));
    QCOMPARE(text(1, ResultsModel::kFlux), QString());
    // No file says what A takes; of B one does and one does not.
    QCOMPARE(text(0, ResultsModel::kPower), QStringLiteral("\u2013"));
    QCOMPARE(text(2, ResultsModel::kPower), QStringLiteral("\u2265\u00a050"));
    QCOMPARE(text(2, ResultsModel::kPowerDensity), QStringLiteral("\u2265\u00a02.5"));
  }

  void newValuesKeepTheRows() {
    ResultsModel model;
    model.setReadings(twoLayouts());
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    model.setReadings(twoLayouts());
    QCOMPARE(reset.size(), 0);
    QCOMPARE(changed.size(), 1);
    model.setReadings(nullptr);
    QCOMPARE(model.rowCount(), 0);
  }

  void theTableIsCopiedForASpreadsheet() {
    ResultsPanel panel;
    panel.setReadings(twoLayouts());
    panel.copy();
    QStringList lines = QApplication::clipboard()->text().split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), 6);  // headings, four rows, and the end of the last
    for (int i = 0; i < 5; ++i) QCOMPARE(lines[i].count(QLatin1Char('\t')), 9);
    QVERIFY(lines[2].startsWith(QStringLiteral("A\tFloor north\t20.2\t")));
    panel.findChild<QTableView*>(QStringLiteral("all_layouts"))->selectRow(2);
    lines = panel.text().split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), 3);
    QVERIFY(lines[1].startsWith(QStringLiteral("B\tDesks\t300")));
  }

  void twoLayoutsAreComparedQuantityByQuantity() {
    ResultsPanel panel;
    panel.setReadings(twoLayouts());
    panel.setComparison(std::pair(QStringLiteral("A"), QStringLiteral("B")));
    const QStringList lines = panel.text().split(QLatin1Char('\n'));
    QVERIFY(lines[0].startsWith(QStringLiteral("Work plane\tQuantity\tA\tB\tDifference\t%")));
    QVERIFY(lines[1].endsWith(QStringLiteral("\t500.4\t300.0\t\u2212200.4\t\u221240.0")));
    // Nothing stands against nothing; equal values have no sign.
    QVERIFY(lines[6].endsWith(QStringLiteral("\t0.0\t0.0\t0.0\t\u2013")));
    QVERIFY(lines[9].startsWith(QStringLiteral("All\t\u03a6 lm\t4200\t4200\t0\t0.0")));
    panel.setComparison(std::nullopt);
    QVERIFY(panel.text().startsWith(QStringLiteral("Layout\t")));
  }

  void aDoubleClickChoosesTheLayout() {
    ResultsPanel panel;
    panel.setReadings(twoLayouts());
    QSignalSpy chosen(&panel, &ResultsPanel::layoutChosen);
    auto* table = panel.findChild<QTableView*>(QStringLiteral("all_layouts"));
    Q_EMIT table->doubleClicked(table->model()->index(3, 2));
    QCOMPARE(chosen.front().front().toString(), QStringLiteral("B"));
  }
};

}  // namespace soffit::ui

QTEST_MAIN(soffit::ui::ResultsPanelTest)
#include "results_panel_test.moc"
