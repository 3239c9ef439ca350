// SPDX-License-Identifier: MIT
#pragma once

#include "ui/main_window/main_window.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <memory>

/// A window with a small project in a folder of its own, for tests of the whole.
namespace soffit::ui {

constexpr int kPatienceMs = 180000;

/// As application.cpp sets up a program with views; before the QApplication.
inline void prepareProgram() {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);
  QSurfaceFormat::setDefaultFormat(format);
  QStandardPaths::setTestModeEnabled(true);
}

inline void nameProgram(const QString& name) {
  QApplication::setOrganizationName(QStringLiteral("soffit-test"));
  QApplication::setApplicationName(name);
  QSettings().clear();
}

class WindowFixture {
 public:
  WindowFixture() {
    const QString source = QStringLiteral(SOFFIT_SOURCE_DIR "/projects/cornell/");
    for (const char* ending : {"obj", "mtl"}) {
      const QString name = QStringLiteral("cornell.") + QString::fromLatin1(ending);
      QFile::copy(source + name, folder.filePath(name));
    }
    qputenv("SOFFIT_CACHE", folder.filePath(QStringLiteral("cache")).toUtf8());
    qputenv("XDG_STATE_HOME", folder.filePath(QStringLiteral("state")).toUtf8());
    QFile original(source + QStringLiteral("cornell.soffit"));
    original.open(QIODevice::ReadOnly);
    text = original.readAll();
    // Few texels: the tests are about the window.
    text.replace("\"quality\": \"interactive\"",
                 "\"quality\": {\"preset\": \"draft\", \"texels\": 1500, \"trainings\": 8, "
                 "\"sensor_rays\": 16}");
    project = folder.filePath(QStringLiteral("cornell.soffit"));
  }

  /// Writes the project anew and opens it; false when no light came.
  bool open() {
    QFile copy(project);
    copy.open(QIODevice::WriteOnly | QIODevice::Truncate);
    copy.write(text);
    copy.close();
    showWindow();
    window->open(project);
    return lit();
  }
  bool showWindow() {
    window = std::make_unique<MainWindow>();
    window->show();
    return QTest::qWaitForWindowExposed(window.get(), kPatienceMs);
  }
  /// Waits for the final light of what is shown.
  bool lit() {
    return QTest::qWaitFor(
        [this] {
          return window->session() != nullptr && window->session()->relighting().isCurrent() &&
                 view().frame() != nullptr && !view().frame()->solver->operators().coarse &&
                 view().meshSolver() == view().frame()->solver && !view().readLinear().empty();
        },
        kPatienceMs);
  }

  [[nodiscard]] Document& document() { return window->session()->document(); }
  [[nodiscard]] SceneView& view() { return window->workspace().area->view(); }

  void switchFirst() {
    document().editLuminaires(QStringLiteral("Switch off"),
                              {QString::fromStdString(document().luminaires().front().name)},
                              [](light::Luminaire& l) { l.on = !l.on; });
  }
  bool trigger(const QString& entry) {
    for (QAction* action : window->findChildren<QAction*>()) {
      if (action->text() != entry) continue;
      if (!action->isEnabled()) return false;
      action->trigger();
      return true;
    }
    return false;
  }
  /// Clicks a button of the dialog that will be shown.
  static void answer(QMessageBox::StandardButton button) {
    whenAsked<QMessageBox>([button](QMessageBox& box) {
      QAbstractButton* wanted = box.button(button);
      if (wanted != nullptr) wanted->click();
      return wanted != nullptr;
    });
  }
  /// Calls `act` with the dialog of a kind that will be shown.
  template <class Dialog, class Act>
  static void whenAsked(Act act) {
    auto* timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, act] {
      auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !act(*dialog)) return;
      timer->stop();
      timer->deleteLater();
    });
    timer->start(50);
  }

  QTemporaryDir folder;
  QByteArray text;
  QString project;
  std::unique_ptr<MainWindow> window;
};

}  // namespace soffit::ui
