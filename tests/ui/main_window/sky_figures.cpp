// SPDX-License-Identifier: MIT
// Prints how fast the application follows a slider of the surroundings, light added up by the
// processor and by shaders: soffit_sky_figures PROJECT [overcast].
//
// A clear sky with a sun (overcast: without) is turned step by step: from the slider's step to the
// picture in its light, one after the other.
#include "ui/document/environment_edits.h"
#include "ui/main_window/main_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTimer>

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>

namespace soffit::ui {
namespace {

constexpr int kSteps = 40;
constexpr int kFirstSteps = 8;  ///< not counted: transfer vectors are made

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

/// Of all threads of this process, ms.
double processorMilliseconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto ms = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

template <class Done>
bool waitFor(const Done& done, int most_ms) {
  QElapsedTimer timer;
  timer.start();
  QTimer wake;
  wake.start(2);
  while (!done()) {
    if (timer.elapsed() > most_ms) return false;
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  return true;
}

scene::Environment turned(bool overcast, int step) {
  return {"", scene::Sky{.cie = overcast ? 1 : 12,
                         .sun_azimuth_deg = 150.0 + 1.5 * step,
                         .sun_altitude_deg = 35.0,
                         .horizontal_illuminance = 12000.0 + 10.0 * step,
                         .direct_normal_illuminance = overcast ? 0.0 : 60000.0,
                         .ground_reflectance = 0.2}};
}

/// Holds the slider and turns the sky.
bool follow(MainWindow& window, bool overcast, const char* name) {
  ProjectSession& session = *window.session();
  SceneView& view = window.workspace().area->view();
  quint64 shown = 0;
  double painted = 0.0;
  const auto connection =
      QObject::connect(&view, &SceneView::lightShown, [&](quint64 revision, double ms) {
        shown = revision;
        painted = ms;
      });
  view.setMoving(true);
  std::vector<double> answers;
  std::vector<double> light;
  std::vector<double> paints;
  std::vector<double> shader;
  double processor = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    if (i == kFirstSteps) processor = processorMilliseconds();
    QElapsedTimer timer;
    timer.start();
    previewEnvironment(session.document(), turned(overcast, i));
    if (!waitFor([&] { return shown == session.relighting().revision(); }, 60000)) return false;
    if (i < kFirstSteps) continue;
    answers.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    light.push_back(session.relighting().frame()->milliseconds);
    paints.push_back(painted);
    shader.push_back(view.skyFigures().milliseconds);
  }
  processor = (processorMilliseconds() - processor) / (kSteps - kFirstSteps);
  std::printf(
      "%s: step to picture %.1f ms; light thread %.1f ms, shaders %.2f ms (%.1f MB), "
      "picture %.1f ms; processor time per step %.1f ms\n",
      name, median(answers), median(light), median(shader),
      static_cast<double>(view.skyFigures().bytes) / 1e6, median(paints), processor);
  std::fflush(stdout);
  view.setMoving(false);
  session.document().cancelPreview();
  QObject::disconnect(connection);
  return waitFor([&] { return session.relighting().isCurrent(); }, 60000);
}

int run(const QString& project, bool overcast) {
  MainWindow window;
  window.resize(1280, 800);
  window.show();
  window.open(project);
  const auto settled = [&] {
    return window.session() != nullptr && window.session()->relighting().isCurrent() &&
           !window.session()->relighting().frame()->solver->operators().coarse;
  };
  if (!waitFor(settled, 600000)) return 1;
  editEnvironment(window.session()->document(), QStringLiteral("Sky"), turned(overcast, 0));
  if (!waitFor(settled, 600000)) return 1;
  SceneView& view = window.workspace().area->view();
  if (!waitFor([&] { return view.meshSolver() == view.frame()->solver; }, 60000)) return 1;
  waitFor([] { return false; }, 3000);  // all samples
  const auto& op = view.frame()->solver->operators();
  std::printf("view %d x %d px, %zu points, %zu vertices\n", view.pixelSize().width(),
              view.pixelSize().height(), op.texels.texelCount(), view.lightRows()->points());
  for (int round = 0; round < 2; ++round) {
    window.workspace().evaluation->setWanted(Evaluation::cpu);
    if (!follow(window, overcast, "CPU")) return 2;
    window.workspace().evaluation->setWanted(Evaluation::gpu);
    if (!follow(window, overcast, "GPU")) return 2;
  }
  window.workspace().evaluation->setWanted(Evaluation::automatic);
  window.session()->document().undoStack()->setClean();
  return 0;
}

}  // namespace
}  // namespace soffit::ui

int main(int argc, char** argv) {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);
  format.setSwapInterval(0);
  QSurfaceFormat::setDefaultFormat(format);
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("soffit-test"));
  QApplication::setApplicationName(QStringLiteral("soffit-sky"));
  QStringList arguments = QApplication::arguments().mid(1);
  const bool overcast = arguments.removeAll(QStringLiteral("overcast")) > 0;
  if (arguments.size() != 1) {
    std::fputs("usage: soffit_sky_figures PROJECT [overcast]\n", stderr);
    return 2;
  }
  return soffit::ui::run(arguments[0], overcast);
}
