// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/light_frame.h"

#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

namespace soffit::ui {

class SceneView;

/// Pins of probes under the mouse: a press takes hold of one, a drag moves it over the surfaces.
/// Stands before ViewInput, and leaves it everything else.
class ProbeDrag : public QObject {
  Q_OBJECT

 public:
  /// The view must outlive this.
  explicit ProbeDrag(SceneView& view, QObject* parent = nullptr);
  /// Where the pins are, world.
  void setPins(std::vector<dvec3> pins) { pins_ = std::move(pins); }
  /// The pin under a pixel that nothing hides; nothing: none.
  [[nodiscard]] std::optional<std::size_t> pinAt(const QPointF& mouse) const;

 Q_SIGNALS:
  void chosen(std::size_t pin);
  void moved(std::size_t pin, const SurfaceReading& to);
  /// The mouse let go; what moved() said last stays.
  void finished();
  /// Escape.
  void canceled();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool move(const QPointF& mouse);

  SceneView& view_;
  std::vector<dvec3> pins_;
  std::optional<std::size_t> held_;
  QPointF start_;
  bool moving_ = false;
};

}  // namespace soffit::ui
