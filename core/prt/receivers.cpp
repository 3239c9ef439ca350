// SPDX-License-Identifier: MIT
#include "core/prt/receivers.h"

#include <algorithm>

namespace soffit::prt {

bool Receivers::grey() const {
  return std::all_of(reflectance.begin(), reflectance.end(),
                     [](const vec3& r) { return r.x == r.y && r.y == r.z; });
}

std::vector<std::uint32_t> spreadFromValid(std::span<const std::uint8_t> valid,
                                           std::span<const std::uint32_t> offsets,
                                           std::span<const std::uint32_t> neighbors) {
  std::vector<std::uint32_t> source(valid.size(), kNoReceiver);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t i = 0; i < valid.size(); ++i) {
    if (valid[i] == 0) continue;
    source[i] = i;
    queue.push_back(i);
  }
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::uint32_t i = queue[head];
    for (std::uint32_t k = offsets[i]; k < offsets[i + 1]; ++k) {
      if (source[neighbors[k]] != kNoReceiver) continue;
      source[neighbors[k]] = source[i];
      queue.push_back(neighbors[k]);
    }
  }
  for (std::uint32_t i = 0; i < source.size(); ++i) {
    if (source[i] == kNoReceiver) source[i] = i;
  }
  return source;
}

}  // namespace soffit::prt
