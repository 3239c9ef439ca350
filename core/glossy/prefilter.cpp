// SPDX-License-Identifier: MIT
#include "core/glossy/prefilter.h"

#include "core/base/parallel.h"
#include "core/glossy/ggx.h"
#include "core/sh/cube_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::glossy {
namespace {

/// A texel is taken as it is where its share of the lobe, times the square of its width in units of
/// the angle over which the lobe changes, is below this: that is about what its middle may err by.
constexpr double kLeastShare = 2.0e-3;

/// The reflected lobe at cosine t from its axis.
double lobeAt(double t, double alpha) {
  return 0.25 * ggxDensity(std::sqrt(std::max(0.0, 0.5 * (1.0 + t))), alpha);
}

}  // namespace

TexelPyramid::TexelPyramid(int side) : side_(side) {
  assert(side >= 1 && side <= 512 && (side & (side - 1)) == 0);
  for (int n = side; n >= 1; n /= 2) {
    first_.push_back(directions_.size());
    const sh::SphereSamples samples = sh::cubeSamples(n);
    directions_.insert(directions_.end(), samples.directions.begin(), samples.directions.end());
    solid_angles_.insert(solid_angles_.end(), samples.weights.begin(), samples.weights.end());
  }
}

void TexelPyramid::fill(std::span<vec3> values) const {
  assert(values.size() == size());
  int n = side_;
  for (int level = 1; level < levels(); ++level) {
    const int half = n / 2;
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < half; ++row) {
        for (int column = 0; column < half; ++column) {
          const auto at = [&](int i, int j) {
            return first(level - 1) +
                   static_cast<std::size_t>((face * n + 2 * row + j) * n + 2 * column + i);
          };
          vec3 sum(0.0F);
          float whole = 0.0F;
          for (const std::size_t k : {at(0, 0), at(1, 0), at(0, 1), at(1, 1)}) {
            const auto w = static_cast<float>(solid_angles_[k]);
            sum += w * values[k];
            whole += w;
          }
          values[first(level) + static_cast<std::size_t>((face * half + row) * half + column)] =
              sum / whole;
        }
      }
    }
    n = half;
  }
}

namespace {

/// Collects the texels of one lobe, coarse ones where they will do.
class Collector {
 public:
  Collector(const TexelPyramid& pyramid, double alpha) : pyramid_(pyramid), alpha_(alpha) {}

  void collect(const dvec3& axis, std::vector<std::uint32_t>& indices,
               std::vector<float>& weights) {
    axis_ = axis;
    indices_ = &indices;
    weights_ = &weights;
    const std::size_t before = weights.size();
    whole_ = 0.0;
    for (int face = 0; face < 6; ++face) visit(pyramid_.levels() - 1, face, 0, 0);
    for (std::size_t k = before; k < weights.size(); ++k) {
      weights[k] = static_cast<float>(static_cast<double>(weights[k]) / whole_);
    }
  }

 private:
  void visit(int level, int face, int row, int column) {
    const int n = pyramid_.side() >> level;
    const std::size_t k =
        pyramid_.first(level) + static_cast<std::size_t>((face * n + row) * n + column);
    const double t = std::clamp(glm::dot(axis_, pyramid_.direction(k)), -1.0, 1.0);
    // D depends on tan of half the angle over alpha: it changes over the angle itself, or over
    // alpha near the axis.
    const double width = std::sqrt(pyramid_.solidAngle(k));
    const double scale = std::acos(t) - 0.7 * width + 1.2 * alpha_;
    const double weight = lobeAt(t, alpha_) * pyramid_.solidAngle(k);
    const double steps = width / std::max(scale, 0.5 * alpha_);
    // A coarse texel may hide the axis in a corner.
    const bool near = std::acos(t) < width;
    if (level > 0 && (near ? width > 0.35 * alpha_ : weight * steps * steps > kLeastShare)) {
      for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) visit(level - 1, face, 2 * row + j, 2 * column + i);
      }
      return;
    }
    whole_ += weight;
    indices_->push_back(static_cast<std::uint32_t>(k));
    weights_->push_back(static_cast<float>(weight));
  }

  const TexelPyramid& pyramid_;
  double alpha_;
  dvec3 axis_{0.0};
  double whole_ = 0.0;
  std::vector<std::uint32_t>* indices_ = nullptr;
  std::vector<float>* weights_ = nullptr;
};

}  // namespace

PrefilterLevel::PrefilterLevel(const TexelPyramid& pyramid, int side, double alpha)
    : side_(side), alpha_(alpha) {
  const sh::SphereSamples samples = sh::cubeSamples(side);
  struct List {
    std::vector<std::uint32_t> indices;
    std::vector<float> weights;
  };
  std::vector<List> lists(samples.size());
  parallelFor(samples.size(), 32, [&](std::size_t begin, std::size_t end) {
    Collector collector(pyramid, alpha);
    for (std::size_t k = begin; k < end; ++k) {
      collector.collect(samples.directions[k], lists[k].indices, lists[k].weights);
    }
  });
  begin_.push_back(0);
  for (const List& list : lists) {
    indices_.insert(indices_.end(), list.indices.begin(), list.indices.end());
    weights_.insert(weights_.end(), list.weights.begin(), list.weights.end());
    begin_.push_back(static_cast<std::uint32_t>(indices_.size()));
  }
}

void PrefilterLevel::apply(std::span<const vec3> pyramid, std::span<vec3> out) const {
  assert(out.size() + 1 == begin_.size());
  parallelFor(out.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      vec3 sum(0.0F);
      for (std::uint32_t i = begin_[k]; i < begin_[k + 1]; ++i) {
        sum += weights_[i] * pyramid[indices_[i]];
      }
      out[k] = sum;
    }
  });
}

}  // namespace soffit::glossy
