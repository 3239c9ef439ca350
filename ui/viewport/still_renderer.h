// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/piece_drawing.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <memory>

namespace soffit::ui {

/// Makes pictures on any thread, with an OpenGL context of its own: what a view would show, piece
/// by piece, so that the views get their turn in between and no picture is too large for the
/// graphics memory.
///
/// Made and deleted in the GUI thread; render() may be called from one thread at a time.
class StillRenderer {
 public:
  StillRenderer();
  ~StillRenderer();

  /// Whether pictures can be made beside the GUI thread on this machine.
  [[nodiscard]] static bool isThreaded() { return QOpenGLContext::supportsThreadedOpenGL(); }

  /// The picture of a still, as SceneView::picture() draws it; without marks. Tells its progress
  /// after each sample of a piece.
  /// Errors: no context, a size beyond what the machine draws, too little memory; cancelled.
  Result<Picture> render(const Still& still, const Job& job);
  /// Gives back the graphics memory. The next picture takes it again.
  void release();

 private:
  [[nodiscard]] Result<void> begin();
  void end();

  QOffscreenSurface surface_;
  std::unique_ptr<QOpenGLContext> context_;
  PieceDrawing drawing_;
};

}  // namespace soffit::ui
