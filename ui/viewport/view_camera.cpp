// SPDX-License-Identifier: MIT
#include "ui/viewport/view_camera.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

/// Sine of the steepest pitch, about 89 degrees.
constexpr double kSteepest = 0.99985;
/// Looks along z itself: a plan, whose right is x.
constexpr double kVertical = 1.0 - 1e-12;
/// What a parallel view can show, m from bottom to top.
constexpr double kLeastHeight = 0.02;
constexpr double kMostHeight = 2e4;
/// Air about a box that fills a parallel picture.
constexpr double kAir = 1.08;
const dvec3 kUp(0.0, 0.0, 1.0);

dvec3 turned(const dvec3& v, const dvec3& axis, double angle) {
  const double c = std::cos(angle);
  return v * c + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1.0 - c));
}

/// Tilted away from the pole when too near to it.
dvec3 upright(const dvec3& direction) {
  if (std::abs(direction.z) <= kSteepest) return direction;
  dvec2 flat(direction);
  flat = glm::length(flat) > 1e-12 ? glm::normalize(flat) : dvec2(0.0, 1.0);
  const double z = std::copysign(kSteepest, direction.z);
  return dvec3(flat * std::sqrt(1.0 - z * z), z);
}

}  // namespace

ViewCamera ViewCamera::from(const scene::Camera& camera) {
  ViewCamera view;
  view.position = camera.position;
  view.forward = upright(glm::normalize(camera.target - camera.position));
  view.vertical_fov = glm::radians(camera.vertical_fov_deg);
  return view;
}

scene::Camera ViewCamera::toScene(const std::string& name, double distance) const {
  return {name, position, position + distance * forward, glm::degrees(vertical_fov)};
}

dvec3 ViewCamera::right() const {
  if (std::abs(forward.z) > kVertical) return {1.0, 0.0, 0.0};
  return glm::normalize(glm::cross(forward, kUp));
}

dvec3 ViewCamera::up() const {
  return glm::cross(right(), forward);
}

dvec3 ViewCamera::rayThrough(const dvec2& pixel, const dvec2& size) const {
  if (isParallel()) return forward;
  const double half = std::tan(0.5 * vertical_fov);
  const double x = (2.0 * pixel.x - size.x) / size.y * half;
  const double y = (1.0 - 2.0 * pixel.y / size.y) * half;
  return glm::normalize(forward + x * right() + y * up());
}

dvec3 ViewCamera::rayOrigin(const dvec2& pixel, const dvec2& size) const {
  if (!isParallel()) return position;
  const dvec2 off = pixelSize(0.0, size) * (pixel - 0.5 * size);
  return position + off.x * right() - off.y * up();
}

dvec3 ViewCamera::eyeFor(const dvec3& point) const {
  return isParallel() ? point - glm::dot(point - position, forward) * forward : position;
}

dvec3 ViewCamera::sightTo(const dvec3& point) const {
  return isParallel() ? forward : glm::normalize(point - position);
}

dvec3 ViewCamera::project(const dvec3& point, const dvec2& size) const {
  const dvec3 d = point - position;
  const double depth = glm::dot(d, forward);
  const double scale = 1.0 / pixelSize(depth, size);
  return {0.5 * size.x + glm::dot(d, right()) * scale, 0.5 * size.y - glm::dot(d, up()) * scale,
          depth};
}

double ViewCamera::pixelSize(double depth, const dvec2& size) const {
  if (isParallel()) return parallel_height / size.y;
  return 2.0 * std::tan(0.5 * vertical_fov) * depth / size.y;
}

void ViewCamera::orbit(const dvec3& pivot, double yaw, double pitch) {
  const double now = std::asin(std::clamp(forward.z, -1.0, 1.0));
  const double limit = std::asin(kSteepest);
  pitch = std::clamp(now + pitch, -limit, limit) - now;
  const dvec3 axis = right();
  const auto turn = [&](const dvec3& v) { return turned(turned(v, axis, pitch), kUp, yaw); };
  position = pivot + turn(position - pivot);
  forward = upright(glm::normalize(turn(forward)));
}

void ViewCamera::pan(const dvec2& pixels, double depth, const dvec2& size) {
  const double metres = pixelSize(depth, size);
  position += metres * (-pixels.x * right() + pixels.y * up());
}

void ViewCamera::approach(const dvec3& point, double factor) {
  if (isParallel()) {
    const double height = std::clamp(factor * parallel_height, kLeastHeight, kMostHeight);
    position += (1.0 - height / parallel_height) * (eyeFor(point) - position);
    parallel_height = height;
    return;
  }
  position = point + factor * (position - point);
}

void ViewCamera::frame(const Box& box, const dvec3& origin, double aspect) {
  if (box.empty()) return;
  if (isParallel()) {
    frameParallel(box, origin, aspect);
    return;
  }
  const double half = std::tan(0.5 * vertical_fov) * std::min(1.0, aspect);
  const double radius = std::max(0.5 * static_cast<double>(box.diagonal()), 1e-3);
  const double distance = radius / std::sin(std::atan(half));
  position = origin + dvec3(box.center()) - distance * forward;
}

void ViewCamera::frameParallel(const Box& box, const dvec3& origin, double aspect) {
  const dvec3 size(box.size());
  const double wide = glm::dot(glm::abs(right()), size);
  const double tall = glm::dot(glm::abs(up()), size);
  parallel_height = std::max(kAir * std::max(tall, wide / std::max(aspect, 1e-3)), kLeastHeight);
  const dvec3 center = origin + dvec3(box.center());
  // As far before it as it was, with the cut: a box may be but a part of the building.
  position = center + glm::dot(position - center, forward) * forward;
}

int ViewCamera::mainAxis() const {
  const dvec3 a = glm::abs(forward);
  return a.z >= a.x && a.z >= a.y ? 2 : a.y >= a.x ? 1 : 0;
}

double ViewCamera::cutPlace() const {
  const int axis = mainAxis();
  return position[axis] + cut_depth * forward[axis];
}

void ViewCamera::setCutPlace(double metres) {
  const int axis = mainAxis();
  cut_depth = std::max((metres - position[axis]) * (forward[axis] > 0.0 ? 1.0 : -1.0), 1e-3);
}

}  // namespace soffit::ui
