// SPDX-License-Identifier: MIT
#include "ui/viewport/scene_view.h"

#include "core/scene/equality.h"
#include "ui/document/text.h"
#include "ui/viewport/picture_pass.h"
#include "ui/viewport/plain_preview.h"
#include "ui/viewport/traced_still.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

constexpr vec3 kSelectedColor{1.0F, 0.72F, 0.16F};
constexpr vec3 kHoveredColor{0.98F, 0.98F, 0.98F};
/// Frames slower than this are drawn with fewer pixels while things move.
constexpr double kFluentMs = 15.0;
constexpr int kRestMs = 80;
/// Where pictures are slow, one that shows a luminaire at its new place waits so long for its
/// light.
constexpr int kLateMs = 150;

}  // namespace

SceneView::SceneView(QWidget* parent) : VtkView(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  gizmo_ = std::make_unique<GizmoActor>(overlay());
  cut_hatch_ = std::make_unique<OutlineActor>(overlay(), kHatchColor, kHatchWidth);
  cut_outline_ = std::make_unique<OutlineActor>(overlay(), kCutColor, kCutWidth);
  plan_outline_ = std::make_unique<OutlineActor>(overlay(), kPlanColor, kPlanWidth);
  hovered_outline_ = std::make_unique<OutlineActor>(overlay(), kHoveredColor, 1.5F);
  selected_outline_ = std::make_unique<OutlineActor>(overlay(), kSelectedColor, 2.5F);
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, [this] { restart(); });
  late_.setSingleShot(true);
  late_.setInterval(kLateMs);
  connect(&late_, &QTimer::timeout, this, &SceneView::restart);
  connect(&mesh_job_, &DisplayMeshJob::finished, this, &SceneView::onMeshFinished);
  connect(this, &VtkView::painted, this, &SceneView::refine);
}

SceneView::~SceneView() = default;

dvec3 SceneView::origin() const {
  return scene_ == nullptr ? dvec3(0.0) : scene_->mesh->origin;
}

Box SceneView::bounds() const {
  Box box;
  if (scene_ != nullptr) box = scene_->mesh->bounds();
  if (luminaires_ != nullptr) {
    for (const light::Emitter& e : luminaires_->emitters()) box.add(e.bounds);
  }
  return box;
}

void SceneView::setScene(std::shared_ptr<const scene::Scene> scene) {
  const bool same_building = scene_ != nullptr && scene != nullptr && scene_->mesh == scene->mesh;
  const auto before = std::exchange(scene_, std::move(scene));
  if (showOutside(before.get()) && same_building) restart();
  if (same_building) return;
  frame_.reset();
  lit_from_frame_ = false;
  mesh_.reset();
  mesh_solver_.reset();
  pass().building.setMesh(nullptr);
  if (scene_ != nullptr) {
    PlainPreview preview = makePlainPreview(*scene_->mesh, scene_->materials);
    pass().building.setMesh(std::move(preview.mesh));
    pass().building.setLight(std::make_shared<const std::vector<vec3>>(std::move(preview.lux)));
  }
  restart();
}

/// Whether anything of it is another now.
bool SceneView::showOutside(const scene::Scene* before) {
  static const scene::Scene kNone;
  const scene::Scene& was = before == nullptr ? kNone : *before;
  const scene::Scene& now = scene_ == nullptr ? kNone : *scene_;
  OutsideDrawing& outside = pass().building.outside();
  const bool same_light = was.environment.has_value() == now.environment.has_value() &&
                          (!now.environment || scene::same(*was.environment, *now.environment));
  if (!same_light) outside.setEnvironment(now.environment);
  const bool same_glass =
      was.mesh == now.mesh && scene::sameReflectances(was.materials, now.materials);
  if (!same_glass) {
    outside.setPanes(now.mesh == nullptr ? std::vector<PaneCorner>{}
                                         : paneCorners(*now.mesh, now.materials));
  }
  return !same_light || !same_glass;
}

void SceneView::setFrame(LightFramePtr frame) {
  // Light that was under way when the building changed comes late; its triangles name materials
  // that this building may not have.
  if (frame != nullptr && (scene_ == nullptr || frame->solver->scene().mesh != scene_->mesh)) {
    return;
  }
  frame_ = std::move(frame);
  lit_from_frame_ = false;
  if (frame_ == nullptr) return;
  if (mesh_solver_ == frame_->solver) {
    showLight();
  } else if (mesh_ != nullptr && &mesh_solver_->operators() == &frame_->solver->operators() &&
             !lacksNormals(*mesh_, scene_->materials)) {
    // The same texels with other reflectances: the cuts stay.
    mesh_ = std::make_shared<const DisplayMesh>(repainted(*mesh_, scene_->materials));
    mesh_solver_ = frame_->solver;
    pass().building.setMesh(mesh_);
    showLight();
  } else if (mesh_job_.solver() != frame_->solver) {
    mesh_job_.start(frame_->solver, scene_->materials);
  }
}

void SceneView::onMeshFinished() {
  auto mesh = mesh_job_.take();
  if (mesh == nullptr) return;
  if (scene_ == nullptr || mesh_job_.solver()->scene().mesh != scene_->mesh) return;
  mesh_ = std::move(mesh);
  mesh_solver_ = mesh_job_.solver();
  pass().building.setMesh(mesh_);
  if (frame_ != nullptr && frame_->solver == mesh_solver_) showLight();
  Q_EMIT meshChanged();
}

SkyEvaluation::Figures SceneView::skyFigures() {
  return pass().building.skyEvaluation().figures();
}

void SceneView::lightBuilding(const LightFrame& frame) {
  BuildingDrawing& building = pass().building;
  const auto& known = building.light();
  const bool lit = known != nullptr && known->size() == mesh_->vertexCount();
  if (frame.held == nullptr || !lit) {
    auto lux = std::make_shared<std::vector<vec3>>(mesh_->vertexCount());
    lightVertices(*mesh_, frame.lux, *lux);
    building.setLight(std::move(lux));
    smoothLines();
  }
  if (frame.held != nullptr) building.setSky(frame.held);
  building.reflections().setLight(frame.reflections);
}

/// In a drag there are better things to do: specks come and go with the light there.
void SceneView::smoothLines() {
  const auto& lux = pass().building.light();
  if (mesh_ == nullptr || lux == nullptr || lux->size() != mesh_->vertexCount()) return;
  if (pass().building.sky() != nullptr) return;
  pass().building.setShift(moving_ ? std::vector<float>{}
                                   : withoutSpecks(*mesh_, *lux, look_.levels));
}

void SceneView::setFrameOf(SceneView& other) {
  if (other.frame_ == nullptr || other.mesh_ != mesh_ || other.frame_->solver != mesh_solver_ ||
      !other.lit_from_frame_) {
    setFrame(other.frame_);
    return;
  }
  frame_ = other.frame_;
  pass().building.setLight(other.pass().building.light());
  pass().building.setSky(other.pass().building.sky());
  pass().building.setShift(other.pass().building.shift());
  pass().building.reflections().setLight(other.pass().building.reflections().light());
  lit_from_frame_ = true;
  light_pending_ = true;
  restart();
}

void SceneView::showLight() {
  lightBuilding(*frame_);
  lit_from_frame_ = true;
  light_pending_ = true;
  restart();
}

void SceneView::setLuminaires(std::shared_ptr<const EmitterSet> luminaires) {
  luminaires_ = std::move(luminaires);
  if (!moving_ || mesh_ == nullptr || full_frame_ms_ <= kFluentMs) {
    restart();
  } else if (!late_.isActive()) {
    late_.start();
  }
}

void SceneView::setSelection(const QStringList& names) {
  if (names == selection_) return;
  selection_ = names;
  restart();
}

void SceneView::setHovered(const std::string& name) {
  if (name == hovered_) return;
  hovered_ = name;
  update();
}

Result<void> SceneView::setLook(const Look& look) {
  // The panel says it at every change of the scene: at each place in a drag.
  if (look_given_ && look == look_) return {};
  if (const auto set = pass().display.setLook(look); !set) return set.error();
  const bool other_lines = look.levels != look_.levels;
  look_ = look;
  if (other_lines) smoothLines();
  look_given_ = true;
  restart();
  return {};
}

color::PictureLuminance SceneView::adaptation() {
  return pass().display.adaptation();
}

void SceneView::setViewCamera(const ViewCamera& camera) {
  view_ = camera;
  size_ = viewSize();  // which may come before the first resizeGL()
  restart();
  Q_EMIT cameraMoved();
}

void SceneView::frameAll() {
  view_.frame(bounds(), origin(), viewSize().x / std::max(viewSize().y, 1.0));
  restart();
  Q_EMIT cameraMoved();
}

void SceneView::frameSelection() {
  Box box;
  for (const light::Emitter* e : selectedEmitters()) box.add(e->bounds);
  if (box.empty()) {
    frameAll();
    return;
  }
  const vec3 margin(0.5F);
  box.lo -= margin;
  box.hi += margin;
  view_.frame(box, origin(), viewSize().x / std::max(viewSize().y, 1.0));
  restart();
  Q_EMIT cameraMoved();
}

void SceneView::setMoving(bool moving) {
  if (moving != moving_) Q_EMIT movingChanged(moving);
  const bool rests = moving_ && !moving;
  moving_ = moving;
  if (rests && !look_.levels.empty()) {
    smoothLines();
    restart();
  }
  if (!moving && drew_scaled_) rest_.start();
}

double SceneView::movingScale() const {
  if (full_frame_ms_ <= kFluentMs) return 1.0;
  return std::clamp(std::sqrt(kFluentMs / full_frame_ms_), 0.5, 1.0);
}

void SceneView::restart() {
  late_.stop();
  sample_ = 0;
  picture_stale_ = true;
  update();
}

void SceneView::refine() {
  if (moving_ || drew_scaled_ || mesh_ == nullptr || !isVisible() || showsTraced()) return;
  if (sample_ + 1 >= PicturePass::kMostSamples) return;
  ++sample_;
  // After what waits: mouse, keys, new light.
  QTimer::singleShot(0, this, [this, wanted = sample_] {
    if (sample_ != wanted) return;
    picture_stale_ = true;
    update();
  });
}

void SceneView::resizeGL(int width, int height) {
  VtkView::resizeGL(width, height);
  keepExtent(viewSize());
  restart();
}

void SceneView::keepExtent(const dvec2& size) {
  if (view_.isParallel() && size_.y > 0.0 && size.x > 0.0 && size.y > 0.0) {
    if (view_.parallel_height != kept_height_) {
      extent_ = view_.parallel_height * dvec2(size_.x / size_.y, 1.0);
    }
    kept_height_ = std::max(extent_.y, extent_.x * size.y / size.x);
    view_.parallel_height = kept_height_;
  }
  size_ = size;
}

void SceneView::paintGL() {
  placeCamera();
  updateOverlay();
  if (sample_ == 0) drawLuminaires();
  const bool reused = !std::exchange(picture_stale_, false);
  if (reused) {
    pass().reuseOnce();
  } else {
    const double scale = moving_ ? movingScale() : 1.0;
    pass().setTraced(showsTraced()
                         ? std::shared_ptr<const std::vector<float>>(traced_, &traced_->light)
                         : nullptr);
    pass().setSample(moving_ ? 0 : sample_, scale);
    drew_scaled_ = scale < 1.0;
  }
  VtkView::paintGL();
  if (!drew_scaled_ && !reused) full_frame_ms_ = 0.7 * full_frame_ms_ + 0.3 * frameMilliseconds();
  if (std::exchange(light_pending_, false)) {
    Q_EMIT lightShown(frame_ == nullptr ? 0 : frame_->revision, frameMilliseconds());
  }
}

void SceneView::showTraced(std::shared_ptr<const TracedView> picture) {
  if (picture == nullptr && traced_ == nullptr) return;
  traced_ = std::move(picture);
  restart();
}

bool SceneView::showsTraced() const {
  return traced_ != nullptr && !moving_ && frame_ != nullptr && scene_ != nullptr &&
         traced_->camera == view_ && traced_->pixels == pixelSize() && isTraceable(view_, look_) &&
         showsSame(*traced_->frame, *traced_->scene, *frame_, *scene_);
}

std::vector<vec3> SceneView::readLinear() {
  if (!isValid() || mesh_ == nullptr) return {};
  makeCurrent();
  int width = 0;
  int height = 0;
  const std::vector<float> values = pass().readLinear(width, height);
  doneCurrent();
  std::vector<vec3> pixels;
  for (std::size_t i = 0; i + 3 < values.size(); i += 4) {
    pixels.emplace_back(values[i], values[i + 1], values[i + 2]);
  }
  return pixels;
}

PointedAt SceneView::pointAt(const QPointF& mouse) const {
  return ui::pointAt(pointable(), view_, viewSize(), {mouse.x(), mouse.y()});
}

QStringList SceneView::luminairesIn(const QRectF& band) const {
  return ui::luminairesIn(pointable(), view_, viewSize(), band);
}

std::optional<SurfaceReading> SceneView::surfaceAlong(const dvec3& from,
                                                      const dvec3& direction) const {
  if (scene_ == nullptr || frame_ == nullptr) return std::nullopt;
  geometry::Ray ray;
  ray.origin = vec3(from - origin());
  ray.direction = vec3(direction);
  return readSurface(*frame_, *scene_, ray);
}

Surroundings SceneView::surroundings(const QStringList& moving) const {
  if (scene_ == nullptr) return {};
  return surroundingsOf(*scene_, frame_, luminaires_.get(), moving);
}

Pointable SceneView::pointable() const {
  return {scene_.get(), frame_.get(), luminaires_.get(), cutAwayLuminaires()};
}

}  // namespace soffit::ui
