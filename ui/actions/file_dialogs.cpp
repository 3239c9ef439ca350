// SPDX-License-Identifier: MIT
#include "ui/actions/file_dialogs.h"

#include "core/io/image/write_image.h"
#include "ui/document/recent_files.h"
#include "ui/document/text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace soffit::ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Files", text);
}

bool saveTo(QWidget* parent, Document& document, const QString& path) {
  const auto saved = document.save(toPath(path));
  if (!saved) {
    showError(parent, tr("The project was not saved"), messageOf(saved.error()));
    return false;
  }
  rememberFile(path);
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

bool save(QWidget* parent, Document& document) {
  return saveTo(parent, document, document.path());
}

bool saveAs(QWidget* parent, Document& document) {
  const QFileInfo old(document.path());
  QString path = QFileDialog::getSaveFileName(parent, tr("Save the project as"), document.path(),
                                              tr("Soffit projects (*.soffit)"));
  if (path.isEmpty()) return false;
  if (!path.endsWith(QLatin1String(".soffit"))) path += QStringLiteral(".soffit");
  if (QFileInfo(path).dir().canonicalPath() != old.dir().canonicalPath()) {
    showError(parent, tr("The project stays in its folder"),
              tr("The models and photometric files that it names lie in %1. Choose another name "
                 "there, or copy the whole folder first.")
                  .arg(old.dir().path()));
    return false;
  }
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

Result<void> writePicture(const QString& path, const Document& document, const QImage& picture) {
  scene::Image image{picture.width(), picture.height(), 3, {}};
  image.pixels.reserve(3 * static_cast<std::size_t>(picture.width()) *
                       static_cast<std::size_t>(picture.height()));
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  for (int y = 0; y < rgb.height(); ++y) {
    const uchar* row = rgb.constScanLine(y);
    for (int i = 0; i < 3 * rgb.width(); ++i) {
      image.pixels.push_back(static_cast<float>(row[i]) / 255.0F);
    }
  }
  io::WriteOptions options;
  options.metadata = {{"Project", document.scene()->name}, {"Layout", toStd(document.layout())}};
  return io::writeImage(toPath(path), image, options);
}

bool exportPicture(QWidget* parent, const Document& document, const QImage& picture) {
  const QFileInfo project(document.path());
  const QString suggestion =
      project.dir().filePath(project.completeBaseName() + QStringLiteral(".png"));
  QString path = QFileDialog::getSaveFileName(parent, tr("Export the view"), suggestion,
                                              tr("Pictures (*.png *.jpg *.tif)"));
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".png");
  const auto written = writePicture(path, document, picture);
  if (!written) showError(parent, tr("The picture was not written"), messageOf(written.error()));
  return written.ok();
}

}  // namespace soffit::ui
