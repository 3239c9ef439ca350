// SPDX-License-Identifier: MIT
#include "core/render/tile_renderer.h"

#include "core/color/luminance.h"
#include "core/render/pixel_mean.h"
#include "core/render/pixel_pattern.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The part of the picture that a box can cover; everything where it reaches behind the camera.
vec4 pictureArea(const CameraFrame& camera, const Box& box) {
  constexpr float kFar = 1.0e9F;
  vec4 area(kFar, kFar, -kFar, -kFar);
  for (int corner = 0; corner < 8; ++corner) {
    const dvec3 p((corner & 1) != 0 ? box.hi.x : box.lo.x, (corner & 2) != 0 ? box.hi.y : box.lo.y,
                  (corner & 4) != 0 ? box.hi.z : box.lo.z);
    const dvec3 seen = camera.project(p);
    if (seen.z <= 1.0e-3) return {-kFar, -kFar, kFar, kFar};
    const vec2 at(glm::clamp(dvec2(seen), -1.0e9, 1.0e9));
    area = {std::min(area.x, at.x), std::min(area.y, at.y), std::max(area.z, at.x),
            std::max(area.w, at.y)};
  }
  return area;
}

}  // namespace

TileRenderer::TileRenderer(const ViewScene& scene, const CameraFrame& camera,
                           const Illumination& illumination, const RenderOptions& options,
                           const QuickReflections* quick)
    : scene_(scene),
      camera_(camera),
      options_(options),
      illumination_(illumination),
      reflector_(scene, illumination, options, static_cast<float>(camera.pixelAngle())),
      quick_(quick) {
  for (const light::Emitter& e : scene.emitters())
    luminaires_.push_back(pictureArea(camera, e.bounds));
}

bool TileRenderer::mayShowLuminaires(std::span<const PixelTask> tasks) const {
  int left = tasks.front().x;
  int right = left;
  int top = tasks.front().y;
  int bottom = top;
  for (const PixelTask& task : tasks) {
    left = std::min(left, task.x);
    right = std::max(right, task.x);
    top = std::min(top, task.y);
    bottom = std::max(bottom, task.y);
  }
  // The filter reaches a pixel beyond, the far edge is a pixel further, one is for rounding.
  const vec4 tile(left - 2, top - 2, right + 3, bottom + 3);
  return std::any_of(luminaires_.begin(), luminaires_.end(), [&](const vec4& l) {
    return l.x <= tile.z && l.z >= tile.x && l.y <= tile.w && l.w >= tile.y;
  });
}

void TileRenderer::render(std::span<const PixelTask> tasks, std::span<const vec2> pattern,
                          TileScratch& s, Film& film, SpecularLayer* layer) const {
  const auto nearer = [](const vec2& a, const vec2& b) { return glm::dot(a, a) < glm::dot(b, b); };
  s.central = static_cast<std::size_t>(std::min_element(pattern.begin(), pattern.end(), nearer) -
                                       pattern.begin());
  trace(tasks, pattern, s);
  groupSamples(tasks, pattern, s);
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
  traceFirst(scene_, s.rays, {.coherent = true, .luminaires = mayShowLuminaires(tasks)}, s.hits,
             s.first);
}

/// The common case made cheap: the neighbouring sample on the same plain triangle.
bool TileRenderer::sameAsBefore(std::size_t i, const TileScratch& s) const {
  if (s.group_of[i - 1] == kNoGroup) return false;
  const geometry::Hit& hit = s.first[i].surface;
  const geometry::Hit& before = s.first[i - 1].surface;
  const ViewMaterial& m = scene_.material(hit.triangle);
  if (hit.triangle != before.triangle || m.f0 > 0.0F || m.hasMaps()) return false;
  const SurfaceSample& sample = s.samples[i - 1];
  return glm::dot(sample.point.normal, sample.point.shading_normal) > 0.9999F &&
         std::abs(hit.t - before.t) * glm::dot(sample.point.normal, sample.to_eye) <
             2.0F * sample.footprint;
}

void TileRenderer::groupSamples(std::span<const PixelTask> tasks, std::span<const vec2> pattern,
                                TileScratch& s) const {
  const std::size_t per_pixel = pattern.size();
  const SurfaceOptions how{.spread = static_cast<float>(camera_.pixelAngle()),
                           .footprint = 0.0F,
                           .texture_share = textureShare(per_pixel),
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
      if (i > pixel * per_pixel && tasks[pixel].share && sameAsBefore(i, s)) {
        s.samples[i] = s.samples[i - 1];
        s.group_of[i] = s.group_of[i - 1];
        TileScratch::Group& own = s.groups[s.group_of[i]];
        own.count += 1;
        own.normals += s.samples[i].point.shading_normal;
        own.offsets += pattern[i - pixel * per_pixel];
        continue;
      }
      s.samples[i] = sampleSurface(scene_, s.rays[i], s.first[i].surface, how);
      std::size_t group = tasks[pixel].share ? begin : s.groups.size();
      while (group < s.groups.size() && !samePlace(s.samples[s.groups[group].first], s.samples[i]))
        ++group;
      if (group == s.groups.size())
        s.groups.push_back({static_cast<std::uint32_t>(i), 0, vec3(0.0F), vec2(0.0F), 0});
      TileScratch::Group& own = s.groups[group];
      own.count += 1;
      own.normals += s.samples[i].point.shading_normal;
      own.offsets += pattern[i - pixel * per_pixel];
      s.group_of[i] = static_cast<std::uint32_t>(group);
    }
    chooseMiddle(begin, pixel * per_pixel, pattern, how, s);
  }
  s.first_group.push_back(static_cast<std::uint32_t>(s.groups.size()));
}

/// The sample nearest to the middle of its group stands for it: the first one lies at the rim of
/// the pixel, where the light may already be another.
void TileRenderer::chooseMiddle(std::size_t first_group, std::size_t begin,
                                std::span<const vec2> pattern, const SurfaceOptions& how,
                                TileScratch& s) const {
  for (std::size_t g = first_group; g < s.groups.size(); ++g) {
    TileScratch::Group& group = s.groups[g];
    if (group.count < 2) continue;
    const vec2 middle = group.offsets / static_cast<float>(group.count);
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < pattern.size(); ++k) {
      const vec2 d = pattern[k] - middle;
      if (s.group_of[begin + k] != g || glm::dot(d, d) >= least) continue;
      least = glm::dot(d, d);
      group.first = static_cast<std::uint32_t>(begin + k);
    }
    // It may have been taken for the one before it.
    const std::size_t own = group.first;
    s.samples[own] = sampleSurface(scene_, s.rays[own], s.first[own].surface, how);
  }
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
      mean.add(hit.emits ? s.first[i].through *
                               scene_.emitted(hit.emitter, hit.normal, -s.rays[i].direction)
                         : vec3(0.0F));
    } else if (s.group_of[i] != kNoGroup) {
      const vec3& received = s.batch.total(s.groups[s.group_of[i]].light);
      surfaces += 1.0F;
      lux += color::luminance(received);
      mean.add(s.first[i].through * s.samples[i].albedo * received / kPiF);
    } else {
      mean.add(s.first[i].through *
               scene_.outside(s.rays[i].direction, true).value_or(options_.background));
    }
  }
  const std::size_t at = film.at(task.x, task.y);
  const auto count = static_cast<float>(per_pixel);
  film.radiance[at] = mean.value();
  film.lux[at] = surfaces > 0.0F ? lux / surfaces : 0.0F;
  film.surface[at] = surfaces / count;
  film.lamp[at] = lamps / count;
  film.triangle[at] = s.first[pixel * per_pixel + s.central].surface.triangle;
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
    const std::uint32_t middle = s.groups[best].first;
    const std::size_t before = s.mirror_samples.size();
    s.mirror_samples.push_back(s.samples[middle]);  // the one that highlights are seen from
    for (std::size_t i = pixel * per_pixel; i < (pixel + 1) * per_pixel; ++i) {
      if (i != middle && s.group_of[i] == best &&
          s.samples[i].material == s.samples[middle].material)
        s.mirror_samples.push_back(s.samples[i]);
    }
    s.mirror_counts.push_back(static_cast<std::uint32_t>(s.mirror_samples.size() - before));
    s.mirrors.push_back({tasks[pixel].x, tasks[pixel].y, {}});
  }
  listMirrors(s);
  if (quick_ != nullptr) {
    s.rough.clear();
    std::erase_if(s.mirrors, [&](const ReflectingPixel& pixel) {
      if (pixel.samples.front().alpha < kMirrorAlpha) return false;
      s.rough.push_back(pixel);
      return true;
    });
    quick_->render(s.rough, layer);
  }
  reflector_.render(s.mirrors, s.reflector, layer);
}

/// Gives each reflecting pixel its samples.
void TileRenderer::listMirrors(TileScratch& s) const {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < s.mirrors.size(); ++i) {
    s.mirrors[i].samples = std::span(s.mirror_samples).subspan(begin, s.mirror_counts[i]);
    begin += s.mirror_counts[i];
  }
}

void TileRenderer::reflectWhole(std::span<const PixelTask> tasks, std::span<const vec2> pattern,
                                TileScratch& s, SpecularLayer& layer) const {
  trace(tasks, pattern, s);
  s.mirror_samples.clear();
  s.mirror_counts.clear();
  s.mirrors.clear();
  const std::size_t per_pixel = pattern.size();
  for (std::size_t pixel = 0; pixel < tasks.size(); ++pixel) {
    const std::size_t before = s.mirror_samples.size();
    for (std::size_t i = pixel * per_pixel; i < (pixel + 1) * per_pixel; ++i) {
      if (!s.first[i].surface.valid()) continue;
      if (scene_.material(s.first[i].surface.triangle).f0 <= 0.0F) continue;
      s.mirror_samples.push_back(sampleSurface(scene_, s.rays[i], s.first[i].surface,
                                               {.spread = static_cast<float>(camera_.pixelAngle()),
                                                .texture_share = textureShare(per_pixel)}));
    }
    const std::size_t found = s.mirror_samples.size() - before;
    const auto [x, y, share] = tasks[pixel];
    auto& out = layer.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(layer.width) +
                             static_cast<std::size_t>(x)];
    out.coverage = static_cast<float>(found) / static_cast<float>(per_pixel);
    if (found == 0) continue;
    s.mirror_counts.push_back(static_cast<std::uint32_t>(found));
    s.mirrors.push_back({x, y, {}});
  }
  listMirrors(s);
  reflector_.renderWhole(s.mirrors, s.reflector, layer);
}

}  // namespace soffit::render
