// SPDX-License-Identifier: MIT
#include "core/scene/reflectances.h"

#include <fmt/format.h>

#include <algorithm>

namespace soffit::scene {
namespace {

constexpr double kWhitest = 0.9;
constexpr double kBlackest = 0.005;

double luminance(const dvec3& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

dvec3 meanOf(const Image& image) {
  dvec3 sum(0.0);
  const std::size_t pixels = image.pixels.size() / 3;
  for (std::size_t i = 0; i < pixels; ++i) {
    for (int k = 0; k < 3; ++k)
      sum[k] += static_cast<double>(image.pixels[3 * i + static_cast<std::size_t>(k)]);
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
  return std::min(1.0, luminance(material.diffuse * map) + material.specular);
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
