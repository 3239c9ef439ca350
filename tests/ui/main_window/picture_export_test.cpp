// SPDX-License-Identifier: MIT
#include "ui/main_window/picture_export.h"

#include "core/color/display_transform.h"
#include "core/io/image/read_image.h"
#include "tests/ui/main_window/window_fixture.h"
#include "ui/actions/picture_dialog.h"
#include "ui/viewport/still_renderer.h"

#include <QClipboard>
#include <QColorSpace>
#include <QDialogButtonBox>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QToolButton>

#include <algorithm>

namespace soffit::ui {

class PictureExportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    fixture_ = std::make_unique<WindowFixture>();
    QVERIFY(fixture_->open());
  }
  void cleanupTestCase() { fixture_.reset(); }

  void thePictureOfTheViewIsTheView() {
    SceneView& view = fixture_->view();
    const QString path = fixture_->folder.filePath(QStringLiteral("view.png"));
    const QImage shown = view.picture(view.pixelSize(), false);
    write(path, view.pixelSize());
    QImage read = QImage(path).convertToFormat(QImage::Format_RGB888);
    read.setColorSpace({});  // the file says sRGB, a picture of the view says nothing
    QCOMPARE(read.size(), shown.size());
    // A view that stays is shaded from what it sees, another one triangle by triangle: rounding.
    int most = 0;
    for (int y = 0; y < read.height(); ++y) {
      for (int i = 0; i < 3 * read.width(); ++i) {
        most = std::max(most,
                        std::abs(int{read.constScanLine(y)[i]} - int{shown.constScanLine(y)[i]}));
      }
    }
    QVERIFY2(most <= 1, qPrintable(QString::number(most)));
    const auto facts = io::readMetadata(path.toStdString());
    QVERIFY(facts.ok());
    QVERIFY(std::ranges::find(*facts, std::pair(std::string("Layout"), std::string("Classic"))) !=
            facts->end());
  }

  void anySizeShowsTheSameView() {
    const QSize size = fixture_->view().pixelSize();
    const QString small = fixture_->folder.filePath(QStringLiteral("small.png"));
    const QString large = fixture_->folder.filePath(QStringLiteral("large.jpg"));
    write(small, size / 4);
    write(large, 2 * size);
    const QString tiff = fixture_->folder.filePath(QStringLiteral("view.tif"));
    write(tiff, {100, 60});
    QCOMPARE(io::readImage(tiff.toStdString())->width, 100);
    const QImage a(small);
    const QImage b =
        QImage(large).scaled(a.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    QCOMPARE(QImage(large).size(), 2 * size);
    // Mean code values: edges and JPEG differ, the light does not.
    QVERIFY(std::abs(meanOf(a) - meanOf(b)) < 1.0);
  }

  void anExrHoldsLuminance() {
    const QSize size(240, 150);
    const QString path = fixture_->folder.filePath(QStringLiteral("view.exr"));
    write(path, size);
    const auto read = io::readImage(path.toStdString());
    QVERIFY(read.ok());
    QCOMPARE(read->width, 240);
    // Through the view transform it is the tone-mapped picture, away from edges, where code values
    // are averaged instead of light.
    const Look& look = fixture_->view().look();
    const auto transform = color::DisplayTransform::create(look.display);
    std::vector<vec3> linear;
    for (std::size_t i = 0; i + 2 < read->pixels.size(); i += 3) {
      linear.emplace_back(read->pixels[i], read->pixels[i + 1], read->pixels[i + 2]);
    }
    std::vector<vec3> expected(linear.size());
    transform->apply(linear, look.exposure_ev, expected);
    Shot shot;
    shot.pixels = size;
    const QImage seen = fixture_->view().take(shot).image;
    int close = 0;
    for (int y = 0; y < 150; ++y) {
      for (int x = 0; x < 240; ++x) {
        const vec3& e = expected[static_cast<std::size_t>(y) * 240 + static_cast<std::size_t>(x)];
        const QColor s = seen.pixelColor(x, y);
        close += std::abs(s.green() - qRound(255 * e.y)) <= 2 ? 1 : 0;
      }
    }
    QVERIFY2(close > 0.93 * 240 * 150, qPrintable(QString::number(close)));
    const auto facts = io::readMetadata(path.toStdString());
    QVERIFY(std::ranges::find(*facts, std::pair(std::string("Unit"), std::string("cd/m2"))) !=
            facts->end());
  }

  void legendAndTitleArePrinted() {
    fixture_->window->workspace().view->setFalseColor(true);
    const QString with = fixture_->folder.filePath(QStringLiteral("with.png"));
    const QString without = fixture_->folder.filePath(QStringLiteral("without.png"));
    write(with, {800, 500}, true, true);
    write(without, {800, 500}, false, false);
    fixture_->window->workspace().view->setFalseColor(false);
    const QImage a(with);
    const QImage b(without);
    QVERIFY(differsIn(a, b, QRect(600, 0, 200, 500)));
    QVERIFY(differsIn(a, b, QRect(0, 400, 300, 100)));
    QVERIFY(!differsIn(a, b, QRect(300, 100, 200, 200)));
  }

  void theSetHasAPictureOfEachCameraAndLayout() {
    PictureSet set;
    set.cameras = {QStringLiteral("Classic"), QStringLiteral("Inside")};
    set.layouts = {QStringLiteral("Classic"), QStringLiteral("Light moved"),
                   QStringLiteral("Coloured")};
    set.pixels = {160, 100};
    set.folder = fixture_->folder.filePath(QStringLiteral("set"));
    set.title = true;
    QDir().mkpath(set.folder);
    QSignalSpy finished(&pictures(), &PictureExport::setFinished);
    pictures().exportSet(set);
    QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty() && !pictures().isBusy(), kPatienceMs);
    QCOMPARE(finished.front().front().toInt(), 6);
    QSet<QByteArray> different;
    for (const QString& layout : set.layouts) {
      for (const QString& camera : set.cameras) {
        const QString path =
            QDir(set.folder)
                .filePath(layout + QStringLiteral(", ") + camera + QStringLiteral(".png"));
        const QImage image(path);
        QCOMPARE(image.size(), set.pixels);
        different.insert(
            QByteArray(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes()));
      }
    }
    QCOMPARE(different.size(), 6);
    // The view is as it was.
    QCOMPARE(fixture_->document().layout(), QStringLiteral("Classic"));
  }

  void aTracedPictureIsTheSameViewInMoreDetail() {
    const QSize size = fixture_->view().pixelSize() / 3;
    const QString drawn = fixture_->folder.filePath(QStringLiteral("drawn.png"));
    const QString traced = fixture_->folder.filePath(QStringLiteral("traced.png"));
    write(drawn, size);
    write(traced, size, false, false, true);
    const QImage a = QImage(drawn).convertToFormat(QImage::Format_RGB888);
    const QImage b = QImage(traced).convertToFormat(QImage::Format_RGB888);
    QCOMPARE(b.size(), size);
    QVERIFY(a != b);
    // Direct light per pixel instead of per texel moves shadows' edges, not the light.
    QVERIFY2(std::abs(meanOf(a) - meanOf(b)) < 2.0,
             qPrintable(QStringLiteral("%1 %2").arg(meanOf(a)).arg(meanOf(b))));
    qsizetype close = 0;
    for (int y = 0; y < size.height(); ++y) {
      for (int x = 0; x < size.width(); ++x) {
        close += std::abs(qGreen(a.pixel(x, y)) - qGreen(b.pixel(x, y))) <= 8 ? 1 : 0;
      }
    }
    QVERIFY2(close > 0.85 * size.width() * size.height(), qPrintable(QString::number(close)));
  }

  void falseColoursAreNeverTraced() {
    fixture_->window->workspace().view->setFalseColor(true);
    const QString drawn = fixture_->folder.filePath(QStringLiteral("drawn lux.png"));
    const QString traced = fixture_->folder.filePath(QStringLiteral("traced lux.png"));
    write(drawn, {160, 100});
    write(traced, {160, 100}, false, false, true);
    fixture_->window->workspace().view->setFalseColor(false);
    QCOMPARE(QImage(traced), QImage(drawn));
  }

  void tracedPicturesOfASetHaveTheLightOfTheirLayouts() {
    PictureSet set;
    set.cameras = {QStringLiteral("Classic"), QStringLiteral("Inside")};
    set.layouts = {QStringLiteral("Classic"), QStringLiteral("Coloured")};
    set.pixels = {96, 60};
    set.format = QStringLiteral("exr");
    set.folder = fixture_->folder.filePath(QStringLiteral("traced"));
    set.traced = true;
    QDir().mkpath(set.folder);
    QSignalSpy finished(&pictures(), &PictureExport::setFinished);
    pictures().exportSet(set);
    QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty() && !pictures().isBusy(), kPatienceMs);
    QCOMPARE(finished.front().front().toInt(), 4);
    const auto redShare = [&](const char* layout) {
      const QString name = QString::fromLatin1(layout) + QStringLiteral(", Classic.exr");
      const auto read = io::readImage(QDir(set.folder).filePath(name).toStdString());
      double red = 0.0;
      double all = 0.0;
      for (std::size_t i = 0; read.ok() && i + 2 < read->pixels.size(); i += 3) {
        red += read->pixels[i];
        all += read->pixels[i] + read->pixels[i + 1] + read->pixels[i + 2];
      }
      return all > 0.0 ? red / all : 0.0;
    };
    QVERIFY(redShare("Classic") > 0.0 && redShare("Coloured") > 0.0);
    QVERIFY(std::abs(redShare("Classic") - redShare("Coloured")) > 0.01);
  }

  void aSetCanBeGivenUp() {
    PictureSet set;
    set.cameras = {QStringLiteral("Classic"), QStringLiteral("Inside")};
    set.layouts = {QStringLiteral("Classic")};
    set.pixels = {160, 100};
    set.folder = fixture_->folder.path();
    QSignalSpy finished(&pictures(), &PictureExport::setFinished);
    pictures().exportSet(set);
    pictures().cancel();
    QTRY_VERIFY(!finished.isEmpty());
    QVERIFY(finished.front().front().toInt() < 2);
  }

  void thePictureGoesIntoTheClipboard() {
    QSignalSpy copied(&pictures(), &PictureExport::copied);
    QVERIFY(fixture_->trigger(QStringLiteral("Cop&y the picture")));
    QTRY_VERIFY_WITH_TIMEOUT(!copied.isEmpty(), kPatienceMs);
    const SceneView& view = fixture_->view();
    QCOMPARE(QApplication::clipboard()->image().size(), view.pixelSize());
  }

  /// More than one piece each way, with lines that look at their neighbours.
  void aPictureInPiecesHasNoSeams() {
    fixture_->window->workspace().view->setIsolines(true);
    const QSize size(1400, 900);
    const QString path = fixture_->folder.filePath(QStringLiteral("pieces.png"));
    Shot shot;
    shot.pixels = size;
    const QImage whole = fixture_->view().take(shot).image;
    auto still = fixture_->view().still(shot);
    QVERIFY(still.has_value());
    StillRenderer renderer;
    const auto pieces = renderer.render(*still, {});
    fixture_->window->workspace().view->setIsolines(false);
    QVERIFY(pieces.ok());
    const QImage& image = pieces->image;
    QCOMPARE(image.size(), size);
    qsizetype unlike = 0;
    for (int y = 0; y < size.height(); ++y) {
      for (int i = 0; i < 3 * size.width(); ++i) {
        const int step = std::abs(int{image.constScanLine(y)[i]} - int{whole.constScanLine(y)[i]});
        unlike += step > 1 ? 1 : 0;
      }
    }
    // The viewport is cut off at other places: single pixels at edges may round otherwise.
    QVERIFY2(unlike < qsizetype{3} * size.width() * size.height() / 10000,
             qPrintable(QString::number(unlike)));
  }

  void aPictureIsOfTheMomentItWasAskedFor() {
    const QString before = fixture_->folder.filePath(QStringLiteral("before.png"));
    const QString during = fixture_->folder.filePath(QStringLiteral("during.png"));
    const QString after = fixture_->folder.filePath(QStringLiteral("after.png"));
    write(before, {800, 500});
    QSignalSpy written(&pictures(), &PictureExport::written);
    pictures().exportView(during, {800, 500}, false, false);
    QVERIFY(pictures().isBusy() && written.isEmpty());  // the window goes on
    fixture_->switchFirst();
    fixture_->view().setViewCamera(ViewCamera());
    QTRY_VERIFY_WITH_TIMEOUT(!written.isEmpty(), kPatienceMs);
    QVERIFY(fixture_->lit());
    write(after, {800, 500});
    fixture_->document().undoStack()->undo();
    fixture_->window->session()->showFirstCamera();
    QVERIFY(fixture_->lit());
    QCOMPARE(QImage(during), QImage(before));
    QVERIFY(QImage(after) != QImage(before));
  }

  void aLargePictureTellsItsProgressAndCanBeGivenUp() {
    const QString path = fixture_->folder.filePath(QStringLiteral("4k.png"));
    auto* cancel = fixture_->window->statusBar()->findChild<QToolButton*>();
    QVERIFY(cancel != nullptr && !cancel->isVisible());
    QSignalSpy written(&pictures(), &PictureExport::written);
    QSignalSpy failed(&pictures(), &PictureExport::failed);
    pictures().exportView(path, {3840, 2160}, false, false);
    QVERIFY(cancel->isVisible());
    auto* progress = fixture_->window->statusBar()->findChild<QProgressBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(progress->value() > 0, kPatienceMs);
    const int frames = fixture_->view().frameCount();
    fixture_->view().update();
    QTRY_VERIFY(fixture_->view().frameCount() > frames);
    QVERIFY(pictures().isBusy());
    cancel->click();
    QTRY_VERIFY(!pictures().isBusy());
    QVERIFY(!cancel->isVisible());
    QVERIFY(written.isEmpty() && failed.isEmpty() && !QFile::exists(path));
  }

  void aPlanIsExportedWithItsLines() {
    SceneView& view = fixture_->view();
    fixture_->window->workspace().area->active().show(StandardView::section_front);
    ViewCamera camera = view.viewCamera();
    camera.setCutPlace(camera.cutPlace() + 100.0);  // nothing but the outlines of luminaires
    view.setViewCamera(camera);
    Shot shot;
    shot.pixels = view.pixelSize();
    auto still = view.still(shot);
    QVERIFY(still.has_value());
    StillRenderer renderer;
    auto picture = renderer.render(*still, {});
    QVERIFY(picture.ok());
    QCOMPARE(meanOf(picture->image), 0.0);
    still->lines.push_back({{vec3(-1.0F, 0.0F, 1.0F), vec3(1.0F, 0.0F, 1.0F)}, vec3(1.0F), 2.0});
    paintMarks(*still, *picture);
    QVERIFY(meanOf(picture->image) > 0.0);
    fixture_->window->session()->showFirstCamera();
  }

  void aSetThatCannotBeWrittenIsToldOnce() {
    PictureSet set;
    set.cameras = {QStringLiteral("Classic"), QStringLiteral("Inside")};
    set.layouts = {QStringLiteral("Classic")};
    set.pixels = {64, 40};
    set.folder = fixture_->folder.filePath(QStringLiteral("no/where"));
    QSignalSpy failed(&pictures(), &PictureExport::failed);
    QSignalSpy finished(&pictures(), &PictureExport::setFinished);
    WindowFixture::answer(QMessageBox::Ok);
    pictures().exportSet(set);
    QTRY_VERIFY_WITH_TIMEOUT(!failed.isEmpty() && !pictures().isBusy(), kPatienceMs);
    QCOMPARE(failed.size(), 1);
    QCOMPARE(finished.size(), 1);
    QCOMPARE(finished.front().front().toInt(), 0);
    QVERIFY(failed.front().front().toString().contains(set.folder));
  }

  void aFolderThatIsNotThereIsTold() {
    QSignalSpy failed(&pictures(), &PictureExport::failed);
    WindowFixture::answer(QMessageBox::Ok);
    pictures().exportView(fixture_->folder.filePath(QStringLiteral("no/where/a.png")), {64, 40},
                          false, false);
    QTRY_VERIFY(!failed.isEmpty());
  }

  void theDialogStartsAsTheViewShowsIt() {
    PictureDialog dialog({800, 500});
    QVERIFY(!dialog.traced());
    dialog.setTraced(true);
    QVERIFY(dialog.traced());
  }

  void theDialogOffersSizesAndCounts() {
    PictureDialog dialog({800, 500}, {QStringLiteral("A"), QStringLiteral("B")},
                         {QString(), QStringLiteral("L")});
    QCOMPARE(dialog.pixels(), QSize(800, 500));
    // The base is left out where there are layouts.
    QCOMPARE(dialog.layouts(), QStringList{QStringLiteral("L")});
    QCOMPARE(dialog.cameras().size(), 2);
    for (auto* list : dialog.findChildren<QListWidget*>()) {
      for (int i = 0; i < list->count(); ++i) list->item(i)->setCheckState(Qt::Unchecked);
    }
    QVERIFY(!dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
  }

 private:
  PictureExport& pictures() { return fixture_->window->session()->pictures(); }
  void write(const QString& path, const QSize& size, bool legend = false, bool title = false,
             bool traced = false) {
    QSignalSpy written(&pictures(), &PictureExport::written);
    pictures().exportView(path, size, legend, title, traced);
    QTRY_VERIFY_WITH_TIMEOUT(!written.isEmpty(), kPatienceMs);
    QCOMPARE(written.front().front().toString(), path);
  }
  static double meanOf(const QImage& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
    }
    return sum / (image.width() * image.height());
  }
  static bool differsIn(const QImage& a, const QImage& b, const QRect& r) {
    return a.copy(r) != b.copy(r);
  }

  std::unique_ptr<WindowFixture> fixture_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::prepareProgram();
  QApplication application(argc, argv);
  soffit::ui::nameProgram(QStringLiteral("soffit-export-test"));
  soffit::ui::PictureExportTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "picture_export_test.moc"
