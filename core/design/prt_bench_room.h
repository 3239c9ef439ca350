// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/surfaces.h"

#include <memory>

namespace soffit::design {

/// The bench's scene: a room of 6 x 5 x 3 m with a skylight of 2 x 1.5 m, a red wall, a block and a
/// sphere; light is received on the inside alone. cells: per side of each flat piece of the shell
/// (2 cells^2 triangles).
std::shared_ptr<const prt::Surfaces> prtBenchRoom(int cells);

}  // namespace soffit::design
