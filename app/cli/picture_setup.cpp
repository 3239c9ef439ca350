// SPDX-License-Identifier: MIT
#include "app/cli/picture_setup.h"

#include "core/color/white_balance.h"
#include "core/io/project/starting_place.h"
#include "core/light/white.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>

namespace soffit::cli {
namespace {

/// Found before the light is computed. A pixel takes about 60 bytes on the way.
Result<std::pair<int, int>> checkedSize(int width, int height) {
  constexpr int kMostSide = 32768;
  constexpr std::int64_t kMostPixels = 100'000'000;
  const bool sides = width >= 1 && height >= 1 && width <= kMostSide && height <= kMostSide;
  if (sides && std::int64_t{width} * height <= kMostPixels) return std::pair(width, height);
  return Error{"--size",
               fmt::format("expected 1 to {} pixels a side and at most {} million in all, found "
                           "{}x{}",
                           kMostSide, kMostPixels / 1'000'000, width, height),
               "Give for instance 1280x800."};
}

}  // namespace

Result<std::pair<int, int>> parseSize(const std::string& text) {
  int width = 0;
  int height = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  if (first.ec == std::errc() && first.ptr != end && (*first.ptr == 'x' || *first.ptr == 'X')) {
    const auto second = std::from_chars(first.ptr + 1, end, height);
    if (second.ec == std::errc() && second.ptr == end) return checkedSize(width, height);
  }
  return Error{"--size", fmt::format("expected WIDTHxHEIGHT in pixels, found \"{}\"", text),
               "Give for instance 1280x800."};
}

Result<scene::Camera> chooseCamera(const scene::Scene& scene, const std::string& name) {
  for (const scene::Camera& camera : scene.cameras) {
    if (name.empty() || camera.name == name) return camera;
  }
  if (!name.empty()) {
    std::string known;
    for (const scene::Camera& camera : scene.cameras)
      known += (known.empty() ? "" : ", ") + camera.name;
    return Error{
        "--camera", fmt::format("the project has no camera \"{}\"", name),
        known.empty() ? "It has none; leave --camera out." : fmt::format("It has: {}.", known)};
  }
  if (scene.mesh->triangleCount() > 0) return io::startingPlace(*scene.mesh).camera;
  return scene::Camera{};
}

Result<std::optional<double>> parseExposure(const std::string& text, double from_project) {
  if (text.empty()) return std::optional(from_project);
  if (text == "auto") return std::optional<double>();
  double ev = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), ev);
  constexpr double kMostStops = 64.0;  // beyond, every picture is black or white
  if (parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() &&
      std::abs(ev) <= kMostStops) {
    return std::optional(ev);
  }
  return Error{"--exposure",
               fmt::format("expected stops from -64 to 64 (EV) or \"auto\", found \"{}\"", text),
               "Give for instance -0.5."};
}

Result<double> parseWhiteBalance(const std::string& text, const scene::Scene& scene) {
  if (text.empty()) return scene.view.white_balance;
  if (text == "auto") return light::whiteOf(scene.luminaires);
  double kelvin = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), kelvin);
  const bool number = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
  if (number &&
      (kelvin == 0.0 || (kelvin >= color::kWarmestWhite && kelvin <= color::kCoolestWhite))) {
    return kelvin;
  }
  return Error{
      "--white-balance",
      fmt::format("expected {:g} to {:g} kelvin, 0 for daylight, or \"auto\", found \"{}\"",
                  color::kWarmestWhite, color::kCoolestWhite, text),
      "Give for instance 4000."};
}

void finishAsProject(const scene::View& view, render::PictureOptions& picture) {
  picture.display.white_balance = view.white_balance;
  picture.tone = {.key = view.tone_key, .white = view.tone_white};
  picture.bloom = {.threshold = view.bloom_threshold, .strength = view.bloom_strength};
}

Result<std::unique_ptr<render::ViewScene>> makeViewScene(
    const scene::Scene& scene, std::shared_ptr<const geometry::RayCaster> caster) {
  const geometry::Mesh& mesh = *scene.mesh;
  if (caster == nullptr) {
    const auto panes = daylight::Panes::make(mesh, scene.materials);
    caster = std::make_shared<const geometry::RayCaster>(daylight::opaqueCaster(mesh, panes.get()));
  }
  std::vector<light::Emitter> emitters;
  for (const light::Luminaire& luminaire : scene.luminaires) {
    auto emitter = light::makeEmitter(luminaire, mesh.origin);
    if (!emitter) return emitter.error();
    emitters.push_back(std::move(*emitter));
  }
  return std::make_unique<render::ViewScene>(std::make_shared<const scene::Scene>(scene),
                                             std::move(caster), std::move(emitters));
}

}  // namespace soffit::cli
