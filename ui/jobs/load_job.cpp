// SPDX-License-Identifier: MIT
#include "ui/jobs/load_job.h"

#include "ui/document/text.h"

#include <utility>

namespace soffit::ui {

LoadJob::LoadJob(const QString& path, std::optional<std::string> text, QObject* parent)
    : QObject(parent), path_(path) {
  connect(&relay_, &ProgressRelay::progressed, this, &LoadJob::progressed);
  thread_ = std::jthread([this, text = std::move(text)](const std::stop_token& stop) {
    io::LoadOptions options;
    options.text = text;
    options.job = Job{&relay_, stop};
    auto project = io::loadProject(toPath(path_), options);
    if (stop.stop_requested()) return;
    if (!project) {
      Q_EMIT failed(messageOf(project.error()));
      return;
    }
    project_ = std::move(*project);
    Q_EMIT loaded();
  });
}

LoadJob::~LoadJob() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

}  // namespace soffit::ui
