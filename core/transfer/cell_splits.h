// SPDX-License-Identifier: MIT
#pragma once

#include "core/transfer/cell_grid.h"
#include "core/transfer/cell_outlook.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soffit::transfer {

/// One side of a chart's grid, and which fine cells of each base cell make a texel together.
struct SplitGrid {
  GridLayout layout;
  const CellGrid* cut = nullptr;
  std::vector<CellOutlook> outlook;  ///< per fine cell; empty: nothing is known, nothing is split
  std::vector<std::uint8_t>
      group;  ///< per fine cell: its texel within the base cell, 0 unless split
  std::vector<std::uint8_t> groups;  ///< per base cell: how many

  static constexpr std::size_t kMostGroups = 4;  ///< by likeness; walls may part more

  [[nodiscard]] int baseColumns() const { return layout.nu / layout.ku; }
  [[nodiscard]] bool exposed(std::size_t cell) const {
    return cut->cells[cell].area > 0.0 && (outlook.empty() || outlook[cell].cover != Cover::matter);
  }
  /// The fine cells of a base cell.
  template <class Visit>
  void forEachCell(std::size_t base, Visit&& visit) const {
    const int i0 = static_cast<int>(base) % baseColumns() * layout.ku;
    const int j0 = static_cast<int>(base) / baseColumns() * layout.kv;
    for (int j = j0; j < j0 + layout.kv; ++j) {
      for (int i = i0; i < i0 + layout.ku; ++i) visit(static_cast<std::size_t>(j * layout.nu + i));
    }
  }
};

/// Splits base cells into groups of fine cells: first those that something stands between (a wall's
/// foot may cross a cell, and no light passes it) or of which one lies in a gap, then by what they
/// see, until there are about `count` texels: first where what is seen from within one cell differs
/// most. A desk that meets a partition in the middle of a cell, or a cabinet's edge on the floor,
/// divides light from dark there, and one texel more tells them apart; open floor is left whole.
///
/// Returns how many of the splits tell more than a little apart; when these are few, the rest of
/// `count` is better spent on smaller cells everywhere.
std::size_t splitCells(std::span<SplitGrid> grids, std::size_t count);

/// Of exposed fine cells the one that sees most nearly what they all see on average.
std::size_t typicalCell(const SplitGrid& grid, std::span<const std::size_t> cells);

}  // namespace soffit::transfer
