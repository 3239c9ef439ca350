// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// How far computed illuminances are from reference ones, in the figures that claims are made of.
namespace soffit::design {

/// Values at the same receivers, lux; all three of one length.
struct ErrorSamples {
  std::vector<double> value;           ///< computed
  std::vector<double> reference;       ///< unbiased estimates of the truth
  std::vector<double> standard_error;  ///< of `reference`, independent between receivers

  [[nodiscard]] std::size_t size() const { return value.size(); }
  void add(double computed, double truth, double stderr_of_truth);
  /// Joins the receivers of another set.
  void append(const ErrorSamples& other);
};

/// Errors as fractions: rms and bias of the reference's mean, p95 of |error| / max(E, 5 % of the
/// mean). Everything is 0 for no receivers; relative figures are 0 where the mean is 0.
struct ErrorFigures {
  std::size_t receivers = 0;
  double mean_lux = 0.0;          ///< of the reference
  double rms = 0.0;               ///< the reference's noise subtracted in squares, at least 0
  double rms_raw = 0.0;           ///< as it is
  double rms_stderr = 0.0;        ///< what the reference's noise leaves uncertain in rms
  double p95 = 0.0;               ///< noise included
  double bias = 0.0;              ///< positive: computed values are too high
  double bias_stderr = 0.0;       ///< standard error of `bias`, from the reference's
  double reference_stderr = 0.0;  ///< RMS of the standard errors over the mean
};

/// The floor of the denominator of p95, as a share of the mean.
inline constexpr double kFloorOfMean = 0.05;

/// Figures of one set, relative to its own mean.
///
/// With v = r + e + n (true value + error + noise of the reference, independent of e):
/// E[(v - r)^2] = e^2 + s^2, hence rms^2 = mean(d^2) - mean(s^2); its variance given e is
/// sum(4 e^2 s^2 + 2 s^4) / N^2 for Gaussian noise, and sd(rms) = sd(rms^2) / (2 rms).
ErrorFigures errorFigures(const ErrorSamples& samples);

/// Figures over several sets (positions of a light), each relative to its own mean and of equal
/// weight: rms in squares, bias and means averaged, p95 over all receivers of all sets.
ErrorFigures pooledFigures(std::span<const ErrorSamples> sets);

}  // namespace soffit::design
