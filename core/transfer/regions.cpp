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
  /// Texels that see each other, directly or by way of others: what is sealed from the room (the
  /// hollow of a door, a box) must get exactly none of its light.
  Sets sealed;
  /// How dark: 0 about as bright as most, and one more for each octave below.
  std::vector<std::uint8_t> dusk;
};

constexpr std::size_t kRays = 16;

/// Classes of brightness by a glow: light of distance times a constant along each ray, up to 15 cells,
/// and what half-grey surfaces reflect of it. `seen`: kRays per texel.
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

Outlook lookAround(const Texels& texels, std::span<const vec3> positions,
                   std::span<const vec3> normals, const geometry::RayCaster* caster) {
  Outlook out{std::vector<std::uint8_t>(positions.size(), 2), Sets(positions.size()),
              std::vector<std::uint8_t>(positions.size(), 0)};
  if (caster == nullptr) {
    for (std::uint32_t i = 1; i < positions.size(); ++i) out.sealed.join(0, i);
    return out;
  }
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
  // A point that sees the inside of a solid lies in it, and one that sees next to nothing lies on the
  // far side of the building: neither joins what is parted by it.
  const auto counts = [&](std::size_t texel) {
    std::size_t found = 0;
    for (std::size_t k = 0; k < kRays; ++k) found += seen[texel * kRays + k] != kNoTexel ? 1 : 0;
    return 10 * buried[texel] <= kRays && 4 * found > kRays;
  };
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] == kNoTexel || !counts(i / kRays) || !counts(seen[i])) continue;
    out.sealed.join(static_cast<std::uint32_t>(i / kRays), seen[i]);
  }
  return out;
}

/// Whether light may be interpolated between neighbours that nothing stands between.
bool connected(Outlook& outlook, std::uint32_t a, std::uint32_t b) {
  return (outlook.openness[a] == 0) == (outlook.openness[b] == 0) &&
         outlook.sealed.find(a) == outlook.sealed.find(b);
}

bool alike(const Outlook& outlook, std::uint32_t a, std::uint32_t b) {
  return outlook.openness[a] == outlook.openness[b] && outlook.dusk[a] == outlook.dusk[b];
}

}  // namespace

Regions findRegions(const Texels& texels, std::span<const vec3> positions,
                    std::span<const vec3> normals, const geometry::RayCaster* caster) {
  Outlook outlook = lookAround(texels, positions, normals, caster);
  Sets sets(positions.size());
  Sets parts(positions.size());
  std::vector<std::array<std::uint32_t, 2>> pairs;
  std::vector<geometry::Ray> rays;
  for (std::size_t c = 0; c < texels.charts.charts.size(); ++c) {
    const Chart& chart = texels.charts.charts[c];
    if (!chart.planar || chart.sides == kNoSide) continue;
    const Texels::Grid& grid = texels.grids[c];
    const auto per_side = static_cast<std::uint32_t>(grid.nu * grid.nv);
    const std::uint32_t sides = (chart.sides & kFront) != 0 && (chart.sides & kBack) != 0 ? 2U : 1U;
    const float lift = 0.15F * static_cast<float>(texels.cell);
    for (std::uint32_t side = 0; side < sides; ++side) {
      const std::uint32_t* cells = &texels.cells[grid.first + side * per_side];
      for (int j = 0; j < grid.nv; ++j) {
        for (int i = 0; i < grid.nu; ++i) {
          const std::uint32_t a = cells[j * grid.nu + i];
          if (a == kNoTexel) continue;
          for (const auto& [di, dj] : {std::pair{1, 0}, {0, 1}}) {
            if (i + di >= grid.nu || j + dj >= grid.nv) continue;
            const std::uint32_t b = cells[(j + dj) * grid.nu + i + di];
            if (b == kNoTexel || a == b || !connected(outlook, a, b)) continue;
            if (!pairs.empty() && pairs.back() == std::array{a, b}) continue;
            pairs.push_back({a, b});
            const vec3 from = positions[a] + lift * normals[a];
            rays.push_back({from, 0.0F, positions[b] + lift * normals[b] - from, 1.0F});
          }
        }
      }
    }
  }
  std::vector<std::uint8_t> blocked(rays.size(), 0);
  if (caster != nullptr) caster->occluded(rays, blocked);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (blocked[k] != 0) continue;
    parts.join(pairs[k][0], pairs[k][1]);
    if (alike(outlook, pairs[k][0], pairs[k][1])) sets.join(pairs[k][0], pairs[k][1]);
  }
  std::vector<std::uint32_t> count(positions.size(), 0);
  for (std::uint32_t i = 0; i < positions.size(); ++i) ++count[sets.find(i)];
  // Small parts go together by what they have in common, and so do small sealed spaces (there are
  // thousands where furniture stands on furniture); regions are numbered as they come up.
  std::vector<std::uint32_t> sealed_count(positions.size(), 0);
  for (std::uint32_t i = 0; i < positions.size(); ++i) ++sealed_count[outlook.sealed.find(i)];
  std::map<std::array<std::uint32_t, 4>, std::uint32_t> numbers;
  std::vector<std::uint32_t> region(positions.size(), 0);
  std::vector<std::uint32_t> part(positions.size(), 0);
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const std::uint32_t root = sets.find(i);
    const bool large = count[root] >= kLeastCells;
    const std::uint32_t space = outlook.sealed.find(i);
    const std::array<std::uint32_t, 4> key = {
        large ? root : kNoTexel, outlook.openness[i], outlook.dusk[i],
        sealed_count[space] >= 4 * kLeastCells ? space : kNoTexel};
    part[i] = parts.find(i);
    region[i] = numbers.try_emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
  }
  return {std::move(region), std::move(part), std::move(outlook.openness)};
}

}  // namespace soffit::transfer
