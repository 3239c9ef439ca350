// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/display_mesh.h"
#include "ui/viewport/emitter_set.h"
#include "ui/viewport/look.h"
#include "ui/viewport/lux_marks.h"
#include "ui/viewport/picture_pass.h"
#include "ui/viewport/shot.h"

#include <QFont>

#include <memory>
#include <vector>

namespace soffit::ui {

/// All that a picture of a view is made of, for another thread to make it: the view goes on and
/// may show something else by then. Cheap to copy, but for lines and marks.
struct Still {
  /// Drawn over the picture, two ends in a row.
  struct Lines {
    std::vector<vec3> ends;  ///< scene-local
    vec3 color{1.0F};
    double width = 1.0;  ///< logical pixels of the view
  };

  Shot shot;  ///< pixels, samples and what else is asked for; the rest is here
  std::shared_ptr<const scene::Scene> scene;
  std::shared_ptr<const DisplayMesh> mesh;
  LightFramePtr frame;
  std::shared_ptr<const EmitterSet> luminaires;
  std::vector<bool> cut_away;  ///< per luminaire; empty: none
  ViewCamera camera;
  DrawnView drawn;
  Look look;
  std::vector<Lines> lines;
  LuxMarks marks;
  QFont font;                  ///< of the marks
  double view_height = 600.0;  ///< of the view, logical pixels: how large lines and marks are
};

/// Draws lines, marks and the values of the isolux lines into the picture that was made of it, as
/// large as they are in the view, larger in a larger picture.
void paintMarks(const Still& still, Picture& picture);

}  // namespace soffit::ui
