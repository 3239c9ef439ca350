// SPDX-License-Identifier: MIT
#include "ui/viewport/scene_view.h"

#include "core/render/picture.h"
#include "tests/ui/viewport/cornell_view.h"
#include "ui/viewport/picture_pass.h"

#include <QMainWindow>
#include <QSignalSpy>
#include <QSurfaceFormat>
#include <QTest>

namespace soffit::ui {

class SceneViewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { lit_ = std::make_unique<Lit>(lightCornell()); }

  void init() {
    document_ = std::make_unique<Document>(lit_->project);
    document_->setLayout({});
    view_ = std::make_unique<SceneView>();
    view_->resize(640, 400);
    view_->setScene(document_->scene());
    place();
    connect(document_.get(), &Document::sceneChanged, view_.get(), [this] { place(); });
    connect(document_.get(), &Document::selectionChanged, view_.get(),
            [this] { view_->setSelection(document_->selection()); });
    input_ = std::make_unique<ViewInput>(*view_);
    input_->setDocument(document_.get());
    view_->setViewCamera(ViewCamera::from(document_->scene()->cameras.front()));
    QVERIFY(view_->setLook({}).ok());
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get(), kExposedMs));
    QSignalSpy shown(view_.get(), &SceneView::lightShown);
    view_->setFrame(lit_->frame);
    QTRY_VERIFY_WITH_TIMEOUT(!shown.isEmpty(), 20000);
  }
  void cleanup() {
    input_.reset();
    view_.reset();
    document_.reset();
  }

  void everyViewEqualsTheOneOfPicturesWithinOneCodeValue_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<double>("bloom");
    QTest::addColumn<double>("white");
    for (const char* name :
         {"Filmic", "ACES", "sRGB", "Reinhard", "Reinhard 2002", "Tumblin-Rushmeier"}) {
      QTest::newRow(name) << QByteArray(name) << 0.0 << 0.0;
    }
    QTest::newRow("bloom") << QByteArray("Filmic") << 300.0 << 0.0;
    QTest::newRow("both") << QByteArray("Reinhard 2002") << 300.0 << 0.0;
    QTest::newRow("white") << QByteArray("Filmic") << 0.0 << 3000.0;
    QTest::newRow("all") << QByteArray("Reinhard 2002") << 300.0 << 4200.0;
  }
  void everyViewEqualsTheOneOfPicturesWithinOneCodeValue() {
    QFETCH(QByteArray, name);
    QFETCH(double, bloom);
    QFETCH(double, white);
    Look look;
    look.display.white_balance = white;
    look.display.view = name.toStdString();
    look.exposure_ev = 1.5;
    look.bloom = {.threshold = bloom, .strength = 0.3};
    QVERIFY(view_->setLook(look).ok());
    const QImage shown = view_->picture({640, 400}, false, 1);
    render::Film film(640, 400);
    film.radiance = view_->readLinear();
    QCOMPARE(film.radiance.size(), std::size_t{640 * 400});
    const auto finished = render::developPicture(film, {.display = look.display,
                                                        .exposure_ev = look.exposure_ev,
                                                        .adapted_to = view_->adaptation(),
                                                        .bloom = look.bloom});
    QVERIFY(finished.ok());
    const color::PictureLuminance whole = color::pictureLuminance(film.radiance);
    if (color::toneKindOf(look.display.view)) {
      // A part of the pixels tells the same.
      QVERIFY(std::abs(std::log2(view_->adaptation().log_average / whole.log_average)) < 0.02);
    }
    const auto* expected = reinterpret_cast<const vec3*>(finished->pixels.data());
    int most = 0;
    double sum = 0.0;
    for (int y = 0; y < 400; ++y) {
      const uchar* row = shown.constScanLine(399 - y);
      for (int x = 0; x < 640; ++x) {
        const vec3& e = expected[y * 640 + x];
        for (int c = 0; c < 3; ++c) {
          const int code = static_cast<int>(std::lround(255.0F * e[c]));
          most = std::max(most, std::abs(code - int{row[3 * x + c]}));
          sum += code;
        }
      }
    }
    QVERIFY2(most <= 1, qPrintable(QString::number(most)));
    QVERIFY2(sum / (3.0 * 640 * 400) > 20.0, "the picture is black");
  }

  void whatIsKnownOfAViewGivesTheSamePicture() {
    const auto draw = [&] {
      (void)view_->picture({640, 400}, false, 1);
      view_->makeCurrent();
      int width = 0;
      int height = 0;
      std::vector<float> out = view_->pass().readLinear(width, height);
      view_->doneCurrent();
      return out;
    };
    const ViewCamera camera = view_->viewCamera();
    ViewCamera other = camera;
    other.position += dvec3(0.01, 0.0, 0.0);
    view_->setViewCamera(other);
    (void)draw();
    view_->setViewCamera(camera);
    const std::vector<float> by_triangles = draw();
    (void)draw();
    const std::vector<float> by_pixels = draw();
    QCOMPARE(by_pixels.size(), by_triangles.size());
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < by_pixels.size(); ++i) {
      const float most = 2e-3F * std::abs(by_triangles[i]) + 1e-3F;
      unlike += std::abs(by_pixels[i] - by_triangles[i]) > most ? 1 : 0;
    }
    // Where a triangle is thinner than a pixel its weights are anyone's guess.
    QVERIFY2(unlike < by_pixels.size() / 1000, qPrintable(QString::number(unlike)));
  }

  /// A model was imported or its import undone while the light of the other building was under
  /// way.
  void lightOfAnotherBuildingIsNotShown() {
    view_->setLuminaires(nullptr);
    view_->setScene(nullptr);
    QSignalSpy cut(view_.get(), &SceneView::meshChanged);
    view_->setFrame(lit_->frame);
    QCOMPARE(view_->frame(), LightFramePtr());
    view_->setScene(document_->scene());
    view_->setFrame(lit_->frame);
    QCOMPARE(view_->frame(), lit_->frame);
    auto other = std::make_shared<scene::Scene>(*document_->scene());
    other->mesh = std::make_shared<const geometry::Mesh>(*other->mesh);
    view_->setScene(other);
    view_->setFrame(lit_->frame);
    QCOMPARE(view_->frame(), LightFramePtr());
    QTest::qWait(200);
    QVERIFY(cut.isEmpty());
  }

  void falseColoursEqualTheMapWithinOneCodeValue() {
    Look look;
    look.false_color = true;
    look.scale.range = {0.0, 400.0, false};
    QVERIFY(view_->setLook(look).ok());
    const QImage shown = view_->picture({640, 400}, false, 1);
    view_->makeCurrent();
    int width = 0;
    int height = 0;
    const std::vector<float> linear = view_->pass().readLinear(width, height);
    view_->doneCurrent();
    int most = 0;
    int surfaces = 0;
    for (int i = 0; i < 640 * 400; ++i) {
      const float lux = linear[4 * static_cast<std::size_t>(i) + 3];
      if (lux < 0.0F) continue;
      ++surfaces;
      const vec3 e = look.scale.color(lux);
      const uchar* p = shown.constScanLine(399 - i / 640) + 3 * (i % 640);
      for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(static_cast<int>(std::lround(255.0F * e[c])) - int{p[c]}));
    }
    QVERIFY2(most <= 1, qPrintable(QString::number(most)));
    QVERIFY(surfaces > 640 * 400 / 4);
  }

  /// Lines run where the light takes their level, all of it, and are as wide everywhere.
  void isoluxLinesLieOnTheirLevels() {
    Look look;
    look.false_color = true;
    look.scale.range = {0.0, 400.0, false};
    QVERIFY(view_->setLook(look).ok());
    const QImage plain = view_->picture({640, 400}, false, 1);
    look.levels = {60.0, 120.0, 240.0};
    QVERIFY(view_->setLook(look).ok());
    const QImage lined = view_->picture({640, 400}, false, 1);
    const render::LuxPicture light = view_->readLux();
    QCOMPARE(light.width, 640);
    const auto lux = [&](int x, int y) { return light.lux[static_cast<std::size_t>(y * 640 + x)]; };
    const auto inked = [&](int x, int y) {
      const QRgb a = plain.pixel(x, y);
      const QRgb b = lined.pixel(x, y);
      return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) +
                 std::abs(qBlue(a) - qBlue(b)) >
             60;
    };
    int ink = 0;
    int stray = 0;
    int crossings = 0;
    int missed = 0;
    for (int y = 3; y < 397; ++y) {
      for (int x = 3; x < 637; ++x) {
        if (lux(x, y) < 0.0F) continue;
        bool near = false;
        for (int v = -2; v <= 2; ++v) {
          for (int u = -2; u <= 2; ++u) {
            for (const double level : look.levels) {
              near = near || (static_cast<double>(lux(x, y)) < level) !=
                                 (static_cast<double>(lux(x + u, y + v)) < level);
            }
          }
        }
        ink += inked(x, y) ? 1 : 0;
        stray += inked(x, y) && !near ? 1 : 0;
        // A gentle slope through a level, on one surface.
        const float slope = lux(x + 1, y) - lux(x, y);
        const float more = lux(x + 2, y) - lux(x - 1, y);
        if (std::abs(slope) > 4.0F || std::abs(more - 3.0F * slope) > 0.5F * std::abs(slope))
          continue;
        for (const double level : look.levels) {
          if ((static_cast<double>(lux(x, y)) < level) ==
              (static_cast<double>(lux(x + 1, y)) < level))
            continue;
          ++crossings;
          missed += inked(x, y) || inked(x + 1, y) ? 0 : 1;
        }
      }
    }
    QVERIFY2(ink > 300, qPrintable(QString::number(ink)));
    QVERIFY2(crossings > 50, qPrintable(QString::number(crossings)));
    // Kinks of the mesh, where slopes are guessed.
    QVERIFY2(stray < ink / 50, qPrintable(QString::number(stray)));
    QVERIFY2(missed < crossings / 20, qPrintable(QString::number(missed)));
  }

  void stepsAndColoursEqualTheScalesWithinOneCodeValue() {
    Look look;
    look.false_color = true;
    look.scale = {.range = {0.0, 400.0, false}, .map = color::ColorMap::spectrum, .steps = 8};
    QVERIFY(view_->setLook(look).ok());
    const QImage shown = view_->picture({640, 400}, false, 1);
    const render::LuxPicture light = view_->readLux();
    int unlike = 0;
    int surfaces = 0;
    for (int i = 0; i < 640 * 400; ++i) {
      const float lux = light.lux[static_cast<std::size_t>(i)];
      if (lux < 0.0F) continue;
      ++surfaces;
      const vec3 e = look.scale.color(lux);
      const uchar* p = shown.constScanLine(i / 640) + 3 * (i % 640);
      int most = 0;
      for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(static_cast<int>(std::lround(255.0F * e[c])) - int{p[c]}));
      unlike += most > 1 ? 1 : 0;
    }
    // A value on the border of a step may fall to either side by rounding.
    QVERIFY2(unlike < surfaces / 2000, qPrintable(QString::number(unlike)));
  }

  void theCursorReadsWhatIsShown() {
    const QPointF mouse(320.5, 300.5);
    const PointedAt at = view_->pointAt(mouse);
    QVERIFY(at.surface.has_value());
    QVERIFY(at.surface->lux > 1.0);
    (void)view_->picture({640, 400}, false, 1);
    view_->makeCurrent();
    int width = 0;
    int height = 0;
    const auto linear = view_->pass().readLinear(width, height);
    view_->doneCurrent();
    const float lux = linear[4 * static_cast<std::size_t>((399 - 300) * 640 + 320) + 3];
    // Bilinear against linear in triangles: within the bend of the light in one cell.
    QVERIFY(std::abs(static_cast<double>(lux) - at.surface->lux) < 0.05 * at.surface->lux);
  }

  void aClickSelectsTheLuminaireAndAnotherNothing() {
    const QPoint lamp = pixelOf(document_->luminaires().front().position);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, lamp);
    QCOMPARE(document_->selection(),
             QStringList{QString::fromStdString(document_->luminaires().front().name)});
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, QPoint(320, 330));
    QVERIFY(document_->selection().isEmpty());
  }

  void draggingALuminaireMovesItInItsPlaneAsOneStep() {
    const light::Luminaire before = document_->luminaires().front();
    const dvec3 wanted = before.position + dvec3(0.4, 0.3, 0.0);
    drag(pixelOf(before.position), pixelOf(wanted));
    const light::Luminaire& after = document_->luminaires().front();
    const double pixel = view_->viewCamera().pixelSize(6.0, view_->viewSize());
    QVERIFY(std::abs(after.position.z - before.position.z) < 1e-9);
    QVERIFY(glm::length(dvec2(after.position) - dvec2(wanted)) < 12.0 * pixel);
    QCOMPARE(document_->undoStack()->count(), 1);
    document_->undoStack()->undo();
    QVERIFY(glm::length(document_->luminaires().front().position - before.position) < 1e-12);
  }

  void draggingAnArrowMovesAlongItsAxis() {
    const light::Luminaire before = document_->luminaires().front();
    document_->setSelection({QString::fromStdString(before.name)});
    const double length =
        Gizmo::arrowLength(before.position, view_->viewCamera(), view_->viewSize());
    const dvec3 grip = before.position - dvec3(0, 0, 0) + 0.8 * length * axisOf(0);
    QCOMPARE(view_->gizmoPartAt(pixelOf(grip)), GizmoPart::x);
    drag(pixelOf(grip), pixelOf(grip + 0.5 * axisOf(0)));
    const light::Luminaire& after = document_->luminaires().front();
    QVERIFY(after.position.x > before.position.x + 0.2);
    QCOMPARE(after.position.y, before.position.y);
    QCOMPARE(after.position.z, before.position.z);
  }

  void escapeGivesADragUp() {
    const light::Luminaire before = document_->luminaires().front();
    const QPoint from = pixelOf(before.position);
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) QTest::mouseMove(view_.get(), from + QPoint(3 * i, 0));
    QVERIFY(document_->previewing());
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, from + QPoint(30, 0));
    QCOMPARE(document_->undoStack()->count(), 0);
    QVERIFY(glm::length(document_->luminaires().front().position - before.position) < 1e-12);
  }

  void orbitLeavesTheDocumentAlone() {
    const dvec3 before = view_->viewCamera().position;
    drag({320, 330}, {380, 340});
    QVERIFY(glm::length(view_->viewCamera().position - before) > 0.05);
    QCOMPARE(document_->undoStack()->count(), 0);
  }

  void theViewOutlivesDockingElsewhere() {
    QMainWindow window;
    window.resize(500, 400);
    window.setCentralWidget(view_.get());
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window, kExposedMs));
    const int before = view_->frameCount();
    view_->update();
    QTRY_VERIFY(view_->frameCount() > before);
    QVERIFY(meanOf(view_->grabFramebuffer()) > 10.0);
    view_->setParent(nullptr);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get(), kExposedMs));
    view_->update();
    QTRY_VERIFY(meanOf(view_->grabFramebuffer()) > 10.0);
  }

 private:
  void place() {
    view_->setScene(document_->scene());
    view_->setLuminaires(std::make_shared<const EmitterSet>(document_->luminaires(),
                                                            document_->scene()->mesh->origin));
  }
  [[nodiscard]] QPoint pixelOf(const dvec3& p) const {
    const dvec3 at = view_->viewCamera().project(p, view_->viewSize());
    return {static_cast<int>(at.x), static_cast<int>(at.y)};
  }
  void drag(const QPoint& from, const QPoint& to) {
    constexpr int kSteps = 12;
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= kSteps; ++i)
      QTest::mouseMove(view_.get(), from + (to - from) * i / kSteps);
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, to);
  }
  static double meanOf(const QImage& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
    }
    return sum / std::max(1, image.width() * image.height());
  }

  std::unique_ptr<Lit> lit_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<SceneView> view_;
  std::unique_ptr<ViewInput> input_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::wantOpenGl();
  QApplication application(argc, argv);
  soffit::ui::SceneViewTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "scene_view_test.moc"

#include <algorithm>
