// SPDX-License-Identifier: MIT
#include "core/glossy/lobe_shape.h"

#include "core/base/parallel.h"
#include "core/glossy/ggx.h"
#include "core/sh/zonal.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soffit::glossy {
namespace {

constexpr std::size_t kNodes = 33;
constexpr std::size_t kKernels = 1025;
constexpr double kLeastCosine = 1.0e-3;
/// alpha runs over [kMirrorAlpha, 1] as the square of what is stepped through.
const double kLeastRoughness = std::sqrt(kMirrorAlpha);

/// Steps through the shares of the density from its foot, where GGX has a long tail within w^2 =
/// 1 - u ~ alpha^2: 1 - u = v^4 resolves it at any alpha.
struct Tail {
  double rest;    ///< 1 - u
  double weight;  ///< of the step
  Tail(int i, int steps) {
    const double v = (i + 0.5) / steps;
    rest = v * v * v * v;
    weight = 4.0 * v * v * v / steps;
  }
};

/// What is left of the reflected lobe about an axis when everything below the surface is cut off.
struct CutLobe {
  double share = 0.0;
  double sine = 0.0;  ///< of the mean direction's angle from the normal, toward the axis
  double mean_cosine = 0.0;
};

/// Rings about the axis by shares of D cos, the azimuths above the surface in closed form.
CutLobe cutLobe(double axis_angle, double alpha) {
  constexpr int kRings = 128;
  const double axis_sine = std::sin(axis_angle);
  const double axis_cosine = std::cos(axis_angle);
  double share = 0.0;
  double along = 0.0;   // the axis
  double across = 0.0;  // toward the normal
  for (int i = 0; i < kRings; ++i) {
    const Tail tail(i, kRings);
    const double mu2 = tail.rest / (tail.rest + alpha * alpha * (1.0 - tail.rest));
    const double weight = tail.weight;
    const double t = 2.0 * mu2 - 1.0;
    const double s = std::sqrt(std::max(0.0, (1.0 - t) * (1.0 + t)));
    const double c = -t * axis_cosine / std::max(1.0e-300, s * axis_sine);
    const double half = std::acos(std::clamp(c, -1.0, 1.0));
    share += weight * half / kPi;
    along += weight * t * half / kPi;
    across += weight * s * std::sin(half) / kPi;
  }
  const dvec2 mean(along * axis_sine - across * axis_cosine,
                   along * axis_cosine + across * axis_sine);
  const double length = glm::length(mean);
  return {share, mean.x / length, length / share};
}

/// The axis and the width of the round lobe that, cut, has this mean direction and mean cosine. The
/// mean cosine falls as alpha grows; the mean direction follows the axis.
RoundLobe fitRoundLobe(const dvec3& mean, double weight) {
  const double length = glm::length(mean);
  const double mean_cosine = length / weight;
  RoundLobe lobe;
  const double wanted = std::asin(std::clamp(-mean.x / length, 0.0, 1.0));
  double axis = wanted;
  for (int round = 0; round < 12; ++round) {
    double low = 0.25 * kMirrorAlpha;
    double high = 1.0;
    for (int i = 0; i < 20; ++i) {
      const double middle = std::sqrt(low * high);
      (cutLobe(axis, middle).mean_cosine > mean_cosine ? low : high) = middle;
    }
    lobe.alpha = std::sqrt(low * high);
    const double found = std::asin(std::clamp(cutLobe(axis, lobe.alpha).sine, -1.0, 1.0));
    // Near the normal the two are proportional, by a small factor for rough lobes.
    axis = std::clamp(axis * wanted / std::max(found, 1.0e-9), 0.0, 0.5 * kPi);
  }
  lobe.axis_sine = std::sin(axis);
  lobe.above = cutLobe(axis, lobe.alpha).share;
  return lobe;
}

LobeShape integrate(double cos_view, double alpha, int side) {
  const dvec3 wo(std::sqrt(std::max(0.0, 1.0 - cos_view * cos_view)), 0.0, cos_view);
  double base = 0.0;
  double rise = 0.0;
  dvec3 base_mean(0.0);
  dvec3 rise_mean(0.0);
  for (int i = 0; i < side; ++i) {
    const Tail tail(i, side);
    for (int j = 0; j < side; ++j) {
      const GgxDraw draw = drawGgx(wo, alpha, {1.0 - tail.rest, (j + 0.5) / side});
      const double weight = tail.weight * draw.weight / side;
      const double risen = weight * schlickRise(draw.cos_h);
      base += weight - risen;
      rise += risen;
      base_mean += (weight - risen) * draw.wi;
      rise_mean += risen * draw.wi;
    }
  }
  LobeShape shape;
  shape.scale = base;
  shape.bias = rise;
  shape.base = fitRoundLobe(base_mean, base);
  shape.rise = fitRoundLobe(rise_mean, rise);
  return shape;
}

LobeShape mirror(double cos_view) {
  const double rise = schlickRise(cos_view);
  const RoundLobe sharp{std::sqrt(std::max(0.0, 1.0 - cos_view * cos_view)), kMirrorAlpha, 1.0};
  return {1.0 - rise, rise, sharp, sharp};
}

/// Members are kept as what changes slowly: the axis's sine over the mirror direction's,
/// alpha over the true one.
struct Table {
  std::vector<LobeShape> nodes{kNodes * kNodes};

  static double cosineAt(double x) { return kLeastCosine + (1.0 - kLeastCosine) * x * x; }
  static double alphaAt(double y) {
    const double roughness = kLeastRoughness + (1.0 - kLeastRoughness) * y;
    return roughness * roughness;
  }
  static double sineOf(double cosine) {
    return std::sqrt(std::max(1.0e-12, (1.0 - cosine) * (1.0 + cosine)));
  }
  Table() {
    constexpr int kSide = 64;
    parallelFor(kNodes * kNodes, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        // At the pole the ratio of the sines is taken beside it, where the sines outweigh the
        // rule's error; it is even in the angle.
        const double x = static_cast<double>(k % kNodes) / (kNodes - 1);
        const double cosine = std::min(cosineAt(x), 1.0 - 2.0e-3);
        const double alpha = alphaAt(static_cast<double>(k / kNodes) / (kNodes - 1));
        LobeShape shape = integrate(cosine, alpha, kSide);
        for (RoundLobe* lobe : {&shape.base, &shape.rise}) {
          lobe->axis_sine /= sineOf(cosine);
          lobe->alpha /= alpha;
        }
        nodes[k] = shape;
      }
    });
  }
};

const Table& table() {
  static const Table made;
  return made;
}

double mix(double a, double b, double t) {
  return a + t * (b - a);
}

RoundLobe mix(const RoundLobe& a, const RoundLobe& b, double t) {
  return {mix(a.axis_sine, b.axis_sine, t), mix(a.alpha, b.alpha, t), mix(a.above, b.above, t)};
}

LobeShape mix(const LobeShape& a, const LobeShape& b, double t) {
  return {mix(a.scale, b.scale, t), mix(a.bias, b.bias, t), mix(a.base, b.base, t),
          mix(a.rise, b.rise, t)};
}

}  // namespace

LobeShape integrateLobe(double cos_view, double alpha) {
  return integrate(cos_view, alpha, 256);
}

LobeShape lobeShape(double cos_view, double alpha) {
  const double cosine = std::clamp(cos_view, kLeastCosine, 1.0);
  if (alpha < kMirrorAlpha) return mirror(cosine);
  const double limited = std::min(alpha, 1.0);
  const double x = std::sqrt((cosine - kLeastCosine) / (1.0 - kLeastCosine)) * (kNodes - 1);
  const double y = (std::sqrt(limited) - kLeastRoughness) / (1.0 - kLeastRoughness) * (kNodes - 1);
  const auto i = std::min(static_cast<std::size_t>(x), kNodes - 2);
  const auto j = std::min(static_cast<std::size_t>(y), kNodes - 2);
  const LobeShape* at = table().nodes.data() + j * kNodes + i;
  const double s = x - static_cast<double>(i);
  LobeShape shape =
      mix(mix(at[0], at[1], s), mix(at[kNodes], at[kNodes + 1], s), y - static_cast<double>(j));
  for (RoundLobe* lobe : {&shape.base, &shape.rise}) {
    lobe->axis_sine = std::min(1.0, lobe->axis_sine * Table::sineOf(cosine));
    lobe->alpha = std::min(1.0, lobe->alpha * limited);
  }
  return shape;
}

LobeTable lobeTable() {
  return {kNodes, kLeastCosine, kLeastRoughness, table().nodes};
}

vec3 lobeAxis(const RoundLobe& lobe, const vec3& normal, const vec3& to_eye) {
  const vec3 along = glm::dot(to_eye, normal) * normal - to_eye;
  const float length = glm::length(along);
  const auto sine = static_cast<float>(lobe.axis_sine);
  if (length < 1.0e-6F) return normal;
  return (sine / length) * along + std::sqrt(std::max(0.0F, 1.0F - sine * sine)) * normal;
}

const std::array<float, 10>& lobeKernel(double alpha) {
  static const std::vector<std::array<float, 10>> table = [] {
    std::vector<std::array<float, 10>> kernels(kKernels);
    for (std::size_t i = 0; i < kKernels; ++i) {
      const double at = std::max(kMirrorAlpha, static_cast<double>(i) / (kKernels - 1));
      const sh::Kernel kernel = sh::ggxReflectedKernel(at, sh::kMaxBands);
      std::copy(kernel.begin(), kernel.end(), kernels[i].begin());
    }
    return kernels;
  }();
  const double place = std::clamp(alpha, 0.0, 1.0) * (kKernels - 1);
  return table[static_cast<std::size_t>(std::lround(place))];
}

}  // namespace soffit::glossy
