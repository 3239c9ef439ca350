// SPDX-License-Identifier: MIT
#include "core/glossy/bounces.h"

#include "core/base/parallel.h"
#include "core/sh/projection.h"

#include <array>
#include <cassert>

namespace soffit::glossy {
namespace {

/// Projects radiance by direction into the rows of a receiver.
class Projector {
 public:
  Projector(const sh::SphereSamples& samples, int bands)
      : table_(samples, bands), n_(sh::coefficientCount(bands)) {}

  void project(std::span<const vec3> radiance, std::size_t receiver, FloatBlocks& out) const {
    std::array<std::vector<float>, 3> channels;
    for (std::size_t c = 0; c < 3; ++c) {
      channels[c].reserve(radiance.size());
      for (const vec3& value : radiance) channels[c].push_back(value[static_cast<int>(c)]);
    }
    const sh::RgbCoefficients found = table_.project(channels[0], channels[1], channels[2]);
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < n_; ++i) {
        out.at(receiver, c * n_ + i) = static_cast<float>(found[c][i]);
      }
    }
  }

 private:
  sh::ProjectionTable table_;
  std::size_t n_;
};

template <class RadianceOf>
FloatBlocks projectAll(const FirstHits& receivers, int bands, const RadianceOf& radiance_of) {
  const Projector projector(receivers.samples(), bands);
  FloatBlocks arriving(receivers.size(), 3 * sh::coefficientCount(bands));
  parallelFor(receivers.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) projector.project(radiance_of(r), r, arriving);
  });
  return arriving;
}

}  // namespace

FloatBlocks arrivingLight(const FirstHits& receivers, const HitRadiance& light, int bands) {
  return projectAll(receivers, bands,
                    [&](std::size_t r) { return lightHits(receivers, r, light); });
}

FloatBlocks arrivingLight(const FirstHits& receivers, std::span<const std::uint32_t> source_of,
                          std::span<const vec3> radiance, int bands) {
  const std::size_t count = receivers.samples().size();
  assert(source_of.size() == receivers.size() * count);
  return projectAll(receivers, bands, [&](std::size_t r) {
    return gatherSources(source_of.subspan(r * count, count), radiance);
  });
}

std::vector<FloatBlocks> bounceTextures(const BounceSurfaces& surfaces,
                                        std::span<const vec3> direct, int bounces, int bands) {
  const std::size_t receivers = surfaces.receivers.size();
  const sh::SphereSamples& samples = surfaces.receivers.samples();
  assert(direct.size() == receivers && surfaces.reflectance.size() == receivers);
  std::vector<FloatBlocks> textures;
  std::vector<vec3> lux(direct.begin(), direct.end());
  std::vector<vec3> radiance(receivers);
  for (int bounce = 0; bounce < bounces; ++bounce) {
    for (std::size_t r = 0; r < receivers; ++r) {
      radiance[r] = surfaces.reflectance[r] * lux[r] / static_cast<float>(kPi);
    }
    textures.push_back(arrivingLight(surfaces.receivers, surfaces.source_of, radiance, bands));
    parallelFor(receivers, 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        dvec3 sum(0.0);
        for (std::size_t k = 0; k < samples.size(); ++k) {
          const std::uint32_t source = surfaces.source_of[r * samples.size() + k];
          const double cosine = glm::dot(samples.directions[k], dvec3(surfaces.normals[r]));
          if (source == kNoSource || cosine <= 0.0) continue;
          sum += samples.weights[k] * cosine * dvec3(radiance[source]);
        }
        lux[r] = vec3(sum);
      }
    });
  }
  return textures;
}

}  // namespace soffit::glossy
