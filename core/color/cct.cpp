// SPDX-License-Identifier: MIT
#include "core/color/cct.h"

#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace soffit::color {
namespace {

/// exp(-t^2/2) with different widths on either side of the peak.
double lobe(double nm, double peak, double width_below, double width_above) {
  const double t = (nm - peak) / (nm < peak ? width_below : width_above);
  return std::exp(-0.5 * t * t);
}

dvec3 matchingFunctions(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

/// Planck's law relative to its value at 560 nm: the ratio stays finite for any temperature.
double relativePlanck(double nm, double cct_k) {
  constexpr double kC2 = 1.438776877e7;  // nm K
  constexpr double kRefNm = 560.0;
  const double a = kC2 / (nm * cct_k);
  const double b = kC2 / (kRefNm * cct_k);
  // expm1(b) / expm1(a), written so that neither overflows at low temperatures.
  const double ratio = std::exp(b - a) * (-std::expm1(-b)) / (-std::expm1(-a));
  return std::pow(kRefNm / nm, 5.0) * ratio;
}

dvec3 integratedXyz(double cct_k) {
  dvec3 sum(0.0);
  // The integrand vanishes at both ends, so the midpoint sum converges fast.
  for (int i = 360; i < 830; ++i) {
    const double nm = i + 0.5;
    sum += relativePlanck(nm, cct_k) * matchingFunctions(nm);
  }
  return sum / sum.y;
}

}  // namespace

dvec3 planckianXyz(double cct_k) {
  // The integral takes 0.1 ms, luminaires ask for it at each move, and a project has a handful of
  // temperatures.
  constexpr std::size_t kMost = 256;
  thread_local std::unordered_map<double, dvec3> known;
  if (const auto found = known.find(cct_k); found != known.end()) return found->second;
  if (known.size() >= kMost) known.clear();
  return known[cct_k] = integratedXyz(cct_k);
}

dvec3 rec709FromXyz(const dvec3& xyz) {
  return {3.2409699419045226 * xyz.x - 1.5373831775700939 * xyz.y - 0.4986107602930034 * xyz.z,
          -0.9692436362808796 * xyz.x + 1.8759675015077202 * xyz.y + 0.0415550574071756 * xyz.z,
          0.0556300796969936 * xyz.x - 0.2039769588889766 * xyz.y + 1.0569715142428785 * xyz.z};
}

dvec3 xyzFromRec709(const dvec3& rgb) {
  static const dmat3 matrix =
      glm::inverse(dmat3(rec709FromXyz({1.0, 0.0, 0.0}), rec709FromXyz({0.0, 1.0, 0.0}),
                         rec709FromXyz({0.0, 0.0, 1.0})));
  return matrix * rgb;
}

}  // namespace soffit::color
