// SPDX-License-Identifier: MIT
#include "core/design/contours.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace soffit::design {
namespace {

/// Edges between points of the grid: twice the point's index for the edge along i, one more for
/// the one along j. A line crosses an edge at most once, so an edge names a point of it.
using Edge = std::uint64_t;

struct Segment {
  Edge from = 0;
  Edge to = 0;
};

class Grid {
 public:
  Grid(std::span<const double> values, int nu, double level)
      : values_(values), nu_(static_cast<std::size_t>(nu)), level_(level) {}

  [[nodiscard]] double value(std::size_t i, std::size_t j) const { return values_[j * nu_ + i]; }
  [[nodiscard]] bool above(std::size_t i, std::size_t j) const { return value(i, j) >= level_; }
  [[nodiscard]] Edge alongI(std::size_t i, std::size_t j) const { return 2 * (j * nu_ + i); }
  [[nodiscard]] Edge alongJ(std::size_t i, std::size_t j) const { return 2 * (j * nu_ + i) + 1; }

  /// Where the level is crossed on an edge.
  [[nodiscard]] dvec2 crossing(Edge edge) const {
    const std::size_t at = edge / 2;
    const bool along_j = edge % 2 != 0;
    const double a = values_[at];
    const double b = values_[along_j ? at + nu_ : at + 1];
    const double way = (level_ - a) / (b - a);
    const dvec2 start(static_cast<double>(at % nu_), static_cast<double>(at / nu_));
    return start + (along_j ? dvec2(0.0, way) : dvec2(way, 0.0));
  }

  /// Whether the bilinear function is above the level at its saddle point, corners in order round
  /// the cell.
  [[nodiscard]] bool saddleAbove(double a, double b, double c, double d) const {
    return (a * c - b * d) / (a + c - b - d) >= level_;
  }

  void addCell(std::size_t i, std::size_t j, std::vector<Segment>& segments) const {
    const std::array<bool, 4> corner{above(i, j), above(i + 1, j), above(i + 1, j + 1),
                                     above(i, j + 1)};
    // Edge k joins corners k and k + 1.
    const std::array<Edge, 4> edge{alongI(i, j), alongJ(i + 1, j), alongI(i, j + 1), alongJ(i, j)};
    std::array<Edge, 4> crossed{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (corner[k] != corner[(k + 1) % 4]) crossed[count++] = edge[k];
    }
    if (count == 2) segments.push_back({crossed[0], crossed[1]});
    if (count != 4) return;
    const bool joined =
        saddleAbove(value(i, j), value(i + 1, j), value(i + 1, j + 1), value(i, j + 1));
    // Corners of the kind that the saddle is not are cut off one by one: 1 and 3 lie between the
    // edges 0, 1 and 2, 3; corners 0 and 2 between 3, 0 and 1, 2.
    if (joined == corner[0]) {
      segments.push_back({edge[0], edge[1]});
      segments.push_back({edge[2], edge[3]});
    } else {
      segments.push_back({edge[3], edge[0]});
      segments.push_back({edge[1], edge[2]});
    }
  }

 private:
  std::span<const double> values_;
  std::size_t nu_;
  double level_;
};

/// Joins segments end to end.
class Chains {
 public:
  Chains(const Grid& grid, std::vector<Segment> segments)
      : grid_(grid), segments_(std::move(segments)), used_(segments_.size(), false) {
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      for (const Edge e : {segments_[s].from, segments_[s].to}) {
        auto& two = at_[e];
        two[two[0] == kNone ? 0 : 1] = s;
      }
    }
  }

  [[nodiscard]] std::vector<Contour> take() {
    std::vector<Contour> lines;
    // Those that end at the border first: what is left is closed.
    for (const bool open : {true, false}) {
      for (std::size_t s = 0; s < segments_.size(); ++s) {
        if (used_[s]) continue;
        const Segment& segment = segments_[s];
        if (open && at_[segment.from][1] != kNone && at_[segment.to][1] != kNone) continue;
        const Edge start = open && at_[segment.from][1] != kNone ? segment.to : segment.from;
        lines.push_back(follow(start, s, !open));
      }
    }
    return lines;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Two : std::array<std::size_t, 2> {
    Two() : std::array<std::size_t, 2>{kNone, kNone} {}
  };

  Contour follow(Edge start, std::size_t segment, bool closed) {
    Contour line;
    line.closed = closed;
    line.points.push_back(grid_.crossing(start));
    Edge at = start;
    while (segment != kNone && !used_[segment]) {
      used_[segment] = true;
      at = segments_[segment].from == at ? segments_[segment].to : segments_[segment].from;
      if (at == start) break;
      line.points.push_back(grid_.crossing(at));
      const Two& two = at_[at];
      segment = two[0] == segment ? two[1] : two[0];
    }
    return line;
  }

  const Grid& grid_;
  std::vector<Segment> segments_;
  std::vector<bool> used_;
  std::unordered_map<Edge, Two> at_;
};

}  // namespace

std::vector<Contour> contoursAt(std::span<const double> values, int nu, int nv, double level) {
  if (nu < 2 || nv < 2) return {};
  const Grid grid(values, nu, level);
  std::vector<Segment> segments;
  for (std::size_t j = 0; j + 1 < static_cast<std::size_t>(nv); ++j) {
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(nu); ++i) {
      grid.addCell(i, j, segments);
    }
  }
  return Chains(grid, std::move(segments)).take();
}

}  // namespace soffit::design
