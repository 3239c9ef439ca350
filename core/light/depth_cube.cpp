// SPDX-License-Identifier: MIT
#include "core/light/depth_cube.h"

#include "core/base/parallel.h"
#include "core/sh/cube_map.h"

#include <cassert>
#include <span>

namespace soffit::light {

DepthCube makeDepthCube(const geometry::RayCaster& scene, const dvec3& probe, int side) {
  assert(side >= 1);
  DepthCube cube{probe, side, {}};
  const auto row = static_cast<std::size_t>(side);
  cube.distance.resize(6 * row * row);
  parallelFor(6 * row, 4, [&](std::size_t begin, std::size_t end) {
    std::vector<geometry::Ray> rays(row);
    std::vector<geometry::Hit> hits(row);
    for (std::size_t line = begin; line < end; ++line) {
      for (std::size_t column = 0; column < row; ++column) {
        const auto center = sh::texelCenter(static_cast<int>(line / row), static_cast<int>(column),
                                            static_cast<int>(line % row), side);
        rays[column].origin = vec3(probe);
        rays[column].direction = vec3(sh::cubeDirection(center));
      }
      scene.closest(rays, hits, true);
      for (std::size_t column = 0; column < row; ++column) {
        cube.distance[line * row + column] = hits[column].t;  // infinity for a miss
      }
    }
  });
  return cube;
}

}  // namespace soffit::light
