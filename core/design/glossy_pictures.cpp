// SPDX-License-Identifier: MIT
#include "core/design/glossy_pictures.h"

#include "core/base/parallel.h"
#include "core/color/luminance.h"
#include "core/design/glossy_picture_rows.h"
#include "core/design/pixel_samples.h"
#include "core/reference/beams.h"
#include "core/render/harmonic_reflections.h"
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
#include <map>
#include <memory>

namespace soffit::design {
namespace {

using render::SurfaceSample;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

using MethodResult = PictureByMethod;

class Measurement {
 public:
  Measurement(const render::ViewScene& scene, const PictureLights& lights,
              const render::CameraFrame& frame, const GlossyPictureOptions& options)
      : scene_(scene),
        illumination_(lights.quick),
        best_(lights.best),
        options_(options),
        sent_(scene),
        pixels_(samplePixels(scene, frame, options.stride, options.samples)),
        matte_(matteLight(pixels_, lights.quick)) {}

  [[nodiscard]] const PixelSamples& pixels() const { return pixels_; }

  /// Diffuse light alone, and its parts.
  [[nodiscard]] MethodResult matte(const render::Illumination& light, std::string name) const {
    std::vector<render::SurfacePoint> points;
    for (const SurfaceSample& s : pixels_.samples) points.push_back(s.point);
    std::vector<vec3> direct(points.size(), vec3(0.0F)), indirect(direct);
    light.evaluate(points, direct, indirect);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const vec3 sent = pixels_.samples[k].albedo / static_cast<float>(kPi);
      direct[k] *= sent;
      indirect[k] *= sent;
    }
    MethodResult result{std::move(name), pixelLuminance(direct), pixelLuminance(direct), 0.0};
    const std::vector<double> reflected = pixelLuminance(indirect);
    for (std::size_t i = 0; i < reflected.size(); ++i) result.luminance[i] += reflected[i];
    return result;
  }

  [[nodiscard]] Result<MethodResult> rays(const scene::Camera& camera, const Job& job) const {
    const auto start = std::chrono::steady_clock::now();
    render::RenderOptions how;
    how.width = options_.width;
    how.height = options_.height;
    how.samples = options_.samples;
    const auto film = render::renderView(scene_, camera, best_, how, job);
    if (!film) return film.error();
    MethodResult result{"rays", {}, {}, secondsSince(start)};
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
      return render::lampHighlights(scene_, s, m.f0, s.alpha);
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
      return maps.reflected(s, m.f0, s.alpha);
    });
    addHighlights(specular);
    return {fmt::format("reflection maps, {} probes", maps.probeCount()),
            luminanceOf(specular),
            {},
            secondsSince(start) + highlight_seconds_};
  }

  /// As the viewport shows them, luminaires included.
  [[nodiscard]] MethodResult liveMaps(const render::LitProbes& probes) const {
    const auto start = std::chrono::steady_clock::now();
    const auto specular = forSamples([&](const SurfaceSample& s, const render::ViewMaterial& m) {
      return probes.reflected({s.point.position, s.point.shading_normal, s.to_eye}, m.f0, s.alpha);
    });
    return {fmt::format("live maps, {} probes", probes.probes().size()),
            luminanceOf(specular),
            {},
            secondsSince(start)};
  }

  /// One receiver per pixel and material that reflects.
  [[nodiscard]] std::vector<MethodResult> harmonics() const {
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::uint32_t> receiver_of(pixels_.samples.size(), render::kNoReceiver);
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
    const auto arriving = render::arrivingAt(scene_, sent_, illumination_, positions, normals,
                                             directions, kMostBands);
    const double gathered = secondsSince(start);
    std::vector<MethodResult> results;
    for (int bands = 3; bands <= kMostBands; ++bands) {
      const auto begun = std::chrono::steady_clock::now();
      auto specular = render::throughLobes(scene_, arriving, bands, pixels_.samples, receiver_of);
      addHighlights(specular);
      results.push_back({fmt::format("harmonics, {} bands", bands),
                         luminanceOf(specular),
                         {},
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

  void addHighlights(std::vector<vec3>& specular) const {
    for (std::size_t k = 0; k < specular.size(); ++k) specular[k] += highlights_[k];
  }

  [[nodiscard]] std::vector<double> luminanceOf(const std::vector<vec3>& specular) const {
    std::vector<vec3> sum(matte_);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += specular[k];
    return pixelLuminance(sum);
  }

  [[nodiscard]] std::vector<double> pixelLuminance(const std::vector<vec3>& per_sample) const {
    std::vector<double> luminance;
    for (const auto& pixel : pixels_.pixels) {
      luminance.push_back(static_cast<double>(color::luminance(pixels_.mean(pixel, per_sample))));
    }
    return luminance;
  }

  const render::ViewScene& scene_;
  const render::Illumination& illumination_;
  const render::Illumination& best_;
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

}  // namespace

Result<GlossyPictures> measureGlossyPictures(const render::ViewScene& scene,
                                             const PictureLights& lights,
                                             const reference::ReferenceScene& reference,
                                             const scene::Camera& camera,
                                             const GlossyPictureOptions& options, const Job& job) {
  const auto frame =
      render::CameraFrame::create(camera, options.width, options.height, scene.mesh().origin);
  if (!frame) return frame.error();
  Measurement measurement(scene, lights, *frame, options);
  const PixelSamples& pixels = measurement.pixels();
  std::vector<MethodResult> methods{measurement.matte(lights.quick, "matte alone")};
  if (&lights.best != &lights.quick) {
    methods.push_back(measurement.matte(lights.best, "matte alone, final"));
  }
  const auto rays = measurement.rays(camera, job);
  if (!rays) return rays.error();
  methods.push_back(*rays);
  measurement.makeHighlights();
  methods.push_back(measurement.reflectionMaps());
  if (lights.live != nullptr) methods.push_back(measurement.liveMaps(*lights.live));
  for (MethodResult& method : measurement.harmonics()) methods.push_back(std::move(method));
  const auto truth = reference::traceBeams(reference, beamsOf(*frame, pixels, scene.mesh().origin),
                                           {.paths = options.paths, .seed = options.seed}, job);
  if (job.cancelled()) return Error{"bench glossy", "cancelled", ""};
  return judgePictures({camera.name, pixels, reference.materials(), truth}, methods);
}

}  // namespace soffit::design
