// SPDX-License-Identifier: MIT
#include "ui/viewport/evaluation.h"

#include <QCoreApplication>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace soffit::ui {

const QString kCard = QStringLiteral("Mesa Intel(R) UHD Graphics 620 (KBL GT2)");
const QString kProgram = QStringLiteral("llvmpipe (LLVM 15.0.6, 256 bits)");

class EvaluationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
    QCoreApplication::setOrganizationName(QStringLiteral("soffit-test"));
    QCoreApplication::setApplicationName(QStringLiteral("evaluation"));
  }
  void init() { QSettings().clear(); }

  void programsThatDrawAreKnown() {
    for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Google SwiftShader",
                             "ANGLE (Google, Vulkan 1.3.0 (SwiftShader "
                             "Device (Subzero) (0x0000C0DE)), SwiftShader driver)",
                             "Software Rasterizer"}) {
      QVERIFY2(isSoftwareRenderer(QString::fromLatin1(name)), name);
    }
    for (const char* name : {"NVIDIA GeForce RTX 3060/PCIe/SSE2", "AMD Radeon RX 6600 (radeonsi)",
                             "Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "V3D 4.2", "virgl"}) {
      QVERIFY2(!isSoftwareRenderer(QString::fromLatin1(name)), name);
    }
  }

  void automaticTakesTheGraphicsProcessorWhereThereIsOne() {
    EvaluationChoice choice;
    QSignalSpy changed(&choice, &EvaluationChoice::changed);
    QCOMPARE(choice.wanted(), Evaluation::automatic);
    QVERIFY(!choice.onGpu());
    QVERIFY(choice.text().isEmpty());
    choice.setRenderer(kProgram);
    QCOMPARE(changed.size(), 1);
    QVERIFY(!choice.onGpu());
    QCOMPARE(choice.text(), QStringLiteral("CPU"));
    QVERIFY(choice.reason().contains(kProgram));
    choice.setRenderer(kCard);
    QVERIFY(choice.onGpu());
    QCOMPARE(choice.text(), QStringLiteral("GPU"));
    QVERIFY(choice.reason().contains(kCard));
    choice.setRenderer(kCard);
    QCOMPARE(changed.size(), 2);
  }

  void whatTheUserChoosesHoldsAndIsKept() {
    {
      EvaluationChoice choice;
      choice.setRenderer(kProgram);
      choice.setWanted(Evaluation::gpu);
      QVERIFY(choice.onGpu());
      QVERIFY(choice.reason().contains(QStringLiteral("chosen")));
    }
    EvaluationChoice choice;
    QCOMPARE(choice.wanted(), Evaluation::gpu);
    choice.setRenderer(kCard);
    choice.setWanted(Evaluation::cpu);
    QVERIFY(!choice.onGpu());
    QVERIFY(choice.reason().contains(QStringLiteral("chosen")));
    QSettings().setValue(QStringLiteral("view/evaluation"), QStringLiteral("nonsense"));
    QCOMPARE(EvaluationChoice().wanted(), Evaluation::automatic);
  }

  void anObstacleIsToldUntilItIsGone() {
    EvaluationChoice choice;
    choice.setRenderer(kCard);
    choice.setWanted(Evaluation::gpu);
    choice.setObstacle(QStringLiteral("no room"));
    QVERIFY(!choice.onGpu());
    QCOMPARE(choice.text(), QStringLiteral("CPU"));
    QVERIFY(choice.reason().contains(QStringLiteral("no room")));
    choice.setObstacle({});
    QVERIFY(choice.onGpu());
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::EvaluationTest)
#include "evaluation_test.moc"
