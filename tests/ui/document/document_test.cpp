// SPDX-License-Identifier: MIT
#include "ui/document/document.h"
#include "tests/ui/document/saving.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace soffit::ui {

/// A project of two luminaires and a layout, as the importer hands it over.
io::Project twoLuminaires() {
  io::Project project;
  auto mesh = std::make_shared<geometry::Mesh>();
  project.scene.mesh = mesh;
  for (const char* name : {"A", "B"}) {
    light::Luminaire luminaire;
    luminaire.name = name;
    luminaire.flux = 1000.0;
    project.scene.luminaires.push_back(luminaire);
  }
  return project;
}

io::Project withEvening() {
  io::Project project = twoLuminaires();
  project.scene.layouts.push_back({"Evening", {}});
  return project;
}

class DocumentTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void editsAreUndoneAndRedone() {
    Document document(twoLuminaires());
    document.editLuminaires(QStringLiteral("Dim"), {QStringLiteral("A")},
                            [](light::Luminaire& l) { l.dimming = 0.5; });
    QCOMPARE(document.luminaire(QStringLiteral("A"))->dimming, 0.5);
    QCOMPARE(document.luminaire(QStringLiteral("B"))->dimming, 1.0);
    QVERIFY(document.isModified());
    document.undoStack()->undo();
    QCOMPARE(document.luminaire(QStringLiteral("A"))->dimming, 1.0);
    QVERIFY(!document.isModified());
    document.undoStack()->redo();
    QCOMPARE(document.luminaire(QStringLiteral("A"))->dimming, 0.5);
  }

  void anEditThatChangesNothingIsNoStep() {
    Document document(twoLuminaires());
    document.editLuminaires(QStringLiteral("Dim"), {QStringLiteral("A")}, [](light::Luminaire&) {});
    QCOMPARE(document.undoStack()->count(), 0);
  }

  void aSlidersWayIsOneStep() {
    Document document(twoLuminaires());
    for (const double dimming : {0.9, 0.6, 0.3}) {
      document.editLuminaires(
          QStringLiteral("Dim"), {QStringLiteral("A")},
          [dimming](light::Luminaire& l) { l.dimming = dimming; }, 7);
    }
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QCOMPARE(document.luminaire(QStringLiteral("A"))->dimming, 1.0);
  }

  void aDragIsOneStepFromItsBeginning() {
    Document document(twoLuminaires());
    const QStringList names{QStringLiteral("A")};
    for (int i = 1; i <= 20; ++i) {
      document.preview(names, [i](light::Luminaire& l) { l.position.x += 0.1 * i; });
      QVERIFY(document.previewing());
    }
    QCOMPARE(document.undoStack()->count(), 0);
    QCOMPARE(document.luminaire(names.front())->position.x, 2.0);
    document.commitPreview(QStringLiteral("Move"));
    QVERIFY(!document.previewing());
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QCOMPARE(document.luminaire(names.front())->position.x, 0.0);
  }

  void aDragGivenUpLeavesNothing() {
    Document document(twoLuminaires());
    document.preview({QStringLiteral("A")}, [](light::Luminaire& l) { l.position.x = 3.0; });
    document.cancelPreview();
    QCOMPARE(document.luminaire(QStringLiteral("A"))->position.x, 0.0);
    QCOMPARE(document.undoStack()->count(), 0);
  }

  void aDragBackToItsBeginningIsNoStepButIsShown() {
    Document document(twoLuminaires());
    document.preview({QStringLiteral("A")}, [](light::Luminaire& l) { l.position.x = 3.0; });
    document.preview({QStringLiteral("A")}, [](light::Luminaire&) {});
    QSignalSpy changes(&document, &Document::sceneChanged);
    document.commitPreview(QStringLiteral("Move"));
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(!changes.isEmpty());
  }

  void editsOfALayoutLeaveTheBaseAlone() {
    Document document(withEvening());
    QCOMPARE(document.layout(), QStringLiteral("Evening"));
    document.editLuminaires(QStringLiteral("Dim"), {QStringLiteral("B")},
                            [](light::Luminaire& l) { l.dimming = 0.2; });
    QCOMPARE(document.luminaire(QStringLiteral("B"))->dimming, 0.2);
    document.setLayout({});
    QCOMPARE(document.luminaire(QStringLiteral("B"))->dimming, 1.0);
  }

  void undoShowsTheLayoutOfTheChange() {
    Document document(withEvening());
    document.editLuminaires(QStringLiteral("Dim"), {QStringLiteral("B")},
                            [](light::Luminaire& l) { l.dimming = 0.2; });
    document.setLayout({});
    document.undoStack()->undo();
    QCOMPARE(document.layout(), QStringLiteral("Evening"));
  }

  void selectionForgetsWhatIsGone() {
    Document document(twoLuminaires());
    document.setSelection({QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("no such")});
    QCOMPARE(document.selection().size(), 2);
    auto without = scene::withoutLuminaire(*document.scene(), "A");
    document.edit(QStringLiteral("Delete"), *without);
    QCOMPARE(document.selection(), QStringList{QStringLiteral("B")});
  }

  void savingWritesTheChangeAndCleansTheStack() {
    QTemporaryDir folder;
    const QString source = QStringLiteral(SOFFIT_SOURCE_DIR "/projects/cornell/");
    for (const char* ending : {"obj", "mtl", "soffit"}) {
      const QString name = QStringLiteral("cornell.") + QString::fromLatin1(ending);
      QVERIFY(QFile::copy(source + name, folder.filePath(name)));
    }
    const std::filesystem::path file =
        folder.filePath(QStringLiteral("cornell.soffit")).toStdString();
    auto project = io::loadProject(file);
    QVERIFY(project.ok());
    Document document(*project);
    document.setLayout({});
    const QStringList names{QString::fromStdString(document.luminaires().front().name)};
    document.editLuminaires(QStringLiteral("Dim"), names,
                            [](light::Luminaire& l) { l.dimming = 0.25; });
    QVERIFY(testing::saved(document, file));
    QVERIFY(!document.isModified());
    const auto again = io::loadProject(file);
    QVERIFY(again.ok());
    QCOMPARE(again->scene.luminaires.front().dimming, 0.25);
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("cornell.soffit~"))));
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::DocumentTest)
#include "document_test.moc"
