// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/piece_drawing.h"

#include "ui/document/text.h"
#include "ui/viewport/luminaire_mesh.h"

#include <QCoreApplication>
#include <QRect>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>

namespace soffit::ui {
namespace {

/// Of a piece, px: some tens of milliseconds on a machine without a graphics card.
constexpr int kPieceWidth = 1024;
constexpr int kPieceHeight = 640;
/// Isolux lines look at the pixels about them.
constexpr int kApron = 1;
constexpr int kLearnedFrom = 512;  // pixels along the longer side
/// The eye of a parallel view is very far away, m.
constexpr double kFarEye = 1e5;

std::string tr(const char* text) {
  return toStd(QCoreApplication::translate("soffit::ui", text));
}

/// All that is asked for, black. Throws std::bad_alloc.
Picture emptyPicture(const Shot& shot) {
  Picture picture;
  picture.image = QImage(shot.pixels, QImage::Format_RGB888);
  if (picture.image.isNull()) throw std::bad_alloc();
  const auto count = static_cast<std::size_t>(shot.pixels.width()) *
                     static_cast<std::size_t>(shot.pixels.height());
  if (shot.linear) picture.linear.assign(count, vec3(0.0F));
  if (!shot.lux) return picture;
  picture.lux.width = shot.pixels.width();
  picture.lux.height = shot.pixels.height();
  picture.lux.lux.resize(count);
  return picture;
}

Result<void> checkSize(const QSize& size) {
  std::array<GLint, 2> most{};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, most.data());
  if (!size.isEmpty() && size.width() <= most[0] && size.height() <= most[1]) return {};
  const QString what = QCoreApplication::translate(
      "soffit::ui", "Pictures on this machine are at most %1 \u00d7 %2 pixels");
  return Error{{}, toStd(what.arg(most[0]).arg(most[1])), tr("Choose a smaller size.")};
}

}  // namespace

/// A rectangle of the picture, rows from the top; `inner` without its apron.
struct PieceDrawing::Piece {
  QRect outer;
  QRect inner;
  QSize picture;

  /// Of a pixel among the values read from the target, whose rows go upward.
  [[nodiscard]] std::size_t inTarget(int row, int column) const {
    const int up = outer.y() + outer.height() - 1 - row;
    return 4 * (static_cast<std::size_t>(up) * static_cast<std::size_t>(outer.width()) +
                static_cast<std::size_t>(column - outer.x()));
  }
  [[nodiscard]] std::size_t inPicture(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width()) +
           static_cast<std::size_t>(column);
  }
};

std::vector<PieceDrawing::Piece> PieceDrawing::piecesOf(const QSize& size, int apron) {
  const QRect whole({0, 0}, size);
  std::vector<Piece> pieces;
  for (int y = 0; y < size.height(); y += kPieceHeight) {
    for (int x = 0; x < size.width(); x += kPieceWidth) {
      const QRect inner = QRect(x, y, kPieceWidth, kPieceHeight) & whole;
      pieces.push_back({inner.adjusted(-apron, -apron, apron, apron) & whole, inner, size});
    }
  }
  return pieces;
}

void PieceDrawing::take(const Still& still) {
  building_.setInPieces(true);
  if (mesh_ != still.mesh) building_.setMesh(still.mesh);
  if (mesh_ != still.mesh || frame_ != still.frame) {
    auto lux = std::make_shared<std::vector<vec3>>(still.mesh->vertexCount());
    lightVertices(*still.mesh, still.frame->lux, *lux);
    building_.setLight(std::move(lux));
    building_.reflections().setLight(still.frame->reflections);
  }
  if (mesh_ != still.mesh) {
    building_.outside().setPanes(paneCorners(*still.scene->mesh, still.scene->materials));
  }
  building_.outside().setEnvironment(still.scene->environment);
  mesh_ = still.mesh;
  frame_ = still.frame;
  building_.setShift(withoutSpecks(*still.mesh, *building_.light(), still.look.levels));
  const ViewCamera& camera = still.camera;
  const dvec3 eye = camera.position - (camera.isParallel() ? kFarEye : 0.0) * camera.forward;
  building_.setLuminaires(still.luminaires == nullptr
                              ? LuminaireMesh{}
                              : makeLuminaireMesh(*still.luminaires,
                                                  vec3(eye - still.scene->mesh->origin),
                                                  still.cut_away));
  building_.setView(still.drawn.clip_from_scene, still.drawn.eye, still.drawn.cuts);
}

void PieceDrawing::drawSample(const Piece& piece, int sample) {
  linear_.bind();
  // The picture's viewport, of which the target is a part: pixels lie where they would lie in one
  // piece.
  const int bottom = piece.picture.height() - piece.outer.y() - piece.outer.height();
  glViewport(-piece.outer.x(), -bottom, piece.picture.width(), piece.picture.height());
  const vec2 shift =
      2.0F * sampleOffset(sample) / vec2(piece.picture.width(), piece.picture.height());
  building_.draw(shift, vec3(0.0F));
  finished_.bind();
  const vec2 whole(piece.picture.width(), piece.picture.height());
  display_.draw(linear_, {.from = vec2(piece.outer.x(), bottom) / whole,
                          .size = vec2(piece.outer.width(), piece.outer.height()) / whole,
                          .picture_height = piece.picture.height()});
  sum_.bind();
  display_.copy(finished_, 1.0F / static_cast<float>(sample + 1));
  glFinish();
}

void PieceDrawing::release() {
  building_.release();
  display_.release();
  for (GlTarget* target : {&linear_, &finished_, &sum_}) target->release();
  mesh_.reset();
  frame_.reset();
}

/// Adds a sample's light to the picture; the lux are those of the first.
void PieceDrawing::collect(const Still& still, const Piece& piece, int sample, float share,
                           Picture& picture) const {
  const bool lux = still.shot.lux && sample == 0;
  if (!still.shot.linear && !lux) return;
  const std::vector<float> values = linear_.read();
  for (int row = piece.inner.top(); row <= piece.inner.bottom(); ++row) {
    for (int column = piece.inner.left(); column <= piece.inner.right(); ++column) {
      const float* v = &values[piece.inTarget(row, column)];
      const std::size_t at = piece.inPicture(row, column);
      if (still.shot.linear) picture.linear[at] += share * vec3(v[0], v[1], v[2]);
      if (lux) picture.lux.lux[at] = v[3];
    }
  }
}

/// The piece's code values, all samples done.
void PieceDrawing::finish(const Piece& piece, Picture& picture) {
  finished_.bind();
  display_.copy(sum_);
  const std::vector<float> values = finished_.read();
  for (int row = piece.inner.top(); row <= piece.inner.bottom(); ++row) {
    uchar* out = picture.image.scanLine(row) + std::ptrdiff_t{3} * piece.inner.left();
    for (int column = piece.inner.left(); column <= piece.inner.right(); ++column) {
      const float* v = &values[piece.inTarget(row, column)];
      for (int c = 0; c < 3; ++c) *out++ = static_cast<uchar>(std::lround(255.0F * v[c]));
    }
  }
}

/// A small picture of all tells what the view adapts to and what light is spread.
void PieceDrawing::learnWhole(QSize size) {
  if (!display_.learns()) return;
  const QSize small = size.boundedTo(size.scaled(kLearnedFrom, kLearnedFrom, Qt::KeepAspectRatio));
  linear_.resize(small.width(), small.height(), GlTarget::Format::linear_with_depth);
  linear_.bind();
  glViewport(0, 0, small.width(), small.height());
  building_.draw(vec2(0.0F), vec3(0.0F));
  display_.learn(linear_);
}

Result<Picture> PieceDrawing::draw(const Still& still, const Job& job) {
  const QSize size = still.shot.pixels;
  if (auto fits = checkSize(size); !fits) return fits.error();
  take(still);
  if (const auto set = display_.setLook(still.look); !set) return set.error();
  const int samples = still.shot.samples > 0
                          ? std::min(still.shot.samples, PicturePass::kMostSamples)
                          : PicturePass::kMostSamples;
  learnWhole(size);
  Picture picture = emptyPicture(still.shot);
  const auto pieces = piecesOf(size, still.look.levels.empty() ? 0 : kApron);
  const double steps = static_cast<double>(pieces.size()) * samples;
  int done = 0;
  for (const Piece& piece : pieces) {
    const QSize outer = piece.outer.size();
    linear_.resize(outer.width(), outer.height(), GlTarget::Format::linear_with_depth);
    finished_.resize(outer.width(), outer.height(), GlTarget::Format::display);
    sum_.resize(outer.width(), outer.height(), GlTarget::Format::sum);
    for (int sample = 0; sample < samples; ++sample) {
      if (job.cancelled()) return Error{{}, "cancelled", {}};
      drawSample(piece, sample);
      collect(still, piece, sample, 1.0F / static_cast<float>(samples), picture);
      job.report("drawing", ++done / steps);
    }
    finish(piece, picture);
  }
  return picture;
}

}  // namespace soffit::ui
