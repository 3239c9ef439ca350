// SPDX-License-Identifier: MIT
#include "ui/main_window/main_window.h"

#include "ui/actions/file_dialogs.h"
#include "ui/document/recent_files.h"
#include "ui/document/state_folder.h"
#include "ui/document/text.h"
#include "ui/jobs/load_job.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QUndoGroup>
#include <QUndoView>

namespace soffit::ui {
namespace {

constexpr QSize kSize(1440, 900);
constexpr QSize kFrame(16, 48);  ///< what the desktop's own frame may take

}  // namespace

MainWindow::MainWindow()
    : workspace_(makeWorkspace(*this)),
      files_(*this, workspace_),
      pages_(new QStackedWidget),
      start_(new StartPage),
      undo_(new QUndoGroup(this)) {
  setObjectName(QStringLiteral("main"));
  workspace_.history->setGroup(undo_);
  // In a scroll area, for its size must not decide how small the window can be.
  auto* start = new QScrollArea;
  start->setWidget(start_);
  start->setWidgetResizable(true);
  start->setFrameShape(QFrame::NoFrame);
  pages_->addWidget(start);
  pages_->addWidget(workspace_.area);
  setCentralWidget(pages_);
  setAcceptDrops(true);
  connect(&files_, &ProjectFiles::openRequested, this, &MainWindow::openVersion);
  connect(start_, &StartPage::chosen, this, &MainWindow::open);
  connect(start_, &StartPage::openRequested, this, [this] {
    const QString path = askProjectToOpen(this);
    if (!path.isEmpty()) files_.openFile(path);
  });
  connect(start_, &StartPage::newRequested, &files_, &ProjectFiles::newProject);
  connect(start_, &StartPage::importRequested, this, [this] {
    const QString path = askModelToImport(this);
    if (!path.isEmpty()) files_.importModel(path);
  });
  connect(workspace_.status, &StatusLine::cancelRequested, this, [this] {
    if (load_ != nullptr) load_->cancel();
  });
  connect(&workspace_.area->input(), &ViewInput::editRequested, workspace_.luminaire, [this] {
    workspace_.docks.front()->show();
    workspace_.docks.front()->raise();
  });
  connect(&workspace_.area->input(), &ViewInput::surfaceDoubleClicked, workspace_.materials,
          [this] {
            for (QDockWidget* dock : workspace_.docks) {
              if (!dock->isAncestorOf(workspace_.materials)) continue;
              dock->show();
              dock->raise();
            }
          });
  connect(workspace_.area, &ViewArea::scaleRequested, workspace_.view, [this] {
    auto* dock = findChild<QDockWidget*>(QStringLiteral("view"));
    dock->show();
    dock->raise();
  });
  makeMenus();
  resize(kSize.boundedTo(screen()->availableSize() - kFrame));
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  restoreState(settings.value(QStringLiteral("window/docks")).toByteArray());
  workspace_.area->grid().restore(settings);
  showWorkspace(false);
}

MainWindow::~MainWindow() = default;

void MainWindow::showWorkspace(bool shown) {
  pages_->setCurrentIndex(shown ? 1 : 0);
  if (shown) {
    restoreState(docks_);
  } else {
    docks_ = saveState();
    for (QDockWidget* dock : workspace_.docks) dock->hide();
  }
  for (QAction* action : project_actions_) action->setEnabled(shown);
  if (!shown) start_->refresh();
  updateTitle();
}

void MainWindow::openVersion(const QString& path, const std::optional<std::string>& text) {
  if (!closeProject()) {
    if (!text) removeUntitledProject(path);  // a new one; a recovered one stays
    return;
  }
  if (!text) files_.forgetRecovery();
  load_ = std::make_unique<LoadJob>(path, text);
  connect(load_.get(), &LoadJob::progressed, workspace_.status, &StatusLine::showProgress);
  connect(load_.get(), &LoadJob::loaded, this, &MainWindow::finishOpening);
  connect(load_.get(), &LoadJob::failed, this, [this](const QString& message) {
    workspace_.status->endProgress();
    workspace_.log->addWarning(message);
    showError(this, tr("The project was not opened"), message);
  });
  workspace_.status->showProgress(tr("opening %1").arg(path), 0.0);
}

void MainWindow::finishOpening() {
  workspace_.status->endProgress();
  showWorkspace(true);
  session_ = std::make_unique<ProjectSession>(load_->take(), workspace_);
  Document& document = session_->document();
  if (!isUntitledProject(document.path())) rememberFile(document.path());
  files_.begin(*session_);
  undo_->addStack(document.undoStack());
  undo_->setActiveStack(document.undoStack());
  connect(&document, &Document::modifiedChanged, this, &MainWindow::updateTitle);
  connect(&document, &Document::pathChanged, this, &MainWindow::updateTitle);
  workspace_.area->view().setFocus();
  updateTitle();
}

bool MainWindow::closeProject() {
  load_.reset();
  if (session_ == nullptr) return true;
  if (!mayClose(this, session_->document())) return false;
  files_.end();
  session_.reset();
  return true;
}

void MainWindow::updateTitle() {
  if (session_ == nullptr) {
    setWindowTitle(tr("Soffit"));
    setWindowModified(false);
    return;
  }
  setWindowTitle(tr("%1[*] \u2013 Soffit").arg(session_->document().name()));
  setWindowFilePath(session_->document().path());
  setWindowModified(session_->document().isModified());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!ProjectFiles::droppable(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = ProjectFiles::droppable(event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  // After the drop: the other program waits for its end.
  QTimer::singleShot(0, this, [this, path] { files_.openFile(path); });
}

void MainWindow::closeEvent(QCloseEvent* event) {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  settings.setValue(QStringLiteral("window/docks"), session_ == nullptr ? docks_ : saveState());
  workspace_.area->grid().save(settings);
  event->setAccepted(closeProject());
}

}  // namespace soffit::ui
