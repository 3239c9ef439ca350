// SPDX-License-Identifier: MIT
#include "core/design/glossy_pictures.h"

#include "core/base/parallel.h"
#include "core/color/luminance.h"
#include "core/design/pixel_samples.h"
#include "core/glossy/bounces.h"
#include "core/glossy/lobe_shape.h"
#include "core/glossy/matrix_set.h"
#include "core/reference/beams.h"
#include "core/render/lamp_highlights.h"
#include "core/render/probe_reflections.h"
#include "core/render/sent_albedo.h"
#include "core/render/view_renderer.h"
#include "core/sh/sphere_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <set>

namespace soffit::design {
namespace {

using render::SurfaceSample;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A picture by one method: luminance per pixel.
struct MethodResult {
  std::string name;
  std::vector<double> luminance;
  double seconds = 0.0;
};

class Measurement {
 public:
  Measurement(const render::ViewScene& scene, const render::Illumination& illumination,
              const render::CameraFrame& frame, const GlossyPictureOptions& options)
      : scene_(scene),
        illumination_(illumination),
        options_(options),
        sent_(scene),
        pixels_(samplePixels(scene, frame, options.stride, options.samples)),
        matte_(matteLight(pixels_, illumination)) {}

  [[nodiscard]] const PixelSamples& pixels() const { return pixels_; }

  [[nodiscard]] MethodResult matte() const {
    return {"matte alone", luminanceOf(std::vector<vec3>(matte_.size(), vec3(0.0F))), 0.0};
  }

  [[nodiscard]] Result<MethodResult> rays(const scene::Camera& camera, const Job& job) const {
    const auto start = std::chrono::steady_clock::now();
    render::RenderOptions how;
    how.width = options_.width;
    how.height = options_.height;
    how.samples = options_.samples;
    const auto film = render::renderView(scene_, camera, illumination_, how, job);
    if (!film) return film.error();
    MethodResult result{"rays", {}, secondsSince(start)};
    for (const auto& pixel : pixels_.pixels) {
      result.luminance.push_back(
          static_cast<double>(color::luminance(film->radiance[film->at(pixel.x, pixel.y)])));
    }
    return result;
  }

  /// What lamps add to every sample, by any method without rays.
  void makeHighlights() {
    const auto start = std::chrono::steady_clock::now();
    highlights_ = forSamples([&](const SurfaceSample& s, const render::ViewMaterial& m) {
      return render::lampHighlights(scene_, s, m.f0, m.alpha);
    });
    highlight_seconds_ = secondsSince(start);
  }

  [[nodiscard]] MethodResult reflectionMaps() const {
    const auto start = std::chrono::steady_clock::now();
    const Box room = scene_.mesh().bounds();
    const auto levels = std::make_shared<const glossy::ReflectionLevels>(options_.map_side);
    const auto probes = render::probeGrid(scene_, room, options_.probe_spacing);
    render::ProbeReflections maps(scene_, probes, room, levels);
    maps.light(illumination_);
    auto specular = forSamples([&](const SurfaceSample& s, const render::ViewMaterial& m) {
      return maps.reflected(s, m.f0, m.alpha);
    });
    addHighlights(specular);
    return {fmt::format("reflection maps, {} probes", maps.probeCount()), luminanceOf(specular),
            secondsSince(start) + highlight_seconds_};
  }

  /// One receiver per pixel and material that reflects.
  [[nodiscard]] std::vector<MethodResult> harmonics() const {
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::uint32_t> receiver_of(pixels_.samples.size(), glossy::kNoSource);
    std::vector<vec3> positions, normals;
    for (const auto& pixel : pixels_.pixels) {
      std::map<std::uint32_t, std::uint32_t> made;
      for (std::uint32_t k = pixel.begin; k < pixel.end; ++k) {
        const SurfaceSample& s = pixels_.samples[k];
        if (scene_.material(s.point.triangle).f0 <= 0.0F) continue;
        const auto [found, fresh] =
            made.try_emplace(s.surface, static_cast<std::uint32_t>(positions.size()));
        if (fresh) {
          positions.push_back(s.point.position);
          normals.push_back(s.point.normal);
        }
        receiver_of[k] = found->second;
      }
    }
    const auto directions =
        std::make_shared<const sh::SphereSamples>(sh::hammersleySamples(options_.directions));
    const glossy::FirstHits first(scene_.caster(), positions, normals, directions);
    const auto arriving = glossy::arrivingLight(first, hitLight(), kMostBands);
    const double gathered = secondsSince(start);
    std::vector<MethodResult> results;
    for (int bands = 3; bands <= kMostBands; ++bands) {
      const auto begun = std::chrono::steady_clock::now();
      auto specular = throughLobes(arriving, bands, receiver_of);
      addHighlights(specular);
      results.push_back({fmt::format("harmonics, {} bands", bands), luminanceOf(specular),
                         gathered + secondsSince(begun) + highlight_seconds_});
    }
    return results;
  }

 private:
  static constexpr int kMostBands = 6;

  template <class Of>
  std::vector<vec3> forSamples(const Of& of) const {
    std::vector<vec3> values(pixels_.samples.size(), vec3(0.0F));
    parallelFor(values.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const render::ViewMaterial& m = scene_.material(pixels_.samples[k].point.triangle);
        if (m.f0 > 0.0F) values[k] = of(pixels_.samples[k], m);
      }
    });
    return values;
  }

  [[nodiscard]] std::vector<vec3> throughLobes(
      const glossy::FloatBlocks& arriving, int bands,
      const std::vector<std::uint32_t>& receiver_of) const {
    // Every sample is a receiver that looks along its own lobe at its pixel's light.
    const std::size_t n = sh::coefficientCount(bands);
    const std::size_t stored = arriving.rows() / 3;
    glossy::FloatBlocks light(receiver_of.size(), 3 * n);
    const glossy::LobeView none{vec3(0, 0, 1), 0.5F, 0.0F};
    std::array<std::vector<glossy::LobeView>, 2> lobes;  // both parts of the lobe
    for (auto& part : lobes) part.assign(receiver_of.size(), none);
    for (std::size_t k = 0; k < receiver_of.size(); ++k) {
      if (receiver_of[k] == glossy::kNoSource) continue;
      for (std::size_t i = 0; i < 3 * n; ++i) {
        light.at(k, i) = arriving.at(receiver_of[k], i / n * stored + i % n);
      }
      const SurfaceSample& s = pixels_.samples[k];
      const render::ViewMaterial& m = scene_.material(s.point.triangle);
      const glossy::LobeShape shape =
          glossy::lobeShape(static_cast<double>(glm::dot(s.point.shading_normal, s.to_eye)),
                            static_cast<double>(m.alpha));
      const auto view = [&](const glossy::RoundLobe& lobe, double weight) {
        return glossy::LobeView{glossy::lobeAxis(lobe, s.point.shading_normal, s.to_eye),
                                static_cast<float>(lobe.alpha),
                                static_cast<float>(weight / lobe.above)};
      };
      lobes[0][k] = view(shape.base, static_cast<double>(m.f0) * shape.scale);
      lobes[1][k] = view(shape.rise, shape.bias);
    }
    std::vector<vec3> radiance(receiver_of.size()), rise(receiver_of.size());
    glossy::shade(light, lobes[0], radiance);
    glossy::shade(light, lobes[1], rise);
    for (std::size_t k = 0; k < rise.size(); ++k) radiance[k] += rise[k];
    for (vec3& value : radiance) value = glm::max(value, vec3(0.0F));
    return radiance;
  }

  [[nodiscard]] glossy::HitRadiance hitLight() const {
    return [this](std::span<const geometry::Ray> rays, std::span<const geometry::Hit> hits,
                  std::span<vec3> radiance) {
      std::vector<render::SurfacePoint> points;
      std::vector<vec3> albedo;
      for (std::size_t k = 0; k < hits.size(); ++k) {
        const SurfaceSample seen =
            render::sampleSurface(scene_, rays[k], hits[k], {.spread = 0.05F});
        points.push_back(seen.point);
        albedo.push_back(sent_.of(seen));
      }
      std::vector<vec3> direct(points.size(), vec3(0.0F)), indirect(points.size(), vec3(0.0F));
      illumination_.evaluate(points, direct, indirect);
      for (std::size_t k = 0; k < points.size(); ++k) {
        radiance[k] = albedo[k] * (direct[k] + indirect[k]) / static_cast<float>(kPi);
      }
    };
  }

  void addHighlights(std::vector<vec3>& specular) const {
    for (std::size_t k = 0; k < specular.size(); ++k) specular[k] += highlights_[k];
  }

  [[nodiscard]] std::vector<double> luminanceOf(const std::vector<vec3>& specular) const {
    std::vector<vec3> sum(matte_);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += specular[k];
    std::vector<double> luminance;
    for (const auto& pixel : pixels_.pixels) {
      luminance.push_back(static_cast<double>(color::luminance(pixels_.mean(pixel, sum))));
    }
    return luminance;
  }

  const render::ViewScene& scene_;
  const render::Illumination& illumination_;
  GlossyPictureOptions options_;
  render::SentAlbedo sent_;
  PixelSamples pixels_;
  std::vector<vec3> matte_;
  std::vector<vec3> highlights_;
  double highlight_seconds_ = 0.0;
};

std::vector<reference::Beam> beamsOf(const render::CameraFrame& frame, const PixelSamples& pixels,
                                     const dvec3& origin) {
  std::vector<reference::Beam> beams;
  for (const auto& pixel : pixels.pixels) {
    const auto along = [&](double dx, double dy) {
      return dvec3(frame.ray(pixel.x + 0.5 + dx, pixel.y + 0.5 + dy).direction);
    };
    const dvec3 middle = glm::normalize(along(0, 0));
    beams.push_back({origin + dvec3(frame.ray(0, 0).origin), middle,
                     0.5 * (along(1, 0) - along(-1, 0)), 0.5 * (along(0, 1) - along(0, -1))});
  }
  return beams;
}

/// Figures of a method over the pixels that `in` takes.
GlossyPictureRow rowOf(const MethodResult& method,
                       const std::vector<reference::BeamEstimate>& truth, double whole_mean,
                       const std::function<bool(std::size_t)>& in) {
  GlossyPictureRow row;
  row.method = method.name;
  row.seconds = method.seconds;
  double squares = 0.0, sum = 0.0, noise = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!in(i)) continue;
    const double a = color::luminance(truth[i].halves[0]);
    const double b = color::luminance(truth[i].halves[1]);
    const double found = method.luminance[i];
    squares += (found - a) * (found - b);
    sum += found - 0.5 * (a + b);
    noise += 0.25 * (a - b) * (a - b);
    row.mean += 0.5 * (a + b);
    ++row.pixels;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(row.pixels, 1));
  row.mean /= count;
  row.rms = std::sqrt(std::max(0.0, squares / count)) / whole_mean;
  row.bias = sum / count / whole_mean;
  row.noise = std::sqrt(noise / count) / whole_mean;
  return row;
}

}  // namespace

Result<std::vector<GlossyPictureRow>> measureGlossyPictures(
    const render::ViewScene& scene, const render::Illumination& illumination,
    const reference::ReferenceScene& reference, const scene::Camera& camera,
    const GlossyPictureOptions& options, const Job& job) {
  const auto frame =
      render::CameraFrame::create(camera, options.width, options.height, scene.mesh().origin);
  if (!frame) return frame.error();
  Measurement measurement(scene, illumination, *frame, options);
  const PixelSamples& pixels = measurement.pixels();
  std::vector<MethodResult> methods{measurement.matte()};
  const auto rays = measurement.rays(camera, job);
  if (!rays) return rays.error();
  methods.push_back(*rays);
  measurement.makeHighlights();
  methods.push_back(measurement.reflectionMaps());
  for (MethodResult& method : measurement.harmonics()) methods.push_back(std::move(method));
  const auto truth = reference::traceBeams(reference, beamsOf(*frame, pixels, scene.mesh().origin),
                                           {.paths = options.paths, .seed = options.seed}, job);
  if (job.cancelled()) return Error{"bench glossy", "cancelled", ""};

  double whole = 0.0;
  for (const auto& beam : truth) whole += color::luminance(beam.mean());
  whole /= static_cast<double>(std::max<std::size_t>(truth.size(), 1));
  std::set<std::uint32_t> materials;
  for (const auto& pixel : pixels.pixels) {
    if (pixel.reflects) materials.insert(pixel.material);
  }
  std::vector<GlossyPictureRow> rows;
  for (const MethodResult& method : methods) {
    const auto add = [&](const std::string& part, const std::function<bool(std::size_t)>& in) {
      rows.push_back(rowOf(method, truth, whole, in));
      rows.back().camera = camera.name;
      rows.back().part = part;
    };
    add("picture", [](std::size_t) { return true; });
    for (const std::uint32_t material : materials) {
      const auto& m = reference.materials()[material];
      add(fmt::format("{}, roughness {:.2f}", m.name, m.roughness), [&](std::size_t i) {
        return pixels.pixels[i].reflects && pixels.pixels[i].material == material;
      });
    }
    add("matte surfaces", [&](std::size_t i) { return !pixels.pixels[i].reflects; });
  }
  return rows;
}

std::string formatGlossyPictureRows(const std::vector<GlossyPictureRow>& rows) {
  std::string text = "camera,method,part,pixels,mean,rms,bias,noise,seconds\n";
  for (const GlossyPictureRow& r : rows) {
    text += fmt::format("\"{}\",\"{}\",\"{}\",{},{:.6g},{:.6g},{:.6g},{:.6g},{:.4g}\n", r.camera,
                        r.method, r.part, r.pixels, r.mean, r.rms, r.bias, r.noise, r.seconds);
  }
  return text;
}

}  // namespace soffit::design
