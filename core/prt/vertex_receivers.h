// SPDX-License-Identifier: MIT
#pragma once

#include "core/prt/receivers.h"
#include "core/prt/surfaces.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace soffit::prt {

/// The vertices of a mesh as receivers (the tutorial; Fujita & Kanai 2004): one per place, shading
/// normal, material and side.
///
/// A vertex on the border of its surface (the foot of a wall) is drawn inward along the surface by
/// a twentieth of its triangles, 1 mm at most: exactly on the border it would lie on the other
/// wall as well, and half of its rays would start beyond it.
class VertexReceivers final : public ReceiverSet {
 public:
  explicit VertexReceivers(std::shared_ptr<const Surfaces> surfaces);

  /// Receiver of corner k (0..2) of a triangle on a side; kNoReceiver where that receives nothing.
  [[nodiscard]] std::uint32_t of(std::uint32_t triangle, int k, bool front) const {
    return corner_[front ? 0 : 1][3 * std::size_t{triangle} + static_cast<std::size_t>(k)];
  }

  std::size_t around(const geometry::Hit& hit, bool front, Around& taps) const override;
  std::vector<std::uint32_t> nearestValid(std::span<const std::uint8_t> valid) const override;

 private:
  void numberCorners();
  void accumulate();
  void drawInward();

  std::shared_ptr<const Surfaces> surfaces_;
  std::vector<std::uint32_t> corner_[2];  ///< front, back
};

}  // namespace soffit::prt
