// SPDX-License-Identifier: MIT
#include "ui/jobs/readings_worker.h"

#include "core/color/luminance.h"
#include "core/relight/engine.h"
#include "core/scene/edits.h"
#include "core/scene/equality.h"
#include "ui/document/text.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace soffit::ui {
namespace {

using Clock = std::chrono::steady_clock;

/// Seed of the sensors' rays: that of the command line, so that both read the same.
constexpr std::uint64_t kSeed = 1;
/// A drag is read about ten times a second, and never more than half of the time: the picture comes
/// first.
constexpr std::chrono::milliseconds kPace(80);

/// The layouts that are listed: the base counts where it is shown, wanted or stands alone.
std::vector<std::string> listed(const ReadingsRequest& request) {
  const auto& layouts = request.scene->layouts;
  std::vector<std::string> names;
  if (request.with_base || request.shown.empty() || layouts.empty()) names.emplace_back();
  for (const scene::Layout& layout : layouts) names.push_back(layout.name);
  return names;
}

std::vector<light::Luminaire> luminairesOf(const ReadingsRequest& request,
                                           const std::string& layout) {
  if (layout == request.shown) return request.luminaires;
  const scene::Layout* found = scene::findLayout(*request.scene, layout);
  return found == nullptr ? request.scene->luminaires
                          : scene::resolveLayout(*request.scene, *found);
}

}  // namespace

ReadingsWorker::ReadingsWorker(QObject* parent) : QObject(parent) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

ReadingsWorker::~ReadingsWorker() {
  thread_.request_stop();
  thread_.join();
}

void ReadingsWorker::request(ReadingsRequest request) {
  {
    const std::scoped_lock lock(mutex_);
    newest_ = std::move(request);
  }
  wake_.notify_all();
}

ReadingsPtr ReadingsWorker::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(finished_, nullptr);
}

bool ReadingsWorker::superseded() {
  const std::scoped_lock lock(mutex_);
  return newest_.has_value();
}

void ReadingsWorker::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    ReadingsRequest request;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return newest_.has_value(); })) return;
      request = std::move(*std::exchange(newest_, std::nullopt));
    }
    const auto start = Clock::now();
    serve(request, stop);
    if (!request.dragging) continue;
    const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, stop, std::max(kPace, took),
                   [this] { return newest_.has_value() && !newest_->dragging; });
  }
}

bool ReadingsWorker::prepare(const ReadingsRequest& request) {
  const auto quality = relight::qualitySettings(request.scene->quality);
  if (!quality) return false;  // told by those who compute the light
  if (!sensors_ || rays_ != quality->sensor_rays ||
      !scene::sameList(planes_, request.scene->work_planes)) {
    planes_ = request.scene->work_planes;
    rays_ = quality->sensor_rays;
    sensors_.emplace(design::sensorsOfAll(planes_), rays_, kSeed);
    solver_.reset();
  }
  if (solver_ != request.solver) {
    solver_ = request.solver;
    sensors_->setSolver(solver_);
    known_.clear();
  }
  if (outside_ != request.outside) known_.clear();
  outside_ = request.outside;
  return true;
}

void ReadingsWorker::addPower(const ReadingsRequest& request,
                              const std::vector<light::Luminaire>& luminaires,
                              LayoutReading& reading) {
  for (const light::Luminaire& l : luminaires) {
    if (!l.on || l.dimming <= 0.0) continue;
    const std::string& file = l.distribution.file;
    const auto watts = file.empty() ? std::optional<double>() : power_.watts(request.folder / file);
    if (watts) {
      reading.watts += l.dimming * *watts;
    } else {
      ++reading.unknown_power;
    }
  }
}

Result<LayoutReading> ReadingsWorker::read(const ReadingsRequest& request,
                                           const std::string& layout,
                                           const std::vector<light::Luminaire>& luminaires,
                                           const Job& job) {
  std::vector<light::Emitter> emitters;
  for (const light::Luminaire& l : luminaires) {
    auto emitter = light::makeEmitter(l, solver_->scene().mesh->origin);
    if (!emitter) return emitter.error();
    emitters.push_back(std::move(*emitter));
  }
  std::vector<relight::SensorLight> light;
  if (!planes_.empty()) {
    auto answer = sensors_->read(emitters, outside_, job);
    if (!answer) return answer.error();
    light = std::move(*answer);
  }
  LayoutReading reading;
  reading.layout = layout;
  reading.figures =
      design::layoutFigures(layout.empty() ? "Base" : layout, emitters, planes_, light);
  for (const relight::SensorLight& point : light) {
    reading.points.push_back(static_cast<float>(color::luminance(point.direct + point.indirect)));
  }
  addPower(request, luminaires, reading);
  return reading;
}

void ReadingsWorker::serve(const ReadingsRequest& request, const std::stop_token& stop) {
  if (request.solver == nullptr || !prepare(request)) return;
  std::vector<std::string> names = listed(request);
  // The one in the view first.
  std::stable_partition(names.begin(), names.end(),
                        [&](const std::string& name) { return name == request.shown; });
  for (const std::string& name : names) {
    const auto luminaires = luminairesOf(request, name);
    const auto known =
        std::ranges::find_if(known_, [&](const Known& k) { return k.reading.layout == name; });
    const bool first = name == request.shown;
    if (known != known_.end() && scene::sameList(known->luminaires, luminaires)) {
      known->reading.current = true;
    } else if (!first && (request.dragging || superseded())) {
      if (known != known_.end()) known->reading.current = false;
    } else {
      auto reading = read(request, name, luminaires, Job{nullptr, stop});
      if (stop.stop_requested()) return;
      if (!reading) {
        Q_EMIT failed(messageOf(reading.error()));
        continue;
      }
      if (known != known_.end()) known_.erase(known);
      known_.push_back({std::move(*reading), luminaires});
    }
    if (first) publish(request);
  }
  publish(request);
}

void ReadingsWorker::publish(const ReadingsRequest& request) {
  auto readings = std::make_shared<Readings>();
  for (const std::string& name : listed(request)) {
    for (const Known& known : known_) {
      if (known.reading.layout == name) readings->layouts.push_back(known.reading);
    }
  }
  readings->shown = request.shown;
  readings->area_m2 = design::areaOfAll(planes_);
  readings->coarse = solver_->operators().coarse;
  readings->revision = request.revision;
  {
    const std::scoped_lock lock(mutex_);
    finished_ = std::move(readings);
  }
  Q_EMIT ready();
}

}  // namespace soffit::ui
