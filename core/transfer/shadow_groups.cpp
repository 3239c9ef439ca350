// SPDX-License-Identifier: MIT
#include "core/transfer/shadow_groups.h"

namespace soffit::transfer {

ShadowGroups makeShadowGroups(const Texels& texels, std::span<const std::uint32_t> fill_from) {
  const light::Receivers& receivers = texels.receivers;
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  std::vector<std::uint32_t> index(receivers.slotCount(), kNoTexel);
  const auto indexOf = [&](std::uint32_t slot) {
    if (index[slot] == kNoTexel) {
      index[slot] = static_cast<std::uint32_t>(positions.size());
      positions.push_back(receivers.position(slot));
      normals.push_back(receivers.normal(slot));
    }
    return index[slot];
  };
  ShadowGroups groups;
  for (std::size_t s = 0; s < receivers.slotCount(); ++s) {
    // Padding repeats a point of its cluster.
    groups.place.push_back(indexOf(fill_from[receivers.slot_of[receivers.point_of[s]]]));
  }
  groups.points = light::makeCompactReceivers(positions, normals);
  for (std::uint32_t& place : groups.place) place = groups.points.slot_of[place];
  return groups;
}

}  // namespace soffit::transfer
