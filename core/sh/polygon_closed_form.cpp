// SPDX-License-Identifier: MIT
// Closed form of numerics.md 1.5: along an edge, with z(t) = w . s(t) = a cos t + b sin t,
//   B_k = integral P_k(z) dt, C_k = integral z P_k(z) dt, D_k = integral P'_k(z) dt,
// follow from one another, and S_k(w) = integral over the light of P_k(w . d) = sum over the edges
// of (w . inward) D_k / (k (k + 1)). The addition theorem turns S_k at enough axes w into y_km.
#include "core/sh/polygon_edges.h"
#include "core/sh/polygon_light.h"

#include "core/math/quadrature.h"
#include "core/sh/basis.h"

#include <array>
#include <cmath>

namespace soffit::sh {
namespace {

using Bands = std::array<double, kMaxBands>;

/// Solves the symmetric positive definite A x = b in place (Cholesky), size n.
void solveInPlace(std::vector<double>& a, std::vector<double>& b, std::size_t n) {
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) {
      double sum = a[i * n + j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i * n + k] * a[j * n + k];
      a[i * n + j] = i == j ? std::sqrt(sum) : sum / a[j * n + j];
    }
  }
  const std::size_t columns = b.size() / n;
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k) b[i * columns + c] -= a[i * n + k] * b[k * columns + c];
      b[i * columns + c] /= a[i * n + i];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k) {
        b[i * columns + c] -= a[k * n + i] * b[k * columns + c];
      }
      b[i * columns + c] /= a[i * n + i];
    }
  }
}

/// Axes on the upper half of the sphere (P_k knows a direction from its opposite by sign only) and
/// for each band the matrix from S_k at the axes to coefficients: the least-squares inverse of
/// P_k(w . d) = 4 pi / (2k + 1) sum_m y_km(w) y_km(d).
struct LobeBasis {
  std::vector<dvec3> axes;
  std::vector<std::vector<double>> matrix;  ///< [band][m][axis]

  explicit LobeBasis(int bands) {
    const int count = 2 * bands + 1;
    constexpr double kGolden = 2.39996322972865332;
    for (int j = 0; j < count; ++j) {
      const double z = 1.0 - (j + 0.5) / count;
      const double r = std::sqrt((1.0 - z) * (1.0 + z));
      axes.emplace_back(r * std::cos(kGolden * j), r * std::sin(kGolden * j), z);
    }
    for (int l = 0; l < bands; ++l) matrix.push_back(inverseOf(l));
  }

  [[nodiscard]] std::vector<double> inverseOf(int l) const {
    const auto orders = static_cast<std::size_t>(2 * l + 1);
    std::vector<double> lobes(orders * axes.size());  // [m][axis]
    std::array<double, kMaxCoefficients> basis;
    for (std::size_t j = 0; j < axes.size(); ++j) {
      evaluate(axes[j], l + 1, basis);
      for (std::size_t m = 0; m < orders; ++m) {
        lobes[m * axes.size() + j] =
            4.0 * kPi / static_cast<double>(orders) * basis[index(l, -l) + m];
      }
    }
    std::vector<double> gram(orders * orders, 0.0);
    for (std::size_t m = 0; m < orders; ++m) {
      for (std::size_t n = 0; n < orders; ++n) {
        for (std::size_t j = 0; j < axes.size(); ++j) {
          gram[m * orders + n] += lobes[m * axes.size() + j] * lobes[n * axes.size() + j];
        }
      }
    }
    solveInPlace(gram, lobes, orders);
    return lobes;
  }

  static const LobeBasis& ofBands(int bands) {
    static const std::array<LobeBasis, kMaxBands> all{
        LobeBasis(1), LobeBasis(2), LobeBasis(3), LobeBasis(4), LobeBasis(5),
        LobeBasis(6), LobeBasis(7), LobeBasis(8), LobeBasis(9), LobeBasis(10)};
    return all.at(static_cast<std::size_t>(bands - 1));
  }
};

/// D_k for an arc too short for the recurrences, whose terms cancel: P'_k hardly bends over it.
void slopesByQuadrature(double a, double b, double angle, int bands, Bands& slopes) {
  static const QuadratureRule rule = gaussLegendre(7);
  slopes.fill(0.0);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double t = 0.5 * angle * (rule.nodes[i] + 1.0);
    const double z = a * std::cos(t) + b * std::sin(t);
    const double weight = 0.5 * angle * rule.weights[i];
    double p_before = 1.0, p = z, slope_before = 0.0, slope = 1.0;
    for (int k = 1; k < bands; ++k) {
      slopes[static_cast<std::size_t>(k)] += weight * slope;
      const double next_slope = (2.0 * k + 1.0) * p + slope_before;
      const double next = ((2.0 * k + 1.0) * z * p - k * p_before) / (k + 1.0);
      slope_before = slope;
      slope = next_slope;
      p_before = p;
      p = next;
    }
  }
}

/// D_k, k = 1 .. bands - 1, of an arc with cosine and sine of its angle.
void slopesInClosedForm(double a, double b, const Arc& arc, double cosine, double sine, int bands,
                        Bands& slopes) {
  const double flat = 1.0 - (a * a + b * b);
  const double z0 = a, z1 = a * cosine + b * sine;
  const double turn0 = -b, turn1 = a * sine - b * cosine;     // -dz/dt at the ends
  double p0_before = 1.0, p0 = z0, p1_before = 1.0, p1 = z1;  // P_{k-1}, P_k at the ends
  double b_before = 0.0, b_now = arc.angle;                   // B_{k-2}, B_{k-1}
  double c_now = turn1 - turn0;                               // C_{k-1}
  double d_before = 0.0, d_now = arc.angle;                   // D_{k-1}, D_k
  for (int k = 1; k < bands; ++k) {
    slopes[static_cast<std::size_t>(k)] = d_now;
    const double ends = turn1 * p1 - turn0 * p0;
    const double c_next = (ends + k * b_now - flat * d_now) / (k + 1.0);
    const double b_next = ((2.0 * k - 1.0) * c_now - (k - 1.0) * b_before) / k;
    const double d_next = (2.0 * k + 1.0) * b_next + d_before;
    b_before = b_now;
    b_now = b_next;
    c_now = c_next;
    d_before = d_now;
    d_now = d_next;
    const double p0_next = ((2.0 * k + 1.0) * z0 * p0 - k * p0_before) / (k + 1.0);
    const double p1_next = ((2.0 * k + 1.0) * z1 * p1 - k * p1_before) / (k + 1.0);
    p0_before = p0;
    p0 = p0_next;
    p1_before = p1;
    p1 = p1_next;
  }
}

constexpr double kShortArc = 0.2;

}  // namespace

Coefficients polygonCoefficientsClosedForm(std::span<const dvec3> outline, const dvec3& p,
                                           int bands) {
  Coefficients result(coefficientCount(bands), 0.0);
  const double solid_angle = polygonSolidAngle(outline, p);
  if (!(solid_angle > 0.0)) return result;
  const LobeBasis& lobes = LobeBasis::ofBands(bands);
  std::array<Bands, 2 * kMaxBands + 1> sums{};
  Bands slopes{};
  for (const Arc& arc : arcsOf(outline, p)) {
    const double cosine = std::cos(arc.angle);
    const double sine = std::sin(arc.angle);
    for (std::size_t j = 0; j < lobes.axes.size(); ++j) {
      const dvec3& w = lobes.axes[j];
      const double a = glm::dot(w, arc.start);
      const double b = glm::dot(w, arc.side);
      if (arc.angle < kShortArc) {
        slopesByQuadrature(a, b, arc.angle, bands, slopes);
      } else {
        slopesInClosedForm(a, b, arc, cosine, sine, bands, slopes);
      }
      const double in = glm::dot(w, arc.inward);
      for (std::size_t k = 1; k < static_cast<std::size_t>(bands); ++k) {
        sums[j][k] += in * slopes[k];
      }
    }
  }
  result[0] = solid_angle / std::sqrt(4.0 * kPi);
  for (int l = 1; l < bands; ++l) {
    const std::vector<double>& matrix = lobes.matrix[static_cast<std::size_t>(l)];
    for (std::size_t m = 0; m < static_cast<std::size_t>(2 * l + 1); ++m) {
      double sum = 0.0;
      for (std::size_t j = 0; j < lobes.axes.size(); ++j) {
        sum += matrix[m * lobes.axes.size() + j] * sums[j][static_cast<std::size_t>(l)];
      }
      result[index(l, -l) + m] = sum / (l * (l + 1.0));
    }
  }
  return result;
}

}  // namespace soffit::sh
