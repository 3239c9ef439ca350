// SPDX-License-Identifier: MIT
#include "core/render/quick_reflections.h"

#include "core/glossy/bands.h"
#include "core/render/harmonic_reflections.h"
#include "core/render/lamp_highlights.h"

#include <map>
#include <tuple>
#include <utility>

namespace soffit::render {
namespace {

constexpr int kBands = 5;
constexpr int kMapSide = 64;
constexpr float kProbeSpacing = 2.0F;  // m
constexpr std::size_t kDirections = 512;
constexpr int kReceiverBlock = 8;  // pixels a side that share a receiver
constexpr float kNever = 2.0F;     // beyond any alpha

}  // namespace

Reflections settled(Reflections wanted, bool quick) {
  if (wanted != Reflections::automatic) return wanted;
  return quick ? Reflections::harmonics : Reflections::rays;
}

QuickReflections::QuickReflections(const ViewScene& scene, const Illumination& illumination,
                                   Reflections method)
    : scene_(scene),
      illumination_(illumination),
      sent_(scene),
      least_alpha_(method == Reflections::harmonics
                       ? static_cast<float>(glossy::leastAlphaFor(kBands))
                       : kNever) {
  bool maps = false;
  bool harmonics = false;
  for (std::uint32_t t = 0; t < scene.mesh().triangles.size(); ++t) {
    const ViewMaterial& m = scene.material(t);
    if (m.f0 <= 0.0F || m.alpha < kMirrorAlpha) continue;
    harmonics = harmonics || m.alpha >= least_alpha_;
    maps = maps || m.least_alpha < least_alpha_;
  }
  if (harmonics) {
    directions_ = std::make_shared<const sh::SphereSamples>(sh::hammersleySamples(kDirections));
  }
  if (!maps) return;
  const Box room = scene.mesh().bounds();
  maps_.emplace(scene, probeGrid(scene, room, kProbeSpacing), room,
                std::make_shared<const glossy::ReflectionLevels>(kMapSide));
  maps_->light(illumination);
}

void QuickReflections::render(std::span<const ReflectingPixel> pixels, SpecularLayer& layer) const {
  std::vector<vec3> radiance;
  for (const ReflectingPixel& pixel : pixels) {
    const SurfaceSample& at = pixel.samples.front();
    const ViewMaterial& m = scene_.material(at.point.triangle);
    vec3 sum = lampHighlights(scene_, at, m.f0, at.alpha);
    if (at.alpha < least_alpha_ && maps_) sum += maps_->reflected(at, m.f0, at.alpha);
    radiance.push_back(sum);
  }
  if (directions_ != nullptr) addHarmonics(pixels, radiance);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    auto& out =
        layer.pixels[static_cast<std::size_t>(pixels[i].y) * static_cast<std::size_t>(layer.width) +
                     static_cast<std::size_t>(pixels[i].x)];
    out.radiance = radiance[i];
    out.whole = true;
  }
}

void QuickReflections::addHarmonics(std::span<const ReflectingPixel> pixels,
                                    std::vector<vec3>& radiance) const {
  std::map<std::tuple<int, int, std::uint32_t>, std::uint32_t> made;
  std::vector<vec3> positions, normals;
  std::vector<SurfaceSample> samples;
  std::vector<std::uint32_t> receiver_of;
  for (const ReflectingPixel& pixel : pixels) {
    const SurfaceSample& at = pixel.samples.front();
    samples.push_back(at);
    receiver_of.push_back(kNoReceiver);
    if (at.alpha < least_alpha_) continue;
    const auto [found, fresh] =
        made.try_emplace({pixel.x / kReceiverBlock, pixel.y / kReceiverBlock, at.surface},
                         static_cast<std::uint32_t>(positions.size()));
    if (fresh) {
      positions.push_back(at.point.position);
      normals.push_back(at.point.normal);
    }
    receiver_of.back() = found->second;
  }
  if (positions.empty()) return;
  const auto arriving =
      arrivingAt(scene_, sent_, illumination_, positions, normals, directions_, kBands);
  const std::vector<vec3> reflected = throughLobes(scene_, arriving, kBands, samples, receiver_of);
  for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] += reflected[i];
}

}  // namespace soffit::render
