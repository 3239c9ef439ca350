// SPDX-License-Identifier: MIT
// Prints how fast the application answers a drag: soffit_drag_figures PROJECT [LUMINAIRE] [four].
//
// Two figures: from the hand's move to the picture in the light of that very place, one after the
// other; and pictures in new light per second while the hand moves on without waiting. Besides, how
// long a move of the hand keeps the window from anything else. four: with four views.
#include "ui/main_window/main_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QTimer>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace soffit::ui {
namespace {

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

/// Processor time of all threads of this process, ms: what a step costs, whoever else is at work.
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
  // Wakes the loop, which sleeps in between as in the application: a loop that turns on the spot
  // would take a core from the light.
  QTimer wake;
  wake.start(2);
  while (!done()) {
    if (timer.elapsed() > most_ms) return false;
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  return true;
}

void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& at) {
  const bool pressed = type != QEvent::MouseButtonRelease;
  QMouseEvent event(type, at, widget.mapToGlobal(at),
                    type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                    pressed ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(&widget, &event);
}

int run(const QString& project, const QString& wanted, bool four) {
  MainWindow window;
  window.resize(1280, 800);
  window.show();
  QElapsedTimer since_open;
  since_open.start();
  window.open(project);
  SceneView& view = window.workspace().area->view();
  quint64 shown = 0;
  double first_ms = -1.0;
  std::vector<double> paints;
  QObject::connect(&view, &SceneView::lightShown, [&](quint64 revision, double ms) {
    shown = revision;
    paints.push_back(ms);
    if (first_ms < 0.0) first_ms = static_cast<double>(since_open.elapsed());
  });
  const auto converged = [&] {
    return window.session() != nullptr && window.session()->relighting().isCurrent() &&
           !window.session()->relighting().frame()->solver->operators().coarse &&
           shown == window.session()->relighting().revision();
  };
  if (!waitFor(converged, 600000)) return 1;
  const double converged_ms = static_cast<double>(since_open.elapsed());
  std::printf("first light %.0f ms after opening, converged %.0f ms\n", first_ms, converged_ms);
  std::fflush(stdout);
  waitFor([] { return false; }, 3000);  // the mesh of the final solver, and all samples

  if (four) {
    window.workspace().area->grid().setArrangement(ViewGrid::Arrangement::four);
    waitFor([] { return false; }, 3000);
  }
  Document& document = window.session()->document();
  const QString name =
      wanted.isEmpty() ? QString::fromStdString(document.luminaires()[5].name) : wanted;
  document.setSelection({name});
  const dvec3 start = document.luminaire(name)->position;
  const auto pixelOf = [&](const dvec3& p) {
    const dvec3 at = view.viewCamera().project(p, view.viewSize());
    return QPointF(at.x, at.y);
  };
  const auto place = [&](int i) {
    const double phi = 0.05 * i;
    return start + dvec3(0.8 * std::sin(phi), 0.5 * std::sin(1.7 * phi), 0.0);
  };
  sendMouse(view, QEvent::MouseButtonPress, pixelOf(start));
  constexpr int kSteps = 60;
  std::vector<double> answers;
  std::vector<double> light;
  std::vector<double> hand;
  const double processor_before = processorMilliseconds();
  for (int i = 1; i <= kSteps; ++i) {
    QElapsedTimer timer;
    timer.start();
    sendMouse(view, QEvent::MouseMove, pixelOf(place(i)));
    hand.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    if (!waitFor([&] { return shown == window.session()->relighting().revision(); }, 5000))
      return 2;
    if (i <= 10) continue;
    answers.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    light.push_back(window.session()->relighting().frame()->milliseconds);
  }
  std::printf("hand to picture: median %.1f ms, 95 %% %.1f ms (light: median %.1f ms)\n",
              quantile(answers, 0.5), quantile(answers, 0.95), quantile(light, 0.5));
  std::printf("a move of the hand takes the window: median %.2f ms, most %.2f ms\n",
              quantile(hand, 0.5), quantile(hand, 1.0));
  std::printf("processor time per step: %.1f ms\n",
              (processorMilliseconds() - processor_before) / kSteps);
  std::fflush(stdout);
  paints.clear();
  QElapsedTimer timer;
  timer.start();
  constexpr int kHandMs = 8;
  for (int i = kSteps + 1; timer.elapsed() < 6000; ++i) {
    sendMouse(view, QEvent::MouseMove, pixelOf(place(i)));
    waitFor([] { return false; }, kHandMs);
  }
  const double per_second =
      static_cast<double>(paints.size()) / (static_cast<double>(timer.elapsed()) / 1e3);
  sendMouse(view, QEvent::MouseButtonRelease, pixelOf(place(0)));
  std::printf("view %d x %d px, %zu luminaires, dragged %s\n", view.pixelSize().width(),
              view.pixelSize().height(), document.luminaires().size(), qPrintable(name));
  std::printf("moving on: %.1f pictures in new light per second, a picture takes %.1f ms\n",
              per_second, quantile(paints, 0.5));
  document.undoStack()->setClean();
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
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("soffit-test"));
  QApplication::setApplicationName(QStringLiteral("soffit-drag"));
  QStringList arguments = QApplication::arguments().mid(1);
  const bool four = arguments.removeAll(QStringLiteral("four")) > 0;
  if (arguments.isEmpty()) {
    std::fputs("usage: soffit_drag_figures PROJECT [LUMINAIRE] [four]\n", stderr);
    return 2;
  }
  return soffit::ui::run(arguments[0], arguments.value(1), four);
}
