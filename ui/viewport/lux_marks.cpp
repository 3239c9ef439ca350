// SPDX-License-Identifier: MIT
#include "ui/viewport/lux_marks.h"

#include "ui/widgets/quantity.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <optional>

namespace soffit::ui {
namespace {

constexpr double kNearest = 0.05;  // m before the eye
constexpr QMarginsF kAround(4.0, 1.0, 4.0, 1.0);
constexpr QPointF kPinOffset(14.0, -30.0);
constexpr double kPinRadius = 4.5;
constexpr int kRanks = 4;

const QColor kInk(250, 250, 250);
const QColor kShade(10, 12, 16, 200);
const QColor kPlate(20, 22, 26, 215);
const QColor kChosen(255, 184, 40);
const QColor kBorder(250, 250, 250, 110);

/// A number of lux in the unit of a scale, as it is spelled beside points: 1240, 312, 48.5, 4.25.
QString numberText(double lux, color::LuxUnit unit) {
  const double value = lux / color::luxPer(unit);
  if (value >= 99.95) return QString::number(std::lround(value));
  return QString::number(value, 'f', value >= 9.995 ? 1 : 2);
}

/// A level as it was chosen: 7.5, 500.
QString levelText(double lux, color::LuxUnit unit) {
  return QString::number(lux / color::luxPer(unit), 'g', 4);
}

QColor toQt(const vec3& c) {
  return QColor::fromRgbF(c.x, c.y, c.z);
}

class Projection {
 public:
  explicit Projection(const Sight& sight) : sight_(sight) {}

  [[nodiscard]] std::optional<QPointF> operator()(const dvec3& place) const {
    const dvec3 at = sight_.camera.project(place, sight_.size);
    if (at.z < kNearest) return std::nullopt;
    return QPointF(at.x, at.y);
  }
  [[nodiscard]] bool isVisible(const dvec3& place) const {
    return !sight_.visible || sight_.visible(place);
  }
  [[nodiscard]] QRectF picture() const { return {0.0, 0.0, sight_.size.x, sight_.size.y}; }

 private:
  const Sight& sight_;
};

QRectF boxAbout(const QPointF& at, const QString& text, const QFontMetricsF& metrics) {
  QRectF box(0.0, 0.0, metrics.horizontalAdvance(text), metrics.ascent());
  box = box.marginsAdded(kAround);
  box.moveCenter(at);
  return box;
}

bool isFree(const QRectF& box, const std::vector<SeenMarks::Pin>& pins) {
  return std::ranges::none_of(pins, [&](const auto& pin) { return pin.plate.box.intersects(box); });
}

bool isFree(const QRectF& box, const std::vector<SeenMarks::Text>& others) {
  return std::ranges::none_of(others, [&](const auto& other) { return other.box.intersects(box); });
}

void addNumbers(const LuxMarks& marks, const Projection& project, const QFontMetricsF& metrics,
                SeenMarks& seen) {
  std::vector<const LuxMarks::Number*> order;
  for (const LuxMarks::Number& number : marks.numbers) order.push_back(&number);
  std::ranges::stable_sort(order, {}, [](const LuxMarks::Number* n) { return n->rank; });
  for (const LuxMarks::Number* number : order) {
    const auto at = project(number->at);
    if (!at || !project.picture().contains(*at)) continue;
    const QString text = numberText(number->lux, marks.scale.unit);
    const QRectF box = boxAbout(*at, text, metrics);
    // Rays are dearer than rectangles.
    if (!project.picture().contains(box) || !isFree(box, seen.numbers)) continue;
    if (!isFree(box, seen.pins)) continue;
    if (project.isVisible(number->at)) seen.numbers.push_back({box, text});
  }
}

/// The middle of the longest stretch is where a line has most room for its value.
void addLabel(const QPolygonF& stretch, const QString& text, const QFontMetricsF& metrics,
              const Projection& project, SeenMarks& seen) {
  const QPointF at = stretch[stretch.size() / 2];
  const QRectF box = boxAbout(at, text, metrics);
  const QSizeF extent = stretch.boundingRect().size();
  if (extent.width() + extent.height() < 2.5 * box.width()) return;
  if (!project.picture().contains(box)) return;
  if (isFree(box, seen.labels) && isFree(box, seen.numbers) && isFree(box, seen.pins)) {
    seen.labels.push_back({box, text});
  }
}

void addLines(const LuxMarks& marks, const Projection& project, const QFontMetricsF& metrics,
              SeenMarks& seen) {
  for (const LuxMarks::Line& line : marks.lines) {
    const QColor color = toQt(marks.scale.color(static_cast<float>(line.level)));
    QPolygonF longest;
    QPolygonF stretch;
    const auto end = [&] {
      if (stretch.size() > longest.size()) longest = stretch;
      if (stretch.size() > 1) seen.lines.push_back({stretch, color});
      stretch.clear();
    };
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i < count + (line.closed ? 1 : 0); ++i) {
      const dvec3& place = line.points[i % count];
      const auto at = project(place);
      if (at && project.isVisible(place)) {
        stretch.append(*at);
      } else {
        end();
      }
    }
    end();
    if (longest.size() > 2) {
      addLabel(longest, levelText(line.level, marks.scale.unit), metrics, project, seen);
    }
  }
}

void addPins(const LuxMarks& marks, const Projection& project, const QFontMetricsF& metrics,
             SeenMarks& seen) {
  for (const LuxMarks::Pin& pin : marks.pins) {
    const auto at = project(pin.at);
    if (!at || !project.picture().contains(*at) || !project.isVisible(pin.at)) continue;
    SeenMarks::Pin shown{*at, {}, pin.chosen};
    shown.plate.text = pin.name + QLatin1Char('\n') + pin.reading;
    const double width =
        std::max(metrics.horizontalAdvance(pin.name), metrics.horizontalAdvance(pin.reading));
    QRectF box(0.0, 0.0, width + 14.0, 2.0 * metrics.height() + 6.0);
    box.moveTopLeft(*at + kPinOffset);
    box.moveLeft(std::min(box.left(), project.picture().right() - box.width() - 2.0));
    box.moveTop(std::max(box.top(), 2.0));
    shown.plate.box = box;
    seen.pins.push_back(std::move(shown));
  }
}

void paintHalo(QPainter& painter, const SeenMarks::Text& text) {
  painter.setPen(kShade);
  for (const QPointF& by : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)}) {
    painter.drawText(text.box.translated(by), Qt::AlignCenter, text.text);
  }
  painter.setPen(kInk);
  painter.drawText(text.box, Qt::AlignCenter, text.text);
}

void paintPlate(QPainter& painter, const SeenMarks::Text& text, Qt::Alignment alignment) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(kPlate);
  painter.drawRoundedRect(text.box, 3.0, 3.0);
  painter.setPen(kInk);
  painter.drawText(text.box.adjusted(alignment & Qt::AlignLeft ? 7.0 : 0.0, 0.0, 0.0, 0.0),
                   static_cast<int>(alignment), text.text);
}

void paintPin(QPainter& painter, const SeenMarks::Pin& pin) {
  painter.setPen(QPen(kShade, 3.0));
  painter.drawLine(pin.at, pin.plate.box.bottomLeft() + QPointF(4.0, -4.0));
  painter.setPen(QPen(pin.chosen ? kChosen : kInk, 1.2));
  painter.drawLine(pin.at, pin.plate.box.bottomLeft() + QPointF(4.0, -4.0));
  painter.setPen(QPen(kShade, 1.5));
  painter.setBrush(pin.chosen ? kChosen : kInk);
  painter.drawEllipse(pin.at, kPinRadius, kPinRadius);
  paintPlate(painter, pin.plate, Qt::AlignLeft | Qt::AlignVCenter);
}

}  // namespace

SeenMarks seenFrom(const LuxMarks& marks, const Sight& sight, const QFont& font) {
  SeenMarks seen;
  const Projection project(sight);
  const QFontMetricsF metrics(font);
  for (const auto& corners : marks.borders) {
    QPolygonF border;
    for (const dvec3& corner : corners) {
      if (const auto at = project(corner)) border.append(*at);
    }
    if (border.size() == static_cast<qsizetype>(corners.size())) seen.borders.push_back(border);
  }
  for (const auto& cut : marks.cuts) {
    const auto a = project(cut[0]);
    const auto b = project(cut[1]);
    if (a && b) seen.cuts.emplace_back(*a, *b);
  }
  addPins(marks, project, metrics, seen);  // the others keep clear of them
  addNumbers(marks, project, metrics, seen);
  addLines(marks, project, metrics, seen);
  return seen;
}

render::LabelRoom labelRoom(const QFont& font, double scale) {
  const QFontMetricsF metrics(font);
  const double width = metrics.horizontalAdvance(QStringLiteral("0000")) + 10.0;
  render::LabelRoom room;
  room.size = vec2(dvec2(width, metrics.height()) / scale);
  room.repeat = static_cast<float>(260.0 / scale);
  return room;
}

void addLineLabels(const std::vector<render::LineLabel>& labels, double scale,
                   const color::LuxScale& unit, const QFont& font, SeenMarks& seen) {
  const QFontMetricsF metrics(font);
  for (const render::LineLabel& label : labels) {
    const QPointF at =
        scale * QPointF(static_cast<double>(label.at.x), static_cast<double>(label.at.y));
    const QString text = levelText(label.level, unit.unit);
    const QRectF box = boxAbout(at, text, metrics);
    if (isFree(box, seen.numbers) && isFree(box, seen.labels) && isFree(box, seen.pins)) {
      seen.labels.push_back({box, text});
    }
  }
}

void paint(QPainter& painter, const SeenMarks& marks) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kBorder, 1.0, Qt::DashLine));
  for (const QPolygonF& border : marks.borders) painter.drawPolygon(border);
  for (const SeenMarks::Line& line : marks.lines) {
    painter.setPen(QPen(kShade, 3.4));
    painter.drawPolyline(line.points);
    painter.setPen(QPen(line.color, 1.6));
    painter.drawPolyline(line.points);
  }
  for (const QLineF& cut : marks.cuts) {
    painter.setPen(QPen(kShade, 4.0));
    painter.drawLine(cut);
    painter.setPen(QPen(kChosen, 2.0));
    painter.drawLine(cut);
    painter.setBrush(kChosen);
    painter.drawEllipse(cut.p1(), kPinRadius - 1.0, kPinRadius - 1.0);  // where the way is 0
  }
  for (const SeenMarks::Text& number : marks.numbers) paintHalo(painter, number);
  for (const SeenMarks::Text& label : marks.labels) paintPlate(painter, label, Qt::AlignCenter);
  for (const SeenMarks::Pin& pin : marks.pins) paintPin(painter, pin);
}

int gridRank(int i, int j, int nu, int nv) {
  const int u = std::abs(i - nu / 2);
  const int v = std::abs(j - nv / 2);
  int rank = kRanks;
  // The greatest power of two that divides both.
  for (int step = 2; rank > 0 && u % step == 0 && v % step == 0; step *= 2) --rank;
  return rank;
}

}  // namespace soffit::ui
