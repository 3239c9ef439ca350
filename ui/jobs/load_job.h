// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/project.h"
#include "ui/jobs/progress_relay.h"

#include <QObject>
#include <QString>

#include <optional>
#include <thread>

namespace soffit::ui {

/// Reads a project on a thread of its own. One project per object; deleting it cancels.
class LoadJob : public QObject {
  Q_OBJECT

 public:
  /// text: the content to load in place of the file's; nothing: the file's.
  explicit LoadJob(const QString& path, std::optional<std::string> text = {},
                   QObject* parent = nullptr);
  ~LoadJob() override;

  void cancel() { thread_.request_stop(); }
  [[nodiscard]] const QString& path() const { return path_; }
  /// The project, once, after loaded().
  [[nodiscard]] io::Project take() { return std::move(*project_); }

 Q_SIGNALS:
  void progressed(const QString& stage, double done);
  void loaded();
  void failed(const QString& message);

 private:
  QString path_;
  ProgressRelay relay_;
  std::optional<io::Project> project_;
  std::jthread thread_;
};

}  // namespace soffit::ui
