// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "ui/viewport/emitter_set.h"
#include "ui/viewport/surroundings.h"
#include "ui/viewport/view_camera.h"

#include <vector>

namespace soffit::ui {

/// The lines in which a plane across a world axis (0..2) meets a building, two ends in a row,
/// scene-local: what a cut is outlined with. place: on the axis, scene-local. Triangles that lie in
/// the plane give none: their neighbours do.
std::vector<vec3> sectionLines(const geometry::Mesh& mesh, int axis, double place);

/// Per luminaire, whether the cut of a view takes it away; empty when the view cuts nothing.
///
/// A plan shows the luminaires above its cut, too, as far as no floor lies between: a plan of
/// luminaires is what it is for. A section takes away what hangs before it.
std::vector<bool> cutAway(const EmitterSet& luminaires, const ViewCamera& camera,
                          const Surroundings& around);

}  // namespace soffit::ui
