// SPDX-License-Identifier: MIT
#include "core/prt/material_maps.h"

#include "core/geometry/texture_tangents.h"

#include <algorithm>
#include <cmath>

namespace soffit::prt {
namespace {

std::size_t wrapped(float x, int n) {
  const int i = static_cast<int>(x) % n;
  return static_cast<std::size_t>(i < 0 ? i + n : i);
}

vec3 bilinear(const scene::Image& image, const vec2& uv) {
  const auto width = static_cast<std::size_t>(image.width);
  const float x = (uv.x - std::floor(uv.x)) * static_cast<float>(image.width) - 0.5F;
  const float y = (1.0F - (uv.y - std::floor(uv.y))) * static_cast<float>(image.height) - 0.5F;
  const float fx = std::floor(x);
  const float fy = std::floor(y);
  const auto pixel = [&](float i, float j) {
    const std::size_t at = 3 * (wrapped(j, image.height) * width + wrapped(i, image.width));
    return vec3(image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]);
  };
  return glm::mix(glm::mix(pixel(fx, fy), pixel(fx + 1, fy), x - fx),
                  glm::mix(pixel(fx, fy + 1), pixel(fx + 1, fy + 1), x - fx), y - fy);
}

vec2 uvAt(const geometry::Mesh& mesh, const MapPlace& p) {
  const uvec3& t = mesh.triangles[p.triangle];
  return (1.0F - p.u - p.v) * mesh.uvs[t.x] + p.u * mesh.uvs[t.y] + p.v * mesh.uvs[t.z];
}

/// Mean of a map over the place; `flat` where there are no texture coordinates.
vec3 lookAt(const Surfaces& s, const scene::Image& image, const MapPlace& p, const vec3& flat) {
  const geometry::Mesh& mesh = *s.mesh;
  if (mesh.uvs.empty() || image.pixels.empty() || image.channels != 3) return flat;
  vec3 u, v;
  vec2 width(0.0F);
  if (geometry::textureTangents(mesh, mesh.triangles[p.triangle], u, v)) {
    width = p.width / vec2(glm::length(u), glm::length(v));
  }
  return meanOf(image, uvAt(mesh, p), width);
}

vec3 bent(const vec3& normal, const vec3& along_u, const vec3& along_v, const vec3& code) {
  const vec3 n = 2.0F * code - 1.0F;
  const vec3 t = along_u - glm::dot(along_u, normal) * normal;
  const vec3 b = along_v - glm::dot(along_v, normal) * normal;
  const float lt = glm::length(t);
  const float lb = glm::length(b);
  if (!(lt > 0.0F && lb > 0.0F)) return normal;
  return glm::normalize(n.x / lt * t + n.y / lb * b + std::max(n.z, 0.05F) * normal);
}

}  // namespace

vec3 meanOf(const scene::Image& image, const vec2& uv, const vec2& width) {
  const vec2 place = std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : vec2(0.0F);
  const vec2 pixels = glm::abs(width) * vec2(image.width, image.height);
  const auto looks = [](float n) {
    return std::isfinite(n) ? std::clamp(static_cast<int>(std::ceil(n)), 1, 8) : 1;
  };
  const int nx = looks(pixels.x);
  const int ny = looks(pixels.y);
  vec3 sum(0.0F);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const vec2 at((static_cast<float>(i) + 0.5F) / static_cast<float>(nx) - 0.5F,
                    (static_cast<float>(j) + 0.5F) / static_cast<float>(ny) - 0.5F);
      sum += bilinear(image, nx * ny == 1 ? place : place + at * width);
    }
  }
  return sum / static_cast<float>(nx * ny);
}

vec3 reflectanceAt(const Surfaces& s, const MapPlace& place) {
  const scene::Material& material = s.material(place.triangle);
  const vec3 albedo(material.diffuse);
  if (material.diffuse_image == nullptr) return albedo;
  return albedo * glm::clamp(lookAt(s, *material.diffuse_image, place, vec3(1.0F)), 0.0F, 1.0F);
}

vec3 shadingNormalAt(const Surfaces& s, const MapPlace& p) {
  const vec3* corners = &s.corner_normals[3 * std::size_t{p.triangle}];
  const vec3 mixed = (1.0F - p.u - p.v) * corners[0] + p.u * corners[1] + p.v * corners[2];
  const float length = glm::length(mixed);
  const vec3 normal = length > 0.0F ? mixed / length : s.normals[p.triangle];
  const scene::Material& material = s.material(p.triangle);
  vec3 u, v;
  if (material.normal_image == nullptr || s.mesh->uvs.empty() ||
      !geometry::textureTangents(*s.mesh, s.mesh->triangles[p.triangle], u, v)) {
    return normal;
  }
  return bent(normal, u, v, lookAt(s, *material.normal_image, p, vec3(0.5F, 0.5F, 1.0F)));
}

}  // namespace soffit::prt
