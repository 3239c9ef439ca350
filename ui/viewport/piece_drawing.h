// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "ui/viewport/still.h"

namespace soffit::ui {

/// Draws a still piece by piece: no picture is too large for the graphics memory, and what else is
/// drawn gets its turn in between. All calls need a context to be current, always the same one.
class PieceDrawing {
 public:
  /// The picture, without marks. Tells its progress after each sample of a piece.
  /// Errors: a size beyond what the machine draws; cancelled. Throws std::bad_alloc.
  Result<Picture> draw(const Still& still, const Job& job);
  void release();

 private:
  struct Piece;
  [[nodiscard]] static std::vector<Piece> piecesOf(const QSize& size, int apron);
  void take(const Still& still);
  void learnWhole(QSize size);
  void drawSample(const Piece& piece, int sample);
  void collect(const Still& still, const Piece& piece, int sample, float share,
               Picture& picture) const;
  void finish(const Piece& piece, Picture& picture);

  BuildingDrawing building_;
  DisplayDrawing display_;
  GlTarget linear_;
  GlTarget finished_;
  GlTarget sum_;
  std::shared_ptr<const DisplayMesh> mesh_;
  LightFramePtr frame_;
};

}  // namespace soffit::ui
