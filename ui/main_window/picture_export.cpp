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

QString pathOf(const PictureSet& set, const QString& camera, const QString& layout) {
  const std::string of_layout = toStd(layout.isEmpty() ? PictureExport::tr("Base") : layout);
  const std::string of_camera = toStd(camera.isEmpty() ? PictureExport::tr("View") : camera);
  const std::string stem = io::fileNameOf(of_layout) + ", " + io::fileNameOf(of_camera) + ".";
  return QDir(set.folder).filePath(toQt(stem) + set.format);
}

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
  connect(&job_, &PictureJob::progressed, this, &PictureExport::showProgress);
}

QString PictureExport::titleOf(const render::PictureFacts& facts) const {
  QStringList parts{toQt(facts.project), toQt(facts.layout)};
  if (!facts.camera.empty()) parts.append(toQt(facts.camera));
  return parts.join(QStringLiteral(" \u2013 "));
}

std::optional<PictureOrder> PictureExport::order(const Wanted& wanted) const {
  // What is seen, unless a camera is wanted.
  SceneView& view =
      wanted.camera.isEmpty() ? workspace_.area->active().view() : workspace_.area->view();
  Shot shot;
  shot.pixels = wanted.pixels;
  shot.linear = !wanted.path.isEmpty() && io::isSceneLinear(toPath(wanted.path));
  shot.lux = !view.look().levels.empty() && !shot.linear;
  shot.traced = wanted.traced;
  if (wanted.traced) {
    shot.lamps = wanted.layout == document_.layout()
                     ? document_.litLuminaires()
                     : comparison_.lights().luminairesOf(wanted.layout);
  }
  for (const scene::Camera& camera : document_.scene()->cameras) {
    if (toQt(camera.name) == wanted.camera) shot.camera = ViewCamera::from(camera);
  }
  if (wanted.layout != document_.layout()) {
    shot.frame = comparison_.lights().frame(wanted.layout);
    if (shot.frame == nullptr) return std::nullopt;
    shot.luminaires = std::make_shared<const EmitterSet>(
        comparison_.lights().luminairesOf(wanted.layout), document_.scene()->mesh->origin);
  }
  auto still = view.still(shot);
  if (!still) return std::nullopt;
  still->marks = marks_.marksOf(wanted.layout);
  still->font = workspace_.area->marks().font();
  PictureFile file;
  file.path = wanted.path;
  file.facts = factsOf(document_, wanted.layout, wanted.camera);
  file.legend = wanted.legend;
  if (wanted.title) file.title = titleOf(file.facts);
  return PictureOrder{std::move(*still), std::move(file)};
}

void PictureExport::take(const Wanted& wanted) {
  ++asked_;
  if (auto ordered = order(wanted)) {
    start(std::move(*ordered), wanted);
    return;
  }
  PictureOutcome none;
  none.error =
      tr("There is no light to take a picture of yet. Wait until the first light is "
         "computed.");
  end(wanted, none);
}

void PictureExport::start(PictureOrder order, const Wanted& wanted) {
  if (wanted.traced && !isTraceable(order.still)) {
    workspace_.log->addLine(
        tr("%1 is drawn as in the view: false colours, isolux lines and flat views are not traced")
            .arg(QFileInfo(wanted.path).fileName()));
  }
  showProgress(0.0);
  job_.take(std::move(order),
            [this, wanted](const PictureOutcome& outcome) { end(wanted, outcome); });
}

void PictureExport::end(const Wanted& wanted, const PictureOutcome& outcome) {
  ++ended_;
  const bool good = outcome.error.isEmpty() && !outcome.cancelled;
  if (!outcome.error.isEmpty()) {
    asked_ -= static_cast<int>(left_.size());
    left_.clear();
  }
  if (good && wanted.path.isEmpty()) {
    QGuiApplication::clipboard()->setImage(outcome.image);
    Q_EMIT copied();
  } else if (good) {
    Q_EMIT written(wanted.path);
  }
  if (wanted.of_set) {
    set_drawing_ = false;
    if (good) ++set_written_;
    next();
  }
  endProgress();
  if (!outcome.error.isEmpty()) Q_EMIT failed(outcome.error);
}

void PictureExport::endProgress() {
  if (asked_ == 0 || ended_ < asked_) return;
  asked_ = ended_ = 0;
  workspace_.status->endProgress();
}

void PictureExport::showProgress(double within) {
  if (asked_ == 0) return;  // of one that was given up
  workspace_.status->showProgress(tr("taking pictures"),
                                  (ended_ + within) / static_cast<double>(asked_));
}

void PictureExport::exportView(const QString& path, const QSize& pixels, bool legend, bool title,
                               bool traced) {
  Wanted wanted;
  wanted.layout = document_.layout();
  wanted.path = path;
  wanted.pixels = pixels;
  wanted.legend = legend;
  wanted.title = title;
  wanted.traced = traced;
  take(wanted);
}

void PictureExport::exportView() {
  QWidget* window = workspace_.area->window();
  PictureDialog dialog(workspace_.area->active().view().pixelSize(), window);
  dialog.setTraced(workspace_.area->active().view().showsTraced());
  if (dialog.exec() != QDialog::Accepted) return;
  const QFileInfo project(document_.path());
  const QString ending = dialog.format();
  QString path = QFileDialog::getSaveFileName(
      window, tr("Export the view"),
      project.dir().filePath(project.completeBaseName() + QLatin1Char('.') + ending),
      tr("Pictures (*.%1)").arg(ending));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + ending;
  exportView(path, dialog.pixels(), dialog.legend(), dialog.title(), dialog.traced());
}

void PictureExport::copyView() {
  Wanted wanted;
  wanted.layout = document_.layout();
  wanted.pixels = workspace_.area->active().view().pixelSize();
  wanted.traced = workspace_.area->active().view().showsTraced();
  take(wanted);
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
             dialog.legend(), dialog.title(), dialog.traced()});
}

void PictureExport::exportSet(const PictureSet& set) {
  for (const QString& layout : set.layouts) {
    for (const QString& camera : set.cameras) {
      left_.push_back({camera, layout, pathOf(set, camera, layout), set.pixels, set.legend,
                       set.title, set.traced, true});
    }
  }
  asked_ += static_cast<int>(set.layouts.size() * set.cameras.size());
  set_running_ = true;
  next();
}

void PictureExport::cancel() {
  asked_ -= static_cast<int>(left_.size());
  left_.clear();
  job_.cancel();
  // A picture under way tells its end itself.
  if (!set_drawing_) next();
  endProgress();
}

/// The next picture of the set, as soon as its light is there.
void PictureExport::next() {
  if (!set_running_ || set_drawing_) return;
  if (left_.empty()) {
    set_running_ = false;
    Q_EMIT setFinished(std::exchange(set_written_, 0));
    return;
  }
  const Wanted wanted = left_.front();
  showProgress(0.0);
  const bool lit = workspace_.area->view().meshSolver() != nullptr &&
                   comparison_.lights().isCurrent(wanted.layout);
  // A light of other reflectances than the mesh's: the mesh comes soon.
  auto ordered = lit ? order(wanted) : std::nullopt;
  if (!ordered) {
    QTimer::singleShot(kWaitMs, this, &PictureExport::next);
    return;
  }
  left_.pop_front();
  set_drawing_ = true;
  start(std::move(*ordered), wanted);
}

}  // namespace soffit::ui
