// SPDX-License-Identifier: MIT
#include "core/prt/skyline.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace soffit::prt {
namespace {

/// The upper edge of what is packed: pieces from left to right.
struct Piece {
  int x, y, width;
};

/// Height at which a rectangle comes to rest on the pieces from `first`; -1 beyond the strip.
int restingHeight(const std::vector<Piece>& line, std::size_t first, int width, int strip) {
  if (line[first].x + width > strip) return -1;
  int y = 0;
  int left = width;
  for (std::size_t i = first; left > 0; ++i) {
    y = std::max(y, line[i].y);
    left -= line[i].width;
  }
  return y;
}

void place(std::vector<Piece>& line, std::size_t first, const Piece& top) {
  line.insert(line.begin() + static_cast<std::ptrdiff_t>(first), top);
  const int end = top.x + top.width;
  std::size_t i = first + 1;
  while (i < line.size() && line[i].x < end) {
    const int covered = std::min(end - line[i].x, line[i].width);
    line[i].x += covered;
    line[i].width -= covered;
    if (line[i].width > 0) break;
    line.erase(line.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

Packing packRectangles(std::span<const glm::ivec2> sizes, int width) {
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sizes[a].y != sizes[b].y ? sizes[a].y > sizes[b].y : sizes[a].x > sizes[b].x;
  });
  Packing packing;
  packing.places.resize(sizes.size());
  std::vector<Piece> line{{0, 0, width}};
  for (const std::size_t k : order) {
    assert(sizes[k].x <= width);
    std::size_t best = line.size();
    int lowest = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const int y = restingHeight(line, i, sizes[k].x, width);
      if (y < 0 || (best < line.size() && y >= lowest)) continue;
      best = i;
      lowest = y;
    }
    packing.places[k] = {line[best].x, lowest};
    packing.height = std::max(packing.height, lowest + sizes[k].y);
    place(line, best, {line[best].x, lowest + sizes[k].y, sizes[k].x});
  }
  return packing;
}

}  // namespace soffit::prt
