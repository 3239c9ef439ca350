// SPDX-License-Identifier: MIT
#include "ui/main_window/comparison_session.h"

#include "core/color/luminance.h"
#include "core/render/difference_picture.h"
#include "tests/ui/main_window/window_fixture.h"
#include "ui/viewport/difference_light.h"
#include "ui/viewport/picture_pass.h"

#include <QComboBox>
#include <QListWidget>
#include <QTableView>

namespace soffit::ui {

class ComparisonTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { fixture_ = std::make_unique<WindowFixture>(); }
  void cleanupTestCase() { fixture_.reset(); }
  void init() { QVERIFY(fixture_->open()); }
  void cleanup() { fixture_->window.reset(); }

  void theSecondPictureIsTheOtherLayoutInTheSameView() {
    start(ComparisonMode::side_by_side);
    QCOMPARE(comparison().other(), QStringLiteral("Light moved"));
    QCOMPARE(second().size(), fixture_->view().size());
    const QSize pixels = second().pixelSize();
    const QImage compared = pictureOf(second(), pixels);
    comparison().setMode(ComparisonMode::off);
    fixture_->document().setLayout(QStringLiteral("Light moved"));
    QVERIFY(fixture_->lit());
    const QImage alone = pictureOf(fixture_->view(), pixels);
    // Sums of the same columns: the same code values but for rounding.
    QVERIFY2(mostDifference(compared, alone) <= 1,
             qPrintable(QString::number(mostDifference(compared, alone))));
  }

  void cameraAndExposureGoTogether() {
    start(ComparisonMode::split);
    ViewCamera camera = fixture_->view().viewCamera();
    camera.position.x += 0.3;
    fixture_->view().setViewCamera(camera);
    QCOMPARE(second().viewCamera().position.x, camera.position.x);
    fixture_->window->workspace().view->stepExposure(1.0);
    QCOMPARE(second().look().exposure_ev, fixture_->view().look().exposure_ev);
    fixture_->window->workspace().view->setFalseColor(true);
    QVERIFY(second().look().false_color);
  }

  void theSliderDividesThePicture() {
    start(ComparisonMode::split);
    ViewArea& area = *fixture_->window->workspace().area;
    auto* slider = area.findChild<QWidget*>(QStringLiteral("split_slider"));
    QVERIFY(slider->isVisible());
    const QPoint middle = slider->rect().center();
    QTest::mousePress(slider, Qt::LeftButton, {}, middle);
    QMouseEvent move(QEvent::MouseMove, QPointF(middle) - QPointF(120, 0),
                     slider->mapToGlobal(QPointF(middle) - QPointF(120, 0)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(slider, &move);
    const double expected = 0.5 - 120.0 / area.width();
    QVERIFY(std::abs(area.comparison().split() - expected) < 2.0 / area.width());
    QWidget* clip = second().parentWidget();
    QVERIFY(std::abs(clip->x() - expected * area.width()) < 2.0);
    // The same place of the picture lies at the same place of the window.
    QCOMPARE(second().mapTo(&area, QPoint(0, 0)), QPoint(0, 0));
  }

  void aDifferenceIsInLuxOnASymmetricScale() {
    start(ComparisonMode::difference);
    const LightFramePtr a = fixture_->window->session()->relighting().frame();
    const LightFramePtr b = comparison().lights().frame(comparison().other());
    QTRY_VERIFY(second().look().difference);
    QCOMPARE(second().look().scale.range.max, 2.0 * fittingDifference(*a, *b));
    // Wide enough that nothing is cut: what is cut at a vertex shows in the pixels around it.
    double range = 1.0;
    for (std::size_t s = 0; s < a->lux[1].size(); ++s) {
      for (std::size_t c = 0; c < 3; ++c) {
        range = std::max(range, std::abs(double{b->lux[c][s]} - double{a->lux[c][s]}));
      }
    }
    Q_EMIT fixture_->window->workspace().area->comparison().bar().rangeChosen(range);
    QCOMPARE(second().look().scale.range.max, 2.0 * range);
    const QImage shown = pictureOf(second(), {320, 200});
    // The same view of both, read as lux.
    const auto lux_a = luxOf(fixture_->view(), a, second().luminaires());
    const auto lux_b = luxOf(fixture_->view(), b, second().luminaires());
    int most = 0;
    int colored = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 320; ++x) {
        const auto i = static_cast<std::size_t>(199 - y) * 320 + static_cast<std::size_t>(x);
        if (lux_a[i] < 0.0F || lux_b[i] < 0.0F) continue;
        const vec3 expected =
            render::differenceColor((lux_b[i] - lux_a[i]) / static_cast<float>(range));
        const QColor found = shown.pixelColor(x, y);
        most = std::max(most, std::abs(found.red() - qRound(255 * expected.x)));
        most = std::max(most, std::abs(found.blue() - qRound(255 * expected.z)));
        ++colored;
      }
    }
    QVERIFY(colored > 10000);
    QVERIFY2(most <= 1, qPrintable(QString::number(most)));
    QVERIFY(fixture_->window->workspace().area->findChild<Legend*>()->isVisible());
  }

  void blinkShowsOneAfterTheOther() {
    start(ComparisonMode::blink);
    ComparisonView& view = fixture_->window->workspace().area->comparison();
    const bool first = view.showsSecond();
    QTRY_VERIFY(view.showsSecond() != first);
    QTRY_VERIFY(view.showsSecond() == first);
    QVERIFY(fixture_->trigger(QStringLiteral("Bl&ink")));
    QVERIFY(comparison().mode() == ComparisonMode::off);
    QVERIFY(!view.showsSecond());
  }

  void swappingAndGoingToTheOtherKeepThePair() {
    start(ComparisonMode::split);
    comparison().swap();
    QCOMPARE(fixture_->document().layout(), QStringLiteral("Light moved"));
    QCOMPARE(comparison().other(), QStringLiteral("Classic"));
    fixture_->document().setLayout(QStringLiteral("Classic"));
    QCOMPARE(comparison().other(), QStringLiteral("Light moved"));
  }

  void theTableShowsTheDifferences() {
    start(ComparisonMode::side_by_side);
    auto* table = fixture_->window->workspace().results->findChild<QTableView*>(
        QStringLiteral("differences"));
    QTRY_VERIFY_WITH_TIMEOUT(table->model()->rowCount() >= 9, kPatienceMs);
    QCOMPARE(table->model()->headerData(DifferenceModel::kSecond, Qt::Horizontal).toString(),
             QStringLiteral("Light moved"));
    const auto value = [&](int column) {
      return table->model()
          ->index(0, column)
          .data()
          .toString()
          .replace(QChar(0x2212), QLatin1Char('-'))
          .toDouble();
    };
    QVERIFY(std::abs(value(DifferenceModel::kSecond) - value(DifferenceModel::kFirst) -
                     value(DifferenceModel::kDifference)) < 0.11);
  }

  void everyLayoutGetsItsThumbnail() {
    auto* list = fixture_->window->workspace().layouts->findChild<QListWidget*>();
    QTRY_VERIFY_WITH_TIMEOUT(list->count() == 4 && coloursOf(*list->item(1)) > 8 &&
                                 coloursOf(*list->item(2)) > 8 && coloursOf(*list->item(3)) > 8,
                             kPatienceMs);
  }

  void theComparisonEndsWithItsProjectAndItsLastLayout() {
    start(ComparisonMode::split);
    QVERIFY(fixture_->trigger(QStringLiteral("&Close project")));
    QVERIFY(fixture_->window->workspace().area->comparison().mode() == ComparisonMode::off);
  }

 private:
  ComparisonSession& comparison() { return fixture_->window->session()->comparison(); }
  SceneView& second() { return fixture_->window->workspace().area->comparison().second(); }
  void start(ComparisonMode mode) {
    comparison().setMode(mode);
    QVERIFY(comparison().mode() == mode);
    QTRY_VERIFY_WITH_TIMEOUT(comparison().isCurrent(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(second().frame() != nullptr && second().meshSolver() != nullptr,
                             kPatienceMs);
    QTRY_VERIFY(second().frameCount() > 0);
  }
  static QImage pictureOf(SceneView& view, const QSize& pixels) {
    Shot shot;
    shot.pixels = pixels;
    shot.samples = 1;
    return view.take(shot).image;
  }
  static int mostDifference(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return 255;
    int most = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int i = 0; i < 3 * a.width(); ++i) {
        most = std::max(most, std::abs(int{a.constScanLine(y)[i]} - int{b.constScanLine(y)[i]}));
      }
    }
    return most;
  }
  /// Lux per pixel, the bottom row first; negative where no surface is.
  static std::vector<float> luxOf(SceneView& view, const LightFramePtr& frame,
                                  const std::shared_ptr<const EmitterSet>& luminaires) {
    Shot shot;
    shot.pixels = {320, 200};
    shot.frame = frame;
    shot.luminaires = luminaires;
    shot.samples = 1;
    (void)view.take(shot);
    view.makeCurrent();
    int width = 0;
    int height = 0;
    const auto pixels = view.pass().readLinear(width, height);
    view.doneCurrent();
    std::vector<float> lux;
    for (std::size_t i = 3; i < pixels.size(); i += 4) lux.push_back(pixels[i]);
    return lux;
  }
  static int coloursOf(const QListWidgetItem& item) {
    const QImage image = item.icon().pixmap(72, 45).toImage();
    QSet<QRgb> colours;
    for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, image.height() / 2));
    return static_cast<int>(colours.size());
  }

  std::unique_ptr<WindowFixture> fixture_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::prepareProgram();
  QApplication application(argc, argv);
  soffit::ui::nameProgram(QStringLiteral("soffit-comparison-test"));
  soffit::ui::ComparisonTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "comparison_test.moc"

#include <algorithm>
