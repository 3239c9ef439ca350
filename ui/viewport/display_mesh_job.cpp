// SPDX-License-Identifier: MIT
#include "ui/viewport/display_mesh_job.h"

#include "ui/viewport/cut_hatch.h"

#include <utility>

namespace soffit::ui {

DisplayMeshJob::DisplayMeshJob(QObject* parent) : QObject(parent) {}

DisplayMeshJob::~DisplayMeshJob() = default;

void DisplayMeshJob::start(std::shared_ptr<const relight::Solver> solver,
                           std::vector<scene::Material> materials) {
  solver_ = solver;
  int number = 0;
  {
    const std::scoped_lock lock(mutex_);
    number = ++newest_;
    mesh_.reset();
  }
  // One after the other: the older thread joins the newer one's way in.
  thread_ = std::jthread([this, number, solver = std::move(solver),
                          materials = std::move(materials),
                          older = std::make_shared<std::jthread>(std::move(thread_))]() mutable {
    if (older->joinable()) older->join();
    const transfer::StaticScene& scene = solver->scene();
    auto mesh = std::make_shared<DisplayMesh>(
        makeDisplayMesh(*scene.mesh, solver->operators().texels, materials));
    mesh->solid =
        std::make_shared<const std::vector<std::uint8_t>>(solidTriangles(*scene.mesh, scene.sides));
    {
      const std::scoped_lock lock(mutex_);
      if (number != newest_) return;
      mesh_ = std::move(mesh);
    }
    Q_EMIT finished();
  });
}

std::shared_ptr<const DisplayMesh> DisplayMeshJob::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(mesh_, nullptr);
}

}  // namespace soffit::ui
