// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/column.h"
#include "core/transfer/operators.h"

#include <cstdint>
#include <span>

/// Light of several luminaires together. Reflected light is added where it is known, at some ten
/// skeleton points per cluster, and interpolated to all texels once for the whole sum: what another
/// luminaire costs is its direct light where it shines (design.md § 1).
namespace soffit::relight {

/// Columns times weights in the form that columns are stored in. Linear: weights may be negative,
/// for light that is taken away again.
struct LightSum {
  Planes direct;                           ///< lux per slot
  std::vector<vec4> skeleton;              ///< as in Column
  std::vector<transfer::PatchLight> node;  ///< as in Column
};

struct WeightedColumn {
  const Column* column = nullptr;
  dvec3 weight{1.0};  ///< gain times colour
};

struct WeightedSum {
  const LightSum* sum = nullptr;
  dvec3 factor{1.0};
};

/// What spread() gives. unbounded: reflected light as it is interpolated, below 0 too: a part of a
/// larger sum.
enum class LightPart : std::uint8_t { all, reflected, direct, unbounded };

/// Darkness.
[[nodiscard]] LightSum noLight(const transfer::Operators& operators);

/// Adds weight * column to a sum of the same operators.
void addTo(LightSum& sum, const WeightedColumn& light, const transfer::Operators& operators);

/// lux = sums and columns together at every slot, resized as needed. Weights of the interpolation
/// may be negative, light is not: reflected light below 0 is taken as 0, in the sum and not in its
/// parts. Invalid texels get the light of those that they stand for.
void spread(std::span<const WeightedSum> sums, std::span<const WeightedColumn> columns,
            const transfer::Operators& operators, Planes& lux, LightPart part = LightPart::all);

/// Lux of one column times its weight at one slot of a cluster: what spread() writes there.
[[nodiscard]] dvec3 luxAt(const WeightedColumn& light, const transfer::Operators& operators,
                          std::uint32_t slot);

}  // namespace soffit::relight
