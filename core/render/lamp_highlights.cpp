// SPDX-License-Identifier: MIT
#include "core/render/lamp_highlights.h"

#include "core/color/luminance.h"
#include "core/glossy/lobe_shape.h"
#include "core/glossy/ltc_light.h"
#include "core/math/sampling.h"
#include "core/render/light_aim.h"
#include "core/render/microfacet.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace soffit::render {
namespace {

/// The lobe at a point.
struct Lobe {
  const SurfaceSample& at;
  float f0, alpha;
  mat3 local{1.0F};  ///< rows: tangents and normal

  Lobe(const SurfaceSample& sample, float f, float a) : at(sample), f0(f), alpha(a) {
    vec3 t(0.0F), b(0.0F);
    orthonormalBasis(at.point.shading_normal, t, b);
    local = glm::transpose(mat3(t, b, at.point.shading_normal));
  }
  [[nodiscard]] float toward(const vec3& wi) const {
    return ggxReflection(local * at.to_eye, local * wi, f0, alpha);
  }
};

/// Share of a luminaire's highlight that is not hidden, by the same samples above and below (a
/// ratio estimator: Heitz, Hill & McGuire 2018); plainly of the luminaire where the lobe misses
/// them all.
float unhidden(const ViewScene& scene, std::size_t e, const Lobe& lobe, int rays) {
  const vec3& normal = lobe.at.point.normal;
  const vec3 origin = geometry::offsetOrigin(lobe.at.point.position, normal);
  float reached = 0.0F;
  float weights = 0.0F;
  for (int k = 0; k < rays; ++k) {
    const dvec2 u = r2Sequence(static_cast<std::uint32_t>(k));
    const LightAim aim = aimAt(scene.emitters()[e], dvec3(origin), vec2(u));
    const vec3 wi(aim.direction);
    if (!(aim.distance > 0.0) || glm::dot(wi, normal) <= 0.0F) continue;
    // Points by area; each stands for the solid angle that its piece covers.
    const float piece = aim.pdf > 0.0 ? static_cast<float>(1.0 / aim.pdf) : 1.0F;
    const float weight = piece * std::max(lobe.toward(wi), 1.0e-12F);
    weights += weight;
    const geometry::Ray ray{origin, 0.0F, wi,
                            static_cast<float>(aim.distance * (1.0 - 1.0e-4) - 5.0e-4)};
    if (scene.emitterHits().blocked(ray, static_cast<int>(e))) continue;
    if (scene.caster().occluded(ray)) continue;
    float through = 1.0F;
    if (scene.panes() != nullptr) {
      scene.panes()->attenuate(std::span(&ray, 1), std::span(&through, 1));
    }
    reached += weight * through;
  }
  return weights > 0.0F ? reached / weights : 0.0F;
}

dvec3 middleOf(const light::Emitter& emitter) {
  return emitter.bounds.empty() ? emitter.position : dvec3(emitter.bounds.center());
}

float fresnelToward(const SurfaceSample& at, const dvec3& place, float f0) {
  const vec3 wi = glm::normalize(vec3(place) - at.point.position);
  const vec3 both = wi + at.to_eye;
  const float length = glm::length(both);
  return length > 0.0F ? schlick(f0, glm::dot(wi, both) / length) : 1.0F;
}

/// Luminance toward p as the luminaire's middle shows it.
vec3 luminanceToward(const ViewScene& scene, std::size_t e, const dvec3& p) {
  const light::Emitter& emitter = scene.emitters()[e];
  const dvec3 to = glm::normalize(p - middleOf(emitter));
  dvec3 normal = to;  // round shapes and meshes: the side that faces p
  if (emitter.kind == light::EmitterKind::planar) normal = emitter.normal;
  return scene.emitted(static_cast<int>(e), vec3(normal), vec3(to));
}

}  // namespace

vec3 lampHighlights(const ViewScene& scene, const SurfaceSample& at, float f0, float alpha,
                    const HighlightOptions& options) {
  if (alpha < kMirrorAlpha || f0 <= 0.0F) return vec3(0.0F);
  const SurfacePoint& point = at.point;
  const dvec3 p(point.position);
  const dvec3 normal(point.shading_normal);
  const dvec3 eye(at.to_eye);
  const double cosine = glm::dot(normal, eye);
  if (cosine <= 0.0) return vec3(0.0F);
  const Lobe lobe(at, f0, alpha);
  const glossy::LobeShape shape = glossy::lobeShape(cosine, static_cast<double>(alpha));
  const auto whole = static_cast<float>(shape.scale + shape.bias);  // with F = 1, as is fitted
  std::optional<glossy::LobeFrame> frame;
  vec3 sum(0.0F);
  for (std::size_t e = 0; e < scene.emitters().size(); ++e) {
    const light::Emitter& emitter = scene.emitters()[e];
    if (emitter.gain <= 0.0) continue;
    vec3 carried(0.0F);
    if (emitter.kind == light::EmitterKind::point) {
      const LightAim aim = aimAt(emitter, p, vec2(0.5F));
      if (!(aim.distance > 0.0)) continue;
      carried = aim.intensity * lobe.toward(vec3(aim.direction));
    } else {
      if (!frame) frame.emplace(p, normal, eye, static_cast<double>(alpha));
      double share = 0.0;
      for (const auto& outline : glossy::facingOutlines(emitter, p)) share += frame->share(outline);
      if (!(share > 0.0)) continue;
      // Fresnel's term of the luminaire's middle: over a lobe it may vary tenfold, over a lamp not.
      const float fresnel = fresnelToward(at, middleOf(emitter), f0);
      carried = luminanceToward(scene, e, p) * (fresnel * whole * static_cast<float>(share));
    }
    if (color::luminance(carried) < options.least_radiance) continue;
    sum += carried * unhidden(scene, e, lobe, options.shadow_rays);
  }
  return sum;
}

}  // namespace soffit::render
