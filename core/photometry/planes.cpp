// SPDX-License-Identifier: MIT
#include "core/photometry/planes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace soffit::photometry {
namespace {

// Angles closer than this are the same plane: 540 - C and the like round.
constexpr double kSameDeg = 1e-7;

/// A plane of the result: an angle in [0, 360) and the stored row it shows.
struct Placed {
  double c_deg;
  std::size_t row;
};

double onCircle(double angle_deg) {
  double c = std::fmod(angle_deg, 360.0);
  if (c < 0.0) c += 360.0;
  return c > 360.0 - kSameDeg || c < kSameDeg ? 0.0 : c;
}

/// The reflections of an angle that belong to the mirror, itself included.
std::vector<double> images(double angle_deg, Mirror mirror) {
  switch (mirror) {
    case Mirror::c0:
      return {angle_deg, 360.0 - angle_deg};
    case Mirror::c90:
      return {angle_deg, 180.0 - angle_deg};
    case Mirror::both:
      return {angle_deg, 180.0 - angle_deg, 180.0 + angle_deg, 360.0 - angle_deg};
    case Mirror::none:
      break;
  }
  return {angle_deg};
}

std::vector<Placed> place(const std::vector<double>& c_deg, Mirror mirror) {
  std::vector<Placed> all;
  for (std::size_t row = 0; row < c_deg.size(); ++row) {
    for (const double angle : images(c_deg[row], mirror)) all.push_back({onCircle(angle), row});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Placed& a, const Placed& b) { return a.c_deg < b.c_deg; });
  const auto same = [](const Placed& a, const Placed& b) { return b.c_deg - a.c_deg < kSameDeg; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

/// If the circle is stored with both ends, folds the closing plane into the first so that the
/// trapezoid over C keeps its value although the gaps next to the seam may differ.
void closeSeam(StoredPlanes& s) {
  const std::size_t n = s.c_deg.size();
  if (n < 3 || s.c_deg[n - 1] - s.c_deg[0] < 360.0 - kSameDeg) return;
  const double first_gap = s.c_deg[1] - s.c_deg[0];
  const double last_gap = s.c_deg[n - 1] - s.c_deg[n - 2];
  const double t = last_gap / (first_gap + last_gap);
  const std::size_t columns = s.gamma_deg.size();
  for (std::size_t g = 0; g < columns; ++g) {
    const double closing = s.candela[(n - 1) * columns + g];
    s.candela[g] += t * (closing - s.candela[g]);
  }
  s.c_deg.pop_back();
  s.candela.resize((n - 1) * columns);
}

/// Gives a circle without C0 one on the chord between its neighbours: the trapezoid is unchanged.
void startAtZero(IntensityDistribution& d) {
  if (d.c_deg.front() == 0.0) return;
  const std::size_t columns = d.gamma_deg.size();
  const std::size_t last = d.c_deg.size() - 1;
  const double before = d.c_deg[last] - 360.0;
  const double t = -before / (d.c_deg[0] - before);
  std::vector<double> row(columns);
  for (std::size_t g = 0; g < columns; ++g) {
    const double a = d.candela[last * columns + g];
    row[g] = a + t * (d.candela[g] - a);
  }
  d.c_deg.insert(d.c_deg.begin(), 0.0);
  d.candela.insert(d.candela.begin(), row.begin(), row.end());
}

std::pair<double, double> storedRange(Mirror mirror) {
  if (mirror == Mirror::both) return {0.0, 90.0};
  return mirror == Mirror::c0 ? std::pair{0.0, 180.0} : std::pair{90.0, 270.0};
}

StoredPlanes planesWithin(const IntensityDistribution& d, std::pair<double, double> range) {
  StoredPlanes part;
  part.gamma_deg = d.gamma_deg;
  const auto columns = static_cast<std::ptrdiff_t>(d.gamma_deg.size());
  for (std::size_t i = 0; i < d.c_deg.size(); ++i) {
    if (d.c_deg[i] < range.first || d.c_deg[i] > range.second) continue;
    const auto row = d.candela.begin() + static_cast<std::ptrdiff_t>(i) * columns;
    part.c_deg.push_back(d.c_deg[i]);
    part.candela.insert(part.candela.end(), row, row + columns);
  }
  return part;
}

}  // namespace

IntensityDistribution unfold(const StoredPlanes& stored, Mirror mirror) {
  assert(!stored.c_deg.empty());
  assert(stored.candela.size() == stored.c_deg.size() * stored.gamma_deg.size());
  IntensityDistribution d;
  d.gamma_deg = stored.gamma_deg;
  if (stored.c_deg.size() == 1) {
    d.c_deg = {0.0};
    d.candela = stored.candela;
    return d;
  }
  StoredPlanes closed = stored;
  if (mirror == Mirror::none) closeSeam(closed);
  const auto columns = static_cast<std::ptrdiff_t>(stored.gamma_deg.size());
  for (const Placed& plane : place(closed.c_deg, mirror)) {
    const auto row = closed.candela.begin() + static_cast<std::ptrdiff_t>(plane.row) * columns;
    d.c_deg.push_back(plane.c_deg);
    d.candela.insert(d.candela.end(), row, row + columns);
  }
  startAtZero(d);
  return d;
}

std::pair<StoredPlanes, Mirror> fold(const IntensityDistribution& distribution) {
  for (const Mirror mirror : {Mirror::both, Mirror::c0, Mirror::c90}) {
    StoredPlanes part = planesWithin(distribution, storedRange(mirror));
    if (part.c_deg.size() < 2) continue;
    const IntensityDistribution whole = unfold(part, mirror);
    if (whole.c_deg == distribution.c_deg && whole.candela == distribution.candela) {
      return {std::move(part), mirror};
    }
  }
  return {planesWithin(distribution, {0.0, 360.0}), Mirror::none};
}

}  // namespace soffit::photometry
