// SPDX-License-Identifier: MIT
#include "core/glossy/ltc.h"

#include "core/base/parallel.h"
#include "core/glossy/ggx.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace soffit::glossy {
namespace {

constexpr std::size_t kAngles = 17;
constexpr std::size_t kRoughnesses = 25;
constexpr double kLeastCosine = 0.02;
constexpr double kLeastRoughness = 0.05;
constexpr int kSide = 16;  ///< samples of either density, squared

/// What is fitted and what changes slowly with angle and roughness.
struct Parameters {
  double log_x = 0.0;  ///< stretch in the plane of reflection
  double log_y = 0.0;  ///< stretch across it
  double skew = 0.0;   ///< in the plane
  double tilt = 0.0;   ///< of the mean direction from the normal, away from the eye, radians
};

Ltc toLtc(const Parameters& p) {
  const dvec3 z(-std::sin(p.tilt), 0.0, std::cos(p.tilt));
  const dvec3 x(z.z, 0.0, -z.x);
  const double sx = std::exp(p.log_x);
  const double sy = std::exp(p.log_y);
  // Columns of [x y z] times ((sx, 0, skew), (0, sy, 0), (0, 0, 1)).
  const dmat3 m(sx * x, dvec3(0.0, sy, 0.0), p.skew * x + z);
  const dmat3 inverse = glm::inverse(m);
  return {m, inverse, 1.0 / (sx * sy)};
}

/// The lobe that is fitted, and samples of it.
class Target {
 public:
  Target(double cos_view, double alpha)
      : wo_(std::sqrt((1.0 - cos_view) * (1.0 + cos_view)), 0.0, cos_view), alpha_(alpha) {
    dvec3 mean(0.0);
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const GgxDraw d = drawGgx(wo_, alpha, {(i + 0.5) / kSide, (j + 0.5) / kSide});
        if (d.weight <= 0.0) continue;
        weight_ += d.weight / (kSide * kSide);
        mean += d.weight * d.wi;
        directions_.push_back(d.wi);
      }
    }
    tilt_ = std::atan2(-mean.x, mean.z);
    for (const dvec3& w : directions_) densities_.push_back(density(w));
  }
  [[nodiscard]] double tilt() const { return tilt_; }
  [[nodiscard]] double density(const dvec3& w) const { return ggxLobe(wo_, w, alpha_) / weight_; }

  /// Sum over samples of both densities of |difference|^3 over the density of the samples: the
  /// integral of the error's third power that Heitz et al. minimise.
  [[nodiscard]] double loss(const Parameters& p) const {
    const Ltc ltc = toLtc(p);
    double sum = 0.0;
    const auto add = [&sum](double lobe, double fit) {
      const double difference = std::abs(lobe - fit);
      if (lobe + fit > 0.0) sum += difference * difference * difference / (lobe + fit);
    };
    for (std::size_t k = 0; k < directions_.size(); ++k) {
      add(densities_[k], ltc.density(directions_[k]));
    }
    static const std::vector<dvec3> cosines = [] {
      std::vector<dvec3> all;
      for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
          const double s = std::sqrt((i + 0.5) / kSide);
          const double phi = 2.0 * kPi * (j + 0.5) / kSide;
          all.emplace_back(s * std::cos(phi), s * std::sin(phi), std::sqrt(1.0 - s * s));
        }
      }
      return all;
    }();
    for (const dvec3& c : cosines) {
      const dvec3 stretched = ltc.matrix * c;
      const double length = glm::length(stretched);
      add(density(stretched / length), c.z / kPi * ltc.jacobian * length * length * length);
    }
    return sum;
  }

 private:
  dvec3 wo_;
  double alpha_;
  double weight_ = 0.0;
  double tilt_ = 0.0;
  std::vector<dvec3> directions_;
  std::vector<double> densities_;
};

using Point = std::array<double, 3>;

/// Nelder & Mead 1965, the textbook's coefficients.
template <class F>
Point minimise(const F& f, const Point& start, const Point& step, int evaluations) {
  std::array<Point, 4> x{start, start, start, start};
  for (std::size_t i = 0; i < 3; ++i) x[i + 1][i] += step[i];
  std::array<double, 4> y{};
  for (std::size_t i = 0; i < 4; ++i) y[i] = f(x[i]);
  const auto along = [](const Point& a, const Point& b, double t) {
    Point p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = a[i] + t * (b[i] - a[i]);
    return p;
  };
  for (int used = 4; used < evaluations;) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return y[a] < y[b]; });
    const std::size_t best = order[0], second = order[2], worst = order[3];
    if (y[worst] - y[best] <= 1.0e-9 * std::abs(y[best])) break;
    Point center{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) center[i] += x[order[k]][i] / 3.0;
    }
    const auto attempt = [&](double t) {
      ++used;
      return along(center, x[worst], t);
    };
    const Point reflected = attempt(-1.0);
    const double fr = f(reflected);
    if (fr < y[best]) {
      const Point further = attempt(-2.0);
      const double fe = f(further);
      x[worst] = fe < fr ? further : reflected;
      y[worst] = std::min(fe, fr);
    } else if (fr < y[second]) {
      x[worst] = reflected;
      y[worst] = fr;
    } else {
      const Point nearer = attempt(fr < y[worst] ? -0.5 : 0.5);
      const double fc = f(nearer);
      if (fc < std::min(fr, y[worst])) {
        x[worst] = nearer;
        y[worst] = fc;
      } else {
        for (std::size_t k = 1; k < 4; ++k) {
          x[order[k]] = along(x[best], x[order[k]], 0.5);
          y[order[k]] = f(x[order[k]]);
          ++used;
        }
      }
    }
  }
  return x[static_cast<std::size_t>(std::min_element(y.begin(), y.end()) - y.begin())];
}

Parameters fit(double cos_view, double alpha, const std::optional<Parameters>& near) {
  const Target target(cos_view, alpha);
  // About the normal the lobe is round, by symmetry.
  const bool round = cos_view > 1.0 - 1.0e-9;
  const auto of = [&](const Point& p) {
    return round ? Parameters{p[0], p[0], 0.0, 0.0} : Parameters{p[0], p[1], p[2], target.tilt()};
  };
  // A cosine squeezed to a = alpha has GGX's width.
  const double guess = std::log(std::max(alpha, 1.0e-3));
  const Point start = near ? Point{near->log_x, near->log_y, near->skew} : Point{guess, guess, 0.0};
  const double step = near ? 0.1 : 0.3;
  return of(minimise([&](const Point& p) { return target.loss(of(p)); }, start,
                     {step, -step, 0.2 * alpha}, near ? 70 : 140));
}

struct Table {
  std::vector<Parameters> nodes{kAngles * kRoughnesses};

  static double cosineAt(double x) {
    const double y = 1.0 - x;  // even steps in about the angle
    return 1.0 - (1.0 - kLeastCosine) * y * y;
  }
  static double roughnessAt(double y) { return kLeastRoughness + (1.0 - kLeastRoughness) * y; }
  Table() {
    parallelFor(kRoughnesses, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end; ++j) {
        const double roughness = roughnessAt(static_cast<double>(j) / (kRoughnesses - 1));
        std::optional<Parameters> before;
        for (std::size_t i = kAngles; i-- > 0;) {  // from the normal down
          const double cosine = cosineAt(static_cast<double>(i) / (kAngles - 1));
          before = fit(cosine, roughness * roughness, before);
          nodes[j * kAngles + i] = *before;
        }
      }
    });
  }
};

Parameters mix(const Parameters& a, const Parameters& b, double t) {
  const auto between = [t](double p, double q) { return p + t * (q - p); };
  return {between(a.log_x, b.log_x), between(a.log_y, b.log_y), between(a.skew, b.skew),
          between(a.tilt, b.tilt)};
}

}  // namespace

double Ltc::density(const dvec3& w) const {
  const dvec3 back = inverse * w;
  if (back.z <= 0.0) return 0.0;
  const double squared = glm::dot(back, back);
  // cos / pi in the cosine's frame; solid angles shrink by determinant / length^3.
  return back.z / kPi * jacobian / (squared * squared);
}

Ltc fitLtc(double cos_view, double alpha) {
  return toLtc(fit(cos_view, alpha, std::nullopt));
}

Ltc ltcAt(double cos_view, double alpha) {
  static const Table table;
  const double cosine = std::clamp(cos_view, kLeastCosine, 1.0);
  const double roughness = std::clamp(std::sqrt(alpha), kLeastRoughness, 1.0);
  const double x = (1.0 - std::sqrt((1.0 - cosine) / (1.0 - kLeastCosine))) * (kAngles - 1);
  const double y = (roughness - kLeastRoughness) / (1.0 - kLeastRoughness) * (kRoughnesses - 1);
  const auto i = std::min(static_cast<std::size_t>(std::max(x, 0.0)), kAngles - 2);
  const auto j = std::min(static_cast<std::size_t>(std::max(y, 0.0)), kRoughnesses - 2);
  const Parameters* at = table.nodes.data() + j * kAngles + i;
  const double s = std::clamp(x - static_cast<double>(i), 0.0, 1.0);
  return toLtc(mix(mix(at[0], at[1], s), mix(at[kAngles], at[kAngles + 1], s),
                   std::clamp(y - static_cast<double>(j), 0.0, 1.0)));
}

}  // namespace soffit::glossy
