// SPDX-License-Identifier: MIT
#include "ui/panels/daylight_panel.h"

#include "core/io/image/write_image.h"
#include "core/scene/equality.h"
#include "tests/ui/window_scene.h"
#include "ui/document/text.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSlider>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

namespace soffit::ui {

class DaylightPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

  void everyKindOfLightIsOneStepAndComesBack() {
    Document document(windowProject());
    DaylightPanel panel;
    panel.setDocument(&document);
    auto* kind = panel.findChild<QComboBox*>(QStringLiteral("outside_kind"));
    QCOMPARE(kind->currentIndex(), static_cast<int>(OutsideKind::sky));
    choose(kind, OutsideKind::none);
    QVERIFY(!document.scene()->environment);
    choose(kind, OutsideKind::analytic);
    QVERIFY(kindOf(document.scene()->environment) == OutsideKind::analytic);
    choose(kind, OutsideKind::sky);
    // As it was before.
    QVERIFY(scene::same(*document.scene()->environment, *windowProject().scene.environment));
    QCOMPARE(document.undoStack()->count(), 3);
    document.undoStack()->undo();
    document.undoStack()->undo();
    QCOMPARE(kind->currentIndex(), static_cast<int>(OutsideKind::none));
  }

  void the16SkiesHaveNames() {
    const QStringList names = skyNames();
    QCOMPARE(names.size(), 16);
    QCOMPARE(QSet<QString>(names.begin(), names.end()).size(), 16);
    Document document(windowProject());
    DaylightPanel panel;
    panel.setDocument(&document);
    auto* type = panel.findChild<QComboBox*>(QStringLiteral("sky_type"));
    QCOMPARE(type->count(), 16);
    QCOMPARE(type->currentIndex(), 11);
    type->setCurrentIndex(15);
    Q_EMIT type->activated(15);
    QCOMPARE(std::get<scene::Sky>(document.scene()->environment->light).cie, 16);
  }

  void aHeldSliderIsAPreviewAndOneStep() {
    Document document(windowProject());
    DaylightPanel panel;
    panel.setDocument(&document);
    QSignalSpy held(&panel, &DaylightPanel::held);
    auto* slider = panel.findChild<QSlider*>(QStringLiteral("sun_azimuth"));
    slider->setSliderDown(true);
    for (int azimuth = 195; azimuth < 260; azimuth += 5) slider->setValue(azimuth);
    QVERIFY(document.previewing());
    QCOMPARE(azimuthOf(document), 255.0);
    QCOMPARE(document.undoStack()->count(), 0);
    slider->setSliderDown(false);
    QVERIFY(!document.previewing());
    QCOMPARE(document.undoStack()->count(), 1);
    QVERIFY(!held.last().front().toBool());
    // Keys: steps that follow one another are one.
    for (int i = 0; i < 4; ++i) QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(azimuthOf(document), 259.0);
    QCOMPARE(document.undoStack()->count(), 2);
    document.undoStack()->undo();
    document.undoStack()->undo();
    QCOMPARE(azimuthOf(document), 190.0);
    QCOMPARE(slider->value(), 190);
  }

  void aPictureIsReadAndSavedWithTheProject() {
    QTemporaryDir folder;
    scene::Image image;
    image.width = 32;
    image.height = 16;
    image.pixels.assign(3 * 32 * 16, 2.0F);
    const std::filesystem::path file = toPath(folder.filePath(QStringLiteral("sky.hdr")));
    QVERIFY(io::writeImage(file, image).ok());
    io::Project project = windowProject();
    std::filesystem::create_directory(toPath(folder.filePath(QStringLiteral("p"))));
    project.path = toPath(folder.filePath(QStringLiteral("p/p.soffit")));
    Document document(std::move(project));
    DaylightPanel panel;
    panel.setDocument(&document);
    panel.usePicture(toQt(file));
    QTRY_VERIFY(kindOf(document.scene()->environment) == OutsideKind::picture);
    const auto probe = std::get<scene::Probe>(document.scene()->environment->light);
    QVERIFY(probe.layout == scene::ProbeLayout::lat_long);
    QVERIFY(probe.image != nullptr && probe.image->width == 32);
    QCOMPARE(probe.file, std::string("sky.hdr"));
    QVERIFY(document.writeFiles().ok());
    QVERIFY(std::filesystem::exists(document.project().path.parent_path() / "sky.hdr"));
    QCOMPARE(document.undoStack()->count(), 1);
  }

  void aFileThatIsNoPictureIsTold() {
    Document document(windowProject());
    DaylightPanel panel;
    panel.setDocument(&document);
    QSignalSpy failed(&panel, &DaylightPanel::failed);
    panel.usePicture(QStringLiteral("/no/such/sky.hdr"));
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(kindOf(document.scene()->environment) == OutsideKind::sky);
    QCOMPARE(document.undoStack()->count(), 0);
  }

  void layoutsOfPicturesAreGuessedFromTheirSides() {
    scene::Image image;
    const auto guess = [&](int width, int height) {
      image.width = width;
      image.height = height;
      return likelyLayout(image);
    };
    QVERIFY(guess(4096, 2048) == scene::ProbeLayout::lat_long);
    QVERIFY(guess(900, 900) == scene::ProbeLayout::angular);
    QVERIFY(guess(768, 1024) == scene::ProbeLayout::cross);
    QVERIFY(guess(1024, 768) == scene::ProbeLayout::cross);
  }

 private:
  static void choose(QComboBox* kind, OutsideKind wanted) {
    kind->setCurrentIndex(static_cast<int>(wanted));
    Q_EMIT kind->activated(static_cast<int>(wanted));
  }
  static double azimuthOf(const Document& document) {
    return std::get<scene::Sky>(document.scene()->environment->light).sun_azimuth_deg;
  }
};

}  // namespace soffit::ui

QTEST_MAIN(soffit::ui::DaylightPanelTest)
#include "daylight_panel_test.moc"
