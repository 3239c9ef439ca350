// SPDX-License-Identifier: MIT
#include "core/scene/reflectances.h"

#include "core/light/emitter.h"

#include <fmt/format.h>

#include <algorithm>

namespace soffit::scene {
namespace {

constexpr double kWhitest = 0.9;
constexpr double kBlackest = 0.005;

dvec3 meanOf(const Image& image) {
  // A grey image has one channel; a fourth is opacity.
  const auto channels = static_cast<std::size_t>(std::max(image.channels, 1));
  dvec3 sum(0.0);
  const std::size_t pixels = image.pixels.size() / channels;
  for (std::size_t i = 0; i < pixels; ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t channel = std::min(static_cast<std::size_t>(k), channels - 1);
      sum[k] += static_cast<double>(image.pixels[channels * i + channel]);
    }
  }
  return pixels == 0 ? dvec3(1.0) : sum / static_cast<double>(pixels);
}

}  // namespace

std::vector<double> materialAreas(const Scene& scene) {
  std::vector<double> areas(scene.materials.size(), 0.0);
  const geometry::Mesh& mesh = *scene.mesh;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const uvec3& v = mesh.triangles[t];
    const dvec3 a(mesh.positions[v.x]);
    const dvec3 n = glm::cross(dvec3(mesh.positions[v.y]) - a, dvec3(mesh.positions[v.z]) - a);
    if (mesh.material_of[t] < areas.size()) areas[mesh.material_of[t]] += 0.5 * glm::length(n);
  }
  return areas;
}

double reflectance(const Material& material) {
  const dvec3 map = material.diffuse_image ? meanOf(*material.diffuse_image) : dvec3(1.0);
  return std::min(1.0, glm::dot(light::kLuminance, material.diffuse * map) + material.specular);
}

std::vector<std::string> implausibleReflectances(const Scene& scene) {
  const std::vector<double> areas = materialAreas(scene);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    const double rho = reflectance(m);
    if (m.glass || areas[i] <= 0.0 || (rho >= kBlackest && rho <= kWhitest)) continue;
    const char* why =
        rho > kWhitest ? "more than white paint has (0.85)" : "a black that hardly exists";
    lines.push_back(fmt::format("materials.{}: reflectance {:.2f} on {:.3g} m² is {}", m.name, rho,
                                areas[i], why));
  }
  return lines;
}

}  // namespace soffit::scene
