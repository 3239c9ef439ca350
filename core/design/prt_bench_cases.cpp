// SPDX-License-Identifier: MIT
#include "core/design/prt_bench_cases.h"

#include "core/design/prt_bench_room.h"
#include "core/design/sh_bench.h"
#include "core/math/rng.h"
#include "core/prt/bounces.h"
#include "core/prt/direct_transfer.h"
#include "core/prt/evaluate.h"
#include "core/prt/material_maps.h"
#include "core/prt/shadow_pass.h"
#include "core/prt/texture_bake.h"
#include "core/prt/vertex_receivers.h"
#include "core/sh/analytic_light.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>

namespace soffit::design {
namespace {

using prt::Directions;
using prt::Receivers;
using prt::Surfaces;
using prt::TransferRows;

/// What a call took: by the clock on the wall, and of all threads' processors.
struct Took {
  double ms = 0.0;
  double cpu_ms = 0.0;
  Took operator+(const Took& o) const { return {ms + o.ms, cpu_ms + o.cpu_ms}; }
};

class Watch {
 public:
  [[nodiscard]] Took took() const {
    return {1e3 * std::chrono::duration<double>(Clock::now() - start_).count(),
            1e3 * static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC};
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  std::clock_t cpu_ = std::clock();
};

/// Median by the wall's clock, mean of the processors'.
Took medianOf(const std::function<void()>& run, double budget_s) {
  for (int i = 0; i < 3; ++i) run();
  std::vector<double> all;
  const Watch whole;
  while (all.size() < 5 || whole.took().ms < 1e3 * budget_s) {
    const Watch watch;
    run();
    all.push_back(watch.took().ms);
  }
  const double cpu_ms = whole.took().cpu_ms / static_cast<double>(all.size());
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2),
                   all.end());
  return {all[all.size() / 2], cpu_ms};
}

/// High in the sky, a little to one side: it comes in through the skylight.
sh::AnalyticLight benchLight() {
  return {.overhead_gain = 3.0,
          .overhead_threshold = 1.0,
          .side_gain = 3.0,
          .side_threshold = 1.0,
          .scale = 1000.0};
}

/// E of rows under the light with the rows' bands.
std::vector<double> lit(const TransferRows& rows) {
  const sh::Coefficients light = sh::analyticCoefficients(benchLight(), rows.bands());
  std::vector<double> values;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < light.size(); ++k) sum += light[k] * double{rows.vector(i)[k]};
    values.push_back(sum);
  }
  return values;
}

/// E by the same rays without harmonics.
std::vector<double> litWithoutHarmonics(const Receivers& r, const Directions& directions,
                                        const prt::VisibilityFlags& flags) {
  const sh::AnalyticLight light = benchLight();
  std::vector<double> radiance;
  for (const vec3& d : directions.all()) radiance.push_back(light(dvec3(d)));
  std::vector<double> values(r.size(), 0.0);
  for (std::size_t i = 0; i < r.size(); ++i) {
    for (std::size_t d = 0; d < directions.size(); ++d) {
      const float cosine = glm::dot(directions[d], r.normals[i]);
      if (cosine <= 0.0F || flags.blocked(i, d)) continue;
      values[i] += radiance[d] * double{cosine} * double{directions.weight(d)};
    }
  }
  return values;
}

struct Shadowed {
  prt::VisibilityFlags flags;
  TransferRows rows;
  std::uint64_t rays = 0;
  Took trace;
  Took project;
};

Shadowed shadow(const Surfaces& s, const Receivers& r, const Directions& directions) {
  Shadowed out;
  const Watch tracing;
  auto pass = prt::traceShadows(s, r, directions).value();
  out.trace = tracing.took();
  const Watch projecting;
  out.rows = prt::shadowedTransfer(r, directions, pass.flags).value();
  out.project = projecting.took();
  out.rays = pass.rays;
  out.flags = std::move(pass.flags);
  return out;
}

}  // namespace

std::vector<std::pair<std::string, std::function<void()>>> PrtBench::cases() {
  return {{"apply", [this] { apply(); }},   {"samples", [this] { samples(); }},
          {"bands", [this] { bands(); }},   {"bounces", [this] { bounces(); }},
          {"places", [this] { places(); }}, {"texture", [this] { texture(); }}};
}

/// 100,000 receivers' vectors times one light.
void PrtBench::apply() {
  const std::size_t receivers = options_.detail > 0 ? 100000 : 1000;
  for (int bands = 3; bands <= sh::kMaxBands; ++bands) {
    Rng rng(options_.seed);
    const std::size_t n = sh::coefficientCount(bands);
    for (const std::size_t channels : {std::size_t{1}, std::size_t{3}}) {
      TransferRows rows(receivers, bands, channels);
      for (std::size_t i = 0; i < receivers; ++i) {
        for (std::size_t c = 0; c < channels * n; ++c) rows.row(i)[c] = rng.uniform() - 0.3F;
      }
      sh::Coefficients grey;
      for (std::size_t k = 0; k < n; ++k) grey.push_back(rng.uniformDouble());
      const prt::LightVector light(grey);
      const prt::TransferVectors vectors(rows);
      prt::Illuminances lux;
      std::vector<double> exact, found;
      prt::evaluate(vectors, light, lux);
      for (std::size_t i = 0; i < receivers; ++i) {
        double sum = 0.0;
        for (std::size_t k = 0; k < n; ++k) sum += grey[k] * double{rows.vector(i, 1)[k]};
        exact.push_back(sum);
        found.push_back(double{lux.channels[1][i]});
      }
      const double error = relativeRms(found, exact);
      const double mb = 1e-6 * static_cast<double>(vectors.bytes());
      if (channels == 1) {
        std::vector<float> one(vectors.blockCount() * prt::kBlock);
        const Took took = medianOf([&] { prt::evaluate(vectors, light.channels[0], one); },
                                   options_.seconds_per_case);
        rows_.push_back(
            {"apply", "one channel", bands, 0, receivers, took.ms, took.cpu_ms, 0, mb, error});
      }
      const Took took =
          medianOf([&] { prt::evaluate(vectors, light, lux); }, options_.seconds_per_case);
      rows_.push_back({"apply", channels == 1 ? "rgb light" : "rgb light and transfer", bands, 0,
                       receivers, took.ms, took.cpu_ms, 0, mb, error});
    }
  }
}

/// Shadowed transfer on vertices by every set of directions.
void PrtBench::samples() {
  constexpr int kBands = 5;
  const auto surfaces = prtBenchRoom(options_.detail > 0 ? 16 : 3);
  const prt::VertexReceivers set(surfaces);
  const Receivers& r = set.receivers();
  const std::vector<double> exact =
      lit(shadow(*surfaces, r, {sh::hammersleySamples(options_.detail > 0 ? 16384 : 2048), kBands})
              .rows);
  for (const int side : {16, 32, 64}) {
    const auto add = [&](const std::string& method, const sh::SphereSamples& samples) {
      if (job_.cancelled()) return;
      const Shadowed s = shadow(*surfaces, r, {samples, kBands});
      const Took took = s.trace + s.project;
      rows_.push_back({"samples", method, kBands, samples.size(), r.size(), took.ms, took.cpu_ms,
                       s.rays, 1e-6 * static_cast<double>(s.flags.bytes()),
                       relativeRms(lit(s.rows), exact)});
    };
    add("random", sh::randomSamples(side * side, options_.seed));
    add("stratified", sh::stratifiedSamples(side, options_.seed));
    add("hammersley", sh::hammersleySamples(side * side));
  }
}

/// What each number of bands leaves out of the light.
void PrtBench::bands() {
  const auto surfaces = prtBenchRoom(options_.detail > 0 ? 12 : 3);
  const prt::VertexReceivers set(surfaces);
  const Receivers& r = set.receivers();
  const sh::SphereSamples samples = sh::hammersleySamples(options_.detail > 0 ? 4096 : 512);
  std::vector<double> exact;
  for (int bands = 1; bands <= sh::kMaxBands && !job_.cancelled(); ++bands) {
    const Directions directions(samples, bands);
    const Shadowed s = shadow(*surfaces, r, directions);
    if (exact.empty()) exact = litWithoutHarmonics(r, directions, s.flags);
    rows_.push_back({"bands", "shadowed, projection only", bands, samples.size(), r.size(),
                     s.project.ms, s.project.cpu_ms, 0, 1e-6 * static_cast<double>(s.rows.bytes()),
                     relativeRms(lit(s.rows), exact)});
  }
}

/// Passes of bounces to the default threshold.
void PrtBench::bounces() {
  const auto surfaces = prtBenchRoom(options_.detail > 0 ? 16 : 3);
  const prt::VertexReceivers set(surfaces);
  const Receivers& r = set.receivers();
  for (const int n : {256, 1024}) {
    const Directions directions(sh::hammersleySamples(n), 5);
    const Shadowed s = shadow(*surfaces, r, directions);
    for (const bool keep : {true, false}) {
      if (job_.cancelled()) return;
      prt::BounceOptions options;
      if (!keep) options.keep_bytes = 0;
      const Watch watch;
      const auto out =
          prt::addBounces(*surfaces, set, directions, s.flags, s.rows, options).value();
      const Took took = watch.took();
      // The residual that is left when the passes end.
      rows_.push_back({"bounces", keep ? "rays kept" : "rays traced again", 5, directions.size(),
                       r.size(), took.ms, took.cpu_ms, out.rays,
                       1e-6 * static_cast<double>(out.kept_bytes),
                       out.passes.back().energy / out.passes.front().energy});
    }
  }
}

namespace {

/// Points drawn on the surfaces' triangles by area, with what the rays say of each.
struct Places {
  std::vector<geometry::Hit> hits;
  std::vector<double> exact;

  Places(const Surfaces& s, std::size_t count, int directions, std::uint64_t seed) {
    Rng rng(seed);
    double total = 0.0;
    std::vector<double> sum;
    for (const float a : s.areas) sum.push_back(total += double{a});
    Receivers at;
    while (hits.size() < count) {
      const auto it = std::upper_bound(sum.begin(), sum.end(), total * rng.uniformDouble());
      geometry::Hit hit;
      hit.triangle = static_cast<std::uint32_t>(
          std::min<std::ptrdiff_t>(it - sum.begin(), static_cast<std::ptrdiff_t>(sum.size()) - 1));
      hit.u = 1.0F - std::sqrt(rng.uniform());
      hit.v = (1.0F - hit.u) * rng.uniform();
      if (!s.receives(hit.triangle, true)) continue;
      hits.push_back(hit);
      at.positions.push_back((1 - hit.u - hit.v) * s.corner(hit.triangle, 0) +
                             hit.u * s.corner(hit.triangle, 1) + hit.v * s.corner(hit.triangle, 2));
      at.normals.push_back(prt::shadingNormalAt(s, {hit.triangle, hit.u, hit.v, 0.0F}));
      at.facing.push_back(s.normals[hit.triangle]);
    }
    exact = lit(shadow(s, at, {sh::hammersleySamples(directions), 5}).rows);
  }
  [[nodiscard]] double errorOf(const prt::ReceiverSet& set, const TransferRows& rows) const {
    const std::vector<double> values = lit(rows);
    std::vector<double> found;
    for (const geometry::Hit& hit : hits) {
      prt::ReceiverSet::Around around;
      const std::size_t n = set.around(hit, true, around);
      double sum = 0.0;
      for (std::size_t k = 0; k < n; ++k) {
        sum += double{around[k].weight} * values[around[k].receiver];
      }
      found.push_back(sum);
    }
    return relativeRms(found, exact);
  }
};

}  // namespace

/// Vertices against texels where the eye looks: at random points, most of them between receivers.
void PrtBench::places() {
  const int n = options_.detail > 0 ? 1024 : 256;
  const Directions directions(sh::hammersleySamples(n), 5);
  const std::size_t count = options_.detail > 0 ? 4000 : 200;
  for (const int cells :
       options_.detail > 0 ? std::vector<int>{4, 8, 16, 32} : std::vector<int>{3}) {
    if (job_.cancelled()) return;
    const auto surfaces = prtBenchRoom(cells);
    const Places places(*surfaces, count, options_.detail > 0 ? 16384 : 2048, options_.seed);
    const Watch watch;
    prt::VertexReceivers set(surfaces);
    set.replaceInvalid(prt::findUncovered(*surfaces, set.receivers()).value());
    const Shadowed s = shadow(*surfaces, set.receivers(), directions);
    const Took took = watch.took();
    rows_.push_back({"places", "vertices", 5, directions.size(), set.receivers().size(), took.ms,
                     took.cpu_ms, s.rays, 1e-6 * static_cast<double>(s.rows.bytes()),
                     places.errorOf(set, s.rows)});
  }
  const auto surfaces = prtBenchRoom(1);
  const Places places(*surfaces, count, options_.detail > 0 ? 16384 : 2048, options_.seed);
  for (const double texel :
       options_.detail > 0 ? std::vector<double>{0.8, 0.4, 0.2, 0.1} : std::vector<double>{0.8}) {
    if (job_.cancelled()) return;
    const Watch watch;
    auto set = prt::TextureReceivers::perObject(surfaces, {.texel = texel});
    set.replaceInvalid(prt::findUncovered(*surfaces, set.receivers()).value());
    const Shadowed s = shadow(*surfaces, set.receivers(), directions);
    const Took took = watch.took();
    rows_.push_back({"places", "texels", 5, directions.size(), set.receivers().size(), took.ms,
                     took.cpu_ms, s.rays, 1e-6 * static_cast<double>(s.rows.bytes()),
                     places.errorOf(set, s.rows)});
  }
}

/// One large texture, from triangles to coefficients with bounces in colour.
void PrtBench::texture() {
  const auto surfaces = prtBenchRoom(1);
  prt::TextureBakeOptions options;
  options.one_atlas = true;
  options.textures.side = options_.detail > 0 ? options_.side : 64;
  options.directions = options_.detail > 0 ? 1024 : 256;
  for (const bool bounces : {false, true}) {
    options.bounces = bounces;
    const Watch watch;
    const auto bake = prt::bakeTextures(surfaces, options, job_);
    if (!bake) return;
    const Took took = watch.took();
    rows_.push_back({"texture", bounces ? "shadows and bounces" : "shadows", options.bands,
                     static_cast<std::size_t>(options.directions),
                     bake->receivers->receivers().size(), took.ms, took.cpu_ms,
                     bake->shadow_rays + bake->bounce_rays,
                     1e-6 * static_cast<double>(bake->transfer.bytes()), 0.0});
  }
}

}  // namespace soffit::design
