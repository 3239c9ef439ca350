// SPDX-License-Identifier: MIT
#include "core/daylight/open_sky.h"

#include "core/base/parallel.h"
#include "core/daylight/hemisphere_cells.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <utility>

namespace soffit::daylight {
namespace {

constexpr float kPiF = 3.14159265358979F;
constexpr float kShares = 2047.0F;
/// Sub-directions of a leaf are about so many to the square's side: 1.4 degrees apart.
constexpr int kFineLook = 64;

}  // namespace

OpenSky::OpenSky(std::span<const vec3> positions, std::span<const vec3> normals,
                 const geometry::RayCaster& opaque, const Panes* panes, const LookOptions& options,
                 const Job& job)
    : normals_(normals.begin(), normals.end()) {
  look_.coarse = options.coarse;
  assert(options.coarse % 4 == 0 && options.coarse << options.levels <= 512);
  const std::vector<PaneSeed> seeds = paneSeeds(panes);
  constexpr std::size_t kChunk = 128;
  struct Part {
    std::vector<std::uint32_t> leaves, count;
    std::uint64_t rays = 0;
  };
  std::vector<Part> parts((positions.size() + kChunk - 1) / kChunk);
  std::atomic<std::size_t> done{0};
  parallelFor(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    HemisphereCells cells(opaque, panes, options);
    for (std::size_t p = begin; p < end; ++p) {
      Part& part = parts[p];
      const std::size_t last = std::min(positions.size(), (p + 1) * kChunk);
      for (std::size_t i = p * kChunk; i < last; ++i) {
        const std::size_t before = part.leaves.size();
        if (!job.cancelled() && normals[i] != vec3(0.0F)) {
          cells.look(positions[i], normals[i], seeds, options.seed * 0x9e3779b97f4a7c15ULL + i);
          cells.forEachOpenLeaf([&](int level, int x, int y, float share) {
            const auto quantum =
                static_cast<std::uint32_t>(std::lround(std::min(share, 1.0F) * kShares));
            if (quantum == 0) return;
            part.leaves.push_back(static_cast<std::uint32_t>(x) |
                                  static_cast<std::uint32_t>(y) << 9U |
                                  static_cast<std::uint32_t>(level) << 18U | quantum << 21U);
          });
        }
        part.count.push_back(static_cast<std::uint32_t>(part.leaves.size() - before));
      }
      part.rays = cells.takeRays();
      job.report("looking for the sky",
                 static_cast<double>(++done) / static_cast<double>(parts.size()));
    }
  });
  look_.first.push_back(0);
  for (const Part& part : parts) {
    look_.leaves.insert(look_.leaves.end(), part.leaves.begin(), part.leaves.end());
    for (const std::uint32_t n : part.count) look_.first.push_back(look_.first.back() + n);
    rays_ += part.rays;
  }
}

std::optional<OpenSky> OpenSky::restored(std::span<const vec3> normals, Look look) {
  if (look.first.size() != normals.size() + 1 || look.first.front() != 0 ||
      look.first.back() != look.leaves.size() || look.coarse < 4 || look.coarse > 512 ||
      !std::is_sorted(look.first.begin(), look.first.end())) {
    return std::nullopt;
  }
  OpenSky sky;
  sky.normals_.assign(normals.begin(), normals.end());
  sky.look_ = std::move(look);
  return sky;
}

OpenSky::Leaf OpenSky::unpack(std::uint32_t leaf) const {
  const std::uint32_t level = leaf >> 18U & 7U;
  const float size = 1.0F / static_cast<float>(look_.coarse << level);
  return {static_cast<float>(leaf & 511U) * size, static_cast<float>(leaf >> 9U & 511U) * size,
          size, kPiF * size * size * static_cast<float>(leaf >> 21U) / kShares};
}

std::vector<vec3> OpenSky::illuminance(const Environment& environment, const Job& job) const {
  std::vector<vec3> out(size(), vec3(0.0F));
  std::atomic<std::size_t> done{0};
  constexpr std::size_t kGrain = 64;
  parallelFor(size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    for (std::size_t i = begin; i < end; ++i) {
      dvec3 sum(0.0);
      forEachDirection(i, kFineLook, [&](const vec3& d, float weight) {
        sum += static_cast<double>(weight) * environment.smoothRadiance(dvec3(d));
      });
      out[i] = vec3(sum);
    }
    const std::size_t part = ++done;
    if (part % 16 == 0) {
      job.report("light from outside",
                 static_cast<double>(part * kGrain) / static_cast<double>(size() + kGrain));
    }
  });
  return out;
}

}  // namespace soffit::daylight
