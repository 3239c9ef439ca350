// SPDX-License-Identifier: MIT
#include "core/render/emitter_radiance.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr double kGrazingLimit = 1.0 / 20.0;
constexpr int kRows = 17;
constexpr int kColumns = 32;

dvec3 tableDirection(int row, int column) {
  const double theta = kPi * row / (kRows - 1);
  const double phi = 2.0 * kPi * column / kColumns;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double frontArea(const light::Emitter& e, const dvec3& direction) {
  double sum = 0.0;
  for (std::size_t i = 0; i < e.triangle_normals.size(); ++i) {
    sum += e.triangle_areas[i] * std::max(0.0, glm::dot(e.triangle_normals[i], direction));
  }
  return sum;
}

double lookUp(const std::vector<double>& table, const dvec3& direction) {
  const double row = std::acos(std::clamp(direction.z, -1.0, 1.0)) / kPi * (kRows - 1);
  double column = std::atan2(direction.y, direction.x) / (2.0 * kPi) * kColumns;
  if (column < 0.0) column += kColumns;
  const int r = std::min(static_cast<int>(row), kRows - 2);
  const int c = static_cast<int>(column) % kColumns;
  const auto at = [&](int i, int j) {
    return table[static_cast<std::size_t>(i * kColumns + j % kColumns)];
  };
  const double fr = row - r;
  const double fc = column - std::floor(column);
  return glm::mix(glm::mix(at(r, c), at(r, c + 1), fc),
                  glm::mix(at(r + 1, c), at(r + 1, c + 1), fc), fr);
}

}  // namespace

EmitterRadiance::EmitterRadiance(const light::Emitter& e) {
  using light::EmitterKind;
  if (e.table == nullptr) return;
  double greatest = e.area;
  if (e.kind == EmitterKind::sphere) greatest = kPi * e.radius * e.radius;
  if (e.kind == EmitterKind::tube) greatest = 4.0 * e.radius * e.half_length;
  if (e.kind == EmitterKind::mesh) {
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column)
        mesh_areas_.push_back(frontArea(e, tableDirection(row, column)));
    greatest = *std::max_element(mesh_areas_.begin(), mesh_areas_.end());
  }
  smallest_ = kGrazingLimit * greatest;
}

double EmitterRadiance::projectedArea(const light::Emitter& e, const dvec3& direction) const {
  using light::EmitterKind;
  switch (e.kind) {
    case EmitterKind::planar:
      return e.area * std::abs(glm::dot(e.normal, direction));
    case EmitterKind::sphere:
      return kPi * e.radius * e.radius;
    case EmitterKind::tube: {
      const double along = glm::dot(e.axis, direction);
      return 4.0 * e.radius * e.half_length * std::sqrt(std::max(0.0, 1.0 - along * along));
    }
    case EmitterKind::mesh:
      return lookUp(mesh_areas_, direction);
    case EmitterKind::point:
      break;
  }
  return 0.0;
}

vec3 EmitterRadiance::toward(const light::Emitter& e, const vec3& normal,
                             const vec3& to_eye) const {
  if (e.kind == light::EmitterKind::point) return vec3(0.0F);
  double luminance = e.luminance;
  if (e.table != nullptr) {
    const dvec3 direction(to_eye);
    const double area = std::max(projectedArea(e, direction), smallest_);
    luminance = area > 0.0 ? e.pointIntensity(direction) / area : 0.0;
  } else if (glm::dot(normal, to_eye) <= 0.0F) {
    return vec3(0.0F);
  }
  return vec3(e.color * (luminance * e.gain));
}

}  // namespace soffit::render
