// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <QRectF>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace soffit::ui {

class SceneView;

/// Lines and words over a view, at places of the world: what a drag or a tool says for itself.
class ViewOverlay : public QWidget {
  Q_OBJECT

 public:
  enum class Stroke {
    guide,    ///< dashed: what something is aligned with
    measure,  ///< with ticks at its ends, and its length
    outline,  ///< of what a click would make
  };
  struct Line {
    dvec3 from{0.0};
    dvec3 to{0.0};
    Stroke stroke = Stroke::guide;
    QString text;  ///< at its middle; empty: none
  };
  struct Label {
    dvec3 at{0.0};
    QString text;
  };
  /// Something to drag.
  struct Handle {
    dvec3 at{0.0};
    bool round = false;
    bool lit = false;
  };
  struct Content {
    std::vector<Line> lines;
    std::vector<Label> labels;  ///< beside their places
    std::vector<Handle> handles;
  };

  explicit ViewOverlay(SceneView& view);

  void setContent(Content content);
  [[nodiscard]] const Content& content() const { return content_; }
  /// The rubber band, logical pixels; nothing: none.
  void setBand(const std::optional<QRectF>& band);
  [[nodiscard]] const std::optional<QRectF>& band() const { return band_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  [[nodiscard]] std::optional<QPointF> pixelOf(const dvec3& place) const;
  void paintLine(QPainter& painter, const Line& line) const;
  void paintText(QPainter& painter, const QPointF& at, const QString& text, bool centered) const;

  SceneView& view_;
  Content content_;
  std::optional<QRectF> band_;
};

}  // namespace soffit::ui
