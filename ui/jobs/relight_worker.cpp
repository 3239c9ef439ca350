// SPDX-License-Identifier: MIT
#include "ui/jobs/relight_worker.h"

#include "core/scene/equality.h"
#include "ui/document/text.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace soffit::ui {
namespace {

/// A hand that rests so long on a slider wants to read what it sees.
constexpr std::chrono::milliseconds kPause{60};

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

}  // namespace

RelightWorker::RelightWorker(bool use_cache, QObject* parent)
    : QObject(parent), use_cache_(use_cache) {
  connect(&relay_, &ProgressRelay::progressed, this, &RelightWorker::progressed);
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

RelightWorker::~RelightWorker() {
  thread_.request_stop();
  {
    const std::scoped_lock lock(mutex_);
    current_.request_stop();
  }
  wake_.notify_all();
  thread_.join();
  const std::scoped_lock lock(bake_mutex_);
  bake_.reset();  // joins, and its callbacks use this object
}

void RelightWorker::request(LightRequest request) {
  {
    const std::scoped_lock lock(mutex_);
    if (request.stops_older) current_.request_stop();
    newest_ = std::move(request);
  }
  wake_.notify_all();
}

void RelightWorker::cancelBake() {
  {
    const std::scoped_lock lock(mutex_);
    if (finding_outside_) {
      leave_out_ = true;
      current_.request_stop();
    }
  }
  wake_.notify_all();
  const std::scoped_lock lock(bake_mutex_);
  if (bake_ != nullptr) bake_->cancel();
}

LightFramePtr RelightWorker::takeFrame() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(frame_, nullptr);
}

void RelightWorker::requestOther(LightRequest request) {
  {
    const std::scoped_lock lock(mutex_);
    other_ = std::move(request);
  }
  wake_.notify_all();
}

LightFramePtr RelightWorker::takeOther() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(other_frame_, nullptr);
}

void RelightWorker::publish(LightFramePtr frame) {
  (frame->lux_late ? unwhole_ : whole_) = frame;
  if (!frame->lux_late) unwhole_.reset();
  {
    const std::scoped_lock lock(mutex_);
    frame_ = std::move(frame);
  }
  Q_EMIT frameReady();
}

void RelightWorker::onSolver(Result<SolverBake::Outcome> outcome) {
  if (!outcome) {
    if (outcome.error().what == "cancelled") {
      Q_EMIT bakeFinished(QString());
    } else {
      Q_EMIT failed(messageOf(outcome.error()));
      Q_EMIT bakeFinished(QString());
    }
    return;
  }
  {
    const std::scoped_lock lock(mutex_);
    arrived_ = *outcome;
    // What is being computed belongs to the older solver.
    current_.request_stop();
  }
  wake_.notify_all();
  if (outcome->coarse) return;
  const relight::EngineReport& report = outcome->report;
  const auto texels = outcome->solver->operators().texels.texelCount();
  const QString how = report.cached ? tr("from the cache")
                                    : tr("computed in %L1 s").arg(report.bake.seconds, 0, 'f', 1);
  for (const std::string& message : report.messages) Q_EMIT failed(toQt(message));
  Q_EMIT bakeFinished(tr("Light transport %1: %2 points, %3 MB")
                          .arg(how)
                          .arg(texels)
                          .arg(static_cast<double>(report.bytes) / 1e6, 0, 'f', 0));
}

void RelightWorker::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::stop_token give_up;
    std::optional<LightRequest> other;
    bool reflects = false;
    {
      std::unique_lock lock(mutex_);
      const auto wanted = [this] {
        return newest_.has_value() || arrived_.has_value() || leave_out_ || lacksReflections() ||
               (has_solver_ && other_.has_value());
      };
      bool pause = false;
      if (unwhole_ != nullptr) {
        pause = !wake_.wait_for(lock, stop, kPause, wanted);
      } else {
        wake_.wait(lock, stop, wanted);
      }
      if (stop.stop_requested()) return;
      if (pause) {
        current_ = std::stop_source();
        give_up = current_.get_token();
        lock.unlock();
        settle(give_up);
        continue;
      }
      if (std::exchange(leave_out_, false)) {
        columns_.setOutside(nullptr);
        Q_EMIT outsideLeftOut();
      } else if (!newest_ && !arrived_ && lacksReflections()) {
        reflects = true;
      } else if (!newest_ && !arrived_) {
        other = std::exchange(other_, std::nullopt);
      }
      if (newest_) last_ = std::exchange(newest_, std::nullopt);
      if (arrived_) {
        columns_.setSolver(arrived_->solver);
        held_.forget();
        materials_ = arrived_->scene->materials;
        arrived_.reset();
      }
      current_ = std::stop_source();
      give_up = current_.get_token();
      if (!reflects_) reflections_.clear();
    }
    if (reflects) {
      makeReflections(give_up);
      if (!reflections_.any()) continue;  // what is shown has all that there is
    }
    if (other) {
      serveOther(std::move(*other), give_up);
    } else if (last_) {
      serve(*last_, give_up);
    }
  }
}

void RelightWorker::ensureBake(const LightRequest& request) {
  const std::scoped_lock lock(bake_mutex_);
  if (bake_ != nullptr && bake_->serves(*request.scene)) return;
  bake_.reset();
  columns_.setSolver(nullptr);
  held_.forget();
  whole_.reset();
  {
    // What the older one handed over in its last moment belongs to another building.
    const std::scoped_lock arrival(mutex_);
    arrived_.reset();
  }
  bake_ = std::make_unique<SolverBake>(
      request.scene, use_cache_, &relay_,
      [this](Result<SolverBake::Outcome> outcome) { onSolver(std::move(outcome)); });
}

void RelightWorker::ensureMaterials(const LightRequest& request) {
  if (scene::sameReflectances(materials_, request.scene->materials)) return;
  materials_ = request.scene->materials;
  columns_.repaint(columns_.solver()->repainted(materials_));
}

void RelightWorker::ensureOutside(const LightRequest& request) {
  const auto& wanted = request.scene->environment;
  if (outside_.has_value() == wanted.has_value() && (!wanted || scene::same(*outside_, *wanted))) {
    return;
  }
  outside_ = wanted;
  columns_.setOutside(
      wanted ? std::make_shared<const daylight::Environment>(*wanted, columns_.outside().get())
             : nullptr);
}

std::shared_ptr<const daylight::Environment> RelightWorker::heldEnvironment(
    const LightRequest& request) const {
  return std::make_shared<const daylight::Environment>(*request.scene->environment,
                                                       columns_.outside().get());
}

LightFrame RelightWorker::heldFrameOf(const LightRequest& request, LightColumns::Answer answer,
                                      std::shared_ptr<const daylight::Environment> outside,
                                      Clock::time_point start) {
  LightFrame frame = frameOf(request, std::move(answer), start);
  frame.outside = std::move(outside);
  frame.complete = false;
  frame.shares = shares_.last(request.probes, request.layout);
  return frame;
}

/// The light under surroundings that a slider moves, in parts; null where they are not known, or
/// there is no earlier light to be read meanwhile.
LightFramePtr RelightWorker::heldInParts(const LightRequest& request, const std::stop_token& stop) {
  if (held_.empty() || whole_ == nullptr) return nullptr;
  if (whole_->solver != columns_.solver()) return nullptr;
  const auto start = Clock::now();
  auto outside = heldEnvironment(request);
  const auto parts =
      columns_.partsUnder(*outside, request.layout, request.luminaires, Job{&relay_, stop});
  if (!parts || !held_.fits(*parts)) return nullptr;
  LightColumns::Answer answer;
  answer.lux = whole_->lux;
  const auto emitters = columns_.lightingOf(request.layout)->emitters();
  answer.emitters.assign(emitters.begin(), emitters.end());
  LightFrame frame = heldFrameOf(request, std::move(answer), std::move(outside), start);
  frame.held = held_.step(*parts);
  frame.lux_late = true;
  frame.milliseconds = millisecondsSince(start);
  return std::make_shared<const LightFrame>(std::move(frame));
}

/// The light under surroundings that a slider moves; null where it cannot be mixed.
LightFramePtr RelightWorker::heldOutside(const LightRequest& request, const std::stop_token& stop) {
  const auto start = Clock::now();
  auto outside = heldEnvironment(request);
  auto answer =
      columns_.lightUnder(*outside, request.layout, request.luminaires, Job{&relay_, stop});
  Q_EMIT lightFinished();
  if (!answer) return nullptr;
  return std::make_shared<const LightFrame>(
      heldFrameOf(request, std::move(*answer), std::move(outside), start));
}

/// The hand pauses: what is shown gets its own lux.
void RelightWorker::settle(const std::stop_token& stop) {
  const LightFramePtr shown = std::exchange(unwhole_, nullptr);
  LightFramePtr whole = heldOutside(*last_, stop);
  if (whole == nullptr) return;
  LightFrame frame = *whole;
  frame.held = shown->held;
  frame.milliseconds = shown->milliseconds;
  publish(std::make_shared<const LightFrame>(std::move(frame)));
}

/// Whether a request was answered whose surroundings are in hand.
bool RelightWorker::serveHeld(const LightRequest& request, const std::stop_token& stop) {
  if (!request.in_parts) held_.forget();
  unwhole_.reset();
  if (!request.outside_in_hand || !request.scene->environment) return false;
  if (LightFramePtr quick = heldInParts(request, stop)) {
    publish(std::move(quick));
    return true;
  }
  LightFramePtr frame = heldOutside(request, stop);
  if (frame == nullptr) return false;
  const auto outside = frame->outside;
  publish(std::move(frame));
  if (!request.in_parts) return true;
  // The next step takes less.
  const Job job{nullptr, stop};
  if (auto parts = columns_.partsUnder(*outside, request.layout, request.luminaires, job)) {
    held_.prepare(*parts, columns_.solver()->operators(), job);
  }
  return true;
}

/// Where nothing is shown yet, the luminaires' light comes before that from outside.
void RelightWorker::serveWithoutOutside(const LightRequest& request, const std::stop_token& stop) {
  if (columns_.lightingOf(request.layout) != nullptr) return;
  const auto start = Clock::now();
  auto answer = columns_.light(request.layout, request.luminaires, {}, Job{nullptr, stop},
                               LightColumns::Outside::as_it_was);
  if (!answer) return;  // told by those who come next
  LightFrame frame = frameOf(request, std::move(*answer), start);
  frame.outside = nullptr;
  frame.complete = false;
  publish(std::make_shared<const LightFrame>(std::move(frame)));
}

LightFrame RelightWorker::frameOf(const LightRequest& request, LightColumns::Answer answer,
                                  Clock::time_point start) {
  LightFrame frame;
  frame.solver = columns_.solver();
  frame.outside = columns_.outside();
  frame.lux = std::move(answer.lux);
  frame.times = answer.times;
  frame.counts = answer.counts;
  frame.emitters = std::move(answer.emitters);
  for (const light::Luminaire& l : request.luminaires) frame.names.push_back(l.name);
  frame.revision = request.revision;
  reflections_.addTo(frame);
  frame.milliseconds = millisecondsSince(start);
  return frame;
}

LightFramePtr RelightWorker::lightOf(const LightRequest& request, const std::stop_token& stop) {
  const auto start = Clock::now();
  // While the building is precomputed, that tells how far it is.
  const bool lacks = columns_.lacksOutside(request.layout);
  // A drag does not wait for it: what shone in before goes on shining until the hand rests.
  const bool passing = lacks && (!request.in_hand.empty() || !request.stops_older);
  const bool tells = lacks && !passing && !columns_.solver()->operators().coarse;
  {
    const std::scoped_lock lock(mutex_);
    finding_outside_ = tells;
  }
  auto answer = columns_.light(
      request.layout, request.luminaires, request.in_hand, Job{tells ? &relay_ : nullptr, stop},
      passing ? LightColumns::Outside::as_it_was : LightColumns::Outside::found);
  if (tells) {
    const std::scoped_lock lock(mutex_);
    finding_outside_ = false;
  }
  if (tells) Q_EMIT lightFinished();
  if (!answer) {
    if (!stop.stop_requested()) Q_EMIT failed(messageOf(answer.error()));
    return nullptr;
  }
  LightFrame frame = frameOf(request, std::move(*answer), start);
  frame.complete = !passing;
  // Many luminaires in a drag leave no time for it.
  if (request.stops_older) {
    const auto one =
        request.in_hand.size() == 1 ? std::optional(request.in_hand.front()) : std::nullopt;
    frame.shares = shares_.of(request.probes, columns_, request.layout, frame.lux, one);
    frame.milliseconds = millisecondsSince(start);
  }
  return std::make_shared<const LightFrame>(std::move(frame));
}

void RelightWorker::serve(const LightRequest& request, const std::stop_token& stop) {
  ensureBake(request);
  has_solver_ = columns_.solver() != nullptr;
  if (!has_solver_) return;  // its arrival wakes this thread
  ensureMaterials(request);
  columns_.keep(request.layout);
  if (serveHeld(request, stop)) return;
  ensureOutside(request);
  const auto start = Clock::now();
  if (auto painted = columns_.paintedLight(request.layout, request.luminaires)) {
    LightFrame frame = frameOf(request, std::move(*painted), start);
    frame.shares = shares_.last(request.probes, request.layout);
    publish(std::make_shared<const LightFrame>(std::move(frame)));
  }
  if (columns_.lacksOutside(request.layout)) serveWithoutOutside(request, stop);
  if (LightFramePtr frame = lightOf(request, stop)) publish(std::move(frame));
}

void RelightWorker::serveOther(LightRequest request, const std::stop_token& stop) {
  LightFramePtr frame = lightOf(request, stop);
  {
    const std::scoped_lock lock(mutex_);
    if (frame == nullptr && stop.stop_requested()) {
      // Interrupted for the layout that is shown: its turn comes again.
      if (!other_) other_ = std::move(request);
      return;
    }
    other_frame_ = std::move(frame);
  }
  Q_EMIT otherReady();
}

}  // namespace soffit::ui
