// SPDX-License-Identifier: MIT
#include "core/prt/directions.h"

#include "core/prt/kernels.h"
#include "core/sh/basis.h"
#include "core/sh/cube_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

namespace soffit::prt {
namespace {

/// The lower 10 bits with a zero after each.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 8U)) & 0x00ff00ffU;
  x = (x | (x << 4U)) & 0x0f0f0f0fU;
  x = (x | (x << 2U)) & 0x33333333U;
  return (x | (x << 1U)) & 0x55555555U;
}

/// Faces one after the other, Morton order on each.
std::uint32_t curveOrder(const dvec3& d) {
  const sh::CubePoint p = sh::cubePoint(d);
  const auto cell = [](double u) {
    return static_cast<std::uint32_t>(std::clamp(512.0 * (u + 1.0), 0.0, 1023.0));
  };
  return static_cast<std::uint32_t>(p.face) << 20U | spread(cell(p.u)) << 1U | spread(cell(p.v));
}

}  // namespace

std::size_t Directions::coefficients() const {
  return sh::coefficientCount(bands_);
}

Directions::Directions(const sh::SphereSamples& samples, int bands)
    : bands_(bands), stride_(rowStrideOf(sh::coefficientCount(bands))) {
  assert(samples.size() > 0 && bands >= 1 && bands <= sh::kMaxBands);
  std::vector<std::uint32_t> place;
  for (const dvec3& d : samples.directions) place.push_back(curveOrder(d));
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
  table_.assign(samples.size() * stride_, 0.0F);
  std::array<double, sh::kMaxCoefficients> basis;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const dvec3& d = samples.directions[order[i]];
    const double w = samples.weights[order[i]];
    directions_.emplace_back(d);
    weights_.push_back(static_cast<float>(w));
    sh::evaluate(d, bands, basis);
    for (std::size_t c = 0; c < coefficients(); ++c) {
      table_[i * stride_ + c] = static_cast<float>(w * basis[c]);
    }
  }
}

}  // namespace soffit::prt
