// SPDX-License-Identifier: MIT
// Speed of core/sh's kernels: `soffit_sh_benchmark`, built with SOFFIT_BENCHMARKS. Errors belong to
// the tests, both together to `soffit bench sh`.
#include "core/sh/basis.h"
#include "core/sh/cube_map.h"
#include "core/sh/kernels.h"
#include "core/sh/polygon_light.h"
#include "core/sh/projection.h"
#include "core/sh/rotation.h"
#include "core/sh/sphere_light.h"
#include "core/sh/triple_product.h"
#include "core/sh/window.h"
#include "tests/core/sh/random_directions.h"

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

namespace soffit::sh {
namespace {

constexpr std::size_t kDirections = 4000;  // no power of two: rows would share cache sets

struct Directions {
  std::vector<vec3> packed;
  std::vector<float> x, y, z;

  Directions() {
    for (const dvec3& d : randomSamples(kDirections, 1).directions) {
      const vec3 f(d);
      packed.push_back(f);
      x.push_back(f.x);
      y.push_back(f.y);
      z.push_back(f.z);
    }
  }
};

int bandsOf(const benchmark::State& state) {
  return static_cast<int>(state.range(0));
}

std::vector<float> randomFloats(std::size_t n) {
  Rng rng(2);
  std::vector<float> values(n);
  for (float& v : values) v = 2.0F * rng.uniform() - 1.0F;
  return values;
}

void evaluateOne(benchmark::State& state) {
  const Directions d;
  std::array<float, kMaxCoefficients> y;
  for (auto _ : state) {
    for (const vec3& v : d.packed) {
      evaluate(v, bandsOf(state), y);
      benchmark::DoNotOptimize(y);
    }
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t{kDirections});
}
BENCHMARK(evaluateOne)->DenseRange(3, 5)->Arg(10);

void evaluateMany(benchmark::State& state) {
  const Directions d;
  std::vector<float> values(kDirections * coefficientCount(bandsOf(state)));
  for (auto _ : state) {
    evaluateBatch(d.x, d.y, d.z, bandsOf(state), kDirections, values.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t{kDirections});
}
BENCHMARK(evaluateMany)->DenseRange(3, 5)->Arg(10);

/// 50,000 receivers, three channels: the interactive loop of the founding papers.
void shadeReceivers(benchmark::State& state) {
  constexpr std::size_t kReceivers = 50000;
  const std::size_t n = coefficientCount(bandsOf(state));
  const std::vector<float> rows = randomFloats(n * kReceivers);
  const std::vector<float> light = randomFloats(n);
  std::vector<float> r(kReceivers), g(kReceivers), b(kReceivers);
  for (auto _ : state) {
    dotBatch(light, light, light, rows.data(), kReceivers, r, g, b);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t{kReceivers});
}
BENCHMARK(shadeReceivers)->Arg(3)->Arg(5)->Unit(benchmark::kMillisecond);

void projectCubeMap(benchmark::State& state) {
  const ProjectionTable table(cubeSamples(64), bandsOf(state));
  const std::vector<float> light = randomFloats(table.sampleCount());
  for (auto _ : state) benchmark::DoNotOptimize(table.project(light, light, light));
}
BENCHMARK(projectCubeMap)->Arg(5)->Arg(10)->Unit(benchmark::kMicrosecond);

void rotate(benchmark::State& state) {
  Rng rng(3);
  const Coefficients c = randomCoefficients(bandsOf(state), rng);
  const dmat3 matrix = turnAbout(randomDirection(rng), 1.0);
  for (auto _ : state) benchmark::DoNotOptimize(Rotation(matrix, bandsOf(state)).apply(c));
}
BENCHMARK(rotate)->Arg(5)->Arg(10)->Unit(benchmark::kMicrosecond);

void turnSky(benchmark::State& state) {
  Rng rng(3);
  const Coefficients c = randomCoefficients(bandsOf(state), rng);
  for (auto _ : state) benchmark::DoNotOptimize(rotateAboutZ(c, 0.3));
}
BENCHMARK(turnSky)->Arg(5)->Arg(10);

void multiplyByTensor(benchmark::State& state) {
  const TripleProduct& tensor = TripleProduct::ofBands(bandsOf(state));
  const std::size_t n = coefficientCount(bandsOf(state));
  constexpr std::size_t kItems = 1000;
  const std::vector<float> a = randomFloats(n * kItems);
  std::vector<float> c(n * kItems);
  for (auto _ : state) {
    tensor.multiplyBatch(a.data(), a.data(), c.data(), kItems, kItems);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t{kItems});
}
BENCHMARK(multiplyByTensor)->Arg(3)->Arg(5)->Arg(10)->Unit(benchmark::kMicrosecond);

void multiplyByFixedLight(benchmark::State& state) {
  const std::size_t n = coefficientCount(bandsOf(state));
  constexpr std::size_t kItems = 1000;
  const std::vector<float> matrix = randomFloats(n * n);
  const std::vector<float> b = randomFloats(n * kItems);
  std::vector<float> c(n * kItems);
  for (auto _ : state) {
    multiplyByMatrixBatch(matrix, n, b.data(), c.data(), kItems, kItems);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t{kItems});
}
BENCHMARK(multiplyByFixedLight)->Arg(3)->Arg(5)->Arg(10);

const std::array<dvec3, 4> kPanel{dvec3(-0.6, -0.3, 2), dvec3(-0.6, 0.3, 2), dvec3(0.6, 0.3, 2),
                                  dvec3(0.6, -0.3, 2)};

void polygonByBoundary(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(polygonCoefficients(kPanel, dvec3(0.3, 0.1, 0), bandsOf(state)));
  }
}
BENCHMARK(polygonByBoundary)->Arg(3)->Arg(5)->Arg(10);

void polygonInClosedForm(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        polygonCoefficientsClosedForm(kPanel, dvec3(0.3, 0.1, 0), bandsOf(state)));
  }
}
BENCHMARK(polygonInClosedForm)->Arg(3)->Arg(5)->Arg(10);

void polygonWithGradient(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        polygonCoefficientsWithGradient(kPanel, dvec3(0.3, 0.1, 0), bandsOf(state)));
  }
}
BENCHMARK(polygonWithGradient)->Arg(5)->Arg(10);

void sphere(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        sphereCoefficients(dvec3(0, 0, 2), 0.1, dvec3(0.3, 0.1, 0), bandsOf(state)));
  }
}
BENCHMARK(sphere)->Arg(5)->Arg(10);

void dering(benchmark::State& state) {
  const Coefficients c = sphereCoefficients(dvec3(0, 0, 2), 0.1, dvec3(0), bandsOf(state));
  for (auto _ : state) benchmark::DoNotOptimize(minimalLaplacian(c));
}
BENCHMARK(dering)->Arg(3)->Arg(5)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace soffit::sh

BENCHMARK_MAIN();
