// SPDX-License-Identifier: MIT
#include "core/render/camera_frame.h"

#include <fmt/format.h>

#include <cmath>

namespace soffit::render {
namespace {

constexpr int kMaxSide = 32768;

Result<void> check(const scene::Camera& camera, int width, int height) {
  const std::string place = camera.name.empty() ? "camera" : "cameras." + camera.name;
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
    return Error{
        "size",
        fmt::format("expected 1 to {} pixels a side, found {} x {}", kMaxSide, width, height),
        "Ask for a size such as 1280x800."};
  }
  if (!isFinite(camera.position) || !isFinite(camera.target)) {
    return Error{place, "expected finite numbers for position and target", "Correct the numbers."};
  }
  if (glm::length(camera.target - camera.position) < 1e-9) {
    return Error{place, "the target is at the camera's own position",
                 "Move the target to what is looked at."};
  }
  // The comparison is false for NaN.
  if (!(camera.vertical_fov_deg >= 0.1 && camera.vertical_fov_deg <= 179.0)) {
    return Error{place + ".vertical_fov",
                 fmt::format("expected 0.1 to 179 degrees, found {:g}", camera.vertical_fov_deg),
                 "50 is a usual angle."};
  }
  return {};
}

}  // namespace

Result<CameraFrame> CameraFrame::create(const scene::Camera& camera, int width, int height,
                                        const dvec3& origin) {
  const auto valid = check(camera, width, height);
  if (!valid) return valid.error();
  CameraFrame frame;
  frame.position_ = camera.position - origin;
  frame.forward_ = glm::normalize(camera.target - camera.position);
  const bool steep = std::abs(frame.forward_.z) > 1.0 - 1e-9;
  const dvec3 upright = steep ? dvec3(0.0, 1.0, 0.0) : dvec3(0.0, 0.0, 1.0);
  frame.right_ = glm::normalize(glm::cross(frame.forward_, upright));
  frame.up_ = glm::cross(frame.right_, frame.forward_);
  frame.half_height_ = std::tan(0.5 * radians(camera.vertical_fov_deg));
  frame.pixel_angle_ = 2.0 * frame.half_height_ / height;
  frame.width_ = width;
  frame.height_ = height;
  return frame;
}

geometry::Ray CameraFrame::ray(double x, double y) const {
  const double right = (x - 0.5 * width_) * pixel_angle_;
  const double up = (0.5 * height_ - y) * pixel_angle_;
  geometry::Ray ray;
  ray.origin = vec3(position_);
  ray.direction = vec3(glm::normalize(forward_ + right * right_ + up * up_));
  return ray;
}

dvec3 CameraFrame::project(const dvec3& point) const {
  const dvec3 d = point - position_;
  const double depth = glm::dot(d, forward_);
  if (depth <= 0.0) return {0.0, 0.0, depth};
  return {0.5 * width_ + glm::dot(d, right_) / (depth * pixel_angle_),
          0.5 * height_ - glm::dot(d, up_) / (depth * pixel_angle_), depth};
}

}  // namespace soffit::render
