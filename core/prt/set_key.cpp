// SPDX-License-Identifier: MIT
#include "core/prt/set_key.h"

#include "core/transfer/content_hash.h"

#include <cstddef>
#include <map>
#include <vector>

namespace soffit::prt {
namespace {

/// Numbers one after another.
class Content {
 public:
  template <class T>
  void add(const T& value) {
    const auto bytes = std::as_bytes(std::span<const T, 1>(&value, 1));
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  [[nodiscard]] SetKey hash() const { return transfer::hash128(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

std::uint64_t hashOf(const scene::Material& material) {
  Content content;
  if (material.glass) {
    content.add(material.glass->index);
    content.add(material.glass->transmittance);
  }
  if (material.normal_image != nullptr) {
    content.add(material.normal_image->width);
    content.add(
        transfer::hash64(std::as_bytes(std::span<const float>(material.normal_image->pixels))));
  }
  return content.hash()[0];
}

void addOptions(const TextureOptions& options, Content& content) {
  content.add(options.texel);
  content.add(options.side);
  content.add(options.levels);
  content.add(options.dilation);
  content.add(options.most_side);
  content.add(options.cone_deg);
  content.add(options.given_uvs);
}

}  // namespace

SetKey setKey(const Surfaces& surfaces, std::span<const std::uint32_t> triangles,
              const TextureOptions& options) {
  const geometry::Mesh& mesh = *surfaces.mesh;
  Content content;
  addOptions(options, content);
  std::map<const scene::Material*, std::uint64_t> materials;
  std::map<std::uint32_t, std::uint32_t>
      numbers;  // of materials, in the order met: names count not
  for (const std::uint32_t t : triangles) {
    for (int k = 0; k < 3; ++k) {
      content.add(surfaces.corner(t, k));
      content.add(surfaces.corner_normals[3 * std::size_t{t} + static_cast<std::size_t>(k)]);
      if (!mesh.uvs.empty()) content.add(mesh.uvs[mesh.triangles[t][k]]);
    }
    content.add(surfaces.sides[t]);
    const std::uint32_t material = t < mesh.material_of.size() ? mesh.material_of[t] : 0;
    content.add(numbers.try_emplace(material, numbers.size()).first->second);
    const auto [it, added] = materials.try_emplace(&surfaces.material(t), 0);
    if (added) it->second = hashOf(*it->first);
    content.add(it->second);
  }
  return content.hash();
}

}  // namespace soffit::prt
