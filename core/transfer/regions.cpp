// SPDX-License-Identifier: MIT
#include "core/transfer/regions.h"

#include "core/base/parallel.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace soffit::transfer {
namespace {

constexpr std::uint32_t kLeastCells = 16;

/// Disjoint sets; the smaller index is the root, so the result does not depend on the order.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// What a few rays from each texel tell.
struct Outlook {
  /// 0 in a gap (most rays end within a third of a cell), 1 in a hollow (within about a cell), 2 in
  /// the open. The light in a gap has little to do with the light beside it, and must not share
  /// patches and weights with it.
  std::vector<std::uint8_t> openness;
  /// The space that a texel lies in: texels that see each other, directly or by way of others,
  /// share one. What is sealed from the room (the hollow of a door, a box) must get exactly none of
  /// its light. kNoTexel where the texel cannot tell.
  std::vector<std::uint32_t> space;
  /// How dark: 0 about as bright as most, and one more for each octave below.
  std::vector<std::uint8_t> dusk;
};

constexpr std::size_t kRays = 16;

/// Classes of brightness by a glow: light of distance times a constant along each ray, up to 15
/// cells, and what half-grey surfaces reflect of it. `seen`: kRays per texel.
std::vector<std::uint8_t> dusk(std::span<const float> glow, std::span<const std::uint32_t> seen) {
  constexpr int kBounces = 6;
  constexpr std::uint8_t kDarkest = 4;
  std::vector<float> light(glow.begin(), glow.end());
  for (int bounce = 0; bounce < kBounces; ++bounce) {
    std::vector<float> next(glow.begin(), glow.end());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i] != kNoTexel) next[i / kRays] += 0.5F * light[seen[i]] / static_cast<float>(kRays);
    }
    light.swap(next);
  }
  std::vector<float> sorted = light;
  const auto usual = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 7 / 10);
  std::nth_element(sorted.begin(), usual, sorted.end());
  std::vector<std::uint8_t> out(light.size(), 0);
  for (std::size_t i = 0; i < light.size(); ++i) {
    for (float edge = 0.5F * *usual; out[i] < kDarkest && light[i] < edge; edge *= 0.5F) ++out[i];
  }
  return out;
}

/// The spaces of Outlook. seen: kRays per texel. buried: how many of them met the inside of a
/// solid.
std::vector<std::uint32_t> spacesOf(std::span<const std::uint32_t> seen,
                                    std::span<const std::uint8_t> buried) {
  // A point that sees the inside of a solid lies in it, and one that sees next to nothing may lie
  // on the far side of the building: neither joins what is parted by it.
  std::vector<std::uint8_t> tells(buried.size(), 0);
  for (std::size_t i = 0; i < tells.size(); ++i) {
    const auto own = seen.subspan(i * kRays, kRays);
    const auto found =
        kRays - static_cast<std::size_t>(std::count(own.begin(), own.end(), kNoTexel));
    tells[i] = 10 * buried[i] <= kRays && 4 * found > kRays ? 1 : 0;
  }
  Sets sets(buried.size());
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (seen[k] == kNoTexel || tells[k / kRays] == 0 || tells[seen[k]] == 0) continue;
    sets.join(static_cast<std::uint32_t>(k / kRays), seen[k]);
  }
  std::vector<std::uint32_t> out(buried.size(), kNoTexel);
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    if (tells[i] != 0) out[i] = sets.find(i);
  }
  return out;
}

Outlook lookAround(const Texels& texels, std::span<const vec3> positions,
                   std::span<const vec3> normals, const geometry::RayCaster* caster) {
  Outlook out{std::vector<std::uint8_t>(positions.size(), 2),
              std::vector<std::uint32_t>(positions.size(), kNoTexel),
              std::vector<std::uint8_t>(positions.size(), 0)};
  if (caster == nullptr) return out;
  const auto cell = static_cast<float>(texels.cell);
  const float reach = 15.0F * cell;  // m; some 3
  std::vector<std::uint32_t> seen(positions.size() * kRays, kNoTexel);
  std::vector<float> glow(positions.size(), 0.0F);
  std::vector<std::uint8_t> buried(positions.size(), 0);
  parallelFor(positions.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::vector<geometry::Ray> rays;
    for (std::size_t i = begin; i < end; ++i) {
      vec3 t;
      vec3 b;
      orthonormalBasis(normals[i], t, b);
      for (std::size_t k = 0; k < kRays; ++k) {
        const vec3 d = cosineHemisphere((static_cast<float>(k % 4) + 0.5F) / 4.0F,
                                        (static_cast<float>(k / 4) + 0.5F) / 4.0F);
        rays.push_back({geometry::offsetOrigin(positions[i], normals[i]), 0.0F,
                        d.x * t + d.y * b + d.z * normals[i]});
      }
    }
    std::vector<geometry::Hit> hits(rays.size());
    caster->closest(rays, hits);
    for (std::size_t i = begin; i < end; ++i) {
      std::array<float, kRays> length{};
      for (std::size_t k = 0; k < kRays; ++k) {
        const std::size_t at = (i - begin) * kRays + k;
        length[k] = hits[at].t;
        glow[i] +=
            std::min(hits[at].valid() ? hits[at].t : reach, reach) / static_cast<float>(kRays);
        if (!hits[at].valid()) continue;
        const Chart& chart = texels.charts.charts[texels.charts.chart_of[hits[at].triangle]];
        const bool front = glm::dot(chart.normal, rays[at].direction) < 0.0F;
        seen[i * kRays + k] =
            texels.at(hits[at].triangle, front, rays[at].origin + hits[at].t * rays[at].direction);
        if (seen[i * kRays + k] == kNoTexel) ++buried[i];
      }
      std::nth_element(length.begin(), length.begin() + kRays / 2, length.end());
      const float median = length[kRays / 2];
      out.openness[i] = median < static_cast<float>(Texels::kGapShare) * cell
                            ? 0
                            : (median < 0.9F * cell ? 1 : 2);
    }
  });
  out.dusk = dusk(glow, seen);
  out.space = spacesOf(seen, buried);
  return out;
}

using Pair = std::array<std::uint32_t, 2>;

/// Texels that share an edge with nothing on it; some pairs come more than once.
std::vector<Pair> openPairs(const Texels& texels, std::span<const std::uint8_t> open) {
  std::vector<Pair> pairs;
  for (std::size_t c = 0; c < texels.charts.charts.size(); ++c) {
    const Chart& chart = texels.charts.charts[c];
    if (!chart.planar || chart.sides == kNoSide) continue;
    const Texels::Grid& grid = texels.grids[c];
    const auto per_side = static_cast<std::size_t>(grid.nu) * static_cast<std::size_t>(grid.nv);
    const auto nu = static_cast<std::size_t>(grid.nu);
    const std::size_t end = grid.first + (chart.sides == kBothSides ? 2 : 1) * per_side;
    for (std::size_t i = grid.first; i < end; ++i) {
      for (const auto& [bit, step] : {std::pair{1U, std::size_t{1}}, {2U, nu}}) {
        if ((open[i] & bit) == 0) continue;
        const Pair pair{texels.cells[i], texels.cells[i + step]};
        if (pair[0] == pair[1] || pair[0] == kNoTexel || pair[1] == kNoTexel) continue;
        if (pairs.empty() || pairs.back() != pair) pairs.push_back(pair);
      }
    }
  }
  return pairs;
}

/// Texels that cannot tell their space lie in that of their neighbours.
void spreadSpaces(std::span<const Pair> pairs, std::vector<std::uint32_t>& space) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : pairs) {
      if ((space[a] == kNoTexel) == (space[b] == kNoTexel)) continue;
      space[a] = space[b] = space[a] == kNoTexel ? space[b] : space[a];
      changed = true;
    }
  }
}

bool alike(const Outlook& outlook, std::uint32_t a, std::uint32_t b) {
  return outlook.openness[a] == outlook.openness[b] && outlook.dusk[a] == outlook.dusk[b];
}

}  // namespace

Regions findRegions(const Texels& texels, std::span<const std::uint8_t> open,
                    std::span<const vec3> positions, std::span<const vec3> normals,
                    const geometry::RayCaster* caster) {
  Outlook outlook = lookAround(texels, positions, normals, caster);
  Sets sets(positions.size());
  Sets parts(positions.size());
  const auto pairs = openPairs(texels, open);
  spreadSpaces(pairs, outlook.space);
  for (const auto& [a, b] : pairs) {
    if (outlook.space[a] != outlook.space[b]) continue;
    parts.join(a, b);
    if (alike(outlook, a, b)) sets.join(a, b);
  }
  std::vector<std::uint32_t> count(positions.size(), 0);
  for (std::uint32_t i = 0; i < positions.size(); ++i) ++count[sets.find(i)];
  // Small parts go together by what they have in common, and so do small sealed spaces (there are
  // thousands where furniture stands on furniture); regions are numbered as they come up.
  std::vector<std::uint32_t> held(positions.size(), 0);
  for (const std::uint32_t space : outlook.space) {
    if (space != kNoTexel) ++held[space];
  }
  std::map<std::array<std::uint32_t, 4>, std::uint32_t> numbers;
  std::vector<std::uint32_t> region(positions.size(), 0);
  std::vector<std::uint32_t> part(positions.size(), 0);
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const std::uint32_t root = sets.find(i);
    const bool large = count[root] >= kLeastCells;
    const std::uint32_t space = outlook.space[i];
    const std::array<std::uint32_t, 4> key = {
        large ? root : kNoTexel, outlook.openness[i], outlook.dusk[i],
        space != kNoTexel && held[space] >= 4 * kLeastCells ? space : kNoTexel};
    part[i] = parts.find(i);
    region[i] = numbers.try_emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
  }
  return {std::move(region), std::move(part), std::move(outlook.openness)};
}

}  // namespace soffit::transfer
