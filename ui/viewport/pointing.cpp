// SPDX-License-Identifier: MIT
#include "ui/viewport/pointing.h"

#include "ui/document/text.h"
#include "ui/viewport/luminaire_mesh.h"

#include <algorithm>
#include <array>

namespace soffit::ui {
namespace {

constexpr double kSlack = 1e-3;  // a panel lies in its ceiling

/// Points have no surface: near enough on the screen will do, in pixels.
constexpr double kReach = 9.0;

geometry::Ray rayToward(const dvec3& from, const dvec3& direction, const dvec3& origin) {
  geometry::Ray ray;
  ray.origin = vec3(from - origin);
  ray.direction = vec3(direction);
  return ray;
}

geometry::Ray rayBeyondCut(const dvec3& from, const dvec3& direction, const ViewCamera& camera,
                           const dvec3& origin) {
  return rayToward(from + (camera.isParallel() ? camera.cut_depth : 0.0) * direction, direction,
                   origin);
}

bool isCutAway(const Pointable& things, std::size_t luminaire) {
  return luminaire < things.cut_away.size() && things.cut_away[luminaire];
}

/// The rectangle on the screen about a luminaire; empty when part of it is behind the eye.
QRectF screenBounds(const light::Emitter& emitter, const ViewCamera& camera, const dvec2& size,
                    const dvec3& origin) {
  QRectF bounds;
  for (const vec3& p : outlineOf(emitter)) {
    const dvec3 at = camera.project(origin + dvec3(p), size);
    if (at.z <= 0.0) return {};
    const QRectF dot(at.x - 0.5, at.y - 0.5, 1.0, 1.0);
    bounds = bounds.isNull() ? dot : bounds.united(dot);
  }
  return bounds;
}

/// What a flat view sees edge on is a line: whether the mouse is near enough to it.
bool isOnLine(const QRectF& bounds, const dvec2& mouse) {
  if (bounds.isNull() || std::min(bounds.width(), bounds.height()) > kReach) return false;
  const double more = 0.5 * kReach;
  return bounds.adjusted(-more, -more, more, more).contains(mouse.x, mouse.y);
}

}  // namespace

PointedAt pointAt(const Pointable& things, const ViewCamera& camera, const dvec2& size,
                  const dvec2& mouse) {
  PointedAt found;
  if (things.scene == nullptr) return found;
  const dvec3 origin = things.scene->mesh->origin;
  const dvec3 direction = camera.rayThrough(mouse, size);
  const dvec3 eye = camera.rayOrigin(mouse, size);
  geometry::Ray ray = rayToward(eye, direction, origin);
  double depth = 1e30;
  if (things.frame != nullptr) {
    found.surface =
        readSurface(*things.frame, *things.scene, rayBeyondCut(eye, direction, camera, origin));
    if (found.surface) {
      depth = glm::length(found.surface->position - eye);
      found.place = found.surface->position;
      found.hit = true;
    }
  }
  if (things.luminaires == nullptr) return found;
  const EmitterSet& luminaires = *things.luminaires;
  render::EmitterHit hit = luminaires.closest(ray);
  while (hit.valid() && isCutAway(things, static_cast<std::size_t>(hit.emitter))) {
    ray.t_min = hit.t * (1.0F + 1e-5F) + 1e-4F;
    hit = luminaires.closest(ray);
  }
  if (hit.valid() && static_cast<double>(hit.t) <= depth * (1.0 + kSlack) + kSlack) {
    found.luminaire = luminaires.name(static_cast<std::size_t>(hit.emitter));
    found.place = eye + static_cast<double>(hit.t) * direction;
    found.hit = true;
  }
  if (!found.luminaire.empty()) depth = glm::length(found.place - eye);
  for (std::size_t i = 0; i < luminaires.emitters().size(); ++i) {
    const light::Emitter& e = luminaires.emitters()[i];
    const bool point = e.kind == light::EmitterKind::point;
    if ((!point && !camera.isParallel()) || isCutAway(things, i)) continue;
    const dvec3 at = camera.project(origin + e.position, size);
    if (at.z <= 0.0 || at.z > depth + kSlack) continue;
    if (point ? glm::length(dvec2(at) - mouse) > kReach
              : !isOnLine(screenBounds(e, camera, size, origin), mouse))
      continue;
    found.luminaire = luminaires.name(i);
    found.place = origin + e.position;
    found.hit = true;
  }
  return found;
}

QStringList luminairesIn(const Pointable& things, const ViewCamera& camera, const dvec2& size,
                         const QRectF& band) {
  QStringList names;
  if (things.scene == nullptr || things.luminaires == nullptr) return names;
  const dvec3 origin = things.scene->mesh->origin;
  for (std::size_t i = 0; i < things.luminaires->emitters().size(); ++i) {
    const light::Emitter& e = things.luminaires->emitters()[i];
    const QRectF bounds = screenBounds(e, camera, size, origin);
    if (bounds.isNull() || !bounds.intersects(band) || isCutAway(things, i)) continue;
    if (things.frame != nullptr) {
      const dvec3 place = origin + e.position;
      const dvec3 eye = camera.eyeFor(place);
      const double distance = glm::length(place - eye);
      const auto surface = readSurface(*things.frame, *things.scene,
                                       rayBeyondCut(eye, camera.sightTo(place), camera, origin));
      // Its own half may lie in a wall.
      const double own = 0.5 * static_cast<double>(e.bounds.diagonal()) + 0.05;
      if (surface && glm::length(surface->position - eye) < distance - own) continue;
    }
    names.append(toQt(things.luminaires->name(i)));
  }
  return names;
}

bool isSeen(const Pointable& things, const ViewCamera& camera, const dvec3& place) {
  const dvec3 eye = camera.eyeFor(place);
  const double distance = glm::length(place - eye);
  if (camera.isParallel() && distance < camera.cut_depth) return false;
  if (things.scene == nullptr || things.frame == nullptr || distance <= 0.0) return true;
  const dvec3 origin = things.scene->mesh->origin;
  const auto surface = readSurface(*things.frame, *things.scene,
                                   rayBeyondCut(eye, camera.sightTo(place), camera, origin));
  return !surface || glm::length(surface->position - eye) > distance * (1.0 - kSlack) - kSlack;
}

Surroundings surroundingsOf(const scene::Scene& scene, const LightFramePtr& frame,
                            const EmitterSet* luminaires, const QStringList& moving) {
  Surroundings around;
  around.origin = scene.mesh->origin;
  if (frame != nullptr) {
    around.owner = frame->solver;
    around.caster = &frame->solver->scene().caster;
  }
  if (luminaires == nullptr) return around;
  for (std::size_t i = 0; i < luminaires->emitters().size(); ++i) {
    if (moving.contains(toQt(luminaires->name(i)))) continue;
    around.neighbours.push_back(
        {luminaires->name(i), around.origin + luminaires->emitters()[i].position});
  }
  return around;
}

}  // namespace soffit::ui
