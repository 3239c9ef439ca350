// SPDX-License-Identifier: MIT
#include "core/reference/surface.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

int wrapped(double x, int size) {
  const double m = std::fmod(x, static_cast<double>(size));
  return std::clamp(static_cast<int>(m < 0.0 ? m + size : m), 0, size - 1);
}

dvec3 pixel(const scene::Image& image, double column, double row) {
  const std::size_t index =
      static_cast<std::size_t>(wrapped(row, image.height)) * static_cast<std::size_t>(image.width) +
      static_cast<std::size_t>(wrapped(column, image.width));
  const float* p = &image.pixels[index * static_cast<std::size_t>(image.channels)];
  return image.channels >= 3 ? dvec3(p[0], p[1], p[2]) : dvec3(p[0]);
}

dvec2 uvAt(const geometry::Mesh& mesh, const uvec3& t, const dvec3& barycentric) {
  return barycentric.x * dvec2(mesh.uvs[t.x]) + barycentric.y * dvec2(mesh.uvs[t.y]) +
         barycentric.z * dvec2(mesh.uvs[t.z]);
}

dvec3 diffuseAt(const geometry::Mesh& mesh, const scene::Material& material, const uvec3& t,
                const dvec3& barycentric) {
  if (material.diffuse_image == nullptr || mesh.uvs.empty()) return material.diffuse;
  const dvec3 share = lookUp(*material.diffuse_image, uvAt(mesh, t, barycentric));
  return material.diffuse * glm::clamp(share, 0.0, 1.0);
}

double roughnessAt(const geometry::Mesh& mesh, const scene::Material& material, const uvec3& t,
                   const dvec3& barycentric) {
  if (material.roughness_image == nullptr || mesh.uvs.empty()) return material.roughness;
  const dvec3 share = lookUp(*material.roughness_image, uvAt(mesh, t, barycentric));
  return material.roughness * std::clamp(share.y, 0.0, 1.0);
}

const scene::Material& materialOf(const geometry::Mesh& mesh,
                                  std::span<const scene::Material> materials,
                                  std::uint32_t triangle) {
  static const scene::Material kDefault;
  if (triangle >= mesh.material_of.size()) return kDefault;
  const std::uint32_t index = mesh.material_of[triangle];
  return index < materials.size() ? materials[index] : kDefault;
}

}  // namespace

dvec3 lookUp(const scene::Image& image, const dvec2& uv) {
  if (image.pixels.empty() || !std::isfinite(uv.x) || !std::isfinite(uv.y)) return dvec3(1.0);
  const double x = uv.x * image.width - 0.5;
  const double y = (1.0 - uv.y) * image.height - 0.5;  // row 0 is the upper edge
  const double x0 = std::floor(x);
  const double y0 = std::floor(y);
  const double fx = x - x0;
  const double fy = y - y0;
  return (1.0 - fy) * ((1.0 - fx) * pixel(image, x0, y0) + fx * pixel(image, x0 + 1.0, y0)) +
         fy * ((1.0 - fx) * pixel(image, x0, y0 + 1.0) + fx * pixel(image, x0 + 1.0, y0 + 1.0));
}

SurfacePoint surfaceAt(const geometry::Mesh& mesh, std::span<const scene::Material> materials,
                       const geometry::Hit& hit, const dvec3& direction) {
  const uvec3& t = mesh.triangles[hit.triangle];
  const dvec3 a(mesh.positions[t.x]);
  const dvec3 b(mesh.positions[t.y]);
  const dvec3 c(mesh.positions[t.z]);
  const dvec3 barycentric(1.0 - hit.u - hit.v, hit.u, hit.v);
  SurfacePoint out;
  out.position = barycentric.x * a + barycentric.y * b + barycentric.z * c;
  const dvec3 n = glm::normalize(glm::cross(b - a, c - a));
  out.bsdf.normal = glm::dot(n, direction) > 0.0 ? -n : n;
  const scene::Material& material = materialOf(mesh, materials, hit.triangle);
  if (material.glass) return out;  // a window at night: neither reflects nor lets through
  out.bsdf.diffuse = diffuseAt(mesh, material, t, barycentric);
  out.bsdf.specular = material.specular;
  const double roughness = roughnessAt(mesh, material, t, barycentric);
  out.bsdf.alpha = roughness * roughness;
  return out;
}

}  // namespace soffit::reference
