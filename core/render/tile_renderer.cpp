// SPDX-License-Identifier: MIT
#include "core/render/tile_renderer.h"

#include "core/color/luminance.h"
#include "core/render/pixel_mean.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265358979F;
constexpr std::uint32_t kNoGroup = 0xffffffffU;

/// Whether two samples of one pixel see so nearly the same place that the light is the same.
bool samePlace(const SurfaceSample& a, const SurfaceSample& b) {
  const vec3 d = b.point.position - a.point.position;
  const float cosine = std::max(glm::dot(a.point.normal, a.to_eye), 0.05F);
  const float reach = 4.0F * a.footprint / cosine;
  if (glm::dot(d, d) > reach * reach) return false;
  if (glm::dot(a.point.normal, b.point.normal) < 0.9F)
    return false;  // also the other side of a sheet
  if (a.surface == b.surface) return true;
  return glm::dot(a.point.shading_normal, b.point.shading_normal) > 0.97F &&
         std::abs(glm::dot(d, a.point.normal)) < 0.5F * a.footprint;
}

}  // namespace

TileRenderer::TileRenderer(const ViewScene& scene, const CameraFrame& camera,
                           const Illumination& illumination, const RenderOptions& options)
    : scene_(scene),
      camera_(camera),
      options_(options),
      illumination_(illumination),
      reflector_(scene, illumination, options, static_cast<float>(camera.pixelAngle())) {}

void TileRenderer::render(std::span<const PixelTask> tasks, std::span<const vec2> pattern,
                          TileScratch& s, Film& film, SpecularLayer* layer) const {
  trace(tasks, pattern, s);
  groupSamples(tasks, pattern.size(), s);
  s.batch.clear();
  for (TileScratch::Group& group : s.groups) {
    SurfacePoint point = s.samples[group.first].point;
    const float length = glm::length(group.normals);
    if (length > 0.0F) point.shading_normal = group.normals / length;
    group.light = s.batch.add(point, s.samples[group.first].surface);
  }
  s.batch.run(illumination_);
  for (std::size_t i = 0; i < tasks.size(); ++i) resolve(tasks[i], i, pattern.size(), s, film);
  if (layer != nullptr && !layer->pixels.empty()) reflect(tasks, pattern.size(), s, film, *layer);
}

void TileRenderer::trace(std::span<const PixelTask> tasks, std::span<const vec2> pattern,
                         TileScratch& s) const {
  s.rays.clear();
  for (const PixelTask& task : tasks) {
    for (const vec2& offset : pattern) {
      s.rays.push_back(camera_.ray(task.x + 0.5 + static_cast<double>(offset.x),
                                   task.y + 0.5 + static_cast<double>(offset.y)));
    }
  }
  s.hits.resize(s.rays.size());
  s.first.resize(s.rays.size());
  traceFirst(scene_, s.rays, s.hits, s.first);
}

void TileRenderer::groupSamples(std::span<const PixelTask> tasks, std::size_t per_pixel,
                                TileScratch& s) const {
  const SurfaceOptions how{.spread = static_cast<float>(camera_.pixelAngle()),
                           .footprint = 0.0F,
                           .plain_normals = options_.quantity == Quantity::illuminance};
  s.samples.resize(s.rays.size());
  s.group_of.assign(s.rays.size(), kNoGroup);
  s.groups.clear();
  s.first_group.clear();
  for (std::size_t pixel = 0; pixel < tasks.size(); ++pixel) {
    const std::size_t begin = s.groups.size();
    s.first_group.push_back(static_cast<std::uint32_t>(begin));
    for (std::size_t i = pixel * per_pixel; i < (pixel + 1) * per_pixel; ++i) {
      if (!s.first[i].surface.valid()) continue;
      s.samples[i] = sampleSurface(scene_, s.rays[i], s.first[i].surface, how);
      std::size_t group = tasks[pixel].share ? begin : s.groups.size();
      while (group < s.groups.size() && !samePlace(s.samples[s.groups[group].first], s.samples[i]))
        ++group;
      if (group == s.groups.size())
        s.groups.push_back({static_cast<std::uint32_t>(i), 0, vec3(0.0F), 0});
      s.groups[group].count += 1;
      s.groups[group].normals += s.samples[i].point.shading_normal;
      s.group_of[i] = static_cast<std::uint32_t>(group);
    }
  }
  s.first_group.push_back(static_cast<std::uint32_t>(s.groups.size()));
}

void TileRenderer::resolve(const PixelTask& task, std::size_t pixel, std::size_t per_pixel,
                           const TileScratch& s, Film& film) const {
  PixelMean mean(options_.edge_white);
  float lux = 0.0F;
  float surfaces = 0.0F;
  float lamps = 0.0F;
  for (std::size_t i = pixel * per_pixel; i < (pixel + 1) * per_pixel; ++i) {
    if (s.first[i].emitter.valid()) {
      const EmitterHit& hit = s.first[i].emitter;
      lamps += 1.0F;
      mean.add(hit.emits ? scene_.emitted(hit.emitter, hit.normal, -s.rays[i].direction)
                         : vec3(0.0F));
    } else if (s.group_of[i] != kNoGroup) {
      const vec3& received = s.batch.total(s.groups[s.group_of[i]].light);
      surfaces += 1.0F;
      lux += color::luminance(received);
      mean.add(s.samples[i].albedo * received / kPiF);
    } else {
      mean.add(options_.background);
    }
  }
  const std::size_t at = film.at(task.x, task.y);
  const auto count = static_cast<float>(per_pixel);
  film.radiance[at] = mean.value();
  film.lux[at] = surfaces > 0.0F ? lux / surfaces : 0.0F;
  film.surface[at] = surfaces / count;
  film.lamp[at] = lamps / count;
  film.triangle[at] = s.first[pixel * per_pixel].surface.triangle;
}

void TileRenderer::reflect(std::span<const PixelTask> tasks, std::size_t per_pixel, TileScratch& s,
                           const Film& film, SpecularLayer& layer) const {
  s.mirror_samples.clear();
  s.mirror_counts.clear();
  s.mirrors.clear();
  for (std::size_t pixel = 0; pixel < tasks.size(); ++pixel) {
    // The largest reflecting group stands for the pixel's others.
    std::uint32_t best = kNoGroup;
    std::uint32_t reflecting = 0;
    for (std::uint32_t g = s.first_group[pixel]; g < s.first_group[pixel + 1]; ++g) {
      if (scene_.material(s.samples[s.groups[g].first].point.triangle).f0 <= 0.0F) continue;
      reflecting += s.groups[g].count;
      if (best == kNoGroup || s.groups[g].count > s.groups[best].count) best = g;
    }
    auto& out = layer.pixels[film.at(tasks[pixel].x, tasks[pixel].y)];
    out.coverage = static_cast<float>(reflecting) / static_cast<float>(per_pixel);
    if (best == kNoGroup) continue;
    const std::uint32_t material = s.samples[s.groups[best].first].material;
    const std::size_t before = s.mirror_samples.size();
    for (std::size_t i = pixel * per_pixel; i < (pixel + 1) * per_pixel; ++i) {
      if (s.group_of[i] == best && s.samples[i].material == material)
        s.mirror_samples.push_back(s.samples[i]);
    }
    s.mirror_counts.push_back(static_cast<std::uint32_t>(s.mirror_samples.size() - before));
    s.mirrors.push_back({tasks[pixel].x, tasks[pixel].y, {}});
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < s.mirrors.size(); ++i) {
    s.mirrors[i].samples = std::span(s.mirror_samples).subspan(begin, s.mirror_counts[i]);
    begin += s.mirror_counts[i];
  }
  reflector_.render(s.mirrors, s.reflector, layer);
}

}  // namespace soffit::render
