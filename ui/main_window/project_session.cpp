// SPDX-License-Identifier: MIT
#include "ui/main_window/project_session.h"

#include "core/color/exposure.h"
#include "core/io/project/starting_place.h"
#include "ui/actions/file_dialogs.h"
#include "ui/actions/results_actions.h"
#include "ui/document/camera_edits.h"
#include "ui/document/text.h"
#include "ui/viewport/picture_pass.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

/// Nearly all surfaces are below this share of the sorted values.
constexpr double kNearlyAll = 0.98;

double percentileLux(const LightFrame& frame) {
  std::vector<float> lux;
  for (std::size_t i = 0; i < frame.lux[0].size(); i += 7) {
    lux.push_back(0.2126F * frame.lux[0][i] + 0.7152F * frame.lux[1][i] +
                  0.0722F * frame.lux[2][i]);
  }
  if (lux.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(kNearlyAll * static_cast<double>(lux.size() - 1));
  std::nth_element(lux.begin(), lux.begin() + rank, lux.end());
  return static_cast<double>(lux[static_cast<std::size_t>(rank)]);
}

}  // namespace

ProjectSession::ProjectSession(io::Project project, Workspace& workspace, QObject* parent)
    : QObject(parent),
      document_(std::move(project)),
      workspace_(workspace),
      relighting_(document_),
      readings_(document_, relighting_),
      verification_(document_, relighting_) {
  ViewGrid& views = workspace_.area->grid();
  views.setScene(document_.scene());
  views.setDocument(&document_);
  workspace_.cameras->setDocument(&document_);
  workspace_.lights->setDocument(&document_);
  workspace_.luminaire->setDocument(&document_);
  workspace_.mixer->setDocument(&document_);
  workspace_.materials->setDocument(&document_);
  workspace_.daylight->setDocument(&document_);
  workspace_.layouts->setDocument(&document_);
  workspace_.view->setDocument(&document_);
  workspace_.quality->setDocument(&document_);
  for (const std::string& warning : document_.project().warnings) {
    workspace_.log->addWarning(toQt(warning));
  }
  connectView();
  connectPanels();
  connectProgress();
  connectResults();
  connectVerification();
  comparison_ = std::make_unique<ComparisonSession>(document_, relighting_, readings_, workspace_);
  OtherLights& others = comparison_->lights();
  views.setOtherLayouts({[&others](const QString& layout) { return others.frame(layout); },
                         [this, &others](const QString& layout) {
                           return std::make_shared<const EmitterSet>(
                               others.luminairesOf(layout), document_.scene()->mesh->origin);
                         }});
  connect(&others, &OtherLights::ready, &views, &ViewGrid::catchUp);
  marks_ = std::make_unique<LightMarks>(document_, relighting_, readings_, workspace_);
  pictures_ = std::make_unique<PictureExport>(document_, workspace_, *comparison_, *marks_);
  tracer_ = std::make_unique<RestTracer>(document_, workspace_, relighting_);
  connect(pictures_.get(), &PictureExport::failed, this, [this](const QString& message) {
    showError(workspace_.area->window(), tr("The picture was not written"), message);
  });
  showFirstCamera();
  offerViews();
  placeLuminaires();
  workspace_.area->setNotice(tr("Computing the first light\u2026"));
}

ProjectSession::~ProjectSession() {
  workspace_.area->grid().setOtherLayouts({});
  tracer_.reset();
  pictures_.reset();
  marks_.reset();
  comparison_.reset();
  workspace_.cameras->setDocument(nullptr);
  ViewGrid& views = workspace_.area->grid();
  views.setDocument(nullptr);
  workspace_.lights->setDocument(nullptr);
  workspace_.luminaire->setDocument(nullptr);
  workspace_.mixer->setDocument(nullptr);
  workspace_.materials->setDocument(nullptr);
  workspace_.daylight->setDocument(nullptr);
  workspace_.layouts->setDocument(nullptr);
  workspace_.view->setDocument(nullptr);
  workspace_.quality->setDocument(nullptr);
  workspace_.results->setReadings(nullptr);
  workspace_.verify->setVerification(nullptr);
  for (std::size_t i = 0; i < views.count(); ++i) workspace_.area->errors(i).setPoints({});
  workspace_.status->setVerified({});
  workspace_.status->endProgress();
  workspace_.area->setNotice({});
  views.setSelection({});
  views.setLuminaires(nullptr);
  views.setScene(nullptr);
}

void ProjectSession::connectView() {
  SceneView& view = workspace_.area->view();
  connect(&relighting_, &Relighting::frameChanged, this, &ProjectSession::onFrame);
  connect(&document_, &Document::sceneChanged, this, [this] {
    workspace_.area->grid().setScene(document_.scene());
    offerViews();
    placeLuminaires();
  });
  connect(&document_, &Document::hiddenChanged, this, &ProjectSession::placeLuminaires);
  connect(&workspace_.area->input(), &ViewInput::hintChanged, workspace_.status,
          &StatusLine::showHint);
  connect(&document_, &Document::selectionChanged, this,
          [this] { workspace_.area->grid().setSelection(document_.selection()); });
  connect(&view, &SceneView::lightShown, this, [this](quint64, double frame_ms) {
    workspace_.area->setNotice({});
    if (relighting_.frame() != nullptr) {
      workspace_.status->showLight(*relighting_.frame(), frame_ms);
    }
    const SkyEvaluation::Figures sky = workspace_.area->view().skyFigures();
    workspace_.quality->showSky(sky);
    if (sky.where == SkyEvaluation::Figures::Where::refused) {
      workspace_.evaluation->setObstacle(
          tr("the transfer vectors of this building do not fit into the graphics processor"));
    }
  });
  // Another building, another size.
  workspace_.evaluation->setObstacle({});
  connect(&view, &SceneView::meshChanged, workspace_.evaluation,
          [evaluation = workspace_.evaluation] { evaluation->setObstacle({}); });
  const auto choose = [this] { relighting_.setHeldInParts(workspace_.evaluation->onGpu()); };
  connect(workspace_.evaluation, &EvaluationChoice::changed, this, choose);
  choose();
  connect(&workspace_.area->input(), &ViewInput::pointed, this,
          [this](const PointedAt& at) { workspace_.status->showReading(at.surface); });
  connect(&workspace_.area->input(), &ViewInput::surfaceClicked, this,
          [this](const SurfaceReading& at) { workspace_.materials->choose(toQt(at.material)); });
  connect(&workspace_.area->input(), &ViewInput::left, this,
          [this] { workspace_.status->showReading(std::nullopt); });
}

void ProjectSession::connectPanels() {
  ViewPanel* panel = workspace_.view;
  const auto take_look = [this, panel] {
    const auto set = workspace_.area->setLook(panel->look(), panel->planeLook().levels,
                                              panel->planeLook().values);
    if (!set) workspace_.log->addWarning(messageOf(set.error()));
  };
  connect(panel, &ViewPanel::lookChanged, this, take_look);
  connect(workspace_.daylight, &DaylightPanel::held, this,
          [this](bool in_hand) { workspace_.area->active().view().setMoving(in_hand); });
  connect(workspace_.daylight, &DaylightPanel::failed, this, [this](const QString& message) {
    showError(workspace_.area->window(), tr("The picture was not read"), message);
  });
  CamerasPanel* cameras = workspace_.cameras;
  connect(cameras, &CamerasPanel::cameraChosen, this, &ProjectSession::showCamera);
  connect(&workspace_.area->grid(), &ViewGrid::cameraChosen, this, &ProjectSession::showCamera);
  connect(cameras, &CamerasPanel::saveRequested, this, &ProjectSession::saveCamera);
  connect(cameras, &CamerasPanel::updateRequested, this, &ProjectSession::updateCamera);
  connect(panel, &ViewPanel::autoExposureRequested, this, &ProjectSession::exposeAutomatically);
  take_look();
}

void ProjectSession::connectProgress() {
  RelightWorker& worker = relighting_.worker();
  connect(&worker, &RelightWorker::progressed, workspace_.status, &StatusLine::showProgress);
  connect(&worker, &RelightWorker::bakeFinished, this, [this](const QString& detail) {
    workspace_.status->endProgress();
    workspace_.log->addLine(detail.isEmpty() ? tr("The precomputation was cancelled") : detail);
    if (relighting_.frame() == nullptr && detail.isEmpty())
      workspace_.area->setNotice(tr("No light was computed"));
  });
  connect(&worker, &RelightWorker::lightFinished, workspace_.status, &StatusLine::endProgress);
  connect(&worker, &RelightWorker::outsideLeftOut, this, [this] {
    workspace_.log->addLine(
        tr("Light from outside was left out; any change of it computes it again"));
  });
  connect(&worker, &RelightWorker::failed, workspace_.log, &LogPanel::addWarning);
  connect(workspace_.status, &StatusLine::cancelRequested, &worker, &RelightWorker::cancelBake);
}

void ProjectSession::connectResults() {
  connect(&readings_, &LiveReadings::changed, this,
          [this] { workspace_.results->setReadings(readings_.readings()); });
  connect(&readings_, &LiveReadings::failed, workspace_.log, &LogPanel::addWarning);
  connect(workspace_.results, &ResultsPanel::layoutChosen, &document_, &Document::setLayout);
  connect(workspace_.results, &ResultsPanel::exportRequested, this, &ProjectSession::exportResults);
}

void ProjectSession::connectVerification() {
  workspace_.verify->setVerification(&verification_, &document_);
  connect(&verification_, &Verification::progressed, workspace_.status, &StatusLine::showProgress);
  connect(workspace_.status, &StatusLine::cancelRequested, &verification_, &Verification::cancel);
  connect(&verification_, &Verification::finished, workspace_.status, &StatusLine::endProgress);
  connect(&verification_, &Verification::stopped, this, [this](const QString& why) {
    workspace_.status->endProgress();
    if (!why.isEmpty()) workspace_.log->addWarning(why);
  });
  connect(&verification_, &Verification::changed, this, [this] {
    QString badge;
    if (verification_.isVerified()) {
      const design::LightErrors& errors = verification_.result()->report.total;
      const double rms = (errors.work_planes ? *errors.work_planes : errors.receivers).rms;
      badge = tr("Verified: RMS %1 %").arg(QLocale().toString(100.0 * rms, 'f', 2));
    }
    workspace_.status->setVerified(badge);
    showErrorMap();
  });
  connect(workspace_.verify, &VerifyPanel::mapWantedChanged, this, &ProjectSession::showErrorMap);
  connect(&workspace_.area->grid(), &ViewGrid::shownChanged, this, &ProjectSession::showErrorMap);
}

/// Of the light that is shown alone: discs of another state would lie.
void ProjectSession::showErrorMap() {
  const bool shown = workspace_.verify->mapWanted() && verification_.isVerified();
  ViewGrid& views = workspace_.area->grid();
  for (std::size_t i = 0; i < views.count(); ++i) {
    const auto& layout = views.pane(i).layout();
    const bool own = !layout || *layout == document_.layout();
    workspace_.area->errors(i).setPoints(
        shown && own ? errorPointsOf(verification_.result()->report) : std::vector<ErrorPoint>{});
  }
}

void ProjectSession::exportResults() {
  exportReadings(
      workspace_.area->window(), document_, readings_.readings(), background_,
      [this](const QString& path) { workspace_.log->addLine(tr("Wrote %1").arg(path)); });
}

void ProjectSession::onFrame() {
  workspace_.quality->showFrame(*relighting_.frame());
  const bool dark = document_.luminaires().empty() && !document_.scene()->environment;
  if (dark && workspace_.area->view().frame() == nullptr) {
    // A building in the dark cannot be worked in: it stays as it came until it has luminaires.
    const bool nothing = document_.scene()->mesh->triangleCount() == 0;
    workspace_.area->setNotice(
        nothing ? tr("Drop the model of a building here, or import one: File \u25b8 Import a model")
                : QString());
    return;
  }
  workspace_.area->grid().setFrame(relighting_.frame());
  if (!document_.previewing()) {
    workspace_.view->suggestRange(color::roundRange(percentileLux(*relighting_.frame())));
  }
}

void ProjectSession::placeLuminaires() {
  std::vector<light::Luminaire> seen = document_.litLuminaires();
  if (!document_.hidden().isEmpty()) {
    std::erase_if(seen, [&](const auto& l) { return document_.hidden().contains(toQt(l.name)); });
  }
  workspace_.area->grid().setLuminaires(
      std::make_shared<const EmitterSet>(seen, document_.scene()->mesh->origin));
}

void ProjectSession::showFirstCamera() {
  const auto& cameras = document_.scene()->cameras;
  const auto& mesh = *document_.scene()->mesh;
  if (!cameras.empty()) {
    showCamera(toQt(cameras.front().name));
  } else if (mesh.triangleCount() > 0) {
    workspace_.area->view().setViewCamera(ViewCamera::from(io::startingPlace(mesh).camera));
  }
}

void ProjectSession::showCamera(const QString& name) {
  for (const scene::Camera& camera : document_.scene()->cameras) {
    if (toQt(camera.name) != name) continue;
    workspace_.area->active().view().setViewCamera(ViewCamera::from(camera));
  }
}

/// Of the active view; null when it is flat: those are always there and no cameras of a project.
const ViewCamera* ProjectSession::cameraToSave() const {
  const ViewCamera& camera = workspace_.area->active().view().viewCamera();
  if (!camera.isParallel()) return &camera;
  workspace_.status->showHint(
      tr("Plans and sections are always there: choose a perspective to "
         "save it as a camera."));
  return nullptr;
}

void ProjectSession::saveCamera() {
  const ViewCamera* camera = cameraToSave();
  const QString name = freeCameraName(*document_.scene());
  if (camera != nullptr) addCamera(document_, camera->toScene(toStd(name)));
}

void ProjectSession::updateCamera(const QString& name) {
  const ViewCamera* camera = cameraToSave();
  if (camera != nullptr) ui::updateCamera(document_, camera->toScene(toStd(name)));
}

void ProjectSession::offerViews() {
  QStringList names;
  for (const scene::Camera& camera : document_.scene()->cameras) names.append(toQt(camera.name));
  workspace_.area->grid().setCameras(names);
  QStringList layouts{QString()};
  for (const scene::Layout& layout : document_.scene()->layouts) layouts.append(toQt(layout.name));
  workspace_.area->grid().setLayouts(layouts, document_.layout());
}

void ProjectSession::exposeAutomatically() {
  const auto picture = workspace_.area->active().view().readLinear();
  if (picture.empty()) return;
  scene::Scene next = *document_.scene();
  next.view.exposure = std::round(20.0 * color::autoExposure(picture)) / 20.0;
  document_.edit(tr("Exposure"), std::move(next));
}

}  // namespace soffit::ui
