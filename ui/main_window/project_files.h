// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/import_project.h"
#include "ui/document/copied_files.h"
#include "ui/jobs/autosave.h"
#include "ui/jobs/background.h"
#include "ui/jobs/progress_relay.h"
#include "ui/jobs/recovery.h"
#include "ui/main_window/project_session.h"

#include <QObject>

#include <memory>
#include <optional>
#include <stop_token>
#include <string>

class QMimeData;
class QWidget;

namespace soffit::ui {

/// What the File menu and files dropped on the window do: new projects, models that are imported,
/// versions kept against a crash. Opening itself is the window's.
class ProjectFiles : public QObject {
  Q_OBJECT

 public:
  ProjectFiles(QWidget& window, Workspace& workspace);
  ~ProjectFiles() override;

  /// An empty project without a place.
  void newProject();
  /// A project is opened, a model is asked about.
  void openFile(const QString& path);
  /// Shows the sheet for a model and imports it.
  void importModel(const QString& path);
  /// Gives up the import under way.
  void cancelImport() { stop_.request_stop(); }
  /// Offers what an earlier run left, if anything.
  void offerRecovery();

  /// What is being opened is the file itself, not a version of it.
  void forgetRecovery() { opening_ = {}; }

  /// A session began: its changes are kept from now on.
  void begin(ProjectSession& session);
  /// It is about to end with nothing left to save.
  void end();
  [[nodiscard]] Autosave* autosave() { return autosave_.get(); }

  /// The file that is dragged, if it is one that can be dropped here; else empty.
  [[nodiscard]] static QString droppable(const QMimeData* mime);

 Q_SIGNALS:
  /// A project is to be opened; text: in place of the file's, with changes not yet saved.
  void openRequested(const QString& path, const std::optional<std::string>& text);

 private:
  void importInto(const QString& model, const io::ImportChoices& choices);
  void importAs(const QString& model, const QString& project, const io::ImportChoices& choices);
  void endImport(const QString& message);

  QWidget& window_;
  Workspace& workspace_;
  ProjectSession* session_ = nullptr;
  std::unique_ptr<Autosave> autosave_;
  Recovery opening_;   ///< version that is being opened
  QString recovered_;  ///< version that the session came from, while it is the only one
  CopiedFiles copied_;
  std::stop_source stop_;
  ProgressRelay relay_;
  Background background_;
};

}  // namespace soffit::ui
