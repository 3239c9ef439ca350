// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_writer.h"
#include "ui/document/synthetic_photometry.h"
#include "ui/panels/advanced_quality.h"
#include "ui/panels/library_panel.h"
#include "ui/panels/lights_model.h"
#include "ui/panels/materials_panel.h"
#include "ui/panels/mixer_panel.h"
#include "ui/panels/quality_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>

namespace soffit::ui {

io::Project manyLuminaires(int count) {
  io::Project project;
  auto mesh = std::make_shared<geometry::Mesh>();
  project.scene.mesh = mesh;
  for (int i = 1; i <= count; ++i) {
    light::Luminaire l;
    l.name = "Panel " + std::to_string(i);
    l.flux = 1000.0 + i;
    l.colour.cct_k = 4000.0;
    l.group = i % 3 == 0 ? "Accent" : "General";
    l.position = {0.1 * i, 1.0, 2.79};
    project.scene.luminaires.push_back(l);
  }
  scene::Material wall;
  wall.name = "wall";
  wall.diffuse = dvec3(0.5);
  scene::Material floor;
  floor.name = "floor";
  floor.diffuse = dvec3(0.2);
  project.scene.materials = {wall, floor};
  return project;
}

class PanelsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anEditOfTheListGoesToAllThatAreSelected() {
    Document document(manyLuminaires(300));
    LightsModel model;
    model.setDocument(&document);
    QCOMPARE(model.rowCount(), 300);
    document.setSelection({name(1), name(2), name(3)});
    QVERIFY(set(model, 1, LightsModel::kDimming, QStringLiteral("50 %")));
    QCOMPARE(document.luminaires()[0].dimming, 0.5);
    QCOMPARE(document.luminaires()[2].dimming, 0.5);
    QCOMPARE(document.luminaires()[3].dimming, 1.0);
    QVERIFY(set(model, 1, LightsModel::kFlux, QStringLiteral("+=100")));
    QCOMPARE(*document.luminaires()[1].flux, 1102.0);
    QVERIFY(set(model, 1, LightsModel::kX, QStringLiteral("*=2")));
    QVERIFY(std::abs(document.luminaires()[2].position.x - 0.6) < 1e-12);
    QCOMPARE(document.undoStack()->count(), 3);
    // A row that is not selected is edited alone.
    QVERIFY(set(model, 10, LightsModel::kGroup, QStringLiteral("Wall")));
    QCOMPARE(document.luminaires()[9].group, std::string("Wall"));
    QCOMPARE(document.luminaires()[0].group, std::string("General"));
  }

  void anotherQualityIsAStepThatIsUndone() {
    Document document(manyLuminaires(3));
    QualityPanel panel;
    panel.setDocument(&document);
    auto* preset = panel.findChild<QComboBox*>();
    QCOMPARE(preset->currentData().toString(), QStringLiteral("interactive"));
    preset->setCurrentIndex(2);
    Q_EMIT preset->activated(2);
    QCOMPARE(document.scene()->quality.preset, std::string("final"));
    document.undoStack()->undo();
    QCOMPARE(document.scene()->quality.preset, std::string("interactive"));
    QCOMPARE(preset->currentData().toString(), QStringLiteral("interactive"));
  }

  void everySettingOfTheQualityCanBeChangedAndIsKeptWhenItDiffers() {
    scene::Quality quality;
    quality.preset = "draft";
    quality.settings["max_rank"] = 20;
    AdvancedQuality dialog(quality);
    QVERIFY(dialog.quality().settings == quality.settings);
    QVERIFY(dialog.quality().methods.empty());
    const auto list = relight::listSettings(quality);
    for (const relight::SettingInfo& info : *list) {
      auto* box = dialog.findChild<QDoubleSpinBox*>(QString::fromStdString(info.name));
      QVERIFY2(box != nullptr, info.name.c_str());
      QVERIFY(std::abs(box->value() - info.value) < 1e-5);
      QCOMPARE(box->isVisibleTo(&dialog), !info.of_method);
    }
    dialog.findChild<QDoubleSpinBox*>(QStringLiteral("texels"))->setValue(9000);
    auto* direct = dialog.findChild<QComboBox*>(QStringLiteral("direct_method"));
    direct->setCurrentIndex(direct->findData(QStringLiteral("cubes")));
    dialog.findChild<QDoubleSpinBox*>(QStringLiteral("bands"))->setValue(7);
    const scene::Quality found = dialog.quality();
    QCOMPARE(found.preset, std::string("draft"));
    QCOMPARE(found.settings.size(), std::size_t{3});
    QCOMPARE(found.settings.at("texels"), 9000.0);
    QCOMPARE(found.settings.at("bands"), 7.0);
    QCOMPARE(found.methods.at("direct"), std::string("cubes"));
    QVERIFY(relight::qualitySettings(found).ok());
    // Numbers of a method that is not chosen are no part of the project.
    direct->setCurrentIndex(0);
    QVERIFY(!dialog.quality().settings.contains("bands"));
  }

  void qualitySaysWhatTheProjectDoesWithout() {
    Document document(manyLuminaires(3));
    QualityPanel panel;
    panel.setDocument(&document);
    const auto* figures = panel.findChild<QTreeWidget*>();
    const auto says = [&](int section, const QString& text) {
      const QTreeWidgetItem* item = figures->topLevelItem(section);
      for (int i = 0; i < item->childCount(); ++i) {
        if (item->child(i)->text(0).contains(text)) return true;
      }
      return false;
    };
    constexpr int kComputed = 3;
    constexpr int kSkipped = 4;
    QVERIFY(says(kSkipped, QStringLiteral("no material has a specular share")));
    scene::Scene glossy = *document.scene();
    glossy.materials.front().specular = 0.04;
    document.edit(QStringLiteral("gloss"), glossy);
    QVERIFY(!says(kSkipped, QStringLiteral("no material has a specular share")));
    QVERIFY(says(kComputed, QStringLiteral("reflections")));
  }

  void whatCannotBeReadChangesNothing() {
    Document document(manyLuminaires(3));
    LightsModel model;
    model.setDocument(&document);
    for (const char* text : {"abc", "-5", "+=x", "*=-1"}) {
      (void)set(model, 1, LightsModel::kDimming, QString::fromLatin1(text));
    }
    QCOMPARE(document.undoStack()->count(), 0);
  }

  void aNameIsChangedInPlace() {
    Document document(manyLuminaires(3));
    LightsModel model;
    model.setDocument(&document);
    QVERIFY(set(model, 1, LightsModel::kName, QStringLiteral("Desk")));
    QVERIFY(document.luminaire(QStringLiteral("Desk")) != nullptr);
    (void)set(model, 2, LightsModel::kName, QStringLiteral("Desk"));  // taken
    QVERIFY(document.luminaire(name(2)) != nullptr);
  }

  void columnsSortByValue() {
    Document document(manyLuminaires(12));
    LightsModel model;
    model.setDocument(&document);
    QCOMPARE(model.data(model.index(9, LightsModel::kFlux), Qt::UserRole).toDouble(), 1010.0);
    QVERIFY(model.data(model.index(1, LightsModel::kX), Qt::UserRole).toDouble() <
            model.data(model.index(9, LightsModel::kX), Qt::UserRole).toDouble());
  }

  void fadersOfTheMixerDimTheirGroup() {
    Document document(manyLuminaires(6));
    MixerPanel mixer;
    mixer.setDocument(&document);
    QCOMPARE(mixer.strips().size(), std::size_t{2});
    auto* fader = mixer.strips()[0]->findChild<QSlider*>();
    for (const int percent : {90, 70, 40}) fader->setValue(percent);
    QCOMPARE(document.luminaires()[0].dimming, 0.4);
    QCOMPARE(document.luminaires()[2].dimming, 1.0);
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QCOMPARE(fader->value(), 100);
  }

  void soloIsSeenAndLeavesNoStep() {
    Document document(manyLuminaires(6));
    MixerPanel mixer;
    mixer.setDocument(&document);
    for (auto* button : mixer.strips()[1]->findChildren<QToolButton*>()) {
      if (button->text() == QStringLiteral("Solo")) button->click();
    }
    QCOMPARE(document.soloGroups(), QStringList{QStringLiteral("Accent")});
    QVERIFY(!document.litLuminaires()[0].on);
    QCOMPARE(document.undoStack()->count(), 0);
  }

  void scenesAreStoredAndRecalledByNumber() {
    Document document(manyLuminaires(6));
    MixerPanel mixer;
    mixer.setDocument(&document);
    mixer.store(0);
    setGroupLevel(document, QStringLiteral("General"), 0.2);
    mixer.store(1);
    mixer.recall(0);
    QCOMPARE(document.luminaires()[0].dimming, 1.0);
    mixer.recall(1);
    QCOMPARE(document.luminaires()[0].dimming, 0.2);
    mixer.recall(7);  // not there
    QCOMPARE(document.luminaires()[0].dimming, 0.2);
  }

  void reflectanceIsTypedAndAWarningComesAbove90() {
    Document document(manyLuminaires(1));
    MaterialsPanel panel;
    panel.setDocument(&document);
    panel.choose(QStringLiteral("wall"));
    auto* warning = panel.findChild<QLabel*>(QStringLiteral("warning"));
    QVERIFY(warning->isHidden());
    auto* slider = panel.findChildren<QSlider*>().front();
    for (const int percent : {70, 85, 95}) slider->setValue(percent);
    QVERIFY(std::abs(document.scene()->materials[0].diffuse.x - 0.95) < 1e-5);
    QCOMPARE(document.scene()->materials[1].diffuse.x, 0.2);
    QVERIFY(!warning->isHidden());
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QVERIFY(warning->isHidden());
    QCOMPARE(panel.chosen(), QStringLiteral("wall"));
  }

  void foldersAreIndexedAndSearched() {
    QTemporaryDir folder;
    for (const double beam : {24.0, 60.0}) {
      const auto file = syntheticSpot("Own spot", beam, 1000.0);
      QVERIFY(
          io::writeIes(folder.filePath(QStringLiteral("own_%1.ies").arg(beam)).toStdString(), file)
              .ok());
    }
    QFile broken(folder.filePath(QStringLiteral("broken.ies")));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("nothing");
    broken.close();
    LibraryPanel panel;
    const int built_in = panel.model().rowCount();
    QSignalSpy indexed(&panel, &LibraryPanel::indexed);
    panel.addFolder(folder.path());
    QTRY_VERIFY_WITH_TIMEOUT(!indexed.isEmpty() && indexed.back().front().toInt() == 1, 10000);
    QCOMPARE(panel.model().rowCount(), built_in + 2);
    panel.setSearch(QStringLiteral("own 24"));
    QCOMPARE(panel.shownCount(), 1);
    panel.setSearch(QStringLiteral("spot"));
    QVERIFY(panel.shownCount() >= 4);
    const QImage thumbnail = thumbnailOf(panel.model().type(0), 64);
    int drawn = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) drawn += qAlpha(thumbnail.pixel(x, y)) > 0 ? 1 : 0;
    }
    QVERIFY(drawn > 300);
  }

 private:
  static QString name(int i) { return QStringLiteral("Panel %1").arg(i); }
  static bool set(LightsModel& model, int number, int column, const QString& text) {
    return model.setData(model.index(number - 1, column), text, Qt::EditRole);
  }
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("soffit-test"));
  QApplication::setApplicationName(QStringLiteral("soffit-panels-test"));
  QSettings().clear();
  soffit::ui::PanelsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "panels_test.moc"
