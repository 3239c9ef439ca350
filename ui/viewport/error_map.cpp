// SPDX-License-Identifier: MIT
#include "ui/viewport/error_map.h"

#include "core/math/sampling.h"
#include "core/render/difference_picture.h"
#include "ui/viewport/scene_view.h"
#include "ui/widgets/legend.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace soffit::ui {
namespace {

constexpr double kNearest = 0.05;    // m before the eye
constexpr double kBehind = 0.03;     // m that a surface may lie before its own point
constexpr double kShare = 0.4;       // of the distance between points, for the radius
constexpr double kSmallestM = 0.03;  // m
constexpr double kLargestM = 0.15;   // m
constexpr double kSmallestPx = 2.5;  // smaller discs are drawn as dots
constexpr int kCorners = 20;
constexpr double kCertain = 2.0;  // standard errors
constexpr std::array kScales{0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0};

QColor toQt(const vec3& c) {
  return QColor::fromRgbF(c.x, c.y, c.z);
}

double totalOf(const design::LightParts& parts) {
  return parts.direct + parts.indirect;
}

std::vector<color::LegendTick> percentTicks(double scale, int most) {
  auto ticks = render::differenceTicks(100.0 * scale, most);
  for (color::LegendTick& tick : ticks) tick.label += "\u00a0%";
  return ticks;
}

/// Half of the points have a neighbour that is nearer than this, m.
double spacingOf(const std::vector<ErrorPoint>& points) {
  std::vector<double> nearest;
  for (const ErrorPoint& p : points) {
    double least = std::numeric_limits<double>::max();
    for (const ErrorPoint& q : points) {
      if (&p == &q) continue;
      const dvec3 way = q.position - p.position;
      least = std::min(least, glm::dot(way, way));
    }
    nearest.push_back(std::sqrt(least));
  }
  if (nearest.size() < 2) return 0.0;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

}  // namespace

std::vector<ErrorPoint> errorPointsOf(const design::VerifyReport& report) {
  std::map<std::string, std::pair<double, std::size_t>> sums;
  for (const design::VerifiedPoint& p : report.points) {
    auto& [sum, count] = sums[p.set];
    sum += totalOf(p.reference);
    ++count;
  }
  std::vector<ErrorPoint> out;
  for (const design::VerifiedPoint& p : report.points) {
    const auto& [sum, count] = sums[p.set];
    const double floor = design::kFloorOfMean * sum / static_cast<double>(count);
    const double base = std::max(totalOf(p.reference), floor);
    if (base <= 0.0) continue;  // no light at all: nothing to be wrong about
    out.push_back({p.sensor.position, p.sensor.normal,
                   (totalOf(p.value) - totalOf(p.reference)) / base, p.standard_error / base});
  }
  return out;
}

double fittingErrorScale(const std::vector<ErrorPoint>& points) {
  if (points.empty()) return kScales.front();
  std::vector<double> errors;
  errors.reserve(points.size());
  for (const ErrorPoint& p : points) errors.push_back(std::abs(p.error));
  const double covered = std::ceil(0.95 * static_cast<double>(errors.size()));
  const auto rank = errors.begin() + static_cast<std::ptrdiff_t>(covered) - 1;
  std::nth_element(errors.begin(), rank, errors.end());
  const auto* fitting = std::ranges::lower_bound(kScales, *rank);
  return fitting == kScales.end() ? kScales.back() : *fitting;
}

ErrorMap::ErrorMap(SceneView& view, bool with_legend)
    : QWidget(&view), view_(view), legend_(new Legend(this)) {
  legend_->setVisible(with_legend);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  setAccessibleName(tr("Errors against the reference"));
  view_.installEventFilter(this);
  setGeometry(view_.rect());
  hide();
}

bool ErrorMap::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) setGeometry(view_.rect());
  return QWidget::eventFilter(watched, event);
}

void ErrorMap::resizeEvent(QResizeEvent*) {
  const QSize wanted = legend_->sizeHint();
  const int tall = std::min(wanted.height(), height() - 64);
  legend_->setGeometry(16, height() - tall - 16, wanted.width(), tall);
}

void ErrorMap::setPoints(std::vector<ErrorPoint> points) {
  points_ = std::move(points);
  radius_ = std::clamp(kShare * spacingOf(points_), kSmallestM, kLargestM);
  scale_ = fittingErrorScale(points_);
  legend_->setScale([](float place) { return render::differenceColor(2.0F * place - 1.0F); },
                    [scale = scale_](int most) { return percentTicks(scale, most); }, tr("Error"));
  setVisible(!points_.empty());
  update();
}

bool ErrorMap::isSeen(const ErrorPoint& point) const {
  const dvec2 size = view_.viewSize();
  const dvec3 at = view_.viewCamera().project(point.position, size);
  if (at.z < kNearest || at.x < 0.0 || at.y < 0.0 || at.x > size.x || at.y > size.y) return false;
  const PointedAt front = view_.pointAt({at.x, at.y});
  if (!front.surface) return true;
  return at.z <= view_.viewCamera().project(front.surface->position, size).z + kBehind;
}

void ErrorMap::paintPoint(QPainter& painter, const ErrorPoint& point) const {
  const ViewCamera& camera = view_.viewCamera();
  const dvec2 size = view_.viewSize();
  const dvec3 middle = camera.project(point.position, size);
  dvec3 t;
  dvec3 b;
  orthonormalBasis(point.normal, t, b);
  const bool certain = std::abs(point.error) > kCertain * point.noise;
  const QColor color = toQt(render::differenceColor(static_cast<float>(point.error / scale_)));
  painter.setPen(QPen(certain ? QColor(20, 22, 26, 170) : color, certain ? 0.7 : 1.5));
  painter.setBrush(certain ? QBrush(color) : QBrush(QColor(20, 22, 26, 90)));
  QPolygonF disc;
  double reach = 0.0;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * kPi * i / kCorners;
    const dvec3 corner = point.position + radius_ * (std::cos(angle) * t + std::sin(angle) * b);
    const dvec3 at = camera.project(corner, size);
    if (at.z < kNearest) return;
    disc.append({at.x, at.y});
    reach = std::max(reach, std::hypot(at.x - middle.x, at.y - middle.y));
  }
  if (reach < kSmallestPx) {
    painter.drawEllipse(QPointF(middle.x, middle.y), kSmallestPx, kSmallestPx);
  } else {
    painter.drawPolygon(disc);
  }
}

void ErrorMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawn_ = 0;
  for (const ErrorPoint& point : points_) {
    if (!isSeen(point)) continue;
    paintPoint(painter, point);
    ++drawn_;
  }
}

}  // namespace soffit::ui
