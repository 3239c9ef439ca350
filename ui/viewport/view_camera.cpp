// SPDX-License-Identifier: MIT
#include "ui/viewport/view_camera.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

/// Sine of the steepest pitch, about 89 degrees.
constexpr double kSteepest = 0.99985;
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
  return glm::normalize(glm::cross(forward, kUp));
}

dvec3 ViewCamera::up() const {
  return glm::cross(right(), forward);
}

dvec3 ViewCamera::rayThrough(const dvec2& pixel, const dvec2& size) const {
  const double half = std::tan(0.5 * vertical_fov);
  const double x = (2.0 * pixel.x - size.x) / size.y * half;
  const double y = (1.0 - 2.0 * pixel.y / size.y) * half;
  return glm::normalize(forward + x * right() + y * up());
}

dvec3 ViewCamera::project(const dvec3& point, const dvec2& size) const {
  const dvec3 d = point - position;
  const double depth = glm::dot(d, forward);
  const double scale = 0.5 * size.y / (std::tan(0.5 * vertical_fov) * depth);
  return {0.5 * size.x + glm::dot(d, right()) * scale, 0.5 * size.y - glm::dot(d, up()) * scale,
          depth};
}

double ViewCamera::pixelSize(double depth, const dvec2& size) const {
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
  position = point + factor * (position - point);
}

void ViewCamera::frame(const Box& box, const dvec3& origin, double aspect) {
  if (box.empty()) return;
  const double half = std::tan(0.5 * vertical_fov) * std::min(1.0, aspect);
  const double radius = std::max(0.5 * static_cast<double>(box.diagonal()), 1e-3);
  const double distance = radius / std::sin(std::atan(half));
  position = origin + dvec3(box.center()) - distance * forward;
}

}  // namespace soffit::ui
