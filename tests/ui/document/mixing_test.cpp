// SPDX-License-Identifier: MIT
#include "ui/document/mixing.h"

#include "core/io/project/project.h"
#include "core/scene/edits.h"
#include "core/scene/layout_edits.h"
#include "tests/ui/document/saving.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace soffit::ui {

io::Project twoGroups() {
  io::Project project;
  project.scene.mesh = std::make_shared<geometry::Mesh>();
  int i = 0;
  for (const char* group : {"General", "General", "Accent"}) {
    light::Luminaire l;
    l.name = "L" + std::to_string(++i);
    l.flux = 1000.0;
    l.group = group;
    l.colour.cct_k = 4000.0;
    project.scene.luminaires.push_back(l);
  }
  return project;
}

const QString kGeneral = QStringLiteral("General");
const QString kAccent = QStringLiteral("Accent");

class MixingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void groupsSayWhatTheirLuminairesShare() {
    Document document(twoGroups());
    document.editLuminaires(QStringLiteral("Dim"), {QStringLiteral("L1")},
                            [](light::Luminaire& l) { l.dimming = 0.5; });
    const auto groups = groupsOf(document);
    QCOMPARE(groups.size(), std::size_t{2});
    QCOMPARE(groups[0].count, 2);
    QVERIFY(!groups[0].dimming.has_value());
    QCOMPARE(groups[0].level, 1.0);
    QCOMPARE(*groups[0].on, true);
    QCOMPARE(*groups[1].dimming, 1.0);
  }

  void aFaderKeepsDifferencesAndItsWayIsOneStep() {
    Document document(twoGroups());
    document.editLuminaires(QStringLiteral("Dim"), {QStringLiteral("L1")},
                            [](light::Luminaire& l) { l.dimming = 0.5; });
    for (const double level : {0.9, 0.6, 0.4}) setGroupLevel(document, kGeneral, level);
    QVERIFY(std::abs(document.luminaires()[0].dimming - 0.2) < 1e-9);
    QVERIFY(std::abs(document.luminaires()[1].dimming - 0.4) < 1e-9);
    QCOMPARE(document.luminaires()[2].dimming, 1.0);
    QCOMPARE(document.undoStack()->count(), 2);
  }

  void soloDarkensTheOthersWithoutAStep() {
    Document document(twoGroups());
    QSignalSpy changed(&document, &Document::sceneChanged);
    document.setSoloGroups({kAccent});
    QCOMPARE(changed.count(), 1);
    QVERIFY(!document.litLuminaires()[0].on);
    QVERIFY(document.litLuminaires()[2].on);
    QVERIFY(document.luminaires()[0].on);
    QCOMPARE(document.undoStack()->count(), 0);
    document.setSoloGroups({QStringLiteral("Gone")});
    QVERIFY(document.litLuminaires()[0].on);
    document.setSoloGroups({});
    QVERIFY(document.litLuminaires()[0].on);
  }

  void scenesBringBackWhatWasStored() {
    Document document(twoGroups());
    document.editLuminaires(QStringLiteral("Dim"), {QStringLiteral("L2")},
                            [](light::Luminaire& l) { l.dimming = 0.25; });
    setGroupColour(document, kAccent, {2700.0, dvec3(1.0)});
    storeScene(document, 0);
    const auto before = document.luminaires();
    setGroupLevel(document, kGeneral, 0.1);
    setGroupOn(document, kAccent, false);
    setGroupColour(document, kAccent, {std::nullopt, dvec3(1, 0, 0)});
    QVERIFY(!isShown(document, document.lightScenes()[0]));
    const int steps = document.undoStack()->count();
    recallScene(document, document.lightScenes()[0]);
    QCOMPARE(document.undoStack()->count(), steps + 1);
    QVERIFY(isShown(document, document.lightScenes()[0]));
    for (std::size_t i = 0; i < before.size(); ++i) {
      QCOMPARE(document.luminaires()[i].dimming, before[i].dimming);
      QCOMPARE(document.luminaires()[i].on, before[i].on);
    }
    QCOMPARE(*document.luminaires()[2].colour.cct_k, 2700.0);
  }

  void storingIsUndone() {
    Document document(twoGroups());
    storeScene(document, 5);
    QCOMPARE(document.lightScenes().size(), std::size_t{1});
    renameScene(document, 0, QStringLiteral("Evening"));
    QCOMPARE(document.lightScenes()[0].name, std::string("Evening"));
    removeScene(document, 0);
    QVERIFY(document.lightScenes().empty());
    document.undoStack()->undo();
    QCOMPARE(document.lightScenes()[0].name, std::string("Evening"));
    while (document.undoStack()->canUndo()) document.undoStack()->undo();
    QVERIFY(document.lightScenes().empty());
    QVERIFY(!document.isModified());
  }

  void scenesFollowTheirLayout() {
    Document document(twoGroups());
    storeScene(document, 0);
    auto next = scene::withLayout(*document.scene(), "Copy", "");
    document.editLayouts(QStringLiteral("x"), *next, QStringLiteral("Copy"),
                         std::pair(QStringLiteral("Copy"), QString()));
    QCOMPARE(document.lightScenes().size(), std::size_t{1});
    renameScene(document, 0, QStringLiteral("Evening"));
    next = scene::withLayoutRenamed(*document.scene(), "Copy", "Night");
    document.editLayouts(QStringLiteral("x"), *next, QStringLiteral("Night"),
                         std::pair(QStringLiteral("Night"), QStringLiteral("Copy")));
    QCOMPARE(document.lightScenes().front().name, std::string("Evening"));
    QVERIFY(!document.project().light_scenes.contains("Copy"));
    next = scene::withoutLayout(*document.scene(), "Night");
    document.editLayouts(QStringLiteral("x"), *next, {});
    QVERIFY(!document.project().light_scenes.contains("Night"));
    QVERIFY(document.lightScenes().front().name != "Evening");  // the base's own
    document.undoStack()->undo();
    QCOMPARE(document.lightScenes().front().name, std::string("Evening"));
    document.undoStack()->undo();
    QCOMPARE(document.layout(), QStringLiteral("Copy"));
    QCOMPARE(document.lightScenes().front().name, std::string("Evening"));
    document.undoStack()->undo();
    document.undoStack()->undo();
    QVERIFY(!document.project().light_scenes.contains("Copy"));
    QCOMPARE(document.lightScenes().size(), std::size_t{1});
  }

  void scenesAreSavedWithTheirLayoutAndUnknownKeysStay() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.soffit"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"soffit": 1, "geometry": [], "luminaires": [
      {"name": "A", "shape": {"rectangle": [0.6, 0.6]}, "position": [0, 0, 2], "flux": 1000,
       "group": "General"}],
      "layouts": [{"name": "First", "mood": "bright"}, {"name": "Second"}]})");
    file.close();
    auto project = io::loadProject(path.toStdString());
    QVERIFY(project.ok());
    Document document(std::move(*project));
    document.setLayout(QStringLiteral("First"));
    setGroupLevel(document, kGeneral, 0.5);
    storeScene(document, 0);
    document.setLayout(QStringLiteral("Second"));
    QVERIFY(document.lightScenes().empty());
    QVERIFY(testing::saved(document, path.toStdString()));
    const auto again = io::loadProject(path.toStdString());
    QVERIFY(again.ok());
    QCOMPARE(again->light_scenes.size(), std::size_t{1});
    QVERIFY(io::same(again->light_scenes.at("First").front(),
                     document.project().light_scenes.at("First").front()));
    QCOMPARE(*again->light_scenes.at("First").front().groups.at("General").dimming, 0.5);
    // The only warning is about the key that is really unknown.
    QCOMPARE(again->warnings.size(), std::size_t{1});
    QVERIFY(again->warnings.front().find("mood") != std::string::npos);
    document.setLayout(QStringLiteral("First"));
    removeScene(document, 0);
    QVERIFY(testing::saved(document, path.toStdString()));
    QFile saved(path);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    const QByteArray text = saved.readAll();
    QVERIFY(!text.contains("scenes"));
    QVERIFY(text.contains("mood"));
  }

  void aFaultySceneIsAnErrorThatNamesItsPlace() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.soffit"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"soffit": 1, "geometry": [], "scenes": [
      {"name": "Bad", "groups": {"General": {"dimming": -1}}}]})");
    file.close();
    const auto project = io::loadProject(path.toStdString());
    QVERIFY(!project.ok());
    QVERIFY(project.error().message().find("scenes.Bad.groups.General.dimming") !=
            std::string::npos);
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::MixingTest)
#include "mixing_test.moc"
