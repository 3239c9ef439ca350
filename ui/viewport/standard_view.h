// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/box.h"
#include "ui/viewport/view_camera.h"

#include <QString>

#include <array>

namespace soffit::ui {

/// The views that a building is worked in. An elevation shows the side that one stands before; a
/// section is an elevation through the middle of the building. All but the perspective have a cut
/// that can be moved.
enum class StandardView {
  perspective,
  plan,
  front,
  back,
  left,
  right,
  section_front,
  section_back,
  section_left,
  section_right
};

inline constexpr std::array kStandardViews{
    StandardView::perspective,   StandardView::plan,         StandardView::front,
    StandardView::back,          StandardView::left,         StandardView::right,
    StandardView::section_front, StandardView::section_back, StandardView::section_left,
    StandardView::section_right};

/// For people, without mnemonics.
QString nameOf(StandardView view);
/// Whether one looks along x.
bool isSideways(StandardView view);
/// What a camera shows; a flat one that cuts into the bounds is a section.
StandardView standardViewOf(const ViewCamera& camera, const Box& bounds, const dvec3& origin);

/// A plan is cut so high above the floor, m: above tables, below the heads of doors and windows.
inline constexpr double kPlanCut = 1.2;

/// The camera of a parallel view, all of the building in its picture. y is taken for north: the
/// front is the south side.
///
/// bounds  of building and luminaires, scene-local; origin: Mesh::origin.
/// floor   world z of the floor that a plan is of.
/// aspect  width over height.
ViewCamera standardCamera(StandardView view, const Box& bounds, const dvec3& origin, double floor,
                          double aspect);

}  // namespace soffit::ui
