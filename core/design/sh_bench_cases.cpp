// SPDX-License-Identifier: MIT
#include "core/design/sh_bench.h"

#include "core/math/quadrature.h"
#include "core/math/rng.h"
#include "core/sh/analytic_light.h"
#include "core/sh/basis.h"
#include "core/sh/cube_map.h"
#include "core/sh/kernels.h"
#include "core/sh/polygon_light.h"
#include "core/sh/projection.h"
#include "core/sh/rotation.h"
#include "core/sh/sphere_light.h"
#include "core/sh/triple_product.h"
#include "core/sh/zonal.h"

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace soffit::design {
namespace {

using sh::coefficientCount;
using sh::Coefficients;
using sh::SphereSamples;
using Cases = std::vector<ShBenchCase>;

std::vector<float> randomFloats(std::size_t n, Rng& rng) {
  std::vector<float> values(n);
  for (float& v : values) v = 2.0F * rng.uniform() - 1.0F;
  return values;
}

std::vector<double> asDouble(const std::vector<float>& values) {
  return {values.begin(), values.end()};
}

/// Keeps a result from being optimised away.
void keep(double value) {
  [[maybe_unused]] static volatile double sink = 0.0;
  sink = value;
}

/// Basis values at 1000 directions: a plane per coefficient.
struct BasisWork {
  static constexpr std::size_t kCount = 1000;
  int bands;
  SphereSamples samples;
  std::vector<float> x, y, z, values;
  std::vector<double> exact;

  BasisWork(int n, std::uint64_t seed)
      : bands(n),
        samples(sh::randomSamples(kCount, seed)),
        values(kCount * coefficientCount(n)),
        exact(values.size()) {
    std::array<double, sh::kMaxCoefficients> row;
    for (std::size_t k = 0; k < kCount; ++k) {
      const vec3 d = glm::normalize(vec3(samples.directions[k]));
      x.push_back(d.x);
      y.push_back(d.y);
      z.push_back(d.z);
      sh::evaluateByRecurrence(dvec3(d), bands, row);
      for (std::size_t i = 0; i < coefficientCount(bands); ++i) exact[i * kCount + k] = row[i];
    }
  }
  template <class Evaluate>
  void each(const Evaluate& evaluate) {
    std::array<float, sh::kMaxCoefficients> row;
    for (std::size_t k = 0; k < kCount; ++k) {
      evaluate(vec3(x[k], y[k], z[k]), bands, std::span<float>(row));
      for (std::size_t i = 0; i < coefficientCount(bands); ++i) values[i * kCount + k] = row[i];
    }
  }
};

void addEvaluation(std::uint64_t seed, Cases& cases) {
  for (const int bands : {3, 5, 10}) {
    const auto work = std::make_shared<BasisWork>(bands, seed);
    const auto add = [&](const std::string& method, std::function<void()> run) {
      const auto error = [work, run] {
        run();
        return relativeRms(asDouble(work->values), work->exact);
      };
      cases.push_back(
          {"evaluate", method, bands, BasisWork::kCount, BasisWork::kCount, std::move(run), error});
    };
    const auto recurrence = [](const vec3& d, int n, std::span<float> out) {
      sh::evaluateByRecurrence(d, n, out);
    };
    const auto unrolled = [](const vec3& d, int n, std::span<float> out) {
      sh::evaluate(d, n, out);
    };
    add("recurrence", [work, recurrence] { work->each(recurrence); });
    if (bands <= 5) add("polynomials", [work, unrolled] { work->each(unrolled); });
    add("simd batch", [work] {
      sh::evaluateBatch(work->x, work->y, work->z, work->bands, BasisWork::kCount,
                        work->values.data());
    });
  }
}

/// The tutorial's analytic light by sets of samples; random sets are judged over eight seeds.
void addProjection(std::uint64_t seed, Cases& cases) {
  constexpr int kSeeds = 8;
  const auto add = [&](const std::string& method, int bands, bool random, auto make) {
    const auto samples = std::make_shared<const SphereSamples>(make(seed));
    const auto run = [samples, bands] {
      keep(sh::project(sh::AnalyticLight{}, *samples, bands)[0]);
    };
    const auto error = [make, bands, random, seed] {
      const Coefficients exact = sh::analyticCoefficients({}, bands);
      double squares = 0.0;
      const int times = random ? kSeeds : 1;
      for (int i = 0; i < times; ++i) {
        const auto c =
            sh::project(sh::AnalyticLight{}, make(seed + static_cast<std::uint64_t>(i)), bands);
        squares += std::pow(relativeRms(c, exact), 2);
      }
      return std::sqrt(squares / times);
    };
    cases.push_back({"project", method, bands, samples->size(), samples->size(), run, error});
  };
  for (const int bands : {5, 10}) {
    for (const int side : {32, 100}) {
      add("random", bands, true,
          [=](std::uint64_t s) { return sh::randomSamples(side * side, s); });
      add("stratified", bands, true,
          [=](std::uint64_t s) { return sh::stratifiedSamples(side, s); });
      add("hammersley", bands, false,
          [=](std::uint64_t) { return sh::hammersleySamples(side * side); });
    }
    for (const int degree : {44, 140}) {
      add("cubature", bands, false, [=](std::uint64_t) { return sh::cubature(degree); });
    }
    for (const int n : {16, 64}) {
      add("cube map", bands, false, [=](std::uint64_t) { return sh::cubeSamples(n); });
    }
  }
}

/// A cube map of 64 x 64 x 6 texels by the stored table of basis x weight.
void addTable(Cases& cases) {
  for (const int bands : {5, 10}) {
    const SphereSamples samples = sh::cubeSamples(64);
    const auto table = std::make_shared<const sh::ProjectionTable>(samples, bands);
    const auto values = std::make_shared<std::vector<float>>();
    for (const dvec3& d : samples.directions) {
      values->push_back(static_cast<float>(sh::AnalyticLight{}(d)));
    }
    const auto run = [table, values] { keep(table->project(*values, *values, *values)[0][0]); };
    const auto error = [table, values, bands] {
      return relativeRms(table->project(*values), sh::analyticCoefficients({}, bands));
    };
    cases.push_back(
        {"project", "cube map table rgb", bands, samples.size(), samples.size(), run, error});
  }
}

/// 50,000 receivers' transfer vectors under one light: the loop of the founding papers.
void addShading(std::uint64_t seed, Cases& cases) {
  constexpr std::size_t kReceivers = 50000;
  struct Work {
    std::vector<float> rows, light, r, g, b;
  };
  for (const int bands : {3, 5}) {
    Rng rng(seed);
    const std::size_t n = coefficientCount(bands);
    const auto work = std::make_shared<Work>();
    work->rows = randomFloats(n * kReceivers, rng);
    work->light = randomFloats(n, rng);
    work->r.resize(kReceivers);
    work->g = work->b = work->r;
    const auto run = [work] {
      sh::dotBatch(work->light, work->light, work->light, work->rows.data(), kReceivers, work->r,
                   work->g, work->b);
    };
    const auto error = [work, n, run] {
      run();
      std::vector<double> exact(kReceivers, 0.0);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < kReceivers; ++k) {
          exact[k] += double(work->light[i]) * work->rows[i * kReceivers + k];
        }
      }
      return relativeRms(asDouble(work->g), exact);
    };
    cases.push_back({"shade rgb", "simd dot", bands, kReceivers, kReceivers, run, error});
  }
}

void addRotation(std::uint64_t seed, Cases& cases) {
  const dmat3 about_z = rotationXyz({0, 0, 50});
  for (const int bands : {5, 10}) {
    const Coefficients c = sh::analyticCoefficients({}, bands);
    // The bands that are kept, turned and projected again.
    const auto exact = [c, bands](const dmat3& matrix) {
      return sh::project(
          [&](const dvec3& d) { return sh::reconstruct(c, glm::transpose(matrix) * d); },
          sh::cubature(2 * bands), bands);
    };
    const dmat3 any = rotationXyz({30, 70.0 + static_cast<double>(seed % 10), 20});
    cases.push_back({"rotate", "matrices, made and applied", bands, 1, 1,
                     [=] { keep(sh::Rotation(any, bands).apply(c)[0]); },
                     [=] { return relativeRms(sh::Rotation(any, bands).apply(c), exact(any)); }});
    const auto made = std::make_shared<const sh::Rotation>(any, bands);
    cases.push_back({"rotate", "matrices, applied", bands, 1, 1, [=] { keep(made->apply(c)[0]); },
                     [=] { return relativeRms(made->apply(c), exact(any)); }});
    cases.push_back(
        {"rotate", "about z", bands, 1, 1, [=] { keep(sh::rotateAboutZ(c, radians(50))[0]); },
         [=] { return relativeRms(sh::rotateAboutZ(c, radians(50)), exact(about_z)); }});
  }
}

/// Products of 1000 functions with one another, or with one that is fixed.
void addProducts(std::uint64_t seed, Cases& cases) {
  constexpr std::size_t kItems = 1000;
  struct Work {
    int bands;
    std::vector<float> a, b, c, matrix;
    /// Item 0 by quadrature, the factor being the first of a.
    [[nodiscard]] double error() const {
      const std::size_t n = coefficientCount(bands);
      Coefficients first(n), second(n), found(n);
      for (std::size_t i = 0; i < n; ++i) {
        first[i] = a[i * kItems];
        second[i] = b[i * kItems];
        found[i] = c[i * kItems];
      }
      const auto product = [&](const dvec3& d) {
        return sh::reconstruct(first, d) * sh::reconstruct(second, d);
      };
      return relativeRms(found, sh::project(product, sh::cubature(3 * (bands - 1)), bands));
    }
  };
  for (const int bands : {3, 5, 10}) {
    Rng rng(seed);
    const std::size_t n = coefficientCount(bands);
    const auto work = std::make_shared<Work>();
    work->bands = bands;
    work->a = randomFloats(n * kItems, rng);
    work->b = randomFloats(n * kItems, rng);
    work->c.resize(n * kItems);
    Coefficients fixed(n);
    for (std::size_t i = 0; i < n; ++i) fixed[i] = work->a[i * kItems];
    const sh::TripleProduct& tensor = sh::TripleProduct::ofBands(bands);
    for (const double v : tensor.matrixOf(fixed)) work->matrix.push_back(static_cast<float>(v));
    const auto add = [&](const std::string& method, const std::function<void()>& run) {
      cases.push_back({"product", method, bands, kItems, kItems, run, [=] {
                         run();
                         return work->error();
                       }});
    };
    add("tensor (TP)", [work, &tensor] {
      tensor.multiplyBatch(work->a.data(), work->b.data(), work->c.data(), kItems, kItems);
    });
    add("fixed light (TPFL)", [work, n] {
      sh::multiplyByMatrixBatch(work->matrix, n, work->b.data(), work->c.data(), kItems, kItems);
    });
  }
}

const std::array<dvec3, 4> kPanel{dvec3(-0.6, -0.3, 2), dvec3(-0.6, 0.3, 2), dvec3(0.6, 0.3, 2),
                                  dvec3(0.6, -0.3, 2)};
constexpr dvec3 kReceiver{0.8, 0.3, 0.0};

/// The panel's coefficients at the receiver from a rule on its surface, u and v in [0, 1].
class SurfaceSum {
 public:
  explicit SurfaceSum(int bands) : bands_(bands), sum_(coefficientCount(bands), 0.0) {}
  void add(double u, double v, double weight) {
    const dvec3 to =
        kPanel[0] + u * (kPanel[3] - kPanel[0]) + v * (kPanel[1] - kPanel[0]) - kReceiver;
    const double r2 = glm::dot(to, to), r = std::sqrt(r2);
    std::array<double, sh::kMaxCoefficients> y;
    sh::evaluate(to / r, bands_, y);
    const double angle = weight * 0.72 * to.z / (r2 * r);
    for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += angle * y[i];
  }
  [[nodiscard]] const Coefficients& value() const { return sum_; }

 private:
  int bands_;
  Coefficients sum_;
};

Coefficients panelByGauss(int bands) {
  const QuadratureRule rule = gaussLegendre(32, 0.0, 1.0);
  SurfaceSum sum(bands);
  for (std::size_t i = 0; i < 32; ++i) {
    for (std::size_t j = 0; j < 32; ++j) {
      sum.add(rule.nodes[i], rule.nodes[j], rule.weights[i] * rule.weights[j]);
    }
  }
  return sum.value();
}

Coefficients panelByMonteCarlo(int side, int bands, std::uint64_t seed) {
  Rng rng(seed);
  SurfaceSum sum(bands);
  for (int i = 0; i < side * side; ++i) {
    const double u = (i / side + rng.uniformDouble()) / side;
    sum.add(u, (i % side + rng.uniformDouble()) / side, 1.0 / (side * side));
  }
  return sum.value();
}

void addLights(std::uint64_t seed, Cases& cases) {
  for (const int bands : {3, 5, 10}) {
    const auto add = [&](const std::string& task, const std::string& method, std::size_t samples,
                         const std::function<Coefficients()>& make, const Coefficients& exact) {
      cases.push_back({task, method, bands, samples, 1, [=] { keep(make()[0]); },
                       [=] { return relativeRms(make(), exact); }});
    };
    const Coefficients exact = panelByGauss(bands);
    add(
        "polygon", "boundary quadrature", 1,
        [=] { return sh::polygonCoefficients(kPanel, kReceiver, bands); }, exact);
    add(
        "polygon", "closed form", 1,
        [=] { return sh::polygonCoefficientsClosedForm(kPanel, kReceiver, bands); }, exact);
    add(
        "polygon", "with gradient", 1,
        [=] { return sh::polygonCoefficientsWithGradient(kPanel, kReceiver, bands).values; },
        exact);
    for (const int side : {8, 32}) {
      add(
          "polygon", "stratified on the light",
          static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
          [=] { return panelByMonteCarlo(side, bands, seed); }, exact);
    }
    // A sphere against its cap by a fine rule about its axis.
    const double edge = std::sqrt(1.0 - 0.01);
    const auto cap = sh::projectZonal([=](double t) { return t > edge ? 1.0 : 0.0; },
                                      {.bands = bands, .breakpoints = {edge}});
    const dvec3 axis = glm::normalize(dvec3(1, 2, 3));
    add(
        "sphere", "zonal", 1,
        [=] { return sh::sphereCoefficients(3.0 * axis, 0.3, dvec3(0), bands); },
        sh::zonalAbout(sh::kernelFromZonal(cap), axis));
  }
}

}  // namespace

std::vector<ShBenchCase> shBenchCases(std::uint64_t seed) {
  Cases cases;
  addEvaluation(seed, cases);
  addProjection(seed, cases);
  addTable(cases);
  addShading(seed, cases);
  addRotation(seed, cases);
  addProducts(seed, cases);
  addLights(seed, cases);
  return cases;
}

}  // namespace soffit::design
