// SPDX-License-Identifier: MIT
#include "ui/widgets/quantity.h"
#include "ui/widgets/lux_scale_fields.h"
#include "ui/widgets/quantity_box.h"
#include "ui/widgets/units.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

namespace soffit::ui {

class QuantityTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsQuantities_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("dimension");
    QTest::addColumn<double>("value");
    const auto row = [](const char* text, Dimension dimension, double value) {
      QTest::newRow(text) << QString::fromUtf8(text) << static_cast<int>(dimension) << value;
    };
    row("1200", Dimension::flux, 1200.0);
    row("1200 lm", Dimension::flux, 1200.0);
    row("1.2klm", Dimension::flux, 1200.0);
    row("3.2 m", Dimension::length, 3.2);
    row("3,2", Dimension::length, 3.2);
    row("320 cm", Dimension::length, 3.2);
    row("-75mm", Dimension::length, -0.075);
    row("10' 6\"", Dimension::length, 3.2004);
    row("40 deg", Dimension::angle, 40.0);
    row("40\u00b0", Dimension::angle, 40.0);
    row("1 rad", Dimension::angle, 57.29577951308232);
    row("50 %", Dimension::share, 0.5);
    row("50", Dimension::share, 0.5);
    row("4000 K", Dimension::temperature, 4000.0);
    row("1 fc", Dimension::illuminance, 10.763910416709722);
    row("1e3", Dimension::flux, 1000.0);
    row("\u22122 EV", Dimension::exposure, -2.0);
  }
  void readsQuantities() {
    QFETCH(QString, text);
    QFETCH(int, dimension);
    QFETCH(double, value);
    const auto read = parseQuantity(text, static_cast<Dimension>(dimension));
    QVERIFY(read.has_value());
    QVERIFY(std::abs(*read - value) <= 1e-12 * std::max(1.0, std::abs(value)));  // round-off
  }

  void turnsDownWhatIsNone() {
    for (const char* text :
         {"", "m", "1200 lm", "3.2 m m", "1 2", "nan", "inf", "3.2.1", "x", "3 kg"}) {
      QVERIFY2(!parseQuantity(QString::fromUtf8(text), Dimension::length), text);
    }
  }

  void showsNoNeedlessZeros() {
    QCOMPARE(formatQuantity(3.2, Dimension::length, 3), QStringLiteral("3.2\u00a0m"));
    QCOMPARE(formatQuantity(-0.0001, Dimension::length, 3), QStringLiteral("0\u00a0m"));
    QCOMPARE(formatQuantity(0.5, Dimension::share, 0), QStringLiteral("50\u00a0%"));
    QCOMPARE(formatQuantity(40.0, Dimension::angle, 1), QStringLiteral("40\u00b0"));
  }

  void whatIsShownReadsBack() {
    for (const double value : {0.0, 1.5, -12.25, 1234.5}) {
      const auto read =
          parseQuantity(formatQuantity(value, Dimension::length, 3), Dimension::length);
      QVERIFY(read.has_value());
      QCOMPARE(*read, value);
    }
  }

  void aBoxTakesTextOnReturn() {
    QuantityBox box(Dimension::length);
    box.setValue(1.0);
    QSignalSpy edits(&box, &QuantityBox::edited);
    auto* line = box.findChild<QLineEdit*>();
    line->setText(QStringLiteral("250 cm"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(edits.count(), 1);
    QCOMPARE(*box.value(), 2.5);
    QCOMPARE(line->text(), QStringLiteral("2.5\u00a0m"));
  }

  void aBoxGoesBackFromNonsense() {
    QuantityBox box(Dimension::flux);
    box.setValue(1000.0);
    QSignalSpy edits(&box, &QuantityBox::edited);
    auto* line = box.findChild<QLineEdit*>();
    line->setText(QStringLiteral("bright"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(edits.count(), 0);
    QCOMPARE(line->text(), QStringLiteral("1000\u00a0lm"));
  }

  void imperialUnitsAreThoseOfTheDisplayAlone() {
    applyUnits(Units::imperial);
    QCOMPARE(formatQuantity(0.3048, Dimension::length, 3), QStringLiteral("1\u00a0ft"));
    QCOMPARE(formatQuantity(500.0, Dimension::illuminance, 1), QStringLiteral("46.45\u00a0fc"));
    QCOMPARE(formatQuantity(1200.0, Dimension::flux, 0), QStringLiteral("1200\u00a0lm"));
    QCOMPARE(*parseQuantity(QStringLiteral("10"), Dimension::length), 3.048);
    QCOMPARE(*parseQuantity(QStringLiteral("2 m"), Dimension::length), 2.0);
    QuantityBox box(Dimension::length);
    box.setSteps(0.1, 3);
    box.setValue(3.048);
    box.stepBy(1);
    QVERIFY(std::abs(*box.value() - 3.07848) < 1e-12);  // a tenth of a foot; round-off
    box.setValue(3.048);
    applyUnits(Units::metric);
    QCOMPARE(box.findChild<QLineEdit*>()->text(), QStringLiteral("3.048\u00a0m"));
    QCOMPARE(*box.value(), 3.048);
  }

  void readingsHaveThreeDigits() {
    QCOMPARE(formatReading(1234.4, Dimension::illuminance), QStringLiteral("1234"));
    QCOMPARE(formatReading(99.96, Dimension::illuminance), QStringLiteral("100"));
    QCOMPARE(formatReading(20.24, Dimension::illuminance), QStringLiteral("20.2"));
    QCOMPARE(formatReading(9.996, Dimension::illuminance), QStringLiteral("10.0"));
    QCOMPARE(formatReading(0.5, Dimension::illuminance), QStringLiteral("0.50"));
    QCOMPARE(formatReading(0.0, Dimension::illuminance), QStringLiteral("0"));
  }

  void levelsAreListedAsPeopleListThem() {
    QCOMPARE(parseLevels(QStringLiteral("300, 500 750")), (std::vector{300.0, 500.0, 750.0}));
    QCOMPARE(parseLevels(QStringLiteral("1 klx; 7.5 lx")), (std::vector{7.5, 1000.0}));
    QCOMPARE(parseLevels(QStringLiteral("none, 0")), std::vector<double>{});
  }

  void theScaleFollowsTheLightUntilItIsSet() {
    LuxScaleFields fields;
    QSignalSpy changes(&fields, &LuxScaleFields::changed);
    fields.suggestRange({0.0, 300.0});
    QCOMPARE(fields.scale().range.max, 300.0);
    QCOMPARE(fields.levels().back(), 300.0);
    auto* most = fields.findChildren<QuantityBox*>()[1];
    most->findChild<QLineEdit*>()->setText(QStringLiteral("750 lx"));
    QTest::keyClick(most, Qt::Key_Return);
    fields.suggestRange({0.0, 200.0});
    QCOMPARE(fields.scale().range.max, 750.0);
    fields.forgetRange();
    fields.suggestRange({0.0, 200.0});
    QCOMPARE(fields.scale().range.max, 200.0);
    QCOMPARE(changes.count(), 3);
    // A logarithmic scale cannot start at 0.
    fields.findChild<QCheckBox*>()->setChecked(true);
    QVERIFY(fields.scale().range.min > 0.0 && fields.scale().range.logarithmic);
    auto* steps = fields.findChild<QSpinBox*>();
    steps->stepBy(1);
    QCOMPARE(fields.scale().steps, 2);
    steps->stepBy(-1);
    QCOMPARE(fields.scale().steps, 0);
  }

  void aBoxStaysInItsRange() {
    QuantityBox box(Dimension::share);
    box.setRange(0.0, 1.0);
    box.setSteps(0.25, 0);
    box.setValue(0.9);
    box.stepBy(1);
    QCOMPARE(*box.value(), 1.0);
  }
};

}  // namespace soffit::ui

QTEST_MAIN(soffit::ui::QuantityTest)
#include "quantity_test.moc"

#include <algorithm>
