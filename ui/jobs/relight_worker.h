// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/scene_command.h"
#include "ui/jobs/held_sky.h"
#include "ui/jobs/light_columns.h"
#include "ui/jobs/light_frame.h"
#include "ui/jobs/live_reflections.h"
#include "ui/jobs/probe_shares.h"
#include "ui/jobs/progress_relay.h"
#include "ui/jobs/solver_bake.h"

#include <QObject>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace soffit::ui {

/// A state of the scene whose light is wanted.
struct LightRequest {
  ScenePtr scene;
  std::string layout;                        ///< name, empty for the base
  std::vector<light::Luminaire> luminaires;  ///< of that layout
  std::vector<std::size_t> in_hand;          ///< luminaires that are being dragged, rising
  std::vector<io::Probe> probes;             ///< that want to know who lights them
  std::uint64_t revision = 0;                ///< rising
  /// Surroundings that are being turned or changed: their light is mixed from columns for now.
  bool outside_in_hand = false;
  /// Who shows the light adds up that of surroundings in hand (LightFrame::held).
  bool in_parts = false;
  /// Older work is given up. Not while many luminaires are dragged: each step of that takes longer
  /// than the mouse leaves, and none would ever be finished.
  bool stops_older = true;
};

/// The light engine off the GUI thread (design.md § 8): the newest request wins, stale work is
/// given up, finished light is handed over whole.
///
/// The building is precomputed on a second thread; coarse light comes first and can be worked with,
/// finer light replaces it. Methods are called from, and signals arrive in, the GUI thread.
class RelightWorker : public QObject {
  Q_OBJECT

 public:
  /// use_cache  see SolverBake.
  explicit RelightWorker(bool use_cache = true, QObject* parent = nullptr);
  ~RelightWorker() override;

  void request(LightRequest request);
  /// The light of another layout, when there is nothing else to do; a newer one takes its place.
  /// Answered by otherReady(), not before there is a light transport.
  void requestOther(LightRequest request);
  /// Null where its luminaires have a fault (failed() told it).
  LightFramePtr takeOther();
  /// Gives up the precomputation; the coarse light stays, if there is any. What shines in from
  /// outside is left out, if that is what is being computed, until it is asked for another way.
  void cancelBake();
  /// Whether frames show what specular surfaces reflect; from the next one on.
  void setReflections(bool on);
  /// The newest finished light, once each; null when there is nothing new.
  LightFramePtr takeFrame();

 Q_SIGNALS:
  void frameReady();
  void otherReady();
  void progressed(const QString& stage, double done);
  /// Light that told its progress is there, or was given up.
  void lightFinished();
  /// The user would not wait for what shines in from outside.
  void outsideLeftOut();
  /// The precomputation ended: detail is a line for the log, empty when it was cancelled.
  void bakeFinished(const QString& detail);
  void failed(const QString& message);

 private:
  using Clock = std::chrono::steady_clock;
  void run(const std::stop_token& stop);
  void serve(const LightRequest& request, const std::stop_token& stop);
  void serveOther(LightRequest request, const std::stop_token& stop);
  [[nodiscard]] LightFrame frameOf(const LightRequest& request, LightColumns::Answer answer,
                                   Clock::time_point start);
  [[nodiscard]] LightFramePtr lightOf(const LightRequest& request, const std::stop_token& stop);
  void ensureBake(const LightRequest& request);
  void ensureMaterials(const LightRequest& request);
  void ensureOutside(const LightRequest& request);
  bool serveHeld(const LightRequest& request, const std::stop_token& stop);
  [[nodiscard]] LightFramePtr heldInParts(const LightRequest& request, const std::stop_token& stop);
  [[nodiscard]] LightFramePtr heldOutside(const LightRequest& request, const std::stop_token& stop);
  [[nodiscard]] std::shared_ptr<const daylight::Environment> heldEnvironment(
      const LightRequest& request) const;
  void settle(const std::stop_token& stop);
  void serveWithoutOutside(const LightRequest& request, const std::stop_token& stop);
  void onSolver(Result<SolverBake::Outcome> outcome);
  void publish(LightFramePtr frame);
  /// Whether reflections are to be made ready when nothing else is to do.
  [[nodiscard]] bool lacksReflections() const;
  void makeReflections(const std::stop_token& stop);
  [[nodiscard]] LightFrame heldFrameOf(const LightRequest& request, LightColumns::Answer answer,
                                       std::shared_ptr<const daylight::Environment> outside,
                                       Clock::time_point start);

  const bool use_cache_;
  ProgressRelay relay_;

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<LightRequest> newest_;          // guarded by mutex_
  std::optional<SolverBake::Outcome> arrived_;  // guarded by mutex_
  LightFramePtr frame_;                         // guarded by mutex_
  std::optional<LightRequest> other_;           // guarded by mutex_
  LightFramePtr other_frame_;                   // guarded by mutex_
  std::stop_source current_;                    // guarded by mutex_
  bool finding_outside_ = false;                // guarded by mutex_
  bool leave_out_ = false;                      // guarded by mutex_
  bool reflects_ = false;                       // guarded by mutex_

  // Of the light thread alone.
  LightColumns columns_;
  ProbeShares shares_;
  LiveReflections reflections_;
  HeldSkies held_;
  LightFramePtr whole_;    ///< the newest that was published with its own lux
  LightFramePtr unwhole_;  ///< the newest that was published if its lux is late
  std::vector<scene::Material> materials_;
  std::optional<LightRequest> last_;
  std::optional<scene::Environment> outside_;  ///< that columns_ has, as it was described
  bool has_solver_ = false;

  std::mutex bake_mutex_;
  std::unique_ptr<SolverBake> bake_;  // guarded by bake_mutex_
  std::jthread thread_;
};

}  // namespace soffit::ui
