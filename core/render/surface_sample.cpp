// SPDX-License-Identifier: MIT
#include "core/render/surface_sample.h"

#include "core/geometry/texture_tangents.h"
#include "core/render/microfacet.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

/// The corners of a triangle and the weights of the hit.
struct Corners {
  uvec3 t;
  vec3 weights;
  template <class T>
  T mix(const std::vector<T>& values) const {
    return weights.x * values[t.x] + weights.y * values[t.y] + weights.z * values[t.z];
  }
};

/// Least cosine between shading normal and eye.
constexpr float kLeastCosine = 0.02F;
/// Vertex normals closer to the face than this are flat: no lifting.
constexpr float kFlatCosine = 0.99999F;

vec3 towardEye(const vec3& normal, const vec3& to_eye) {
  const float cosine = glm::dot(normal, to_eye);
  return cosine >= kLeastCosine ? normal
                                : glm::normalize(normal + (kLeastCosine - cosine) * to_eye);
}

/// Width of the footprint in texels of a map: the surface's metres per uv decide.
float texelWidth(const MipMap& map, const vec3& along_u, const vec3& along_v, float footprint) {
  const vec2 size = map.size();
  const float texel_u = glm::length(along_u) / size.x;
  const float texel_v = glm::length(along_v) / size.y;
  const float texel = std::sqrt(texel_u * texel_v);
  return texel > 0.0F ? footprint / texel : 1.0F;
}

vec3 bumped(const vec3& normal, const vec3& along_u, const vec3& along_v, const vec3& code) {
  const vec3 n = 2.0F * code - 1.0F;
  const vec3 t = along_u - glm::dot(along_u, normal) * normal;
  const vec3 b = along_v - glm::dot(along_v, normal) * normal;
  const float lt = glm::length(t);
  const float lb = glm::length(b);
  if (!(lt > 0.0F && lb > 0.0F)) return normal;
  const vec3 bent = n.x / lt * t + n.y / lb * b + std::max(n.z, 0.05F) * normal;
  return glm::normalize(bent);
}

/// Hanika's lift, outward only; `facing` is the face's normal on the side that is seen.
vec3 lifted(const geometry::Mesh& m, const Corners& c, const vec3& p, const vec3& facing) {
  vec3 offset(0.0F);
  for (int k = 0; k < 3; ++k) {
    const vec3& stored = m.normals[c.t[k]];
    const vec3 n = glm::dot(stored, facing) < 0.0F ? -stored : stored;
    const float below = std::min(0.0F, glm::dot(p - m.positions[c.t[k]], n));
    offset -= c.weights[k] * below * n;
  }
  return p + offset;
}

/// The interpolated vertex normal on the front's side; the front itself where there is none.
vec3 vertexNormal(const geometry::Mesh& m, const Corners& c, const vec3& front) {
  const vec3 mixed = c.mix(m.normals);
  const float length = glm::length(mixed);
  if (!(length > 0.0F)) return front;
  return glm::dot(mixed, front) < 0.0F ? -mixed / length : mixed / length;
}

/// Applies the material's maps to the albedo, to alpha and to the (front) normal.
void applyMaps(const geometry::Mesh& m, const Corners& c, const ViewMaterial& material,
               const SurfaceOptions& options, SurfaceSample& s, vec3& normal) {
  if (m.uvs.empty() || !material.hasMaps()) return;
  const vec2 uv = c.mix(m.uvs);
  vec3 along_u(0.0F);
  vec3 along_v(0.0F);
  const bool known = geometry::textureTangents(m, c.t, along_u, along_v);
  const auto look = [&](const MipMap& map) {
    return map.at(
        uv, known ? texelWidth(map, along_u, along_v, options.texture_share * s.footprint) : 1.0F);
  };
  if (material.diffuse_map) s.albedo *= look(*material.diffuse_map);
  if (material.roughness_map) {
    const float share = look(*material.roughness_map).y;
    s.alpha = std::max(s.alpha * share * share, std::min(s.alpha, kMirrorAlpha));
  }
  if (material.normal_map && known && !options.plain_normals) {
    normal = bumped(normal, along_u, along_v, look(*material.normal_map));
  }
}

/// How far points are drawn toward the eye along their surface, m. Ten times what counts as being
/// on a surface: at the foot of a wall a point must not be on the wall as well, which then would
/// not shade it. What lies between it and the eye is free, so it stays on the open side.
constexpr float kTowardEye = 1e-3F;

/// Never past half the way to the triangle's edge: beyond it the surface may bend, and a point that
/// hovers over the ridge of a flute sees lamps that its ground does not.
vec3 drawnTowardEye(const geometry::Mesh& m, const Corners& c, const vec3& p, const vec3& facing,
                    const vec3& to_eye, float footprint) {
  const vec3 along = to_eye - glm::dot(to_eye, facing) * facing;
  const float length = glm::length(along);
  // Straight from above there is no such direction: less and less toward it.
  const vec3 way = std::min(kTowardEye, 0.5F * footprint) / std::max(length, kLeastCosine) * along;
  const vec3 u = m.positions[c.t.y] - m.positions[c.t.x];
  const vec3 v = m.positions[c.t.z] - m.positions[c.t.x];
  const vec3 n = glm::cross(u, v);
  const float n2 = glm::dot(n, n);
  if (!(n2 > 0.0F)) return p;
  // How the way changes the corners' weights, one of which vanishes on each edge.
  const float du = glm::dot(glm::cross(way, v), n) / n2;
  const float dv = glm::dot(glm::cross(u, way), n) / n2;
  const vec3 change(-du - dv, du, dv);
  float share = 1.0F;
  for (int k = 0; k < 3; ++k) {
    if (change[k] < 0.0F) share = std::min(share, -0.5F * c.weights[k] / change[k]);
  }
  return p + std::max(share, 0.0F) * way;
}

}  // namespace

SurfaceSample sampleSurface(const ViewScene& scene, const geometry::Ray& ray,
                            const geometry::Hit& hit, const SurfaceOptions& options) {
  const geometry::Mesh& m = scene.mesh();
  const Corners c{m.triangles[hit.triangle], {1.0F - hit.u - hit.v, hit.u, hit.v}};
  const ViewMaterial& material = scene.material(hit.triangle);
  const vec3& front = scene.normal(hit.triangle);
  SurfaceSample s;
  s.albedo = material.diffuse;
  s.alpha = material.alpha;
  s.to_eye = -ray.direction;
  s.footprint = options.footprint + options.spread * hit.t;
  s.surface = scene.surface(hit.triangle);
  s.material = scene.materialIndex(hit.triangle);
  const float side = glm::dot(front, s.to_eye) < 0.0F ? -1.0F : 1.0F;
  const vec3 facing = side * front;
  // From the corners rather than along the ray: exact on the triangle at any distance.
  s.point = {c.mix(m.positions), facing, facing, hit.triangle, {hit.u, hit.v}};
  vec3 normal = front;
  if (!m.normals.empty() && !options.plain_normals) {
    normal = vertexNormal(m, c, front);
    if (glm::dot(normal, front) < kFlatCosine) {
      s.point.position = lifted(m, c, s.point.position, facing);
    }
  }
  s.point.position = drawnTowardEye(m, c, s.point.position, facing, s.to_eye, s.footprint);
  applyMaps(m, c, material, options, s, normal);
  if (!options.plain_normals) s.point.shading_normal = towardEye(side * normal, s.to_eye);
  return s;
}

}  // namespace soffit::render
