// SPDX-License-Identifier: MIT
#include "ui/actions/file_dialogs.h"

#include "core/io/project/move_project.h"
#include "ui/document/recent_files.h"
#include "ui/document/state_folder.h"
#include "ui/document/text.h"
#include "ui/jobs/background.h"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include <optional>

namespace soffit::ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

/// Written on another thread; the window goes on painting, but takes no input meanwhile.
bool saveTo(QWidget* parent, Document& document, const QString& path) {
  const io::Project project = document.current();
  std::optional<Result<io::Project>> saved;
  QEventLoop loop;
  {
    Background background;
    background.run([&saved, project, file = toPath(path), &loop]() -> Background::End {
      saved = io::saveProjectAs(project, file);
      return [&loop] { loop.quit(); };
    });
    loop.exec(QEventLoop::ExcludeUserInputEvents);
  }
  if (!*saved) {
    showError(parent, tr("The project was not saved"), messageOf(saved->error()));
    return false;
  }
  const QString before = document.path();
  document.setSaved(**saved);
  rememberFile(path);
  if (before != path) removeUntitledProject(before);
  return true;
}

}  // namespace

void showError(QWidget* parent, const QString& title, const QString& message) {
  QMessageBox box(QMessageBox::Warning, title, title, QMessageBox::Ok, parent);
  box.setInformativeText(message);
  box.setTextInteractionFlags(Qt::TextSelectableByMouse);
  box.exec();
}

QString askProjectToOpen(QWidget* parent) {
  const QStringList recent = recentFiles();
  const QString folder = recent.isEmpty() ? QDir::homePath() : QFileInfo(recent.front()).path();
  return QFileDialog::getOpenFileName(parent, tr("Open a project"), folder,
                                      tr("Soffit projects (*.soffit);;All files (*)"));
}

QString askModelToImport(QWidget* parent) {
  const QStringList recent = recentFiles();
  const QString folder = recent.isEmpty() ? QDir::homePath() : QFileInfo(recent.front()).path();
  return QFileDialog::getOpenFileName(
      parent, tr("Import a model"), folder,
      tr("Models (*.obj *.gltf *.glb *.ply *.stl *.3ds *.fbx *.dae *.ifc);;All files (*)"));
}

bool save(QWidget* parent, Document& document) {
  if (isUntitledProject(document.path())) return saveAs(parent, document);
  return saveTo(parent, document, document.path());
}

bool saveAs(QWidget* parent, Document& document) {
  QString suggestion = document.path();
  if (isUntitledProject(suggestion)) {
    const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    suggestion = documents.filePath(document.name() + QStringLiteral(".soffit"));
  }
  QString path = QFileDialog::getSaveFileName(parent, tr("Save the project as"), suggestion,
                                              tr("Soffit projects (*.soffit)"));
  if (path.isEmpty()) return false;
  if (!path.endsWith(QLatin1String(".soffit"))) path += QStringLiteral(".soffit");
  return saveAs(parent, document, path);
}

bool saveAs(QWidget* parent, Document& document, const QString& path) {
  return saveTo(parent, document, path);
}

bool mayClose(QWidget* parent, Document& document) {
  if (!document.isModified()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                  tr("Save the changes to \u201c%1\u201d?").arg(document.name()),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
  box.setInformativeText(tr("Without saving they are lost."));
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return save(parent, document);
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

}  // namespace soffit::ui
