// SPDX-License-Identifier: MIT
#include "ui/viewport/gizmo_actor.h"

#include "core/math/sampling.h"
#include "ui/viewport/gizmo_scaling.h"
#include "ui/viewport/gizmo_turning.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
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
constexpr vec3 kMiddleColor{0.85F, 0.85F, 0.87F};
// Places of the parts in GizmoActor::Parts.
constexpr std::size_t kPlanes = 3;
constexpr std::size_t kRings = 6;
constexpr std::size_t kHandles = 9;
constexpr std::size_t kMiddle = 12;
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

/// A thin torus of an arrow's length 1.
void addRing(Surface& s, int axis) {
  constexpr int kAround = 64;
  constexpr int kSides = 6;
  constexpr double kThickness = 0.014;
  const dvec3 z = axisOf(axis);
  const dvec3 x = axisOf((axis + 1) % 3);
  const dvec3 y = axisOf((axis + 2) % 3);
  for (int i = 0; i < kAround; ++i) {
    const double phi = 2.0 * kPi * i / kAround;
    const dvec3 out = std::cos(phi) * x + std::sin(phi) * y;
    for (int k = 0; k < kSides; ++k) {
      const double psi = 2.0 * kPi * k / kSides;
      const dvec3 p =
          Turning::kRingRadius * out + kThickness * (std::cos(psi) * out + std::sin(psi) * z);
      s.points->InsertNextPoint(p.x, p.y, p.z);
    }
  }
  const auto at = [](int i, int k) {
    return static_cast<vtkIdType>(i % kAround) * kSides + k % kSides;
  };
  for (int i = 0; i < kAround; ++i) {
    for (int k = 0; k < kSides; ++k) {
      const vtkIdType quad[4] = {at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)};
      s.cells->InsertNextCell(4, quad);
    }
  }
}

/// An upright box about a point of an axis.
void addBox(Surface& s, const dvec3& lo, const dvec3& hi) {
  vtkIdType corner[8];
  for (int i = 0; i < 8; ++i) {
    corner[i] = s.points->InsertNextPoint((i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y,
                                          (i & 4) != 0 ? hi.z : lo.z);
  }
  constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) {
    const vtkIdType quad[4] = {corner[face[0]], corner[face[1]], corner[face[2]], corner[face[3]]};
    s.cells->InsertNextCell(4, quad);
  }
}

/// A shaft with a cube at its end.
void addHandle(Surface& s, int axis) {
  constexpr double kCube = 0.055;
  const dvec3 z = axisOf(axis);
  const dvec3 across = dvec3(1.0) - z;
  addBox(s, Scaling::kMiddle * z - kShaftRadius * across, 0.95 * z + kShaftRadius * across);
  addBox(s, (1.0 - kCube) * z - kCube * across, (1.0 + kCube) * z + kCube * across);
}

}  // namespace

struct GizmoActor::Parts {
  vtkRenderer* overlay;
  std::array<Surface, 13> surfaces;  // arrows x y z, planes yz zx xy; rings; handles, middle
};

GizmoActor::GizmoActor(vtkRenderer* overlay) : parts_(std::make_unique<Parts>()) {
  parts_->overlay = overlay;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    addArrow(parts_->surfaces[k], i);
    // Opaque: anything translucent would bring VTK's pass for it, two float pictures of the whole
    // view at each frame.
    addPlane(parts_->surfaces[kPlanes + k], i);
    addRing(parts_->surfaces[kRings + k], i);
    addHandle(parts_->surfaces[kHandles + k], i);
  }
  addBox(parts_->surfaces[kMiddle], dvec3(-0.7 * Scaling::kMiddle), dvec3(0.7 * Scaling::kMiddle));
  for (Surface& s : parts_->surfaces) {
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

void GizmoActor::show(GizmoTool tool, const dvec3& at, const dmat3& frame, double length,
                      GizmoPart highlighted, const std::array<bool, 6>& edge_on) {
  vtkNew<vtkMatrix4x4> world;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      world->SetElement(row, column, length * frame[column][row]);
    }
    world->SetElement(row, 3, at[row]);
  }
  const auto lit = [&](std::size_t part) {
    return static_cast<std::size_t>(highlighted) == part + 1;
  };
  const auto showPart = [&](std::size_t i, bool seen, bool is_lit, const vec3& color) {
    Surface& s = parts_->surfaces[i];
    s.actor->SetVisibility(seen ? 1 : 0);
    s.actor->SetUserMatrix(world);
    s.setColor(is_lit ? kHighlight : color);
  };
  for (std::size_t i = 0; i < 6; ++i) {
    showPart(i, tool == GizmoTool::move && !edge_on[i], lit(i), kAxisColors[i % 3]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    showPart(kRings + i, tool == GizmoTool::rotate, lit(i), kAxisColors[i]);
    showPart(kHandles + i, tool == GizmoTool::scale, lit(i), kAxisColors[i]);
  }
  showPart(kMiddle, tool == GizmoTool::scale, highlighted == GizmoPart::free, kMiddleColor);
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
