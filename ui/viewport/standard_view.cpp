// SPDX-License-Identifier: MIT
#include "ui/viewport/standard_view.h"

#include <QCoreApplication>

namespace soffit::ui {
namespace {

dvec3 directionOf(StandardView view) {
  switch (view) {
    case StandardView::plan:
      return {0.0, 0.0, -1.0};
    case StandardView::back:
    case StandardView::section_back:
      return {0.0, -1.0, 0.0};
    case StandardView::left:
    case StandardView::section_left:
      return {1.0, 0.0, 0.0};
    case StandardView::right:
    case StandardView::section_right:
      return {-1.0, 0.0, 0.0};
    default:
      return {0.0, 1.0, 0.0};
  }
}

bool isSection(StandardView view) {
  return view == StandardView::section_front || view == StandardView::section_back ||
         view == StandardView::section_left || view == StandardView::section_right;
}

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

}  // namespace

QString nameOf(StandardView view) {
  switch (view) {
    case StandardView::perspective:
      return tr("Perspective");
    case StandardView::plan:
      return tr("Plan");
    case StandardView::front:
      return tr("Front");
    case StandardView::back:
      return tr("Back");
    case StandardView::left:
      return tr("Left side");
    case StandardView::right:
      return tr("Right side");
    case StandardView::section_front:
      return tr("Section from the front");
    case StandardView::section_back:
      return tr("Section from the back");
    case StandardView::section_left:
      return tr("Section from the left");
    case StandardView::section_right:
      return tr("Section from the right");
  }
  return {};
}

bool isSideways(StandardView view) {
  return directionOf(view).x != 0.0;
}

StandardView standardViewOf(const ViewCamera& camera, const Box& bounds, const dvec3& origin) {
  if (!camera.isParallel()) return StandardView::perspective;
  const int axis = camera.mainAxis();
  const double cut = camera.cutPlace() - origin[axis];
  const bool cuts = !bounds.empty() && cut > static_cast<double>(bounds.lo[axis]) &&
                    cut < static_cast<double>(bounds.hi[axis]);
  StandardView found = StandardView::plan;
  for (const StandardView view : kStandardViews) {
    if (view == StandardView::perspective) continue;
    if (glm::dot(directionOf(view), camera.forward) > 0.5 && (!isSection(view) || cuts)) {
      found = view;
    }
  }
  return found;
}

ViewCamera standardCamera(StandardView view, const Box& bounds, const dvec3& origin, double floor,
                          double aspect) {
  ViewCamera camera;
  if (view == StandardView::perspective) return camera;
  const dvec3 center = bounds.empty() ? origin : origin + dvec3(bounds.center());
  const double reach = bounds.empty() ? 10.0 : static_cast<double>(bounds.diagonal());
  camera.forward = directionOf(view);
  // Well before the building, which may yet grow.
  camera.position = center - (2.0 * reach + 10.0) * camera.forward;
  camera.parallel_height = 10.0;
  camera.frame(bounds, origin, aspect);
  const int axis = camera.mainAxis();
  if (view == StandardView::plan) {
    camera.setCutPlace(floor + kPlanCut);
  } else if (isSection(view)) {
    camera.setCutPlace(center[axis]);
  } else if (!bounds.empty()) {
    // Before all there is.
    const float near = camera.forward[axis] > 0.0 ? bounds.lo[axis] : bounds.hi[axis];
    camera.setCutPlace(origin[axis] + static_cast<double>(near) - 0.1 * camera.forward[axis]);
  }
  return camera;
}

}  // namespace soffit::ui
