// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"
#include "core/scene/material.h"

#include <string>
#include <vector>

/// Scatter plots on two logarithmic axes, as SVG text or as a picture, from one drawing code.
namespace soffit::cli {

struct ChartSeries {
  std::string name;
  std::vector<dvec2> points;  ///< both coordinates > 0; others are left out
};

struct ChartPanel {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<ChartSeries> series;
  std::vector<dvec2> front;         ///< joined by a line
  std::vector<std::string> labels;  ///< beside the front's points; may be shorter
};

/// Panels in two columns (one, if there is just one), each 640 x 480.
std::string chartSvg(const std::vector<ChartPanel>& panels);
scene::Image chartImage(const std::vector<ChartPanel>& panels);

}  // namespace soffit::cli
