// SPDX-License-Identifier: MIT
#include "ui/widgets/polar_diagram.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295;

double peakOf(const PolarCurve& curve) {
  double peak = 0.0;
  for (const PolarCurve::Point& p : curve.points) peak = std::max(peak, p.cd);
  return peak;
}

/// Whether a share of the light worth a picture goes upward.
bool goesUp(const PolarCurve& curve, double peak) {
  return std::ranges::any_of(curve.points, [&](const PolarCurve::Point& p) {
    return std::abs(p.angle_deg) > 95.0 && p.cd > 0.05 * peak;
  });
}

}  // namespace

QImage polarDiagram(const PolarCurve& c0, const PolarCurve& c90, int pixels, const QColor& curve,
                    const QColor& grid) {
  QImage image(pixels, pixels, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  const double peak = std::max({peakOf(c0), peakOf(c90), 1e-9});
  const bool up = goesUp(c0, peak) || goesUp(c90, peak);
  const double size = pixels;
  // Downlights use the whole height; what shines both ways sits in the middle.
  const QPointF center(0.5 * size, up ? 0.5 * size : 0.08 * size);
  const double radius = up ? 0.46 * size : 0.88 * size;
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(image.rect());
  painter.setPen(QPen(grid, 1.0));
  for (const double share : {0.5, 1.0}) {
    painter.drawEllipse(center, share * radius, share * radius);
  }
  painter.drawLine(QPointF(0.0, center.y()), QPointF(size, center.y()));
  painter.drawLine(QPointF(center.x(), up ? 0.0 : center.y()), QPointF(center.x(), size));
  const auto pathOf = [&](const PolarCurve& c) {
    QPainterPath path;
    for (const PolarCurve::Point& p : c.points) {
      const double a = p.angle_deg * kRadiansPerDegree;
      const QPointF at = center + radius * p.cd / peak * QPointF(std::sin(a), std::cos(a));
      if (path.elementCount() == 0) {
        path.moveTo(at);
      } else {
        path.lineTo(at);
      }
    }
    return path;
  };
  QColor fill = curve;
  fill.setAlpha(60);
  painter.fillPath(pathOf(c0), fill);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(curve, 1.4, Qt::DashLine));
  painter.drawPath(pathOf(c90));
  painter.setPen(QPen(curve, 1.8));
  painter.drawPath(pathOf(c0));
  return image;
}

}  // namespace soffit::ui
