// SPDX-License-Identifier: MIT
#include "core/prt/bounces.h"

#include "core/base/parallel.h"
#include "core/prt/bounce_taps.h"
#include "core/prt/direct_transfer.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <utility>

namespace soffit::prt {
namespace {

constexpr std::size_t kGrain = 32;

Error cancelled() {
  return {"transfer", "cancelled", ""};
}

/// One channel's rows repeated for three.
TransferRows widened(const TransferRows& rows, std::size_t channels) {
  if (rows.channels() == channels) return rows;
  TransferRows wide(rows.size(), rows.bands(), channels);
  const std::size_t n = rows.coefficients();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t c = 0; c < channels; ++c) {
      for (std::size_t k = 0; k < n; ++k) wide.row(i)[c * n + k] = rows.row(i)[k];
    }
  }
  return wide;
}

/// What receivers send out: their reflectance times what they receive.
TransferRows reflected(const Receivers& receivers, const TransferRows& received) {
  TransferRows out = received;
  const std::size_t n = out.coefficients();
  parallelFor(out.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::span<float> row = out.row(i);
      for (std::size_t c = 0; c < out.channels(); ++c) {
        const float rho = receivers.reflectance[i][static_cast<int>(c)];
        for (std::size_t k = 0; k < n; ++k) row[c * n + k] *= rho;
      }
    }
  });
  return out;
}

/// RMS length of the rows, channels averaged, weighted by area.
double energyOf(const Receivers& receivers, const TransferRows& rows) {
  double squares = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double sum = 0.0;
    for (const float v : rows.row(i)) sum += double{v} * v;
    squares += double{receivers.areas[i]} * sum / static_cast<double>(rows.channels());
    area += double{receivers.areas[i]};
  }
  return area > 0.0 ? std::sqrt(squares / area) : 0.0;
}

/// Gathers pass after pass; keeps what the first one's rays found while there is room.
class Passes {
 public:
  Passes(const Surfaces& surfaces, const ReceiverSet& set, const Directions& directions,
         const VisibilityFlags& flags, std::uint64_t keep_bytes)
      : surfaces_(surfaces),
        set_(set),
        directions_(directions),
        flags_(flags),
        room_(keep_bytes),
        kept_(set.receivers().size()) {}

  /// One bounce of what is sent out.
  TransferRows gather(const TransferRows& sent, const Job& job) {
    const Receivers& r = set_.receivers();
    TransferRows received(r.size(), sent.bands(), sent.channels());
    std::atomic<std::uint64_t> rays{0};
    // Merged in the first pass whether there is room or not: no sum depends on the threads.
    const auto list =
        std::exchange(first_, false) ? BounceTaps::List::merged : BounceTaps::List::all;
    parallelFor(r.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      BounceTaps finder(surfaces_, set_, directions_);
      for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
        if (!r.standsForItself(i)) continue;
        const std::vector<Tap>& taps = keeping_ ? kept_[i] : finder.find(r, flags_, i, list);
        addRows(sent.data(), sent.stride(), taps, received.row(i).data());
        if (!keeping_ && !full_) keep(i, taps);
      }
      rays += finder.rays();
    });
    rays_ = rays;
    if (full_) kept_.clear();
    keeping_ = !full_;
    copyFromSources(r, received);
    return received;
  }
  [[nodiscard]] std::uint64_t rays() const { return rays_; }
  [[nodiscard]] std::uint64_t keptBytes() const { return keeping_ ? kept_bytes_.load() : 0; }

 private:
  void keep(std::size_t i, const std::vector<Tap>& taps) {
    const std::uint64_t bytes = taps.size() * sizeof(Tap) + sizeof(std::vector<Tap>);
    if (kept_bytes_.fetch_add(bytes) + bytes > room_) {
      full_ = true;
      return;
    }
    kept_[i] = taps;
  }

  const Surfaces& surfaces_;
  const ReceiverSet& set_;
  const Directions& directions_;
  const VisibilityFlags& flags_;
  std::uint64_t room_;
  std::vector<std::vector<Tap>> kept_;
  std::atomic<std::uint64_t> kept_bytes_{0};
  std::atomic<bool> full_{false};
  bool keeping_ = false;
  bool first_ = true;
  std::uint64_t rays_ = 0;
};

void add(const TransferRows& more, TransferRows& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const std::span<const float> from = more.row(i);
    const std::span<float> to = sum.row(i);
    for (std::size_t c = 0; c < to.size(); ++c) to[c] += from[c];
  }
}

}  // namespace

Result<BouncedTransfer> addBounces(const Surfaces& surfaces, const ReceiverSet& set,
                                   const Directions& directions, const VisibilityFlags& flags,
                                   const TransferRows& direct, const BounceOptions& options,
                                   const Job& job) {
  const Receivers& r = set.receivers();
  assert(direct.size() == r.size() && direct.channels() == 1);
  BouncedTransfer out;
  TransferRows latest = widened(direct, r.grey() ? 1 : 3);
  out.transfer = latest;
  out.passes.push_back({energyOf(r, latest), 0});
  const double enough = options.threshold * out.passes[0].energy;
  Passes passes(surfaces, set, directions, flags, options.keep_bytes);
  out.converged = out.passes[0].energy == 0.0;
  for (int k = 1; k <= options.most_passes && !out.converged; ++k) {
    latest = passes.gather(reflected(r, latest), job);
    if (job.cancelled()) return cancelled();
    add(latest, out.transfer);
    out.passes.push_back({energyOf(r, latest), passes.rays()});
    out.rays += passes.rays();
    const double share = out.passes.back().energy / out.passes[0].energy;
    out.converged = out.passes.back().energy <= enough;
    // The share falls evenly on a logarithmic scale from 1 to the threshold.
    const double done = out.converged ? 1.0 : std::log(share) / std::log(options.threshold);
    job.report(fmt::format("bounce {}: {:.2g} of the direct light", k, share),
               std::clamp(done, 0.0, 1.0));
  }
  out.kept_bytes = passes.keptBytes();
  return out;
}

Result<GatheredBounce> gatherBounce(const Surfaces& surfaces, const ReceiverSet& from,
                                    const TransferRows& solved, const Receivers& to,
                                    const Directions& directions, const VisibilityFlags& flags,
                                    const TransferRows& direct, const Job& job) {
  assert(solved.bands() == direct.bands() && solved.size() == from.receivers().size());
  const TransferRows sent = reflected(from.receivers(), solved);
  GatheredBounce out{widened(direct, solved.channels()), 0};
  std::atomic<std::uint64_t> rays{0};
  std::atomic<std::size_t> done{0};
  parallelFor(to.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    BounceTaps finder(surfaces, from, directions);
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      if (!to.standsForItself(i)) continue;
      addRows(sent.data(), sent.stride(), finder.find(to, flags, i, BounceTaps::List::one_per_ray),
              out.transfer.row(i).data());
    }
    rays += finder.rays();
    const std::size_t before = done.fetch_add(end - begin);
    if (100 * before / to.size() != 100 * (before + end - begin) / to.size()) {
      job.report("last bounce",
                 static_cast<double>(before + end - begin) / static_cast<double>(to.size()));
    }
  });
  if (job.cancelled()) return cancelled();
  copyFromSources(to, out.transfer);
  out.rays = rays;
  return out;
}

}  // namespace soffit::prt
