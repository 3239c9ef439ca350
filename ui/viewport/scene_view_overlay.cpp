// SPDX-License-Identifier: MIT
// SceneView: its camera in VTK's terms, and what lies over the picture (gizmo, outlines, the cut).
#include "ui/document/text.h"
#include "ui/viewport/cut_hatch.h"
#include "ui/viewport/cutting.h"
#include "ui/viewport/gizmo_scaling.h"
#include "ui/viewport/gizmo_turning.h"
#include "ui/viewport/luminaire_mesh.h"
#include "ui/viewport/picture_pass.h"
#include "ui/viewport/scene_view.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

/// Steeper than 45 degrees down is a plan.
constexpr double kPlanSteepness = -0.7;
constexpr double kNearest = 0.03;
constexpr double kFarEye = 1e5;  // m
/// Between the lines of hatching, m, and how many of them there are at most.
constexpr double kHatch = 0.05;
constexpr double kMostHatches = 1500.0;
/// Cosine to the line of sight of what is seen edge on.
constexpr double kEdgeOn = 0.05;

}  // namespace

void SceneView::placeCamera() {
  const dvec3 eye = view_.position - origin();
  const dvec3 target = eye + view_.forward;
  const dvec3 up = view_.up();
  camera()->SetPosition(eye.x, eye.y, eye.z);
  camera()->SetFocalPoint(target.x, target.y, target.z);
  camera()->SetViewUp(up.x, up.y, up.z);
  camera()->SetParallelProjection(view_.isParallel() ? 1 : 0);
  camera()->SetParallelScale(0.5 * view_.parallel_height);
  camera()->SetViewAngle(glm::degrees(view_.vertical_fov));
  const Box box = bounds();
  const double reach =
      box.empty() ? 100.0
                  : glm::length(eye - dvec3(box.center())) + static_cast<double>(box.diagonal());
  camera()->SetClippingRange(std::max(kNearest, reach * 1e-4), reach + 1.0);
  pass().setCut(view_.isParallel() ? view_.cut_depth : 0.0);
}

std::vector<bool> SceneView::cutAwayLuminaires() const {
  if (luminaires_ == nullptr || view_.cut_depth <= 0.0) return {};
  return cutAway(*luminaires_, view_, surroundings({}));
}

void SceneView::drawLuminaires() {
  if (luminaires_ == nullptr) return;
  // The eye of a parallel view is very far away.
  const dvec3 eye = view_.position - (view_.isParallel() ? kFarEye : 0.0) * view_.forward;
  pass().building.setLuminaires(
      makeLuminaireMesh(*luminaires_, vec3(eye - origin()), cutAwayLuminaires()));
}

std::vector<vec3> SceneView::outlines(const QStringList& names) const {
  std::vector<vec3> lines;
  if (luminaires_ == nullptr) return lines;
  for (const QString& name : names) {
    const int i = luminaires_->indexOf(toStd(name));
    if (i < 0) continue;
    const auto own = outlineOf(luminaires_->emitters()[static_cast<std::size_t>(i)]);
    lines.insert(lines.end(), own.begin(), own.end());
  }
  return lines;
}

std::vector<vec3> SceneView::planOutlines() const {
  std::vector<vec3> lines;
  const bool flat = view_.isParallel();
  if (luminaires_ == nullptr || (!flat && view_.forward.z > kPlanSteepness)) return lines;
  const std::vector<bool> away = cutAwayLuminaires();
  for (std::size_t i = 0; i < luminaires_->emitters().size(); ++i) {
    const light::Emitter& e = luminaires_->emitters()[i];
    if (i < away.size() && away[i]) continue;
    // What is not drawn, or black: dark sides, points, and in flat views what is seen edge on.
    const double turned = glm::dot(e.normal, view_.sightTo(origin() + e.position));
    const bool dark = e.kind == light::EmitterKind::planar && !e.twoSided() &&
                      (flat || !e.casts_shadow) && turned > (flat ? -kEdgeOn : 0.0);
    const bool edge_on = e.kind == light::EmitterKind::planar && flat && std::abs(turned) < kEdgeOn;
    if (!dark && !edge_on && !(flat && e.kind == light::EmitterKind::point)) continue;
    const auto own = outlineOf(e);
    lines.insert(lines.end(), own.begin(), own.end());
  }
  return lines;
}

std::vector<const light::Emitter*> SceneView::selectedEmitters() const {
  std::vector<const light::Emitter*> found;
  if (luminaires_ == nullptr) return found;
  for (const QString& name : selection_) {
    const int i = luminaires_->indexOf(toStd(name));
    if (i >= 0) found.push_back(&luminaires_->emitters()[static_cast<std::size_t>(i)]);
  }
  return found;
}

std::optional<dvec3> SceneView::gizmoPlace() const {
  const auto selected = selectedEmitters();
  if (selected.empty()) return std::nullopt;
  dvec3 sum(0.0);
  for (const light::Emitter* e : selected) sum += e->position;
  return origin() + sum / static_cast<double>(selected.size());
}

dmat3 SceneView::gizmoFrame() const {
  const auto selected = selectedEmitters();
  return tool_ == GizmoTool::scale && selected.size() == 1 ? selected.front()->world_from_light
                                                           : dmat3(1.0);
}

dvec3 SceneView::selectionHalfSize() const {
  const auto at = gizmoPlace();
  dvec3 half(0.0);
  for (const light::Emitter* e : selectedEmitters()) {
    if (e->bounds.empty()) continue;
    half = glm::max(half, glm::max(dvec3(e->bounds.hi) - (*at - origin()),
                                   (*at - origin()) - dvec3(e->bounds.lo)));
  }
  return half;
}

void SceneView::setGizmoTool(GizmoTool tool) {
  if (tool == tool_) return;
  tool_ = tool;
  highlight_ = GizmoPart::none;
  update();
}

void SceneView::setGizmoHighlight(GizmoPart part) {
  if (part == highlight_) return;
  highlight_ = part;
  update();
}

void SceneView::setGizmoShown(bool shown) {
  gizmo_shown_ = shown;
  update();
}

GizmoPart SceneView::gizmoPartAt(const QPointF& mouse) const {
  const auto at = gizmoPlace();
  if (!at || !gizmo_shown_) return GizmoPart::none;
  const dvec2 pixel(mouse.x(), mouse.y());
  switch (tool_) {
    case GizmoTool::rotate:
      return Turning::partAt(*at, view_, viewSize(), pixel);
    case GizmoTool::scale:
      return Scaling::partAt(*at, gizmoFrame(), view_, viewSize(), pixel);
    default:
      return Gizmo::partAt(*at, view_, viewSize(), pixel);
  }
}

std::vector<vec3> SceneView::cutLines() const {
  if (scene_ == nullptr || !view_.isParallel() || view_.cut_depth <= 0.0) return {};
  const int axis = view_.mainAxis();
  return sectionLines(*scene_->mesh, axis, view_.cutPlace() - origin()[axis]);
}

std::vector<vec3> SceneView::cutHatch() const {
  if (scene_ == nullptr || mesh_ == nullptr || mesh_->solid == nullptr || !view_.isParallel() ||
      view_.cut_depth <= 0.0) {
    return {};
  }
  const int axis = view_.mainAxis();
  const double spacing =
      std::max(kHatch, static_cast<double>(scene_->mesh->bounds().diagonal()) / kMostHatches);
  return sectionHatch(*scene_->mesh, *mesh_->solid, axis, view_.cutPlace() - origin()[axis],
                      spacing);
}

void SceneView::updateCut() {
  const CutDrawn cut{scene_ == nullptr ? nullptr : scene_->mesh.get(),
                     mesh_ == nullptr ? nullptr : mesh_->solid.get(), view_.mainAxis(),
                     view_.isParallel() ? view_.cutPlace() : 0.0, view_.isParallel()};
  if (cut == cut_drawn_) return;
  cut_drawn_ = cut;
  cut_hatch_->setLines(cutHatch());
  cut_outline_->setLines(cutLines());
}

void SceneView::showDrawingLines() {
  updateCut();
  plan_outline_->setLines(planOutlines());
  selected_outline_->setLines({});
  hovered_outline_->setLines({});
  gizmo_->hide();
}

void SceneView::updateOverlay() {
  updateCut();
  selected_outline_->setLines(outlines(selection_));
  const QString hovered = toQt(hovered_);
  plan_outline_->setLines(planOutlines());
  hovered_outline_->setLines(selection_.contains(hovered) ? std::vector<vec3>{}
                                                          : outlines({hovered}));
  const auto at = gizmoPlace();
  if (!at || !gizmo_shown_ || glm::dot(*at - view_.position, view_.forward) <= 0.0) {
    gizmo_->hide();
    return;
  }
  std::array<bool, 6> edge_on{};
  for (std::size_t i = 0; i < edge_on.size(); ++i) {
    edge_on[i] = Gizmo::isEdgeOn(static_cast<GizmoPart>(i + 1), *at, view_);
  }
  gizmo_->show(tool_, *at - origin(), gizmoFrame(), Gizmo::arrowLength(*at, view_, viewSize()),
               highlight_, edge_on);
}

}  // namespace soffit::ui
