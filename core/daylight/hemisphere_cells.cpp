// SPDX-License-Identifier: MIT
#include "core/daylight/hemisphere_cells.h"

#include "core/daylight/open_sky.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace soffit::daylight {

std::vector<PaneSeed> paneSeeds(const Panes* panes) {
  std::vector<PaneSeed> seeds;
  if (panes == nullptr) return seeds;
  constexpr std::size_t kMost = 128;
  const auto all = panes->triangles();
  const std::size_t step = std::max<std::size_t>(1, (all.size() + kMost - 1) / kMost);
  for (std::size_t i = 0; i < all.size(); i += step) {
    seeds.push_back({panes->center(all[i]), panes->normal(all[i]), panes->area(all[i])});
  }
  return seeds;
}

vec2 hemispherePlace(const vec3& d) {
  constexpr float kQuarter = 0.785398163397448F;
  const float r = std::sqrt(d.x * d.x + d.y * d.y);
  float phi = std::atan2(d.y, d.x);
  if (phi < -kQuarter) phi += 8.0F * kQuarter;  // to [-pi/4, 7 pi/4)
  vec2 square(0.0F);
  if (phi < kQuarter) {
    square = {r, r * phi / kQuarter};
  } else if (phi < 3.0F * kQuarter) {
    square = {r * (2.0F * kQuarter - phi) / kQuarter, r};
  } else if (phi < 5.0F * kQuarter) {
    square = {-r, r * (4.0F * kQuarter - phi) / kQuarter};
  } else {
    square = {r * (phi - 6.0F * kQuarter) / kQuarter, -r};
  }
  return glm::clamp(0.5F * square + 0.5F, 0.0F, 0.99999994F);
}

HemisphereCells::HemisphereCells(const geometry::RayCaster& opaque, const Panes* panes,
                                 const LookOptions& options)
    : opaque_(opaque), panes_(panes), levels_(std::clamp(options.levels, 0, kMostLevels - 1)) {
  for (int level = 0; level <= levels_; ++level) {
    Grid& g = grids_[static_cast<std::size_t>(level)];
    g.side = options.coarse << level;
    const auto cells = static_cast<std::size_t>(g.side) * static_cast<std::size_t>(g.side);
    g.open.assign(cells, 0);
    g.cut.assign(cells, 0);
    g.own.assign(cells, level == 0 ? 1 : 0);
  }
}

void HemisphereCells::findWanted(const vec3& p, const vec3& n, std::span<const PaneSeed> seeds) {
  vec3 t;
  vec3 b;
  orthonormalBasis(n, t, b);
  wanted_.clear();
  rays_of_.clear();
  const auto side = static_cast<float>(grids_[0].side);
  const auto finest = static_cast<float>(grids_[static_cast<std::size_t>(levels_)].side);
  for (const PaneSeed& seed : seeds) {
    const vec3 to = seed.center - p;
    const float height = glm::dot(to, n);
    const float squared = glm::dot(to, to);
    if (!(height > 0.0F) || !(squared > 0.0F)) continue;
    // Its share of the square: what is larger than a few cells is met anyway.
    const float share = seed.area * height * std::abs(glm::dot(to, seed.normal)) /
                        (3.14159265F * squared * squared);
    if (share > 4.0F / (side * side) || share < 4.0F / (finest * finest)) continue;
    wanted_.push_back(
        hemispherePlace(vec3(glm::dot(to, t), glm::dot(to, b), height) / std::sqrt(squared)));
    rays_of_.push_back({geometry::offsetOrigin(p, n), 0.0F, to, 0.999F});
  }
  blocked_.resize(rays_of_.size());
  opaque_.occluded(rays_of_, blocked_);
  rays_ += rays_of_.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (blocked_[i] == 0) wanted_[kept++] = wanted_[i];
  }
  wanted_.resize(kept);
}

void HemisphereCells::look(const vec3& p, const vec3& n, std::span<const PaneSeed> seeds,
                           std::uint64_t seed) {
  findWanted(p, n, seeds);
  Grid& first = grids_[0];
  first.traced.clear();
  // In blocks of 4 x 4: packets of neighbouring directions.
  for (int k = 0; k < first.side * first.side; ++k) {
    const int block = k / 16;
    const int blocks = first.side / 4;
    const int x = block % blocks * 4 + k % 4;
    const int y = block / blocks * 4 + k % 16 / 4;
    first.traced.push_back(static_cast<std::uint32_t>(y * first.side + x));
  }
  trace(first, 0, p, n, seed);
  reached_ = 0;
  while (reached_ < levels_ && chooseCuts(grids_[static_cast<std::size_t>(reached_)])) {
    Grid& next = grids_[static_cast<std::size_t>(reached_ + 1)];
    Grid& from = grids_[static_cast<std::size_t>(reached_)];
    refine(from, next);
    ++reached_;
    seed += 0x632be59bd9b4e019ULL;
    trace(next, 0, p, n, seed);
    // An opening thinner than a cell (a window seen at grazing incidence) is met here and there:
    // follow it.
    for (std::size_t before = next.traced.size(); spread(from, next); before = next.traced.size()) {
      seed += 0x632be59bd9b4e019ULL;
      trace(next, before, p, n, seed);
    }
  }
}

void HemisphereCells::trace(Grid& grid, std::size_t first, const vec3& p, const vec3& n,
                            std::uint64_t seed) {
  vec3 t;
  vec3 b;
  orthonormalBasis(n, t, b);
  Rng rng(mixBits(seed));
  const vec3 origin = geometry::offsetOrigin(p, n);
  const float step = 1.0F / static_cast<float>(grid.side);
  rays_of_.clear();
  const auto cells = std::span(grid.traced).subspan(first);
  for (const std::uint32_t cell : cells) {
    const auto side = static_cast<std::uint32_t>(grid.side);
    const float u = (static_cast<float>(cell % side) + rng.uniform()) * step;
    const float v = (static_cast<float>(cell / side) + rng.uniform()) * step;
    const vec3 d = cosineHemisphere(u, v);
    rays_of_.push_back({origin, 0.0F, d.x * t + d.y * b + d.z * n});
  }
  blocked_.resize(rays_of_.size());
  opaque_.occluded(rays_of_, blocked_);
  rays_ += rays_of_.size();
  grid.share.resize(grid.traced.size());
  const auto share = std::span(grid.share).subspan(first);
  for (std::size_t k = 0; k < share.size(); ++k) share[k] = blocked_[k] != 0 ? 0.0F : 1.0F;
  if (panes_ != nullptr) panes_->attenuate(rays_of_, share);
  for (std::size_t k = 0; k < share.size(); ++k) grid.open[cells[k]] = share[k] > 0.0F ? 1 : 0;
}

bool HemisphereCells::chooseCuts(Grid& grid) const {
  const int side = grid.side;
  bool any = false;
  const auto mark = [&](int x, int y) {
    grid.cut[static_cast<std::size_t>(y * side + x)] = 1;
    any = true;
  };
  for (const std::uint32_t cell : grid.traced) {
    grid.cut[cell] = 0;
    const int x = static_cast<int>(cell) % side;
    const int y = static_cast<int>(cell) / side;
    bool differs = false;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, side - 1); ++j) {
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, side - 1); ++i) {
        differs = differs || grid.open[static_cast<std::size_t>(j * side + i)] != grid.open[cell];
      }
    }
    if (differs) mark(x, y);
  }
  // Only cells with a ray of their own can be cut: on finer levels those of cut parents.
  for (const vec2& at : wanted_) {
    const int x = static_cast<int>(at.x * static_cast<float>(side));
    const int y = static_cast<int>(at.y * static_cast<float>(side));
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, side - 1); ++j) {
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, side - 1); ++i) {
        if (grid.own[static_cast<std::size_t>(j * side + i)] != 0) mark(i, j);
      }
    }
  }
  return any;
}

void HemisphereCells::refine(const Grid& from, Grid& to) const {
  const int side = from.side;
  for (int y = 0; y < side; ++y) {
    const std::uint8_t* row = &from.open[static_cast<std::size_t>(y * side)];
    std::uint8_t* below = &to.open[static_cast<std::size_t>(2 * y * to.side)];
    for (int x = 0; x < side; ++x) below[2 * x] = below[2 * x + 1] = row[x];
    std::copy(below, below + to.side, below + to.side);
  }
  for (const std::uint32_t cell : to.traced) to.own[cell] = 0;
  to.traced.clear();
  for (const std::uint32_t cell : from.traced) {
    if (from.cut[cell] != 0) addChildren(from, cell, to);
  }
}

void HemisphereCells::addChildren(const Grid& from, std::uint32_t cell, Grid& to) {
  const auto side = static_cast<std::uint32_t>(from.side);
  const auto wide = static_cast<std::uint32_t>(to.side);
  const std::uint32_t first = 2 * (cell / side) * wide + 2 * (cell % side);
  for (const std::uint32_t child : {first, first + 1, first + wide, first + wide + 1}) {
    to.traced.push_back(child);
    to.own[child] = 1;
  }
}

bool HemisphereCells::spread(Grid& from, Grid& to) const {
  const std::size_t known = to.traced.size();
  const int side = to.side;
  for (std::size_t k = 0; k < known; ++k) {
    const std::uint32_t cell = to.traced[k];
    const int x = static_cast<int>(cell) % side;
    const int y = static_cast<int>(cell) / side;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, side - 1); ++j) {
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, side - 1); ++i) {
        const auto other = static_cast<std::size_t>(j * side + i);
        if (to.own[other] != 0 || to.open[other] == to.open[cell]) continue;
        const auto parent = static_cast<std::uint32_t>(j / 2 * from.side + i / 2);
        if (from.own[parent] == 0 || from.cut[parent] != 0) continue;
        from.cut[parent] = 1;
        addChildren(from, parent, to);
      }
    }
  }
  return to.traced.size() > known;
}

}  // namespace soffit::daylight
