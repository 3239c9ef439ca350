// SPDX-License-Identifier: MIT
#include "ui/main_window/picture_export.h"

#include "core/io/image/file_name.h"
#include "core/io/image/write_image.h"
#include "ui/actions/file_dialogs.h"
#include "ui/actions/picture_dialog.h"
#include "ui/document/text.h"

#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QTimer>

#include <algorithm>
#include <memory>
#include <utility>

namespace soffit::ui {
namespace {

/// How often the light of a layout is looked for.
constexpr int kWaitMs = 50;

QStringList layoutNames(const Document& document) {
  QStringList names{QString()};
  for (const scene::Layout& layout : document.scene()->layouts) names.append(toQt(layout.name));
  return names;
}

}  // namespace

PictureExport::PictureExport(Document& document, Workspace& workspace,
                             ComparisonSession& comparison, const LightMarks& marks)
    : document_(document), workspace_(workspace), comparison_(comparison), marks_(marks) {
  connect(this, &PictureExport::written, workspace_.log,
          [this](const QString& path) { workspace_.log->addLine(tr("Wrote %1").arg(path)); });
  connect(workspace_.status, &StatusLine::cancelRequested, this, &PictureExport::cancel);
}

QString PictureExport::titleOf(const render::PictureFacts& facts) const {
  QStringList parts{toQt(facts.project), toQt(facts.layout)};
  if (!facts.camera.empty()) parts.append(toQt(facts.camera));
  return parts.join(QStringLiteral(" \u2013 "));
}

PictureFile PictureExport::take(const QString& path, const QSize& pixels, const Wanted& wanted,
                                bool linear) const {
  // What is seen, unless a camera is wanted.
  SceneView& view =
      wanted.camera.isEmpty() ? workspace_.area->active().view() : workspace_.area->view();
  Shot shot;
  shot.pixels = pixels;
  shot.linear = linear;
  shot.lux = !view.look().levels.empty() && !linear;
  for (const scene::Camera& camera : document_.scene()->cameras) {
    if (toQt(camera.name) == wanted.camera) shot.camera = ViewCamera::from(camera);
  }
  if (wanted.layout != document_.layout()) {
    shot.frame = comparison_.lights().frame(wanted.layout);
    shot.luminaires = std::make_shared<const EmitterSet>(
        comparison_.lights().luminairesOf(wanted.layout), document_.scene()->mesh->origin);
  }
  PictureFile file;
  file.path = path;
  file.picture = view.take(shot);
  workspace_.area->marks().paintInto(file.picture, marks_.marksOf(wanted.layout),
                                     shot.camera.value_or(view.viewCamera()));
  file.look = view.look();
  file.facts = factsOf(document_, wanted.layout, wanted.camera);
  return file;
}

void PictureExport::write(PictureFile file) {
  background_.run(
      [this, file = std::make_shared<const PictureFile>(std::move(file))]() -> Background::End {
        const auto done = writePictureFile(*file);
        const QString message = done ? QString() : messageOf(done.error());
        return [this, file, message] {
          if (message.isEmpty()) {
            Q_EMIT written(file->path);
          } else {
            Q_EMIT failed(message);
          }
        };
      });
}

void PictureExport::exportView(const QString& path, const QSize& pixels, bool legend, bool title) {
  PictureFile file =
      take(path, pixels, {QString(), document_.layout()}, io::isSceneLinear(toPath(path)));
  file.legend = legend;
  if (title) file.title = titleOf(file.facts);
  write(std::move(file));
}

void PictureExport::exportView() {
  QWidget* window = workspace_.area->window();
  PictureDialog dialog(workspace_.area->active().view().pixelSize(), window);
  if (dialog.exec() != QDialog::Accepted) return;
  const QFileInfo project(document_.path());
  const QString ending = dialog.format();
  QString path = QFileDialog::getSaveFileName(
      window, tr("Export the view"),
      project.dir().filePath(project.completeBaseName() + QLatin1Char('.') + ending),
      tr("Pictures (*.%1)").arg(ending));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + ending;
  exportView(path, dialog.pixels(), dialog.legend(), dialog.title());
}

void PictureExport::copyView() {
  PictureFile file = take({}, workspace_.area->active().view().pixelSize(),
                          {QString(), document_.layout()}, false);
  if (!file.picture.image.isNull()) QGuiApplication::clipboard()->setImage(decorated(file));
}

void PictureExport::exportSet() {
  QWidget* window = workspace_.area->window();
  QStringList cameras;
  for (const scene::Camera& camera : document_.scene()->cameras) {
    cameras.append(toQt(camera.name));
  }
  if (cameras.isEmpty()) {
    showError(window, tr("The project has no cameras"),
              tr("Save views in the Cameras panel: the set takes a picture from each."));
    return;
  }
  PictureDialog dialog(workspace_.area->view().pixelSize(), cameras, layoutNames(document_),
                       window);
  if (dialog.exec() != QDialog::Accepted) return;
  const QString folder = QFileDialog::getExistingDirectory(window, tr("Folder for the pictures"),
                                                           QFileInfo(document_.path()).path());
  if (folder.isEmpty()) return;
  exportSet({dialog.cameras(), dialog.layouts(), dialog.pixels(), dialog.format(), folder,
             dialog.legend(), dialog.title()});
}

void PictureExport::exportSet(const PictureSet& set) {
  set_ = set;
  left_.clear();
  for (const QString& layout : set.layouts) {
    for (const QString& camera : set.cameras) left_.push_back({camera, layout});
  }
  count_ = static_cast<int>(left_.size());
  taken_ = 0;
  next();
}

void PictureExport::cancel() {
  left_.clear();
}

QString PictureExport::pathOf(const Wanted& wanted) const {
  const std::string layout = wanted.layout.isEmpty() ? toStd(tr("Base")) : toStd(wanted.layout);
  const std::string camera = wanted.camera.isEmpty() ? toStd(tr("View")) : toStd(wanted.camera);
  return QDir(set_.folder)
      .filePath(toQt(io::fileNameOf(layout) + ", " + io::fileNameOf(camera) + ".") + set_.format);
}

void PictureExport::next() {
  if (left_.empty()) {
    if (count_ == 0) return;
    workspace_.status->endProgress();
    Q_EMIT setFinished(std::exchange(taken_, 0));
    count_ = 0;
    return;
  }
  const Wanted wanted = left_.front();
  workspace_.status->showProgress(tr("taking pictures"),
                                  static_cast<double>(taken_) / static_cast<double>(count_));
  const bool drawn = workspace_.area->view().meshSolver() != nullptr &&
                     comparison_.lights().isCurrent(wanted.layout);
  if (drawn) {
    const QString path = pathOf(wanted);
    PictureFile file = take(path, set_.pixels, wanted, io::isSceneLinear(toPath(path)));
    // A light of other reflectances than the mesh's: the mesh comes soon.
    if (!file.picture.image.isNull()) {
      file.legend = set_.legend;
      if (set_.title) file.title = titleOf(file.facts);
      write(std::move(file));
      left_.pop_front();
      ++taken_;
    }
  }
  QTimer::singleShot(drawn ? 0 : kWaitMs, this, &PictureExport::next);
}

}  // namespace soffit::ui
