// SPDX-License-Identifier: MIT
// Prints what a step of a slider of the surroundings takes, light mixed by the processor and added
// up by shaders, and how far the two pictures lie apart: soffit_sky_figures PROJECT [overcast].
//
// A clear sky with its sun is turned (overcast: a sky without one is dimmed), one step after the
// other, each until its picture is there.
#include "core/io/project/project.h"
#include "core/relight/engine.h"
#include "ui/viewport/picture_pass.h"
#include "ui/viewport/scene_view.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSurfaceFormat>
#include <QTimer>

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace soffit::ui {
namespace {

constexpr int kSteps = 30;
constexpr QSize kPixels(1280, 800);

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

double since(const QElapsedTimer& timer) {
  return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

/// Of all threads of this process, ms: what a step costs, whoever else is at work.
double processorMilliseconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto ms = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

scene::Environment turned(bool overcast, int step) {
  return {"", scene::Sky{.cie = overcast ? 1 : 12,
                         .sun_azimuth_deg = 150.0 + 2.0 * step,
                         .sun_altitude_deg = 35.0,
                         .horizontal_illuminance = 12000.0 + 50.0 * step,
                         .direct_normal_illuminance = overcast ? 0.0 : 60000.0,
                         .ground_reflectance = 0.2}};
}

class Figures {
 public:
  Figures(scene::Scene scene, std::shared_ptr<const relight::Solver> solver, bool overcast)
      : scene_(std::move(scene)),
        solver_(std::move(solver)),
        lighting_(solver_),
        overcast_(overcast) {}

  int run() {
    if (!lighting_.setLuminaires(scene_.luminaires) || !open()) return 1;
    QElapsedTimer timer;
    timer.start();
    const auto parts = lighting_.partsUnderSky(daylight::Environment(turned(overcast_, 0)));
    if (!parts) return 1;
    held_.prepare(*parts, solver_->operators(), {});
    std::printf("%zu points, %zu vertices; vectors of %.1f MB made in %.0f ms\n",
                solver_->operators().texels.texelCount(), view_.pass().building.light()->size(),
                static_cast<double>(held_.step(*parts)->vectors->bytes()) / 1e6, since(timer));
    view_.setMoving(true);
    for (int round = 0; round < 2; ++round) {
      follow("CPU", false);
      follow("GPU", true);
    }
    compare();
    return 0;
  }

 private:
  LightFramePtr frame(int step, bool in_parts) {
    const daylight::Environment environment(turned(overcast_, step));
    auto frame = std::make_shared<LightFrame>();
    frame->solver = solver_;
    frame->complete = false;
    if (in_parts) {
      frame->held = held_.step(*lighting_.partsUnderSky(environment));
      frame->lux = late_;
    } else {
      frame->lux = *lighting_.totalUnderSky(environment);
      late_ = frame->lux;
    }
    return frame;
  }
  bool show(const LightFramePtr& frame) {
    bool shown = false;
    const auto connection = QObject::connect(&view_, &SceneView::lightShown, [&] { shown = true; });
    view_.setFrame(frame);
    QTimer wake;
    wake.start(2);
    QElapsedTimer timer;
    timer.start();
    while (!shown && timer.elapsed() < 60000) {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    QObject::disconnect(connection);
    return shown;
  }
  bool open() {
    view_.resize(kPixels);
    view_.setScene(std::make_shared<const scene::Scene>(scene_));
    view_.setViewCamera(ViewCamera::from(scene_.cameras.front()));
    (void)view_.setLook({});
    view_.show();
    return show(frame(0, false));
  }
  void follow(const char* name, bool in_parts) {
    std::vector<double> light;
    std::vector<double> picture;
    std::vector<double> shaders;
    double processor = 0.0;
    for (int i = 0; i < kSteps + 2; ++i) {
      if (i == 2) processor = processorMilliseconds();
      QElapsedTimer timer;
      timer.start();
      const LightFramePtr next = frame(i, in_parts);
      if (i >= 2) light.push_back(since(timer));
      timer.restart();
      if (!show(next)) return;
      if (i < 2) continue;
      picture.push_back(since(timer));
      shaders.push_back(view_.skyFigures().milliseconds);
    }
    std::printf(
        "%s: light %.1f ms, then until the picture %.1f ms, shaders %.1f ms of it; "
        "processor time per step %.1f ms\n",
        name, median(light), median(picture), median(shaders),
        (processorMilliseconds() - processor) / kSteps);
    std::fflush(stdout);
  }
  void compare() {
    view_.setMoving(false);
    int most = 0;
    std::size_t unlike = 0;
    std::size_t samples = 0;
    double sum = 0.0;
    for (const int step : {0, 10, 20, 30}) {
      view_.setFrame(frame(step, false));
      (void)view_.picture(kPixels, false, 1);  // the others know what is seen
      const QImage wanted = view_.picture(kPixels, false, 1);
      view_.setFrame(frame(step + 90, false));
      (void)view_.picture(kPixels, false, 1);  // light that stayed would be none
      view_.setFrame(frame(step, true));
      const QImage found = view_.picture(kPixels, false, 1);
      for (int y = 0; y < kPixels.height(); ++y) {
        for (int x = 0; x < 3 * kPixels.width(); ++x) {
          const int off = std::abs(wanted.constScanLine(y)[x] - found.constScanLine(y)[x]);
          most = std::max(most, off);
          unlike += off > 1 ? 1 : 0;
          sum += wanted.constScanLine(y)[x];
          ++samples;
        }
      }
    }
    std::printf(
        "pictures of mean code %.0f: at most %d apart, more than one at %zu of %zu samples\n",
        sum / static_cast<double>(samples), most, unlike, samples);
  }

  scene::Scene scene_;
  std::shared_ptr<const relight::Solver> solver_;
  relight::Lighting lighting_;
  bool overcast_;
  HeldSkies held_;
  relight::Planes late_;
  SceneView view_;
};

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
  if (argc < 2) {
    std::fputs("usage: soffit_sky_figures PROJECT [overcast]\n", stderr);
    return 2;
  }
  const auto project = soffit::io::loadProject(argv[1]);
  if (!project) return 1;
  const auto quality = soffit::relight::qualitySettings(project->scene.quality);
  soffit::relight::EngineReport report;
  auto solver = soffit::relight::makeSolver(project->scene, *quality, true, {}, report);
  if (!solver) return 1;
  const bool overcast = argc > 2 && std::strcmp(argv[2], "overcast") == 0;
  return soffit::ui::Figures(project->scene, *solver, overcast).run();
}
