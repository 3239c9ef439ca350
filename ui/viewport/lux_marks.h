// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/lux_scale.h"
#include "core/math/vec.h"
#include "core/render/line_labels.h"
#include "ui/viewport/view_camera.h"

#include <QFont>
#include <QLineF>
#include <QPainter>
#include <QPolygonF>
#include <QRectF>
#include <QString>

#include <array>
#include <functional>
#include <vector>

namespace soffit::ui {

/// Light in numbers and lines at places of the world, to lay over a picture: values and isolux
/// lines of work planes, and pinned probes.
struct LuxMarks {
  struct Number {
    dvec3 at{0.0};
    double lux = 0.0;
    int rank = 0;  ///< those of a lower rank take their place first
  };
  struct Line {
    std::vector<dvec3> points;
    bool closed = false;
    double level = 0.0;  ///< lux
  };
  /// A probe on a surface.
  struct Pin {
    dvec3 at{0.0};
    QString name;
    QString reading;
    bool chosen = false;
  };
  std::vector<Number> numbers;
  std::vector<Line> lines;
  std::vector<std::array<dvec3, 4>> borders;  ///< of the planes that numbers and lines belong to
  std::vector<Pin> pins;
  std::vector<std::array<dvec3, 2>> cuts;  ///< lines along which light is read
  color::LuxScale scale;                   ///< colors of lines, and the unit

  [[nodiscard]] bool empty() const {
    return numbers.empty() && lines.empty() && pins.empty() && cuts.empty();
  }
};

/// From where marks are seen.
struct Sight {
  ViewCamera camera;
  dvec2 size{1.0};  ///< of the picture, logical pixels
  /// Whether nothing hides a place from the eye.
  std::function<bool(const dvec3& place)> visible;
};

/// Marks as they lie in a picture, logical pixels.
struct SeenMarks {
  struct Text {
    QRectF box;
    QString text;
  };
  struct Line {
    QPolygonF points;
    QColor color;
  };
  struct Pin {
    QPointF at;
    Text plate;
    bool chosen = false;
  };
  std::vector<Text> numbers;
  std::vector<Text> labels;  ///< of lines
  std::vector<Line> lines;
  std::vector<QPolygonF> borders;
  std::vector<QLineF> cuts;
  std::vector<Pin> pins;
};

/// What of the marks is seen: hidden places are left out, and so are numbers that would touch one
/// another or leave the picture. Numbers of a regular grid so thin out regularly.
SeenMarks seenFrom(const LuxMarks& marks, const Sight& sight, const QFont& font);

/// The values of isolux lines that were found in the picture itself (render::placeLineLabels).
/// scale: logical pixels per pixel of it. Those that would touch what is there are left out.
void addLineLabels(const std::vector<render::LineLabel>& labels, double scale,
                   const color::LuxScale& unit, const QFont& font, SeenMarks& seen);

/// The room for such labels, pixels of the picture.
render::LabelRoom labelRoom(const QFont& font, double scale);

void paint(QPainter& painter, const SeenMarks& marks);

/// The order in which the points of a grid are thinned: every 16th of each direction has rank 0,
/// every 8th 1, and so on; counted from the middle.
int gridRank(int i, int j, int nu, int nv);

}  // namespace soffit::ui
