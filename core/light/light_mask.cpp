// SPDX-License-Identifier: MIT
#include "core/light/light_mask.h"

namespace soffit::light {

vec3 MaskLight::sample(int row, int column) const {
  const float a = (static_cast<float>(column) + rowOffset(row)) / static_cast<float>(kColumns);
  const float b = (static_cast<float>(row) + a) / static_cast<float>(kRows);
  return origin + a * u + b * v;
}

void MaskLight::finish() {
  for (int cell = 0; cell < kCells; ++cell) {
    const int cx = cell % 4;
    const int cy = cell / 4;
    vec3 sum(0.0F);
    int count = 0;
    for (int j = 4 * cy; j < 4 * cy + 4; ++j) {
      for (int i = 8 * cx; i < 8 * cx + 8; ++i) {
        if ((outline[static_cast<std::size_t>(j)] >> static_cast<unsigned>(i) & 1U) != 0U) {
          sum += sample(j, i);
          ++count;
        }
      }
    }
    const auto k = static_cast<std::size_t>(cell);
    cell_count[k] = static_cast<float>(count);
    cell_center[k] = count > 0 ? sum / static_cast<float>(count) : sample(4 * cy + 2, 8 * cx + 4);
  }
}

MaskLight makeMaskLight(const vec3& origin, const vec3& u, const vec3& v, const vec3& normal, bool lambertian) {
  MaskLight light;
  light.origin = origin;
  light.u = u;
  light.v = v;
  light.normal = normal;
  light.lambertian = lambertian;
  light.outline.fill(0xffffffffU);
  light.finish();
  return light;
}

MaskLight placed(const MaskLight& unit, const vec3& origin, const vec3& u, const vec3& v,
                 const vec3& normal) {
  MaskLight light = unit;
  light.origin = origin;
  light.u = u;
  light.v = v;
  light.normal = normal;
  for (vec3& c : light.cell_center) c = origin + c.x * u + c.y * v;
  return light;
}

}  // namespace soffit::light
