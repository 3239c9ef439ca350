// SPDX-License-Identifier: MIT
#include "ui/viewport/gizmo_actor.h"

#include "core/math/sampling.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>

namespace soffit::ui {
namespace {

constexpr std::array<vec3, 3> kAxisColors{
    {{0.93F, 0.27F, 0.30F}, {0.42F, 0.74F, 0.22F}, {0.27F, 0.52F, 0.95F}}};
constexpr vec3 kHighlight{1.0F, 0.85F, 0.2F};
constexpr double kShaftRadius = 0.017;
constexpr double kHeadRadius = 0.065;
constexpr double kHeadFrom = 0.80;

struct Surface {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  void finish(bool lines) {
    data->SetPoints(points);
    if (lines) {
      data->SetLines(cells);
    } else {
      data->SetPolys(cells);
    }
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
  }
  void setColor(const vec3& c) {
    actor->GetProperty()->SetColor(static_cast<double>(c.x), static_cast<double>(c.y),
                                   static_cast<double>(c.z));
  }
};

/// An arrow of length 1 along an axis: a prism and a cone.
void addArrow(Surface& s, int axis) {
  constexpr int kSides = 16;
  const dvec3 z = axisOf(axis);
  const dvec3 x = axisOf((axis + 1) % 3);
  const dvec3 y = axisOf((axis + 2) % 3);
  const auto ring = [&](double at, double radius) {
    const vtkIdType first = s.points->GetNumberOfPoints();
    for (int i = 0; i < kSides; ++i) {
      const double phi = 2.0 * kPi * i / kSides;
      const dvec3 p = at * z + radius * (std::cos(phi) * x + std::sin(phi) * y);
      s.points->InsertNextPoint(p.x, p.y, p.z);
    }
    return first;
  };
  const auto join = [&](vtkIdType a, vtkIdType b) {
    for (int i = 0; i < kSides; ++i) {
      const vtkIdType j = (i + 1) % kSides;
      const vtkIdType quad[4] = {a + i, a + j, b + j, b + i};
      s.cells->InsertNextCell(4, quad);
    }
  };
  join(ring(0.12, kShaftRadius), ring(kHeadFrom, kShaftRadius));
  join(ring(kHeadFrom, kShaftRadius), ring(kHeadFrom, kHeadRadius));
  join(ring(kHeadFrom, kHeadRadius), ring(1.0, 0.0));
}

void addPlane(Surface& s, int normal) {
  const dvec3 u = axisOf((normal + 1) % 3);
  const dvec3 v = axisOf((normal + 2) % 3);
  const double lo = Gizmo::kPlaneFrom;
  const double hi = Gizmo::kPlaneTo;
  vtkIdType quad[4];
  int k = 0;
  for (const dvec2& c : {dvec2(lo, lo), dvec2(hi, lo), dvec2(hi, hi), dvec2(lo, hi)}) {
    const dvec3 p = c.x * u + c.y * v;
    quad[k++] = s.points->InsertNextPoint(p.x, p.y, p.z);
  }
  s.cells->InsertNextCell(4, quad);
}

}  // namespace

struct GizmoActor::Parts {
  vtkRenderer* overlay;
  std::array<Surface, 6> surfaces;  // arrows x y z, planes yz zx xy
};

GizmoActor::GizmoActor(vtkRenderer* overlay) : parts_(std::make_unique<Parts>()) {
  parts_->overlay = overlay;
  for (int i = 0; i < 6; ++i) {
    Surface& s = parts_->surfaces[static_cast<std::size_t>(i)];
    if (i < 3) {
      addArrow(s, i);
    } else {
      // Opaque: anything translucent would bring VTK's pass for it, two float pictures of the whole
      // view at each frame.
      addPlane(s, i - 3);
    }
    s.finish(false);
    overlay->AddActor(s.actor);
  }
  hide();
}

GizmoActor::~GizmoActor() {
  for (Surface& s : parts_->surfaces) parts_->overlay->RemoveActor(s.actor);
}

void GizmoActor::hide() {
  for (Surface& s : parts_->surfaces) s.actor->VisibilityOff();
}

void GizmoActor::show(const dvec3& at, double length, GizmoPart highlighted,
                      const std::array<bool, 6>& edge_on) {
  for (std::size_t i = 0; i < 6; ++i) {
    Surface& s = parts_->surfaces[i];
    const bool lit = static_cast<int>(highlighted) == static_cast<int>(i) + 1;
    s.actor->SetVisibility(edge_on[i] ? 0 : 1);
    s.actor->SetPosition(at.x, at.y, at.z);
    s.actor->SetScale(length);
    s.setColor(lit ? kHighlight : kAxisColors[i % 3]);
  }
}

struct OutlineActor::Parts {
  vtkRenderer* overlay;
  Surface surface;
};

OutlineActor::OutlineActor(vtkRenderer* overlay, const vec3& color, float width)
    : parts_(std::make_unique<Parts>()) {
  parts_->overlay = overlay;
  parts_->surface.finish(true);
  parts_->surface.setColor(color);
  parts_->surface.actor->GetProperty()->SetLineWidth(width);
  parts_->surface.actor->VisibilityOff();
  overlay->AddActor(parts_->surface.actor);
}

OutlineActor::~OutlineActor() {
  parts_->overlay->RemoveActor(parts_->surface.actor);
}

void OutlineActor::setLines(std::span<const vec3> ends) {
  Surface& s = parts_->surface;
  s.points->Reset();
  s.cells->Reset();
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    vtkIdType line[2];
    for (std::size_t k = 0; k < 2; ++k) {
      const dvec3 p(ends[i + k]);
      line[k] = s.points->InsertNextPoint(p.x, p.y, p.z);
    }
    s.cells->InsertNextCell(2, line);
  }
  s.points->Modified();
  s.cells->Modified();
  s.data->Modified();
  s.actor->SetVisibility(ends.empty() ? 0 : 1);
}

}  // namespace soffit::ui
