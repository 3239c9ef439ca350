// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/display_mesh.h"

#include <QObject>

#include <memory>
#include <mutex>
#include <thread>

namespace soffit::ui {

/// Cuts display meshes on a thread of its own. A new start() gives up what is under way.
class DisplayMeshJob : public QObject {
  Q_OBJECT

 public:
  explicit DisplayMeshJob(QObject* parent = nullptr);
  ~DisplayMeshJob() override;

  void start(std::shared_ptr<const relight::Solver> solver, std::vector<scene::Material> materials);
  /// The solver that the newest mesh was started for; null before.
  [[nodiscard]] const std::shared_ptr<const relight::Solver>& solver() const { return solver_; }
  /// The finished mesh of solver(), once; null before it is there.
  std::shared_ptr<const DisplayMesh> take();

 Q_SIGNALS:
  void finished();

 private:
  std::shared_ptr<const relight::Solver> solver_;
  std::mutex mutex_;
  std::shared_ptr<const DisplayMesh> mesh_;  // guarded by mutex_
  int newest_ = 0;                           // guarded by mutex_
  std::jthread thread_;
};

}  // namespace soffit::ui
