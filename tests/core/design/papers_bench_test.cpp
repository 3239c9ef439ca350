// SPDX-License-Identifier: MIT
#include "core/design/papers_bench.h"

#include "core/design/papers_work.h"
#include "core/sh/analytic_light.h"
#include "core/sh/cube_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace soffit::design {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

PapersBenchOptions quick() {
  return {
      .triangles = 1000, .side = 256, .directions = 32, .cube_side = 8, .seconds_per_case = 0.0};
}

const std::vector<PapersRow>& rows() {
  static const auto measured = measurePapers(quick(), {});
  return measured.value();
}

const PapersRow& row(const std::string& table, const std::string& work) {
  const auto found = std::find_if(rows().begin(), rows().end(), [&](const PapersRow& r) {
    return r.table.starts_with(table) && r.work == work;
  });
  EXPECT_NE(found, rows().end()) << table << " " << work;
  return *found;
}

const PapersPlace& vertices() {
  static const PapersPlace place = verticesPlace(1000, 32);
  return place;
}

TEST(PapersBench, HasEveryRowOfTheThreeTables) {
  std::map<std::string, int> count;
  for (const PapersRow& r : rows()) {
    ++count[r.table];
    EXPECT_GT(r.ours, 0.0) << r.work;
    EXPECT_EQ(r.coefficients, 25);
    EXPECT_GT(r.receivers, 0U) << r.work;
    EXPECT_NEAR(static_cast<double>(r.triangles), 1000.0, 300.0);
    EXPECT_EQ(r.unit == "frames/s", r.ms > 0.0) << "what is timed is frames";
  }
  EXPECT_EQ(count["Fujita & Kanai 2"], 3);
  EXPECT_EQ(count["Dhawal et al. 1"], 3 * 4) << "vertices and three textures";
  EXPECT_EQ(count["Dhawal et al. 2"], 5 + 3 + 2);
}

TEST(PapersBench, OnlyWhatWasPublishedIsCompared) {
  for (const PapersRow& r : rows()) {
    if (r.table == "Fujita & Kanai 2") {
      EXPECT_FALSE(r.published.known());
    }
    if (!r.published.known()) {
      EXPECT_EQ(r.leastRatio(), 0.0);
      EXPECT_EQ(r.mostRatio(), 0.0);
      continue;
    }
    EXPECT_GT(r.published.low, 0.0);
    EXPECT_GE(r.published.high, r.published.low);
    EXPECT_NEAR(r.leastRatio() * r.published.high, r.ours, 1e-12 * r.ours);
    EXPECT_NEAR(r.mostRatio() * r.published.low, r.ours, 1e-12 * r.ours);
  }
  EXPECT_FALSE(row("Dhawal et al. 2", "vectors, texture 256").published.known())
      << "that figure is of 1024 x 1024 texels";
}

TEST(PapersBench, CountsTheBytesThatItsSizesMake) {
  const double n = static_cast<double>(row("Fujita", "diffuse, vertices").receivers);
  const double blocks = 16.0 * std::ceil(n / 16.0);
  EXPECT_EQ(row("Fujita", "diffuse, vertices").bytes, 2 * 25 * 32 * std::ceil(n / 32.0));
  EXPECT_EQ(row("Fujita", "glossy, 25 x 25, vertices").bytes, 2 * 625 * blocks);
  EXPECT_EQ(row("Dhawal et al. 2", "matrices, vertices").bytes, 2 * 625 * blocks);
  EXPECT_EQ(row("Dhawal et al. 2", "matrices, upper triangle, vertices").bytes, 2 * 325 * blocks);
  EXPECT_EQ(row("Fujita", "glossy, 25 x 81 of visibility, vertices").bytes, 2 * 81 * blocks);
  EXPECT_EQ(row("Dhawal et al. 1", "triple product, vertices").bytes, 4 * 25 * blocks);
  EXPECT_EQ(row("Dhawal et al. 2", "matrices over vectors, vertices").ours, 25.0);
  const PapersRow& texture = row("Dhawal et al. 1", "fixed light, texture 256");
  EXPECT_EQ(texture.bytes, 2 * 25 * 16 * ((texture.receivers + 15) / 16));
  EXPECT_LE(texture.receivers, 256U * 256U) << "texels with a surface alone";
}

TEST(PapersBench, CountsTheWorkOfAFrame) {
  const double n = static_cast<double>(vertices().receivers.size());
  const double of_light = 3.0 * 25.0 * 6.0 * 64.0;
  EXPECT_NEAR(row("Fujita", "diffuse, vertices").multiply_adds, 75.0 * n + of_light, 0.5);
  EXPECT_NEAR(row("Fujita", "glossy, 25 x 25, vertices").multiply_adds,
              3.0 * (625.0 + 25.0) * n + of_light, 0.5);
  EXPECT_NEAR(row("Dhawal et al. 1", "fixed light, vertices").multiply_adds,
              3.0 * (625.0 + 25.0) * n, 0.5);
  // One band: the product of two constants. Two bands: y_0 with each of the four, in any order.
  EXPECT_EQ(tripleWork(1), 1.0);
  EXPECT_EQ(tripleWork(2), 1.0 + 3.0 * 3.0);
}

TEST(PapersWork, MeshHasAboutTheTrianglesThatAreAskedFor) {
  for (const std::size_t wanted : {600U, 5000U, 50000U}) {
    const PapersPlace place = texturePlace(wanted, 16, 16);
    EXPECT_NEAR(static_cast<double>(place.triangles) / static_cast<double>(wanted), 1.0, 0.1);
  }
}

TEST(PapersWork, CubeLightIsTheProjectionOfItsTexels) {
  constexpr int kSide = 8;
  const CubeLight light(kSide);
  EXPECT_EQ(light.work(), 3.0 * 25.0 * 6.0 * kSide * kSide);
  const sh::AnalyticLight red{.scale = 1000.0};
  const auto wanted =
      sh::project([&](const dvec3& d) { return red(d); }, sh::cubeSamples(kSide), 5);
  const auto found = light.project();
  // The same texels in double precision; single precision errs by about 1e-6 of the integral of
  // |f y|, which is no more than that of f times the largest y (projection.h).
  const double largest = wanted[0] * std::sqrt(4.0 * kPi) * 1.5;
  for (std::size_t i = 0; i < 25; ++i) EXPECT_NEAR(found[0][i], wanted[i], 2e-6 * largest) << i;
}

TEST(PapersWork, BothProductsAndTheMatricesAgree) {
  const CubeLight cube(8);
  const auto light = cube.project();
  const PapersPlace& place = vertices();
  const std::size_t n = place.receivers.size();
  glossy::FloatBlocks triple(n, 75), fixed(n, 75), matrices(n, 75), wide(n, 75);
  multiplyTriple(light, place.visibility, triple);
  halvesOf(place.visibility).apply(light, fixed);
  papersMatrices(place, false).apply(light, matrices);
  halvesOf(place.wide).apply(light, wide);
  double size = 0.0, of_products = 0.0, of_matrices = 0.0;
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t k = 0; k < 75; ++k) {
      const auto square = [](float a, float b) { return std::pow(double{a} - double{b}, 2.0); };
      size += square(matrices.at(r, k), 0.0F);
      of_products += square(triple.at(r, k), fixed.at(r, k));
      of_matrices += square(matrices.at(r, k), wide.at(r, k));
    }
  }
  // Halves: 2^-11 an element at most, a third of it in RMS, some 25 of either sign in each sum.
  constexpr double kHalf = 1.0 / 2048.0;
  EXPECT_LT(std::sqrt(of_products / size), kHalf);
  EXPECT_LT(std::sqrt(of_matrices / size), kHalf);
}

TEST(PapersWork, DiffuseTransferIsThatOfOpenAndShutPlaces) {
  // Even light L all round: E = pi L times the cosine-weighted open share, between 0 and pi L.
  const PapersPlace& place = vertices();
  sh::Coefficients even(25, 0.0);
  even[0] = std::sqrt(4.0 * kPi);
  prt::Illuminances lux;
  prt::evaluate(place.diffuse, prt::LightVector(even), lux);
  float most = 0.0F;
  for (std::size_t r = 0; r < place.receivers.size(); ++r) {
    EXPECT_GE(lux.at(r).x, -1e-3F);
    EXPECT_LE(lux.at(r).x, static_cast<float>(kPi) * 1.001F);
    most = std::max(most, lux.at(r).x);
  }
  EXPECT_GT(most, 0.05F) << "the skylight is seen";
}

TEST(PapersBench, IsWrittenAsATable) {
  const std::string text = formatPapersRows(rows());
  EXPECT_THAT(text, StartsWith("table,work,unit,published,published_low,published_high,machine,"
                               "ours,ratio_low,ratio_high,triangles,"));
  EXPECT_THAT(text, HasSubstr("\"Fujita & Kanai 2\",\"diffuse, vertices\",frames/s,\"\",,,\"\","));
  EXPECT_THAT(text,
              HasSubstr("fixed light over triple product, vertices\",times,\"29, 6.8\",6.7942"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
            rows().size() + 1);
}

TEST(PapersBench, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(measurePapers(quick(), {nullptr, stop.get_token()}));
}

}  // namespace
}  // namespace soffit::design
