// SPDX-License-Identifier: MIT
#include "core/glossy/reflection_map.h"

#include "core/sh/cube_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::glossy {
namespace {

std::size_t rimIndex(int side, int face, int row, int column) {
  const int wide = side + 2;
  return static_cast<std::size_t>((face * wide + row + 1) * wide + column + 1);
}

}  // namespace

SmoothCube::SmoothCube(int side, std::span<const vec3> texels) : side_(side) {
  const auto wide = static_cast<std::size_t>(side) + 2;
  assert(texels.size() == 6 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  texels_.resize(6 * wide * wide);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        texels_[rimIndex(side, face, row, column)] =
            texels[static_cast<std::size_t>((face * side + row) * side + column)];
      }
    }
  }
  // Just beyond an edge lies the neighbour's texel of the same place along the edge.
  const double beyond = 1.0 + 1.0e-6;
  for (int face = 0; face < 6; ++face) {
    for (int k = 0; k < side; ++k) {
      const double along = (2.0 * k + 1.0) / side - 1.0;
      const auto over = [&](double u, double v) {
        return texels[sh::texelOf(sh::cubeDirection({face, u, v}), side)];
      };
      texels_[rimIndex(side, face, k, -1)] = over(-beyond, along);
      texels_[rimIndex(side, face, k, side)] = over(beyond, along);
      texels_[rimIndex(side, face, -1, k)] = over(along, -beyond);
      texels_[rimIndex(side, face, side, k)] = over(along, beyond);
    }
    // The corner of the rim: the mean of the three texels that meet there.
    for (const int row : {-1, side}) {
      for (const int column : {-1, side}) {
        const int i = std::clamp(column, 0, side - 1);
        const int j = std::clamp(row, 0, side - 1);
        texels_[rimIndex(side, face, row, column)] =
            (texels_[rimIndex(side, face, j, i)] + texels_[rimIndex(side, face, row, i)] +
             texels_[rimIndex(side, face, j, column)]) /
            3.0F;
      }
    }
  }
}

vec3 SmoothCube::at(const vec3& direction) const {
  const sh::CubePoint point = sh::cubePoint(dvec3(direction));
  const auto place = [this](double u) {
    return static_cast<float>(std::clamp(0.5 * (u + 1.0) * side_ - 0.5, -0.5, side_ - 0.5));
  };
  const float x = place(point.u);
  const float y = place(point.v);
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const float s = x - static_cast<float>(i);
  const float t = y - static_cast<float>(j);
  const auto texel = [&](int row, int column) -> const vec3& {
    return texels_[rimIndex(side_, point.face, row, column)];
  };
  return glm::mix(glm::mix(texel(j, i), texel(j, i + 1), s),
                  glm::mix(texel(j + 1, i), texel(j + 1, i + 1), s), t);
}

ReflectionLevels::ReflectionLevels(int side) : pyramid_(side) {
  assert(side >= 8);
  for (int step = 0;; ++step) {
    const double alpha =
        std::min(1.0, static_cast<double>(ReflectionMap::kSharpest) *
                          std::exp2(static_cast<double>(step) / ReflectionMap::kStepsPerOctave));
    // Texels of half the lobe's width: 2 / side across, the lobe about 2 alpha.
    int own = 8;
    while (own < side && 2.0 / own > alpha) own *= 2;
    levels_.emplace_back(pyramid_, own, alpha);
    if (alpha >= 1.0) break;
  }
}

ReflectionMap::ReflectionMap(std::shared_ptr<const ReflectionLevels> levels,
                             std::span<const vec3> radiance)
    : levels_(std::move(levels)) {
  const TexelPyramid& pyramid = levels_->pyramid();
  std::vector<vec3> values(pyramid.size());
  assert(radiance.size() ==
         6 * static_cast<std::size_t>(pyramid.side()) * static_cast<std::size_t>(pyramid.side()));
  std::copy(radiance.begin(), radiance.end(), values.begin());
  pyramid.fill(values);
  cubes_.emplace_back(pyramid.side(), radiance);
  std::vector<vec3> blurred;
  for (const PrefilterLevel& level : levels_->blurred()) {
    blurred.resize(6 * static_cast<std::size_t>(level.side()) *
                   static_cast<std::size_t>(level.side()));
    level.apply(values, blurred);
    cubes_.emplace_back(level.side(), blurred);
  }
}

vec3 ReflectionMap::at(const vec3& direction, float alpha) const {
  // Levels 1, 2, .. lie at kSharpest 2^(k/2); level 0 is reached at half of the first.
  const float step =
      1.0F + static_cast<float>(kStepsPerOctave) * std::log2(std::max(alpha, 1.0e-4F) / kSharpest);
  const float place = std::clamp(step, 0.0F, static_cast<float>(cubes_.size() - 1));
  const auto k = std::min(static_cast<std::size_t>(place), cubes_.size() - 2);
  const float s = place - static_cast<float>(k);
  if (s <= 0.0F) return cubes_[k].at(direction);
  if (s >= 1.0F) return cubes_[k + 1].at(direction);
  return glm::mix(cubes_[k].at(direction), cubes_[k + 1].at(direction), s);
}

}  // namespace soffit::glossy
