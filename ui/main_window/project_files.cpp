// SPDX-License-Identifier: MIT
#include "ui/main_window/project_files.h"

#include "core/io/project/move_project.h"
#include "ui/actions/file_dialogs.h"
#include "ui/actions/import_sheet.h"
#include "ui/actions/recovery_dialog.h"
#include "ui/document/state_folder.h"
#include "ui/document/text.h"

#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

#include <utility>

namespace soffit::ui {
namespace {

constexpr QSize kThumbnail(256, 160);
constexpr int kThumbnailSamples = 2;

}  // namespace

ProjectFiles::ProjectFiles(QWidget& window, Workspace& workspace)
    : window_(window), workspace_(workspace) {
  connect(&relay_, &ProgressRelay::progressed, workspace_.status, &StatusLine::showProgress);
  connect(workspace_.status, &StatusLine::cancelRequested, this, &ProjectFiles::cancelImport);
}

ProjectFiles::~ProjectFiles() {
  stop_.request_stop();
}

void ProjectFiles::newProject() {
  const QString path = makeUntitledProject(tr("Untitled"));
  if (path.isEmpty()) {
    showError(&window_, tr("No project can be made"),
              tr("The folder %1 cannot be written.").arg(stateFolder(QString())));
    return;
  }
  Q_EMIT openRequested(path, std::nullopt);
}

void ProjectFiles::openFile(const QString& path) {
  if (io::isModelFile(toPath(path))) {
    importModel(path);
  } else {
    Q_EMIT openRequested(path, std::nullopt);
  }
}

void ProjectFiles::importModel(const QString& path) {
  const QString open = session_ == nullptr ? QString() : session_->document().name();
  ImportSheet sheet(path, open, &window_);
  if (sheet.exec() != QDialog::Accepted) return;
  stop_ = std::stop_source();
  io::ImportChoices choices;
  choices.unit = sheet.unit();
  choices.up = sheet.up();
  choices.job = Job{&relay_, stop_.get_token()};
  workspace_.status->showProgress(tr("importing %1").arg(QFileInfo(path).fileName()), 0.0);
  if (sheet.toOpenProject() && session_ != nullptr) {
    importInto(path, choices);
  } else {
    importAs(path, sheet.newProject(), choices);
  }
}

void ProjectFiles::endImport(const QString& message) {
  workspace_.status->endProgress();
  if (message.isEmpty() || stop_.stop_requested()) return;
  workspace_.log->addWarning(message);
  showError(&window_, tr("The model was not imported"), message);
}

void ProjectFiles::importInto(const QString& model, const io::ImportChoices& choices) {
  const io::Project project = session_->document().current();
  background_.run([this, project, model, choices, session = session_]() -> Background::End {
    std::vector<std::string> written;
    auto grown = std::make_shared<Result<io::Project>>(
        io::withModel(project, toPath(model), choices, &written));
    return [this, grown, model, session, folder = project.path.parent_path(), written] {
      copied_.add(folder, *grown ? (*grown)->geometry.back().file : std::string(), written);
      if (session_ == nullptr) copied_.removeUnneeded();
      endImport(*grown ? QString() : messageOf(grown->error()));
      if (!*grown || session != session_) return;  // closed meanwhile
      for (const std::string& warning : (*grown)->warnings) {
        workspace_.log->addWarning(toQt(warning));
      }
      const bool empty = session_->document().scene()->mesh->triangleCount() == 0;
      session_->document().growTo(tr("Import %1").arg(QFileInfo(model).fileName()),
                                  std::move(**grown));
      if (empty) session_->showFirstCamera();
    };
  });
}

void ProjectFiles::importAs(const QString& model, const QString& project,
                            const io::ImportChoices& choices) {
  background_.run([this, model, project, choices]() -> Background::End {
    const auto made = io::importProject(toPath(model), toPath(project), choices);
    const QString message = made ? QString() : messageOf(made.error());
    return [this, message, project] {
      endImport(message);
      if (message.isEmpty()) Q_EMIT openRequested(project, std::nullopt);
    };
  });
}

void ProjectFiles::offerRecovery() {
  const QList<Recovery> recoveries = findRecoveries();
  if (recoveries.isEmpty()) return;
  RecoveryDialog dialog(recoveries, &window_);
  if (dialog.exec() != QDialog::Accepted) return;
  const Recovery chosen = dialog.chosen();
  const QByteArray text = recoveredText(chosen.id);
  if (chosen.path.isEmpty() || text.isEmpty()) return;
  opening_ = chosen;
  Q_EMIT openRequested(chosen.path, text.toStdString());
}

void ProjectFiles::begin(ProjectSession& session) {
  session_ = &session;
  const Document& document = session.document();
  const auto saved = [this, &document] {
    copied_.saved(document.project().path.parent_path(), document.project().geometry);
  };
  connect(&document, &Document::modifiedChanged, this, [saved](bool modified) {
    if (!modified) saved();
  });
  connect(&document, &Document::pathChanged, this, saved);
  autosave_ = std::make_unique<Autosave>(session.document());
  autosave_->setThumbnails([this] {
    Shot shot;
    shot.pixels = kThumbnail;
    shot.samples = kThumbnailSamples;
    shot.look = plain(workspace_.area->view().look());
    return workspace_.area->view().take(shot).image;
  });
  connect(autosave_.get(), &Autosave::failed, workspace_.log, &LogPanel::addWarning);
  // Another project may have been opened in its place, when it could not be.
  const Recovery opening = std::exchange(opening_, {});
  recovered_ = opening.path == session.document().path() ? opening.id : QString();
  if (recovered_.isEmpty()) return;
  // The old version goes once the new one is on the disk.
  connect(autosave_.get(), &Autosave::kept, this, [this] {
    if (!recovered_.isEmpty()) discardRecovery(std::exchange(recovered_, QString()));
  });
  session.document().setRecovered();
  autosave_->keep();
}

void ProjectFiles::end() {
  if (session_ == nullptr) return;
  autosave_.reset();
  if (!recovered_.isEmpty()) discardRecovery(std::exchange(recovered_, QString()));
  copied_.removeUnneeded();
  removeUntitledProject(session_->document().path());
  session_ = nullptr;
}

QString ProjectFiles::droppable(const QMimeData* mime) {
  const QList<QUrl> urls = mime->urls();
  if (urls.size() != 1 || !urls.front().isLocalFile()) return {};
  const QString path = urls.front().toLocalFile();
  const bool known =
      path.endsWith(QLatin1String(".soffit"), Qt::CaseInsensitive) || io::isModelFile(toPath(path));
  return known ? path : QString();
}

}  // namespace soffit::ui
