// SPDX-License-Identifier: MIT
#include "core/design/error_figures.h"

#include "core/photometry/metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soffit::design {
namespace {

double square(double x) {
  return x * x;
}

/// Sums over a set, in units of its own mean.
struct Moments {
  double mean = 0.0;           ///< lux
  double difference = 0.0;     ///< mean of d
  double squares = 0.0;        ///< mean of d^2
  double noise = 0.0;          ///< mean of s^2
  double square_spread = 0.0;  ///< variance of mean(d^2) - mean(s^2)
};

Moments momentsOf(const ErrorSamples& samples) {
  Moments m;
  const auto n = static_cast<double>(samples.size());
  for (const double r : samples.reference) m.mean += r / n;
  if (!(m.mean > 0.0)) return m;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double d = (samples.value[i] - samples.reference[i]) / m.mean;
    const double s2 = square(samples.standard_error[i] / m.mean);
    m.difference += d / n;
    m.squares += d * d / n;
    m.noise += s2 / n;
    const double e2 = std::max(0.0, d * d - s2);
    m.square_spread += (4.0 * e2 * s2 + 2.0 * s2 * s2) / (n * n);
  }
  return m;
}

void appendRelativeErrors(const ErrorSamples& samples, double mean, std::vector<double>& out) {
  if (!(mean > 0.0)) return;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double scale = std::max(samples.reference[i], kFloorOfMean * mean);
    out.push_back(std::abs(samples.value[i] - samples.reference[i]) / scale);
  }
}

}  // namespace

void ErrorSamples::add(double computed, double truth, double stderr_of_truth) {
  value.push_back(computed);
  reference.push_back(truth);
  standard_error.push_back(stderr_of_truth);
}

void ErrorSamples::append(const ErrorSamples& other) {
  value.insert(value.end(), other.value.begin(), other.value.end());
  reference.insert(reference.end(), other.reference.begin(), other.reference.end());
  standard_error.insert(standard_error.end(), other.standard_error.begin(),
                        other.standard_error.end());
}

ErrorFigures pooledFigures(std::span<const ErrorSamples> sets) {
  ErrorFigures figures;
  double used = 0.0;
  double squares = 0.0;
  double noise = 0.0;
  double square_spread = 0.0;
  double bias_spread = 0.0;
  std::vector<double> relative;
  for (const ErrorSamples& set : sets) {
    assert(set.value.size() == set.reference.size() &&
           set.value.size() == set.standard_error.size());
    if (set.size() == 0) continue;
    const Moments m = momentsOf(set);
    const auto n = static_cast<double>(set.size());
    used += 1.0;
    figures.receivers += set.size();
    figures.mean_lux += m.mean;
    figures.bias += m.difference;
    squares += m.squares;
    noise += m.noise;
    square_spread += m.square_spread;
    bias_spread += m.noise / n;
    appendRelativeErrors(set, m.mean, relative);
  }
  if (used == 0.0) return figures;
  figures.mean_lux /= used;
  figures.bias /= used;
  figures.bias_stderr = std::sqrt(bias_spread) / used;
  figures.reference_stderr = std::sqrt(noise / used);
  figures.rms_raw = std::sqrt(squares / used);
  figures.rms = std::sqrt(std::max(0.0, (squares - noise) / used));
  const double spread = std::sqrt(square_spread) / used;
  // Near 0 the square root is not linear: there the bound is that of the square itself.
  figures.rms_stderr = spread > 0.0 ? spread / std::max(2.0 * figures.rms, std::sqrt(spread)) : 0.0;
  figures.p95 = photometry::percentile(relative, 0.95);
  return figures;
}

ErrorFigures errorFigures(const ErrorSamples& samples) {
  return pooledFigures(std::span(&samples, 1));
}

}  // namespace soffit::design
