// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/rng.h"
#include "core/reference/bsdf.h"
#include "core/reference/light_choice.h"
#include "core/reference/light_sampling.h"
#include "core/reference/quantity.h"
#include "core/reference/reference_scene.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace soffit::reference {

/// Means over a set of paths, RGB lux, and the rays that they took.
struct Tally {
  dvec3 direct{0.0};    ///< without reflection
  dvec3 indirect{0.0};  ///< after at least one
  dvec3 once{0.0};      ///< of that, after one alone
  std::uint64_t rays = 0;
};

/// A line of sight, for radiance instead of illuminance: what an eye sees of surfaces.
struct Beam {
  dvec3 origin{0.0};
  dvec3 direction{1.0, 0.0, 0.0};  ///< unit, from the eye
  /// Directions are drawn about it as direction + a across + b up with tent-shaped densities of a
  /// and b over [-1, 1]: a pixel of a reconstruction filter (core/render). Zero: the line alone.
  dvec3 across{0.0}, up{0.0};
};

/// Traces paths backwards from one sensor, many at a time (rays of one bounce in one packet run).
///
/// At every vertex one luminaire is chosen and sampled; the next ray counts the luminaires that it
/// crosses as well. Both are weighted by the balance heuristic over area densities: an emitting
/// surface that is met with density p_a by choosing points and p_b by following the surface's (or
/// the sensor's) own directions contributes f I cos / (d^2 (p_a + p_b)) either way, so that
/// neither a near emitter nor a sharp reflection gives rare bright samples. Mirrors follow the ray
/// alone. The surroundings and the sun's disc get a sample each at every vertex, weighted against
/// the rays that escape in the same way, per steradian. Sheets of glass dim what passes them; what
/// they mirror goes on as a ray of its own with the probability of their reflectance, weighted by
/// nothing else: the sun's disc is left out there (glints), and so are point sources. Russian
/// roulette by the albedo from the third bounce on; no bound on the bounces.
class Tracer {
 public:
  /// origin: where rays start (placeSensors()). The scene must outlive the tracer.
  Tracer(const ReferenceScene& scene, const dvec3& origin, const Response& response);

  /// For a beam (relative to the mesh's origin). The tally is radiance, cd/m2: `direct` of
  /// luminaires and surroundings that are looked at, `indirect` of surfaces.
  Tracer(const ReferenceScene& scene, const Beam& beam);

  /// The mean of `paths` paths; best a power of two. The same seed gives the same paths, different
  /// seeds independent ones.
  Tally run(std::uint32_t paths, std::uint64_t seed);

 private:
  struct Path {
    std::uint32_t index;
    dvec3 origin;     ///< of the next ray: the last vertex
    dvec3 normal;     ///< there; the zero vector for sensors without a horizon
    dvec3 direction;  ///< of the next ray, unit
    dvec3 beta;       ///< what radiance along the ray is multiplied by
    double density;   ///< of the direction, per steradian; 0: mirror
    int sheets = 0;   ///< of glass that have mirrored it since the last vertex
  };
  struct Shadow {
    dvec3 origin;
    dvec3 point;
    dvec3 normal;
    std::uint32_t light;
    dvec3 light_sent;  ///< what arrives if nothing is in the way
  };

  struct SkyShadow {
    dvec3 origin;
    dvec3 direction;
    dvec3 light_sent;  ///< what arrives if nothing is in the way
  };

  /// Black bodies along a ray: whose is nearest, and the distance to the next one of another.
  struct NearestBodies {
    std::size_t light = ~std::size_t{0};
    double t = kInfinity;
    double t_second = kInfinity;
  };

  void start(std::uint32_t paths);
  void startBeam(std::uint32_t paths);
  void traceShadows();
  void traceSkyShadows();
  void traceRays();
  void follow(const Path& path, const geometry::Hit& hit);
  /// The sheets on a path before t_end; spawns what they mirror.
  void crossPanes(const Path& path, double t_end);
  /// Share of light that comes through the sheets nearer than t.
  [[nodiscard]] double throughPanes(double t) const;
  [[nodiscard]] NearestBodies nearestBodies(const Path& path, double t_surface) const;
  void gatherEmission(const Path& path, double t_surface, const NearestBodies& bodies);
  void gatherCrossing(const Path& path, std::size_t light, const Crossing& crossing);
  void gatherSky(const Path& path);
  void reflect(const Path& path, const geometry::Hit& hit);
  void sendSky(const dvec3& y, const dvec3& u_sky, const dvec3& u_sun, const Bsdf* bsdf,
               const dvec3& wo, const dvec3& beta);
  void sendShadow(const dvec3& y, const LightChoice& choice, const dvec3& u, const Bsdf* bsdf,
                  const dvec3& wo, const dvec3& beta);
  [[nodiscard]] bool bodyBetween(const Shadow& shadow) const;
  [[nodiscard]] dvec3 draw(std::uint32_t path, std::uint32_t vertex, std::uint32_t group);
  [[nodiscard]] dvec3& bin() { return sums_[std::min<std::size_t>(depth_, sums_.size() - 1)]; }
  /// For what a ray meets: light mirrored by glass is indirect.
  [[nodiscard]] dvec3& binOf(const Path& path) { return path.sheets > 0 ? sums_.back() : bin(); }

  const ReferenceScene& scene_;
  dvec3 origin_;
  Response response_;
  std::optional<Beam> beam_;  ///< then the response does not matter
  LightChoice sensor_choice_;
  LightChoice choice_;
  std::vector<Path> paths_;
  std::vector<Path> next_;
  std::vector<Path> mirrored_;
  std::vector<Shadow> shadows_;
  std::vector<SkyShadow> sky_shadows_;
  std::vector<daylight::PaneCrossing> panes_;  ///< on the path at hand
  std::vector<float> share_;
  std::vector<geometry::Ray> rays_;
  std::vector<geometry::Hit> hits_;
  std::vector<std::uint8_t> blocked_;
  std::vector<Crossing> crossings_;
  Rng rng_{0};
  std::uint64_t seed_ = 0;
  std::uint32_t depth_ = 0;      ///< reflections so far
  std::array<dvec3, 3> sums_{};  ///< without reflection, after one, after more
  std::uint64_t ray_count_ = 0;
};

}  // namespace soffit::reference
