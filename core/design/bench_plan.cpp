// SPDX-License-Identifier: MIT
#include "core/design/bench_plan.h"

#include <fmt/format.h>

#include <utility>

namespace soffit::design {
namespace {

BenchStep only(scene::Quality quality) {
  return {quality, {{BenchMethod::bitmask, 0, quality}}};
}

BenchStep preset(const char* name) {
  scene::Quality quality;
  quality.preset = name;
  return only(quality);
}

BenchStep changed(const char* setting, double value) {
  scene::Quality quality;
  quality.settings[setting] = value;
  return only(quality);
}

/// The papers' methods in all their settings, on the interactive preset's bake.
BenchStep papersMethods() {
  BenchStep step;
  step.quality.preset = "interactive";
  const auto add = [&](BenchMethod method, int bands, int resolution) {
    step.points.push_back({method, bands, step.quality, resolution});
  };
  for (const int bands : {10, 2, 4, 6}) add(BenchMethod::harmonics, bands, 0);
  for (const int directions : {256, 4096}) add(BenchMethod::harmonics, 5, directions);
  for (const int side : {8, 32, 64}) {
    for (const int bands : {5, 3, 8}) add(BenchMethod::cubes, bands, side);
  }
  for (const int bands : {10, 2, 4, 6}) add(BenchMethod::cubes, bands, 0);
  return step;
}

}  // namespace

std::string BenchPoint::methodName() const {
  switch (method) {
    case BenchMethod::bitmask:
      return "bitmask";
    case BenchMethod::nodes:
      return "nodes";
    case BenchMethod::shadow_rays:
      return fmt::format("shadow-rays-{}", rays);
    case BenchMethod::harmonics:
      return fmt::format("harmonics-{}", rays) + atResolution("directions");
    case BenchMethod::cubes:
      return fmt::format("cubes-{}", rays) + atResolution("side");
  }
  return "bitmask";
}

std::string BenchPoint::atResolution(const char* what) const {
  return resolution == 0 ? std::string() : fmt::format("-{}-{}", what, resolution);
}

std::string BenchPoint::settingsName() const {
  std::string name = quality.preset;
  for (const auto& [key, value] : quality.settings) name += fmt::format("+{}={:g}", key, value);
  return name;
}

std::vector<BenchStep> benchPlan() {
  std::vector<BenchStep> plan;
  plan.push_back(preset("interactive"));
  plan[0].points.push_back({BenchMethod::nodes, 0, plan[0].quality});
  for (const int rays : {64, 16, 4, 256}) {
    plan[0].points.push_back({BenchMethod::shadow_rays, rays, plan[0].quality});
  }
  for (const auto& [method, bands] : {std::pair(BenchMethod::harmonics, 5),
                                      {BenchMethod::cubes, 5},
                                      {BenchMethod::harmonics, 3},
                                      {BenchMethod::harmonics, 8},
                                      {BenchMethod::cubes, 3},
                                      {BenchMethod::cubes, 8}}) {
    plan[0].points.push_back({method, bands, plan[0].quality});
  }
  plan.push_back(preset("draft"));
  plan.push_back(changed("texels", 25000));
  plan.push_back(changed("list_rays", 24));
  plan.push_back(changed("max_rank", 12));
  plan.push_back(preset("final"));
  // A coarse change of every setting, then finer ones.
  const std::vector<std::pair<const char*, double>> rest{
      {"trainings", 24},    {"sweeps", 0},      {"sweeps", 2},      {"tolerance", 0.05},
      {"patch", 64},        {"texels", 100000}, {"list_rays", 96},  {"max_rank", 96},
      {"tolerance", 0.002}, {"trainings", 256}, {"field_rays", 8},  {"node_rays", 4},
      {"texels", 12500},    {"patch", 32},      {"field_rays", 32}, {"node_rays", 16},
      {"list_rays", 32},    {"list_rays", 16},  {"max_rank", 20},   {"patch", 256},
      {"texels", 200000},   {"lists", 0.5}};
  for (const auto& [setting, value] : rest) plan.push_back(changed(setting, value));
  plan.push_back(papersMethods());
  return plan;
}

}  // namespace soffit::design
