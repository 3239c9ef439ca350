// SPDX-License-Identifier: MIT
#include "ui/widgets/quantity.h"
#include "ui/widgets/quantity_box.h"

#include <QLineEdit>
#include <QSignalSpy>
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
