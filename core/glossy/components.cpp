// SPDX-License-Identifier: MIT
#include "core/glossy/components.h"

#include "core/math/rng.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

namespace soffit::glossy {
namespace {

constexpr std::size_t kSpareRows = 4;
constexpr int kSteps = 8;

using Rows = std::vector<std::vector<float>>;

/// Gram-Schmidt, twice for orthogonality to rounding; rows that vanish are dropped.
void orthonormalise(Rows& rows) {
  Rows kept;
  for (std::vector<float>& row : rows) {
    const std::size_t n = row.size();
    const float before = std::sqrt(dot(row.data(), row.data(), n));
    for (int pass = 0; pass < 2; ++pass) {
      for (const std::vector<float>& q : kept) {
        const float along = dot(row.data(), q.data(), n);
        for (std::size_t i = 0; i < n; ++i) row[i] -= along * q[i];
      }
    }
    const float length = std::sqrt(dot(row.data(), row.data(), n));
    if (!(length > 1.0e-5F * before) || !(length > 1.0e-30F)) continue;
    for (float& x : row) x /= length;
    kept.push_back(std::move(row));
  }
  rows = std::move(kept);
}

/// Eigenvectors of a small symmetric matrix by Jacobi's rotations; columns of the result.
std::vector<std::vector<double>> jacobi(std::vector<std::vector<double>>& a) {
  const std::size_t n = a.size();
  std::vector<std::vector<double>> v(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i) v[i][i] = 1.0;
  for (int sweep = 0; sweep < 30; ++sweep) {
    double off = 0.0, on = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      on += a[i][i] * a[i][i];
      for (std::size_t j = 0; j < i; ++j) off += a[i][j] * a[i][j];
    }
    if (off <= 1.0e-24 * on) break;
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        if (a[p][q] == 0.0) continue;
        const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
        const double t =
            std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(1.0 + theta * theta));
        const double c = 1.0 / std::sqrt(1.0 + t * t);
        const double s = t * c;
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y;
          a[k][q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y;
          a[q][k] = s * x + c * y;
          const double vx = v[k][p], vy = v[k][q];
          v[k][p] = c * vx - s * vy;
          v[k][q] = s * vx + c * vy;
        }
      }
    }
  }
  return v;
}

/// The centred members, and what is asked of them.
class Centred {
 public:
  Centred(std::span<const float> vectors, std::size_t dimension,
          std::span<const std::uint32_t> members, std::vector<float>& mean)
      : n_(dimension), rows_(members.size() * dimension) {
    std::vector<double> sum(n_, 0.0);
    for (const std::uint32_t m : members) {
      for (std::size_t i = 0; i < n_; ++i) sum[i] += static_cast<double>(vectors[m * n_ + i]);
    }
    mean.resize(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      mean[i] = static_cast<float>(sum[i] / static_cast<double>(members.size()));
    }
    for (std::size_t k = 0; k < members.size(); ++k) {
      for (std::size_t i = 0; i < n_; ++i)
        rows_[k * n_ + i] = vectors[members[k] * n_ + i] - mean[i];
    }
  }
  [[nodiscard]] std::size_t count() const { return rows_.size() / n_; }
  [[nodiscard]] const float* row(std::size_t k) const { return rows_.data() + k * n_; }

  /// X^T X q for each row q.
  [[nodiscard]] Rows covarianceTimes(const Rows& q) const {
    Rows out(q.size(), std::vector<float>(n_, 0.0F));
    for (std::size_t k = 0; k < count(); ++k) {
      for (std::size_t j = 0; j < q.size(); ++j) {
        const float c = dot(row(k), q[j].data(), n_);
        for (std::size_t i = 0; i < n_; ++i) out[j][i] += c * row(k)[i];
      }
    }
    return out;
  }

 private:
  std::size_t n_;
  std::vector<float> rows_;
};

/// Turns an orthonormal basis so that its rows are by falling variance.
void sortByVariance(const Centred& x, std::size_t dimension, Rows& q, Components& out) {
  const Rows cq = x.covarianceTimes(q);
  std::vector<std::vector<double>> small(q.size(), std::vector<double>(q.size()));
  for (std::size_t i = 0; i < q.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      small[i][j] = static_cast<double>(dot(q[i].data(), cq[j].data(), dimension));
    }
  }
  for (std::size_t i = 0; i < q.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) small[i][j] = small[j][i];
  }
  const auto turn = jacobi(small);
  std::vector<std::size_t> order(q.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return small[a][a] > small[b][b]; });
  for (const std::size_t column : order) {
    out.variances.push_back(std::max(0.0, small[column][column]));
    for (std::size_t i = 0; i < dimension; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < q.size(); ++j)
        sum += turn[j][column] * static_cast<double>(q[j][i]);
      out.rows.push_back(static_cast<float>(sum));
    }
  }
}

}  // namespace

float dot(const float* a, const float* b, std::size_t n) {
  std::array<float, 8> sums{};
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8) {
    for (std::size_t k = 0; k < 8; ++k) sums[k] += a[i + k] * b[i + k];
  }
  float sum = 0.0F;
  for (; i < n; ++i) sum += a[i] * b[i];
  for (const float s : sums) sum += s;
  return sum;
}

Components principalComponents(std::span<const float> vectors, std::size_t dimension,
                               std::span<const std::uint32_t> members, std::size_t rank) {
  assert(!members.empty());
  Components out;
  const Centred x(vectors, dimension, members, out.mean);
  for (std::size_t k = 0; k < x.count(); ++k) {
    out.total += static_cast<double>(dot(x.row(k), x.row(k), dimension));
  }
  const std::size_t most = std::min({rank + kSpareRows, dimension, x.count()});
  // Members themselves span what is looked for: those at even distances.
  Rows q;
  Rng rng(members.size());
  for (std::size_t j = 0; j < most; ++j) {
    const float* row = x.row(j * x.count() / most);
    q.emplace_back(row, row + dimension);
    for (float& value : q.back()) value += 1.0e-4F * (rng.uniform() - 0.5F);
  }
  orthonormalise(q);
  for (int step = 0; step < kSteps && out.total > 0.0; ++step) {
    q = x.covarianceTimes(q);
    orthonormalise(q);
  }
  if (out.total > 0.0 && !q.empty()) sortByVariance(x, dimension, q, out);
  const std::size_t kept = std::min(rank, out.variances.size());
  out.variances.resize(kept);
  out.rows.resize(kept * dimension);
  return out;
}

}  // namespace soffit::glossy
