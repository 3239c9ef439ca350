// SPDX-License-Identifier: MIT
#include "core/reference/tracer.h"

#include "core/reference/sequence.h"
#include "core/reference/surface.h"

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

/// Vertices whose random numbers come from the stratified sequence: the sensor alone. More were
/// tried; the error did not fall.
constexpr std::uint32_t kStratifiedDepth = 1;

/// The first two reflections are never cut short; then by the albedo, at most this. Of the starts
/// 1, 2 and 3 the last had the least error for its time.
constexpr std::uint32_t kFullReflections = 2;
constexpr double kSurvivalLimit = 0.97;

/// Random numbers of one vertex come in sets of three.
enum Group : std::uint32_t { kDirection = 0, kLight = 1, kSky = 2, kSun = 3, kGroupsPerVertex = 4 };

geometry::Ray toRay(const dvec3& origin, const dvec3& direction) {
  geometry::Ray ray;
  ray.origin = vec3(origin);
  ray.direction = vec3(direction);
  return ray;
}

/// How far a point on an emitter is lifted off it, so that a luminaire flush with a surface is
/// not hidden by that surface.
double liftAt(const dvec3& point) {
  const vec3 p(point);
  return glm::length(dvec3(geometry::offsetOrigin(p, vec3(0, 0, 1)) - p));
}

/// cd/m² per projected receiver: what an element of the surface sends from `point` to y.
dvec3 emission(const light::Emitter& e, const dvec3& normal, const dvec3& toward) {
  return e.gain * e.intensityPerArea(normal, toward) * e.color;
}

}  // namespace

Tracer::Tracer(const ReferenceScene& scene, const dvec3& origin, const Response& response)
    : scene_(scene), origin_(vec3(origin)), response_(response) {
  sensor_choice_.prepare(scene.lights(), origin_, response.horizon());
}

Tracer::Tracer(const ReferenceScene& scene, const Beam& beam)
    : scene_(scene),
      origin_(vec3(beam.origin)),
      response_(Quantity::spherical, dvec3(0.0, 0.0, 1.0)),
      beam_(beam) {}

dvec3 Tracer::draw(std::uint32_t path, std::uint32_t vertex, std::uint32_t group) {
  if (vertex < kStratifiedDepth) {
    const std::uint64_t key = seed_ + kGroupsPerVertex * vertex + group;
    return sobolPoint(path, static_cast<std::uint32_t>(mixBits(key)));
  }
  const double x = rng_.uniformDouble();
  const double y = rng_.uniformDouble();
  return {x, y, rng_.uniformDouble()};
}

Tally Tracer::run(std::uint32_t paths, std::uint64_t seed) {
  seed_ = mixBits(seed + 0x9e3779b97f4a7c15ULL);
  rng_ = Rng(seed_, mixBits(seed_));
  sums_.fill(dvec3(0.0));
  ray_count_ = 0;
  depth_ = 0;
  start(paths);
  while (!paths_.empty() || !shadows_.empty() || !sky_shadows_.empty()) {
    traceShadows();
    if (scene_.sky() != nullptr) traceSkyShadows();
    traceRays();
    paths_.swap(next_);
    ++depth_;
  }
  for (dvec3& sum : sums_) sum /= double(paths);
  return {sums_[0], sums_[1] + sums_[2], sums_[1], ray_count_};
}

void Tracer::start(std::uint32_t paths) {
  paths_.clear();
  shadows_.clear();
  sky_shadows_.clear();
  if (beam_) {
    startBeam(paths);
    return;
  }
  for (std::uint32_t i = 0; i < paths; ++i) {
    const dvec3 u = draw(i, 0, kDirection);
    const dvec3 w = response_.sample({u.x, u.y});
    const double density = response_.density(w);
    if (density > 0.0) {
      paths_.push_back(
          {i, origin_, response_.horizon(), w, dvec3(response_.weight(w) / density), density});
    }
    sendShadow(origin_, sensor_choice_, draw(i, 0, kLight), nullptr, dvec3(0.0), dvec3(1.0));
    if (scene_.sky() != nullptr) {
      sendSky(origin_, draw(i, 0, kSky), draw(i, 0, kSun), nullptr, dvec3(0.0), dvec3(1.0));
    }
  }
}

void Tracer::startBeam(std::uint32_t paths) {
  const auto tent = [](double u) {
    return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * u);
  };
  for (std::uint32_t i = 0; i < paths; ++i) {
    const dvec3 u = draw(i, 0, kDirection);
    const dvec3 w =
        glm::normalize(beam_->direction + tent(u.x) * beam_->across + tent(u.y) * beam_->up);
    // Density 0, as after a mirror: no light is aimed at along a line.
    paths_.push_back({i, origin_, dvec3(0.0), w, dvec3(1.0), 0.0});
  }
}

void Tracer::sendShadow(const dvec3& y, const LightChoice& choice, const dvec3& u, const Bsdf* bsdf,
                        const dvec3& wo, const dvec3& beta) {
  const LightChoice::Picked picked = choice.pick(u.z);
  if (!(picked.probability > 0.0)) return;
  const LightShape& light = scene_.lights()[picked.light];
  const LightPoint sampled = sampleLight(light, y, {u.x, u.y});
  if (!(sampled.density > 0.0)) return;
  const dvec3 to = sampled.point - y;
  const double distance_squared = glm::dot(to, to);
  if (!(distance_squared > 0.0)) return;
  const dvec3 wi = to / std::sqrt(distance_squared);
  const dvec3 response = bsdf != nullptr
                             ? evaluate(*bsdf, wo, wi) * std::max(0.0, glm::dot(bsdf->normal, wi))
                             : dvec3(response_.weight(wi));
  if (response == dvec3(0.0)) return;
  const light::Emitter& e = light.emitter();
  double density_sum = picked.probability * sampled.density;
  dvec3 sent(0.0);
  if (e.kind == light::EmitterKind::point) {
    sent = e.gain * e.pointIntensity(-wi) * e.color;
  } else {
    sent = emission(e, sampled.normal, -wi);
    const double followed = bsdf != nullptr ? density(*bsdf, wo, wi) : response_.density(wi);
    density_sum += followed * std::abs(glm::dot(sampled.normal, wi)) / distance_squared;
  }
  if (sent == dvec3(0.0)) return;
  shadows_.push_back({y, sampled.point, sampled.normal, static_cast<std::uint32_t>(picked.light),
                      beta * response * sent / (distance_squared * density_sum)});
}

bool Tracer::bodyBetween(const Shadow& shadow) const {
  const dvec3 to = shadow.point - shadow.origin;
  const double distance = glm::length(to);
  const Line line{shadow.origin, to / distance};
  const auto lights = scene_.lights();
  for (const std::uint32_t body : scene_.bodies()) {
    if (body != shadow.light && lights[body].bodyDistance(line, distance) < distance) return true;
  }
  return lights[shadow.light].shadesItself(shadow.origin, shadow.point, shadow.normal);
}

void Tracer::traceShadows() {
  rays_.clear();
  for (const Shadow& s : shadows_) {
    const dvec3 back = s.origin - s.point;
    const bool is_point = s.normal == dvec3(0.0);
    const dvec3 lift = is_point                         ? glm::normalize(back)
                       : glm::dot(back, s.normal) < 0.0 ? -s.normal
                                                        : s.normal;
    const dvec3 target = s.point + liftAt(s.point) * lift;
    rays_.push_back(toRay(s.origin, target - s.origin));
    rays_.back().t_max = 1.0F;
  }
  blocked_.resize(rays_.size());
  scene_.caster().occluded(rays_, blocked_);
  ray_count_ += rays_.size();
  share_.assign(rays_.size(), 1.0F);
  if (scene_.panes() != nullptr) {
    for (std::size_t i = 0; i < rays_.size(); ++i) share_[i] = blocked_[i] == 0 ? 1.0F : 0.0F;
    scene_.panes()->attenuate(rays_, share_);
  }
  for (std::size_t i = 0; i < shadows_.size(); ++i) {
    if (blocked_[i] == 0 && !bodyBetween(shadows_[i])) {
      bin() += double(share_[i]) * shadows_[i].light_sent;
    }
  }
  shadows_.clear();
}

void Tracer::traceRays() {
  next_.clear();
  while (!paths_.empty()) {
    rays_.clear();
    mirrored_.clear();
    for (const Path& path : paths_) rays_.push_back(toRay(path.origin, path.direction));
    hits_.resize(rays_.size());
    scene_.caster().closest(rays_, hits_);
    ray_count_ += rays_.size();
    for (std::size_t i = 0; i < paths_.size(); ++i) follow(paths_[i], hits_[i]);
    paths_.swap(mirrored_);
  }
}

void Tracer::follow(const Path& path, const geometry::Hit& hit) {
  const double t_surface = hit.valid() ? hit.t : kInfinity;
  const NearestBodies bodies = nearestBodies(path, t_surface);
  panes_.clear();
  if (scene_.panes() != nullptr) crossPanes(path, std::min(t_surface, bodies.t));
  gatherEmission(path, t_surface, bodies);
  if (bodies.t < kInfinity) return;  // bodies are black
  if (hit.valid()) {
    reflect(path, hit);
  } else if (scene_.sky() != nullptr) {
    gatherSky(path);
  }
}

Tracer::NearestBodies Tracer::nearestBodies(const Path& path, double t_surface) const {
  NearestBodies out;
  if (scene_.bodies().empty()) return out;
  // A body that is flush with a surface hides it.
  const double t_reach =
      t_surface + 2.0 * liftAt(path.origin + std::min(t_surface, 1e6) * path.direction);
  for (const std::uint32_t body : scene_.bodies()) {
    const double t = scene_.lights()[body].bodyDistance({path.origin, path.direction}, t_reach);
    if (t < out.t) {
      out = {.light = body, .t = t, .t_second = out.t};
    } else {
      out.t_second = std::min(out.t_second, t);
    }
  }
  return out;
}

void Tracer::gatherEmission(const Path& path, double t_surface, const NearestBodies& bodies) {
  const auto lights = scene_.lights();
  for (std::size_t l = 0; l < lights.size(); ++l) {
    const light::Emitter& e = lights[l].emitter();
    if (e.kind == light::EmitterKind::point || !(e.gain > 0.0)) continue;
    crossings_.clear();
    // A luminaire's own body does not hide its light (a mesh hides what is behind its first
    // crossing by itself).
    const double t_hidden = l == bodies.light ? bodies.t_second : bodies.t;
    lights[l].cross({path.origin, path.direction}, t_hidden, crossings_);
    for (const Crossing& c : crossings_) {
      const double cosine = std::abs(glm::dot(c.normal, path.direction));
      if (cosine < 1e-9) continue;
      const double lift = liftAt(path.origin + c.t * path.direction) / cosine;
      if (t_surface >= c.t - lift) gatherCrossing(path, l, c);
    }
  }
}

void Tracer::gatherCrossing(const Path& path, std::size_t light, const Crossing& c) {
  const LightShape& shape = scene_.lights()[light];
  const dvec3 sent = emission(shape.emitter(), c.normal, -path.direction);
  if (sent == dvec3(0.0)) return;
  const double cosine = std::abs(glm::dot(c.normal, path.direction));
  const dvec3 beta = path.beta * throughPanes(c.t);
  if (!(path.density > 0.0)) {
    binOf(path) += beta * sent / cosine;
    return;
  }
  double probability = 0.0;
  if (depth_ == 0) {
    probability = sensor_choice_.probability(light);
  } else {
    choice_.prepare(scene_.lights(), path.origin, path.normal);
    probability = choice_.probability(light);
  }
  const dvec3 point = path.origin + c.t * path.direction;
  const double chosen = probability * lightDensity(shape, path.origin, point, c.normal);
  const double distance_squared = c.t * c.t;
  const double followed = path.density * cosine / distance_squared;
  binOf(path) += beta * sent * (path.density / (distance_squared * (followed + chosen)));
}

void Tracer::reflect(const Path& path, const geometry::Hit& hit) {
  const std::uint32_t vertex = depth_ + 1;
  const SurfacePoint surface = surfaceAt(scene_.mesh(), scene_.materials(), hit, path.direction);
  const Bsdf& bsdf = surface.bsdf;
  const dvec3 wo = -path.direction;
  const dvec3 rough = albedo(bsdf, wo);
  const double brightest = std::max({rough.x, rough.y, rough.z});
  if (!(brightest > 0.0)) return;
  const dvec3 y(geometry::offsetOrigin(vec3(surface.position), vec3(bsdf.normal)));
  choice_.prepare(scene_.lights(), y, bsdf.normal);
  const dvec3 beta = path.beta * throughPanes(hit.t);
  sendShadow(y, choice_, draw(path.index, vertex, kLight), &bsdf, wo, beta);
  if (scene_.sky() != nullptr) {
    const dvec3 u_sky = draw(path.index, vertex, kSky);
    sendSky(y, u_sky, draw(path.index, vertex, kSun), &bsdf, wo, beta);
  }

  double survival = 1.0;
  if (vertex > kFullReflections) {
    survival = std::min(brightest, kSurvivalLimit);
    if (rng_.uniformDouble() >= survival) return;
  }
  const BsdfSample next = sample(bsdf, wo, draw(path.index, vertex, kDirection));
  if (next.weight == dvec3(0.0)) return;
  next_.push_back(
      {path.index, y, bsdf.normal, next.direction, beta * next.weight / survival, next.density});
}

}  // namespace soffit::reference
