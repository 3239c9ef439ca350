// SPDX-License-Identifier: MIT
#include "core/render/line_labels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace soffit::render {
namespace {

/// Rows and columns in which lines are looked for, px.
constexpr int kStride = 5;
/// A step between two pixels that is so many times larger than those before and after it is an
/// edge, not a line's slope.
constexpr float kEdge = 4.0F;
constexpr std::size_t kMostLabels = 80;

class Search {
 public:
  Search(const LuxPicture& picture, std::span<const double> levels, const LabelRoom& room)
      : picture_(picture), levels_(levels), room_(room) {}

  [[nodiscard]] std::vector<LineLabel> candidates() const {
    std::vector<LineLabel> found;
    for (int y = 2; y < picture_.height - 2; ++y) {
      for (int x = 2; x < picture_.width - 2; ++x) {
        if (y % kStride == 0) add(x, y, 1, 0, found);
        if (x % kStride == 0) add(x, y, 0, 1, found);
      }
    }
    return found;
  }

 private:
  [[nodiscard]] float at(int x, int y) const {
    return picture_.lux[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                        static_cast<std::size_t>(x)];
  }
  /// How many levels a value reaches.
  [[nodiscard]] std::size_t band(float lux) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(levels_, static_cast<double>(lux)) -
                                    levels_.begin());
  }

  /// A line between a pixel and the next one that way.
  void add(int x, int y, int dx, int dy, std::vector<LineLabel>& found) const {
    const float here = at(x, y);
    const float next = at(x + dx, y + dy);
    if (here < 0.0F || next < 0.0F || here == next) return;
    const std::size_t low = band(std::min(here, next));
    if (band(std::max(here, next)) != low + 1) return;
    const float before = at(x - dx, y - dy);
    const float after = at(x + 2 * dx, y + 2 * dy);
    const float around = std::max(std::abs(here - before), std::abs(after - next));
    if (before < 0.0F || after < 0.0F || std::abs(next - here) > kEdge * around) return;
    if (!isFree(x, y, low)) return;
    const auto level = static_cast<float>(levels_[low]);
    const float way = (level - here) / (next - here);
    found.push_back({{static_cast<float>(x) + way * static_cast<float>(dx) + 0.5F,
                      static_cast<float>(y) + way * static_cast<float>(dy) + 0.5F},
                     levels_[low]});
  }

  /// Whether nothing but the line between bands `low` and low + 1 crosses the label's border.
  [[nodiscard]] bool isFree(int x, int y, std::size_t low) const {
    const int half_width = static_cast<int>(std::ceil(0.5F * room_.size.x));
    const int half_height = static_cast<int>(std::ceil(0.5F * room_.size.y));
    if (x < half_width || y < half_height || x + half_width >= picture_.width ||
        y + half_height >= picture_.height) {
      return false;
    }
    const auto own = [&](int px, int py) {
      const float lux = at(px, py);
      const std::size_t b = lux < 0.0F ? std::numeric_limits<std::size_t>::max() : band(lux);
      return b == low || b == low + 1;
    };
    for (int i = -half_width; i <= half_width; i += 2) {
      if (!own(x + i, y - half_height) || !own(x + i, y + half_height)) return false;
    }
    for (int i = -half_height; i <= half_height; i += 2) {
      if (!own(x - half_width, y + i) || !own(x + half_width, y + i)) return false;
    }
    return true;
  }

  const LuxPicture& picture_;
  std::span<const double> levels_;
  const LabelRoom& room_;
};

bool collides(const LineLabel& a, const LineLabel& b, const LabelRoom& room) {
  const vec2 way = glm::abs(a.at - b.at);
  if (way.x < room.size.x && way.y < room.size.y) return true;
  return a.level == b.level && glm::length(way) < room.repeat;
}

}  // namespace

std::vector<LineLabel> placeLineLabels(const LuxPicture& picture, std::span<const double> levels,
                                       const LabelRoom& room) {
  if (levels.empty() || picture.lux.empty()) return {};
  std::vector<LineLabel> candidates = Search(picture, levels, room).candidates();
  const vec2 middle(0.5F * static_cast<float>(picture.width),
                    0.5F * static_cast<float>(picture.height));
  std::ranges::stable_sort(
      candidates, {}, [&](const LineLabel& l) { return glm::dot(l.at - middle, l.at - middle); });
  std::vector<LineLabel> placed;
  for (const LineLabel& candidate : candidates) {
    if (placed.size() >= kMostLabels) break;
    const bool blocked = std::ranges::any_of(
        placed, [&](const LineLabel& other) { return collides(candidate, other, room); });
    if (!blocked) placed.push_back(candidate);
  }
  return placed;
}

}  // namespace soffit::render
