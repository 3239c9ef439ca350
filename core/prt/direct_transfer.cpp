// SPDX-License-Identifier: MIT
#include "core/prt/direct_transfer.h"

#include "core/base/parallel.h"
#include "core/sh/basis.h"
#include "core/sh/zonal.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace soffit::prt {
namespace {

constexpr std::size_t kGrain = 64;

/// A_l y_lm(n).
void cosineAbout(const vec3& n, int bands, std::span<const double> kernel, float* out) {
  std::array<double, sh::kMaxCoefficients> basis;
  sh::evaluate(glm::normalize(dvec3(n)), bands, basis);
  for (int l = 0; l < bands; ++l) {
    for (int m = -l; m <= l; ++m) {
      const std::size_t i = sh::index(l, m);
      out[i] = static_cast<float>(kernel[static_cast<std::size_t>(l)] * basis[i]);
    }
  }
}

/// The directions' own sum over a whole hemisphere, and what it misses. Neighbouring receivers
/// mostly share their normal, so it is made anew only where that changes.
class Hemisphere {
 public:
  Hemisphere(const Directions& directions, std::span<const double> kernel)
      : directions_(directions), kernel_(kernel), missed_(directions.rowStride(), 0.0F) {}

  void turnTo(const vec3& n) {
    if (known_ && n == normal_) return;
    known_ = true;
    normal_ = n;
    all_.clear();
    cosine_sum_ = 0.0;
    for (std::uint32_t d = 0; d < directions_.size(); ++d) {
      const float cosine = glm::dot(directions_[d], n);
      if (cosine <= 0.0F) continue;
      all_.push_back({d, cosine});
      cosine_sum_ += double{cosine} * directions_.weight(d);
    }
    std::vector<float> sum(directions_.rowStride(), 0.0F);
    addRows(directions_.table(), directions_.rowStride(), all_, sum.data());
    std::fill(missed_.begin(), missed_.end(), 0.0F);
    cosineAbout(n, directions_.bands(), kernel_, missed_.data());
    for (std::size_t c = 0; c < sum.size(); ++c) missed_[c] -= sum[c];
  }

  [[nodiscard]] std::span<const Tap> all() const { return all_; }
  [[nodiscard]] double cosineSum() const { return cosine_sum_; }
  [[nodiscard]] std::span<const float> missed() const { return missed_; }

 private:
  const Directions& directions_;
  std::span<const double> kernel_;
  bool known_ = false;
  vec3 normal_{0.0F};
  std::vector<Tap> all_;  ///< direction, cosine
  double cosine_sum_ = 0.0;
  std::vector<float> missed_;
};

/// Directions that light comes from, with cosine and share; their part of the cosine's integral.
double openOf(const Receivers& r, std::size_t i, const Directions& directions,
              const VisibilityFlags& flags, const Hemisphere& hemisphere, std::vector<Tap>& open) {
  open.clear();
  double sum = 0.0;
  const auto dimmed = flags.dimmed(i);
  auto next = dimmed.begin();
  const bool tilted = r.normals[i] != r.facing[i];
  for (const Tap& t : hemisphere.all()) {
    while (next != dimmed.end() && next->direction < t.receiver) ++next;
    if (flags.blocked(i, t.receiver)) continue;
    if (tilted && glm::dot(directions[t.receiver], r.facing[i]) <= 0.0F) continue;
    Tap tap = t;
    if (next != dimmed.end() && next->direction == t.receiver) tap.weight *= next->share;
    open.push_back(tap);
    sum += double{tap.weight} * directions.weight(t.receiver);
  }
  return sum;
}

}  // namespace

TransferRows unshadowedTransfer(const Receivers& receivers, int bands) {
  TransferRows rows(receivers.size(), bands, 1);
  const sh::Kernel kernel = sh::clampedCosineKernel(bands);
  parallelFor(receivers.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      cosineAbout(receivers.normals[i], bands, kernel, rows.row(i).data());
    }
  });
  return rows;
}

Result<TransferRows> shadowedTransfer(const Receivers& receivers, const Directions& directions,
                                      const VisibilityFlags& flags,
                                      std::span<const std::uint8_t> redo, TransferRows before,
                                      const Job& job) {
  assert(flags.receivers() == receivers.size() && flags.directions() == directions.size());
  TransferRows rows = std::move(before);
  const sh::Kernel kernel = sh::clampedCosineKernel(directions.bands());
  parallelFor(receivers.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Hemisphere hemisphere(directions, kernel);
    std::vector<Tap> open;
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      if (!receivers.standsForItself(i) || (!redo.empty() && redo[i] == 0)) continue;
      hemisphere.turnTo(receivers.normals[i]);
      const double sum = openOf(receivers, i, directions, flags, hemisphere, open);
      const std::span<float> row = rows.row(i);
      std::fill(row.begin(), row.end(), 0.0F);
      addRows(directions.table(), directions.rowStride(), open, row.data());
      const auto share = static_cast<float>(sum / hemisphere.cosineSum());
      for (std::size_t c = 0; c < directions.coefficients(); ++c) {
        row[c] += share * hemisphere.missed()[c];
      }
    }
  });
  if (job.cancelled()) return Error{"transfer", "cancelled", ""};
  copyFromSources(receivers, rows);
  return rows;
}

Result<TransferRows> shadowedTransfer(const Receivers& receivers, const Directions& directions,
                                      const VisibilityFlags& flags, const Job& job) {
  return shadowedTransfer(receivers, directions, flags, {},
                          TransferRows(receivers.size(), directions.bands(), 1), job);
}

void copyFromSources(const Receivers& receivers, TransferRows& rows) {
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    if (receivers.standsForItself(i)) continue;
    const std::span<float> to = rows.row(i);
    const std::span<const float> from = rows.row(receivers.sourceOf(i));
    std::copy(from.begin(), from.end(), to.begin());
  }
}

}  // namespace soffit::prt
