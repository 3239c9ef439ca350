// SPDX-License-Identifier: MIT
#include "core/sh/gradient_grid.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::sh {
namespace {

/// Where p falls along an axis: the lower point of its cell and the share of the upper one.
struct Place {
  int lower = 0;
  double share = 0.0;
  int ends = 2;  ///< 1: an axis of one point
};

Place placeOf(double p, double origin, double spacing, int count) {
  if (count < 2) return {0, 0.0, 1};
  const double steps = std::clamp((p - origin) / spacing, 0.0, count - 1.0);
  const int lower = std::min(static_cast<int>(steps), count - 2);
  return {lower, steps - lower, 2};
}

}  // namespace

dvec3 GridPlaces::at(std::size_t i) const {
  const auto nx = static_cast<std::size_t>(count[0]);
  const auto ny = static_cast<std::size_t>(count[1]);
  const auto x = static_cast<double>(i % nx);
  const auto y = static_cast<double>(i / nx % ny);
  const auto z = static_cast<double>(i / nx / ny);
  return origin + spacing * dvec3(x, y, z);
}

GradientGrid::GradientGrid(const GridPlaces& places, const Evaluate& evaluate) : places_(places) {
  assert(places.count[0] >= 1 && places.count[1] >= 1 && places.count[2] >= 1);
  std::vector<CoefficientsWithGradient> points(places.size());
  parallelFor(points.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) points[i] = evaluate(places_.at(i));
  });
  coefficients_ = points[0].values.size();
  for (const CoefficientsWithGradient& point : points) {
    assert(point.values.size() == coefficients_ && point.gradients.size() == coefficients_);
    values_.insert(values_.end(), point.values.begin(), point.values.end());
    gradients_.insert(gradients_.end(), point.gradients.begin(), point.gradients.end());
  }
}

void GradientGrid::at(const dvec3& p, std::span<double> coefficients) const {
  assert(coefficients.size() == coefficients_);
  std::array<Place, 3> place;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    place[a] = placeOf(p[axis], places_.origin[axis], places_.spacing[axis], places_.count[a]);
  }
  // Between points half of the gradient, beyond the only one of an axis all of it.
  const dvec3 part(place[0].ends == 1 ? 1.0 : 0.5, place[1].ends == 1 ? 1.0 : 0.5,
                   place[2].ends == 1 ? 1.0 : 0.5);
  std::fill(coefficients.begin(), coefficients.end(), 0.0);
  for (int corner = 0; corner < 8; ++corner) {
    std::size_t point = 0;
    std::size_t stride = 1;
    double weight = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool upper = ((corner >> axis) & 1) != 0;
      weight *= upper ? place[axis].share : 1.0 - place[axis].share;
      point += stride * static_cast<std::size_t>(place[axis].lower + (upper ? 1 : 0));
      stride *= static_cast<std::size_t>(places_.count[axis]);
    }
    if (weight == 0.0) continue;  // and never read beyond an axis of one point
    const dvec3 way = weight * part * (p - places_.at(point));
    const double* value = values_.data() + point * coefficients_;
    const dvec3* gradient = gradients_.data() + point * coefficients_;
    for (std::size_t i = 0; i < coefficients_; ++i) {
      coefficients[i] += weight * value[i] + glm::dot(gradient[i], way);
    }
  }
}

}  // namespace soffit::sh
