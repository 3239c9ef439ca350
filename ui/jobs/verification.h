// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/verify.h"
#include "ui/document/document.h"
#include "ui/jobs/background.h"
#include "ui/jobs/progress_relay.h"
#include "ui/jobs/relighting.h"

#include <QObject>

#include <memory>
#include <optional>
#include <stop_token>

namespace soffit::ui {

/// How well the reference is to know each point, and whose light is reported.
struct VerifyWish {
  double error = 0.01;          ///< relative standard error of the reference
  double time_limit_s = 180.0;  ///< after which what there is counts
  QString luminaire;            ///< is reported alone too; empty: none
};

/// What was verified, and what came out.
struct VerifiedLight {
  ScenePtr scene;
  std::vector<light::Luminaire> luminaires;  ///< as they were lit
  design::VerifyReport report;
  VerifyWish wish;
  double seconds = 0.0;
};
using VerifiedLightPtr = std::shared_ptr<const VerifiedLight>;

/// Checks the light that a document shows against the path tracer, in the background (`soffit
/// verify` does the same).
///
/// The result belongs to the state that was verified: it holds again when an undo leads back to
/// it, and a change while the reference runs ends it. Lives in the GUI thread.
class Verification : public QObject {
  Q_OBJECT

 public:
  enum class State {
    idle,
    waiting,  ///< for the final light
    running,
  };

  Verification(Document& document, Relighting& relighting, QObject* parent = nullptr);
  ~Verification() override;

  /// Begins as soon as the final light is there; one that runs is given up.
  void start(const VerifyWish& wish);
  void cancel();

  [[nodiscard]] State state() const { return state_; }
  /// The newest result; null before the first.
  [[nodiscard]] const VerifiedLightPtr& result() const { return result_; }
  /// Whether the result is of what the document shows now.
  [[nodiscard]] bool isVerified() const;

 Q_SIGNALS:
  /// state(), result() or isVerified() may have changed.
  void changed();
  void progressed(const QString& stage, double done);
  void finished();
  /// It ended without a result; empty: the user wanted it.
  void stopped(const QString& why);

 private:
  void onSceneChanged();
  void onFrame();
  void run();
  void stop(const QString& why);
  [[nodiscard]] bool isOfNow(const VerifiedLight& light) const;

  Document& document_;
  Relighting& relighting_;
  State state_ = State::idle;
  VerifyWish wish_;
  std::shared_ptr<VerifiedLight> under_way_;
  VerifiedLightPtr result_;
  bool verified_ = false;
  std::stop_source stop_;
  ProgressRelay relay_;
  Background background_;  ///< the last: its end waits for the work that uses the rest
};

}  // namespace soffit::ui
