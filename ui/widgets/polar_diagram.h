// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QImage>

#include <vector>

namespace soffit::ui {

/// Luminous intensity over the angle in one plane through a luminaire's axis.
struct PolarCurve {
  struct Point {
    double angle_deg = 0.0;  ///< from straight down, positive to the right, -180..180
    double cd = 0.0;
  };
  std::vector<Point> points;  ///< ascending angles
};

/// The light distribution curve as designers know it: down is down, C0-C180 solid and filled,
/// C90-C270 dashed, rings at half and full intensity. On a transparent ground.
QImage polarDiagram(const PolarCurve& c0, const PolarCurve& c90, int pixels, const QColor& curve,
                    const QColor& grid);

}  // namespace soffit::ui
