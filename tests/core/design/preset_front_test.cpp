// SPDX-License-Identifier: MIT
#include "core/design/bench.h"
#include "core/design/move_taps.h"
#include "core/design/surface_reading.h"
#include "core/light/emitter.h"
#include "core/relight/lighting.h"
#include "tests/core/design/scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

/// The quality presets lie on the front of cost against error: none of the settings around one is
/// clearly cheaper and clearly better. Costs are counts (move_taps.h), errors are measured
/// against the path tracer; nothing is timed.
///
/// A preset is made for a building, the room here is a piece of one: it gets a share of the
/// preset's texels (a tenth of draft's, 1/32 of interactive's, 1/125 of final's) and all its other
/// settings.
namespace soffit::design {
namespace {

constexpr double kClearly = 0.95;  ///< less than this times the preset's is clearly less
constexpr double kAlike = 1.02;    ///< and up to this no more: what chance adds to a count

/// A room of 4 x 3.4 x 2.6 m with a red wall, a cupboard before the wall, a table and a panel of
/// light.
scene::Scene furnishedRoom() {
  using relight::testing::addBox;
  scene::Scene scene = testing::blockRoom();
  auto mesh = relight::testing::emptyMesh();
  mesh->materials = {"white", "red", "wood"};
  addBox(*mesh, {0, 0, 0}, {4, 3.4F, 2.6F}, true, 0);
  for (const std::size_t t : {4U, 5U}) mesh->material_of[t] = 1;
  addBox(*mesh, {3.3F, 0.4F, 0.001F}, {3.9F, 1.6F, 1.9F}, false, 2);
  addBox(*mesh, {0.8F, 1.2F, 0.7F}, {2.2F, 2.2F, 0.75F}, false, 2);
  scene.mesh = mesh;
  scene.materials.resize(3);
  scene.materials[0].diffuse = dvec3(0.7);
  scene.materials[1].diffuse = {0.6, 0.15, 0.1};
  scene.materials[2].diffuse = {0.4, 0.3, 0.2};
  scene.luminaires = {relight::testing::panel({1.6, 1.8, 2.55})};
  return scene;
}

const scene::Scene& room() {
  static const scene::Scene scene = furnishedRoom();
  return scene;
}

/// A quality with its counts and what it computes at the points.
struct Choice {
  double move = 0.0, bake = 0.0;
  std::vector<double> lux;
  ErrorFigures error;
};

std::shared_ptr<const relight::Solver> solverOf(relight::QualitySettings settings,
                                                std::uint64_t seed, relight::EngineReport& report) {
  settings.bake.seed = seed;
  return relight::makeSolver(room(), settings, false, {}, report).value();
}

/// The reference, to 1 % at each point.
const BenchCase& reference() {
  static const BenchCase found = [] {
    relight::EngineReport report;
    relight::QualitySettings settings;
    settings.bake.texels = 2000;
    const ReferenceEffort effort{.error = 0.01};
    return makeBenchCase(solverOf(settings, 1, report), room(), 200, effort, {}).value();
  }();
  return found;
}

Choice measure(const relight::QualitySettings& settings, std::uint64_t seed) {
  relight::EngineReport report;
  const auto solver = solverOf(settings, seed, report);
  relight::Lighting lighting(solver);
  EXPECT_TRUE(lighting.setLuminaires(room().luminaires, {}));
  Choice choice;
  choice.move = moveTaps(solver->operators(), solver->sweeps());
  choice.bake = static_cast<double>(report.bake.rays);
  ErrorSamples samples;
  const auto lights = readSurfaces(lighting, reference().receivers);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    choice.lux.push_back(glm::dot(lights[i].direct + lights[i].indirect, light::kLuminance));
    samples.add(choice.lux.back(), reference().total.reference[i],
                reference().total.standard_error[i]);
  }
  choice.error = errorFigures(samples);
  return choice;
}

bool cheaper(const Choice& a, const Choice& b) {
  return a.move <= kAlike * b.move && a.bake <= kAlike * b.bake &&
         (a.move < kClearly * b.move || a.bake < kClearly * b.bake);
}

/// Clearly, and by more than the reference's noise r can feign: of
/// mean((b - r)^2 - (a - r)^2) = mean((b - a)(b + a - 2 r)) the standard deviation is
/// 2 sqrt(sum (b - a)^2 s^2) / N; two of them.
bool better(const Choice& a, const Choice& b) {
  const ErrorSamples& truth = reference().total;
  double gain = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < a.lux.size(); ++i) {
    const double apart = b.lux[i] - a.lux[i];
    gain += apart * (b.lux[i] + a.lux[i] - 2.0 * truth.reference[i]);
    variance += std::pow(apart * truth.standard_error[i], 2.0);
  }
  return a.error.rms < kClearly * b.error.rms && gain > 2.0 * 2.0 * std::sqrt(variance);
}

using Factors = std::map<std::string, double>;

/// Settings times factors; rays are per side, so that theirs is the root.
relight::QualitySettings changed(relight::QualitySettings q, const Factors& factors) {
  transfer::BakeSettings& b = q.bake;
  const auto times = [](auto& value, double factor) {
    using Value = std::remove_reference_t<decltype(value)>;
    const double product = static_cast<double>(value) * factor;
    value = static_cast<Value>(std::is_integral_v<Value> ? std::round(product) : product);
  };
  for (const auto& [name, factor] : factors) {
    if (name == "texels") times(b.texels, factor);
    if (name == "patch") times(b.patch, factor);
    if (name == "trainings") times(b.trainings, factor);
    if (name == "max_rank") times(b.max_rank, factor);
    if (name == "lists") times(b.lists, factor);
    if (name == "sweeps") times(q.sweeps, factor);
    if (name == "tolerance") times(b.tolerance, factor);
    if (name == "node_rays") times(b.node_rays, std::sqrt(factor));
    if (name == "field_rays") times(b.field_rays, std::sqrt(factor));
    if (name == "list_rays") times(b.list_rays, std::sqrt(factor));
  }
  return q;
}

/// A quality with several seeds of the bake, each measured when it is first asked for.
class Measured {
 public:
  explicit Measured(relight::QualitySettings settings) : settings_(std::move(settings)) {}

  [[nodiscard]] const relight::QualitySettings& settings() const { return settings_; }
  /// seed: from 1.
  const Choice& with(std::uint64_t seed) {
    while (choices_.size() < seed) choices_.push_back(measure(settings_, choices_.size() + 1));
    return choices_[seed - 1];
  }

 private:
  relight::QualitySettings settings_;
  std::vector<Choice> choices_;
};

/// By what a neighbour beats a quality, if it does with each of three seeds; else nothing.
std::string beatenBy(Measured& quality, const Factors& factors) {
  constexpr std::uint64_t kSeeds = 3;
  std::string how;
  for (const auto& [setting, factor] : factors) how += fmt::format("{} x {:g}, ", setting, factor);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Choice other = measure(changed(quality.settings(), factors), seed);
    const Choice& own = quality.with(seed);
    const double move = other.move / own.move, bake = other.bake / own.bake;
    // One setting made cheaper saves in one count and costs in none but by chance: made dearer, it
    // is no competitor.
    if (factors.size() == 1) {
      EXPECT_LT(std::max(move, bake), 1.05) << how;
    }
    if (!cheaper(other, own) || !better(other, own)) return "";
    how += fmt::format("move x {:.2f}, bake x {:.2f}, RMS {:.3f} % of {:.3f} %; ", move, bake,
                       100.0 * other.error.rms, 100.0 * own.error.rms);
  }
  return how;
}

/// Every setting made cheaper by two, alone; and some whose saving is spent on another.
std::string whatBeats(const relight::QualitySettings& settings) {
  const std::vector<Factors> neighbours{{{"texels", 0.5}},
                                        {{"patch", 2.0}},
                                        {{"node_rays", 0.5}},
                                        {{"trainings", 0.5}},
                                        {{"field_rays", 0.5}},
                                        {{"list_rays", 0.5}},
                                        {{"max_rank", 0.5}},
                                        {{"lists", 0.5}},
                                        {{"tolerance", 2.0}},
                                        {{"sweeps", 0.0}},
                                        {{"texels", 0.5}, {"list_rays", 2.0}},
                                        {{"texels", 0.5}, {"field_rays", 2.0}},
                                        {{"list_rays", 0.5}, {"lists", 2.0}},
                                        {{"lists", 0.5}, {"list_rays", 2.0}},
                                        {{"tolerance", 2.0}, {"list_rays", 2.0}},
                                        {{"field_rays", 0.5}, {"trainings", 2.0}},
                                        {{"node_rays", 0.5}, {"field_rays", 2.0}}};
  Measured quality(settings);
  std::string found;
  for (const Factors& factors : neighbours) found += beatenBy(quality, factors);
  return found;
}

relight::QualitySettings preset(const std::string& name, int texels) {
  scene::Quality quality;
  quality.preset = name;
  quality.settings["texels"] = texels;  // as many as these: no largest cell
  return relight::qualitySettings(quality).value();
}

// One test, as they share the reference.
TEST(PresetFront, NothingBeatsAPreset) {
  for (const char* name : {"draft", "interactive", "final"}) {
    EXPECT_EQ(whatBeats(preset(name, 1600)), "") << name;
  }
}

TEST(PresetFront, WhatIsOutOfProportionIsBeaten) {
  // Most rays go to the nodes, where they tell little, few to the fields that train the weights.
  relight::QualitySettings lopsided = preset("interactive", 1600);
  lopsided.bake.node_rays = 24;
  lopsided.bake.field_rays = 3;
  Measured quality(lopsided);
  const std::string how = beatenBy(quality, {{"node_rays", 0.5}, {"field_rays", 2.0}});
  EXPECT_NE(how, "");
  RecordProperty("how", how);
}

}  // namespace
}  // namespace soffit::design
