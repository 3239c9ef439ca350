// SPDX-License-Identifier: MIT
#include "core/design/specks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::design {
namespace {

/// The specks of one level.
class Search {
 public:
  Search(std::span<const float> values, const Neighbours& neighbours, double level,
         const SpeckRule& rule)
      : values_(values),
        neighbours_(neighbours),
        level_(level),
        reach_(rule.error * level),
        most_(rule.most),
        set_(values.size(), 0) {}

  void run(std::vector<FlattenedPoint>& found) {
    for (std::uint32_t p = 0; p < values_.size(); ++p) {
      if (set_[p] == 0 && isNear(p) && grow(p)) flatten(found);
    }
  }

 private:
  [[nodiscard]] double value(std::uint32_t p) const { return static_cast<double>(values_[p]); }
  [[nodiscard]] bool isNear(std::uint32_t p) const { return std::abs(value(p) - level_) <= reach_; }
  [[nodiscard]] bool above(std::uint32_t p) const { return value(p) >= level_; }

  /// Collects the set of a point; false as soon as it is known to be no speck.
  bool grow(std::uint32_t start) {
    ++number_;
    points_.assign(1, start);
    set_[start] = number_;
    around_ = 0.0;
    around_count_ = 0;
    for (std::size_t next = 0; next < points_.size(); ++next) {
      const std::uint32_t p = points_[next];
      if (neighbours_.border[p] != 0) return false;
      for (std::uint32_t k = neighbours_.first[p]; k < neighbours_.first[p + 1]; ++k) {
        const std::uint32_t q = neighbours_.to[k];
        if (above(q) != above(start)) {
          around_ += value(q);
          ++around_count_;
          continue;
        }
        if (set_[q] == number_) continue;
        // Deep, or of a set that was given up: the same one.
        if (!isNear(q) || set_[q] != 0 || points_.size() == most_) return false;
        set_[q] = number_;
        points_.push_back(q);
      }
    }
    return around_count_ > 0;
  }

  /// To the mean of what is around it, which is all on the other side.
  void flatten(std::vector<FlattenedPoint>& found) const {
    const double mean = around_ / static_cast<double>(around_count_);
    auto value = static_cast<float>(std::clamp(mean, level_ - reach_, level_ + reach_));
    const auto border = static_cast<float>(level_);
    // Rounding may bring it back onto the level, which counts as above.
    if (above(points_.front())) {
      while (static_cast<double>(value) >= level_) value = std::nextafter(value, 0.0F);
    } else if (static_cast<double>(value) < level_) {
      value = static_cast<double>(border) < level_ ? std::nextafter(border, 2.0F * border) : border;
    }
    for (const std::uint32_t p : points_) found.push_back({p, value});
  }

  std::span<const float> values_;
  const Neighbours& neighbours_;
  double level_;
  double reach_;
  std::size_t most_;
  std::vector<std::uint32_t> set_;  ///< per point, the number of the set it was met in; 0: none
  std::uint32_t number_ = 0;
  std::vector<std::uint32_t> points_;
  double around_ = 0.0;
  std::size_t around_count_ = 0;
};

/// Whether a point lies inside a closed line: the parity of its crossings to the right.
bool isInside(const Contour& line, const dvec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const dvec2& a = line.points[i];
    const dvec2& b = line.points[(i + 1) % line.points.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    inside ^= point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x);
  }
  return inside;
}

bool isSpeck(const Contour& line, std::span<const double> values, int nu, double level,
             const SpeckRule& rule) {
  if (!line.closed) return false;
  dvec2 low = line.points.front();
  dvec2 high = low;
  for (const dvec2& p : line.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  std::size_t count = 0;
  for (int j = static_cast<int>(std::ceil(low.y)); j <= static_cast<int>(high.y); ++j) {
    for (int i = static_cast<int>(std::ceil(low.x)); i <= static_cast<int>(high.x); ++i) {
      if (!isInside(line, dvec2(i, j))) continue;
      const double value = values[static_cast<std::size_t>(j) * static_cast<std::size_t>(nu) +
                                  static_cast<std::size_t>(i)];
      if (std::abs(value - level) > rule.error * level || ++count > rule.most) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Contour> withoutSpecks(std::vector<Contour> lines, std::span<const double> values,
                                   int nu, double level, const SpeckRule& rule) {
  std::erase_if(lines, [&](const Contour& line) { return isSpeck(line, values, nu, level, rule); });
  return lines;
}

Neighbours meshNeighbours(std::size_t vertices, std::span<const std::uint32_t> indices) {
  // Each edge once per triangle and direction, sorted: those of a point lie together.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(2 * indices.size());
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = indices[t + k];
      const std::uint32_t b = indices[t + (k + 1) % 3];
      edges.emplace_back(a, b);
      edges.emplace_back(b, a);
    }
  }
  std::ranges::sort(edges);
  Neighbours out;
  out.first.assign(vertices + 1, 0);
  out.border.assign(vertices, 0);
  for (std::size_t e = 0; e < edges.size();) {
    std::size_t end = e + 1;
    while (end < edges.size() && edges[end] == edges[e]) ++end;
    if (end - e == 1) out.border[edges[e].first] = 1;
    out.to.push_back(edges[e].second);
    ++out.first[edges[e].first + 1];
    e = end;
  }
  for (std::size_t v = 0; v < vertices; ++v) out.first[v + 1] += out.first[v];
  return out;
}

std::vector<FlattenedPoint> findSpecks(std::span<const float> values, const Neighbours& neighbours,
                                       std::span<const double> levels, const SpeckRule& rule) {
  std::vector<FlattenedPoint> found;
  for (const double level : levels) Search(values, neighbours, level, rule).run(found);
  return found;
}

}  // namespace soffit::design
