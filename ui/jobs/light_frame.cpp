// SPDX-License-Identifier: MIT
#include "ui/jobs/light_frame.h"

#include "core/color/luminance.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <array>

namespace soffit::ui {
namespace {

/// Walls seen from outside carry no light and are not drawn: as many of them may be looked through.
constexpr int kMostLayers = 32;

/// Diffuse albedo at a hit; a map is read at its nearest pixel.
vec3 albedoAt(const scene::Material& material, const geometry::Mesh& mesh,
              const geometry::Hit& hit) {
  const vec3 plain(material.diffuse);
  const auto& image = material.diffuse_image;
  if (material.glass) return vec3(0.0F);
  if (image == nullptr || mesh.uvs.empty() || image->channels != 3 || image->width < 1)
    return plain;
  const uvec3& t = mesh.triangles[hit.triangle];
  vec2 uv = (1.0F - hit.u - hit.v) * mesh.uvs[t.x] + hit.u * mesh.uvs[t.y] + hit.v * mesh.uvs[t.z];
  uv -= glm::floor(uv);
  const int x =
      std::min(static_cast<int>(uv.x * static_cast<float>(image->width)), image->width - 1);
  const int y = std::min(static_cast<int>((1.0F - uv.y) * static_cast<float>(image->height)),
                         image->height - 1);
  const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image->width) +
                       static_cast<std::size_t>(x));
  return plain * vec3(image->pixels[at], image->pixels[at + 1], image->pixels[at + 2]);
}

/// A probe's surface is looked for from so far before it, and so far behind it, m: a model that was
/// read in again may have moved by rounding.
constexpr double kProbeReach = 0.01;

geometry::Ray rayOnto(const io::Probe& probe, const dvec3& origin) {
  geometry::Ray ray;
  ray.origin = vec3(probe.position + kProbeReach * probe.normal - origin);
  ray.direction = vec3(-probe.normal);
  ray.t_max = static_cast<float>(2.0 * kProbeReach);
  return ray;
}

}  // namespace

std::optional<ProbePlace> placeOf(const io::Probe& probe, const relight::Solver& solver) {
  const transfer::StaticScene& geometry = solver.scene();
  const geometry::Ray ray = rayOnto(probe, geometry.mesh->origin);
  const geometry::Hit hit = geometry.caster.closest(ray);
  if (!hit.valid() || solver.operators().texels.slotCount() == 0) return std::nullopt;
  ProbePlace place;
  std::array<std::uint32_t, transfer::Texels::kMostAround> slots{};
  std::array<float, transfer::Texels::kMostAround> weights{};
  const int count = solver.operators().texels.around(
      hit.triangle, geometry.hitsFront(hit.triangle, ray.direction),
      ray.origin + hit.t * ray.direction, slots, weights);
  if (count == 0) return std::nullopt;
  place.slots.assign(slots.begin(), slots.begin() + count);
  place.weights.assign(weights.begin(), weights.begin() + count);
  return place;
}

std::optional<SurfaceReading> readProbe(const LightFrame& frame, const scene::Scene& scene,
                                        const io::Probe& probe) {
  return readSurface(frame, scene, rayOnto(probe, scene.mesh->origin));
}

std::optional<SurfaceReading> readSurface(const LightFrame& frame, const scene::Scene& scene,
                                          const geometry::Ray& ray) {
  const transfer::StaticScene& geometry = frame.solver->scene();
  const transfer::Texels& texels = frame.solver->operators().texels;
  geometry::Ray rest = ray;
  for (int layer = 0; layer < kMostLayers; ++layer) {
    const geometry::Hit hit = geometry.caster.closest(rest);
    if (!hit.valid()) return std::nullopt;
    const vec3 point = ray.origin + hit.t * ray.direction;
    const bool front = geometry.hitsFront(hit.triangle, ray.direction);
    std::array<std::uint32_t, transfer::Texels::kMostAround> slots{};
    std::array<float, transfer::Texels::kMostAround> weights{};
    const int count =
        texels.slotCount() == 0 ? 0 : texels.around(hit.triangle, front, point, slots, weights);
    if (count == 0) {
      rest.t_min = hit.t + geometry.epsilon + 1e-6F * hit.t;
      continue;
    }
    vec3 e(0.0F);
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      e +=
          weights[k] * vec3(frame.lux[0][slots[k]], frame.lux[1][slots[k]], frame.lux[2][slots[k]]);
    }
    const geometry::Mesh& mesh = *geometry.mesh;
    const std::size_t material = mesh.material_of.empty() ? 0 : mesh.material_of[hit.triangle];
    SurfaceReading reading;
    reading.position = mesh.origin + dvec3(point);
    reading.normal = front ? geometry.normals[hit.triangle] : -geometry.normals[hit.triangle];
    reading.triangle = hit.triangle;
    reading.lux = static_cast<double>(color::luminance(e));
    if (material < scene.materials.size()) {
      const vec3 radiance = albedoAt(scene.materials[material], mesh, hit) * e;
      reading.luminance = static_cast<double>(color::luminance(radiance)) / kPi;
      reading.material = scene.materials[material].name;
    }
    return reading;
  }
  return std::nullopt;
}

}  // namespace soffit::ui
