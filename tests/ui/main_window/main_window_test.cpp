// SPDX-License-Identifier: MIT
#include "ui/main_window/main_window.h"

#include "core/io/image/read_image.h"
#include "ui/actions/file_dialogs.h"
#include "ui/actions/key_bindings.h"
#include "ui/document/material_edits.h"
#include "ui/document/mixing.h"
#include "ui/document/recent_files.h"
#include "ui/panels/array_bar.h"
#include "ui/widgets/theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUndoView>

#include <algorithm>
#include <cmath>

namespace soffit::ui {

constexpr int kPatienceMs = 180000;

class MainWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    const QString source = QStringLiteral(SOFFIT_SOURCE_DIR "/projects/cornell/");
    for (const char* ending : {"obj", "mtl"}) {
      const QString name = QStringLiteral("cornell.") + QString::fromLatin1(ending);
      QVERIFY(QFile::copy(source + name, folder_.filePath(name)));
    }
    qputenv("XDG_STATE_HOME", folder_.filePath(QStringLiteral("state")).toUtf8());
    qputenv("SOFFIT_CACHE", folder_.filePath(QStringLiteral("cache")).toUtf8());
  }

  void init() {
    // Few texels: the tests are about the window.
    QFile original(QStringLiteral(SOFFIT_SOURCE_DIR "/projects/cornell/cornell.soffit"));
    QVERIFY(original.open(QIODevice::ReadOnly));
    QByteArray text = original.readAll();
    text.replace("\"quality\": \"interactive\"",
                 "\"quality\": {\"preset\": \"draft\", \"texels\": 1500, \"trainings\": 8}");
    project_ = folder_.filePath(QStringLiteral("cornell.soffit"));
    QFile copy(project_);
    QVERIFY(copy.open(QIODevice::WriteOnly | QIODevice::Truncate));
    copy.write(text);
    copy.close();
    window_ = std::make_unique<MainWindow>();
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), kPatienceMs));
    window_->activateWindow();  // no window manager does; shortcuts want it
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    window_->open(project_);
    QTRY_VERIFY_WITH_TIMEOUT(window_->session() != nullptr, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(lit(), kPatienceMs);
  }
  void cleanup() { window_.reset(); }

  void presetsNameCommandsThatThereAre() {
    KeyBindings& keys = window_->keys();
    keys.setPreset(QStringLiteral("Blender"));
    QCOMPARE(keys.keys(QStringLiteral("Edit/Move")), QKeySequence(Qt::Key_G));
    for (const QString& preset : KeyBindings::presets()) {
      for (const QString& id : KeyBindings::commandsOfPreset(preset)) {
        const auto& all = keys.commands();
        QVERIFY2(std::any_of(all.begin(), all.end(), [&](const Command& c) { return c.id == id; }),
                 qPrintable(preset + QStringLiteral(": ") + id));
      }
    }
    keys.setPreset(QStringLiteral("Soffit"));
    QCOMPARE(keys.keys(QStringLiteral("Edit/Move")), QKeySequence(Qt::Key_W));
  }

  void theProjectIsRemembered() {
    QVERIFY(recentFiles().contains(QFileInfo(project_).absoluteFilePath()));
  }

  void selectionInTheListIsSelectionInTheView() {
    auto* table = window_->workspace().lights->findChild<QTableView*>();
    table->selectRow(0);
    QCOMPARE(document().selection().size(), 1);
    document().setSelection({});
    QVERIFY(table->selectionModel()->selectedRows().isEmpty());
  }

  void duplicateDeleteAndSwitchAreUndone() {
    const std::size_t count = document().luminaires().size();
    selectFirst();
    trigger(QStringLiteral("&Duplicate"));
    QCOMPARE(document().luminaires().size(), count + 1);
    trigger(QStringLiteral("De&lete"));
    QCOMPARE(document().luminaires().size(), count);
    selectFirst();
    trigger(QStringLiteral("Switch &on or off"));
    QVERIFY(!document().luminaires().front().on);
    while (document().undoStack()->canUndo()) document().undoStack()->undo();
    QCOMPARE(document().luminaires().size(), count);
    QVERIFY(document().luminaires().front().on);
  }

  void theHistoryGoesBackToAnyStep() {
    auto* history = window_->findChild<QUndoView*>();
    QVERIFY(history != nullptr);
    const std::size_t count = document().luminaires().size();
    QCOMPARE(history->model()->rowCount(), 1);  // as it was opened
    for (int i = 0; i < 3; ++i) {
      selectFirst();
      trigger(QStringLiteral("&Duplicate"));
    }
    QCOMPARE(history->model()->rowCount(), 4);
    history->setCurrentIndex(history->model()->index(1, 0));
    QCOMPARE(document().luminaires().size(), count + 1);
    history->setCurrentIndex(history->model()->index(0, 0));
    QCOMPARE(document().luminaires().size(), count);
    history->setCurrentIndex(history->model()->index(3, 0));
    QCOMPARE(document().luminaires().size(), count + 3);
    while (document().undoStack()->canUndo()) document().undoStack()->undo();
  }

  void layoutsAreDuplicatedAndChosen() {
    const QString before = document().layout();
    window_->workspace().layouts->duplicateShown();
    QVERIFY(document().layout() != before);
    document().undoStack()->undo();
    QCOMPARE(document().scene()->layouts.size(), std::size_t{3});
  }

  void falseColoursComeAndGo() {
    trigger(QStringLiteral("&False colours"));
    QVERIFY(window_->workspace().area->view().look().false_color);
    QVERIFY(window_->workspace().area->findChild<Legend*>()->isVisible());
    trigger(QStringLiteral("&False colours"));
    QVERIFY(!window_->workspace().area->view().look().false_color);
  }

  void unsavedChangesAreAskedAbout() {
    selectFirst();
    trigger(QStringLiteral("Switch &on or off"));
    QVERIFY(window_->isWindowModified());
    answer(QMessageBox::Cancel);
    QVERIFY(!window_->close());
    QVERIFY(window_->session() != nullptr);
    answer(QMessageBox::Save);
    QVERIFY(window_->close());
    const auto saved = io::loadProject(project_.toStdString());
    QVERIFY(saved.ok());
    const scene::Layout& layout = saved->scene.layouts.front();
    QCOMPARE(layout.edits.size(), std::size_t{1});
  }

  void savingCleansTheTitle() {
    selectFirst();
    trigger(QStringLiteral("Switch &on or off"));
    trigger(QStringLiteral("&Save"));
    QVERIFY(!window_->isWindowModified());
    document().undoStack()->undo();
    QVERIFY(window_->isWindowModified());
    trigger(QStringLiteral("&Save"));
  }

  void aFileThatIsNoneIsToldAndTheStartPageStays() {
    QTimer::singleShot(500, this, [] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      QVERIFY(box != nullptr);
      box->accept();
    });
    window_->open(folder_.filePath(QStringLiteral("none.soffit")));
    QTest::qWait(1500);
    QVERIFY(window_->session() == nullptr);
  }

  void scenesAreStoredAndRecalledByTheirKeys() {
    trigger(QStringLiteral("Store scene 1"));
    const QString group = groupsOf(document()).front().name;
    setGroupLevel(document(), group, 0.25);
    QTRY_VERIFY_WITH_TIMEOUT(window_->session()->relighting().isCurrent(), kPatienceMs);
    const double dimmed = meanLux();
    QTest::keyClick(&window_->workspace().area->view(), Qt::Key_1);
    QCOMPARE(document().luminaires().front().dimming, 1.0);
    QTRY_VERIFY_WITH_TIMEOUT(window_->session()->relighting().isCurrent(), kPatienceMs);
    QVERIFY(std::abs(meanLux() / dimmed - 4.0) < 1e-3);  // single precision over all texels
  }

  void aReflectanceFollowsWithoutABake() {
    const auto before = window_->session()->relighting().frame();
    const double lux = meanLux();
    for (const scene::Material& m : std::vector(document().scene()->materials)) {
      editMaterial(document(), QStringLiteral("Change reflectance"), m.name,
                   [](const scene::Material& x) { return withReflectance(x, 0.1); });
    }
    QTRY_VERIFY_WITH_TIMEOUT(window_->session()->relighting().isCurrent(), kPatienceMs);
    const auto after = window_->session()->relighting().frame();
    QCOMPARE(&after->solver->operators(), &before->solver->operators());
    QVERIFY(meanLux() < 0.9 * lux);
    document().undoStack()->undo();
  }

  void keysChooseTheGizmosTool() {
    SceneView& view = window_->workspace().area->view();
    QTest::keyClick(&view, Qt::Key_E);
    QCOMPARE(view.gizmoTool(), GizmoTool::rotate);
    QTest::keyClick(&view, Qt::Key_W);
    QCOMPARE(view.gizmoTool(), GizmoTool::move);
  }

  void anArrayHasItsNumbersOverTheView() {
    selectFirst();
    trigger(QStringLiteral("&Rectangle"));
    auto* bar = window_->workspace().area->findChild<ArrayBar*>();
    QVERIFY(bar != nullptr && bar->isVisible());
    QVERIFY(document().previewing());
    QTest::keyClick(&window_->workspace().area->view(), Qt::Key_Escape);
    QVERIFY(!document().previewing());
    QTRY_VERIFY(window_->workspace().area->findChild<ArrayBar*>() == nullptr);
    QCOMPARE(document().undoStack()->count(), 0);
  }

  void aClickOnASurfaceChoosesItsMaterial() {
    SceneView& view = window_->workspace().area->view();
    const QPoint at(view.width() / 2, view.height() - 20);
    const auto pointed = view.pointAt(at);
    QVERIFY(pointed.surface.has_value() && pointed.luminaire.empty());
    QTest::mouseClick(&view, Qt::LeftButton, {}, at);
    QCOMPARE(window_->workspace().materials->chosen().toStdString(), pointed.surface->material);
  }

  void bothThemesCanBeWorn() {
    applyTheme(Theme::dark);
    QVERIFY(QApplication::palette().color(QPalette::Window).lightness() < 128);
    applyTheme(Theme::light);
    QVERIFY(QApplication::palette().color(QPalette::Window).lightness() > 128);
    // What is selected can be read: 4.5 to 1 (WCAG 2.1, AA).
    const auto luminance = [](const QColor& c) {
      const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
      };
      return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
    };
    for (const Theme theme : {Theme::dark, Theme::light}) {
      applyTheme(theme);
      const double text = luminance(QApplication::palette().color(QPalette::HighlightedText));
      const double ground = luminance(QApplication::palette().color(QPalette::Highlight));
      QVERIFY((std::max(text, ground) + 0.05) / (std::min(text, ground) + 0.05) >= 4.5);
    }
  }

 private:
  Document& document() { return window_->session()->document(); }
  [[nodiscard]] bool lit() {
    return window_->session() != nullptr && window_->session()->relighting().isCurrent() &&
           window_->workspace().area->view().frame() != nullptr &&
           !window_->workspace().area->view().readLinear().empty();
  }
  double meanLux() {
    const auto& lux = window_->session()->relighting().frame()->lux[1];
    double sum = 0.0;
    for (const float e : lux) sum += static_cast<double>(e);
    return sum / static_cast<double>(lux.size());
  }
  void selectFirst() {
    document().setSelection({QString::fromStdString(document().luminaires().front().name)});
  }
  void trigger(const QString& text) {
    for (QAction* action : window_->findChildren<QAction*>()) {
      if (action->text() != text) continue;
      QVERIFY(action->isEnabled());
      action->trigger();
      return;
    }
    QFAIL(qPrintable(QStringLiteral("no action ") + text));
  }
  void answer(QMessageBox::StandardButton button) {
    QTimer::singleShot(200, this, [button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      QVERIFY(box != nullptr);
      box->button(button)->click();
    });
  }

  QTemporaryDir folder_;
  QString project_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);
  QSurfaceFormat::setDefaultFormat(format);
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("soffit-test"));
  QApplication::setApplicationName(QStringLiteral("soffit-test"));
  QSettings().clear();
  soffit::ui::MainWindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "main_window_test.moc"
