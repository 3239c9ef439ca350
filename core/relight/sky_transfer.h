// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/daylight/environment.h"
#include "core/light/emitter.h"
#include "core/relight/light_sum.h"
#include "core/relight/solver.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

/// Transfer vectors for light that is distant (Slomp, Oliveira & Patricio; Sloan 2002): what each
/// texel receives, directly and by all reflections, from each of a few smooth skies. Any other or
/// turned smooth sky is a mix of them, without a ray.
///
/// A sky and the ground meet in a step that no low band can follow, so the hemispheres are apart.
/// In each, the radiance is mirrored at the horizon and projected: of the n^2 real harmonics the
/// n(n + 1)/2 that are even in z remain (l + m even), orthogonal on the hemisphere. An even ground
/// is one function, the constant, and exact. Columns hold functions that are nowhere negative, y_lm
/// + sqrt((2l + 1)/4pi) (the addition theorem bounds |y_lm|), since the engine conserves energy
/// column by column, which only light can bear; the constant's weight takes that back.
///
/// The error is that of the bands left out: README.md.
namespace soffit::relight {

/// Bands of a hemisphere, and the pairs (l, m) that are even in z, in ascending order.
struct EvenHarmonic {
  int l = 0;
  int m = 0;
};
std::vector<EvenHarmonic> evenHarmonics(int bands);

/// Coefficients of smooth surroundings on those functions, RGB, best in the mean square over a
/// hemisphere. upper: the one above the horizon. Spots are left out.
std::vector<dvec3> evenCoefficients(const daylight::Environment& environment, int bands,
                                    bool upper);

class SkyTransfer {
 public:
  static constexpr int kBands = 6;
  /// Discs whose light is computed exactly beside the columns; fainter ones join the smooth light.
  static constexpr std::size_t kMostSpots = 2;

  /// bands: 1 .. sh::kMaxBands.   open: Solver::indirect()'s.   whole: for surroundings whose
  /// ground is not even, too.   Null when cancelled.
  static std::shared_ptr<const SkyTransfer> make(const Solver& solver, int bands, bool whole,
                                                 std::span<const float> open, const Job& job);

  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] bool fits(const daylight::Environment& environment) const {
    return whole_ || environment.evenGround();
  }
  /// What smooth surroundings mix from the columns. They live as long as this.
  [[nodiscard]] std::vector<WeightedColumn> mix(const daylight::Environment& environment) const;
  /// The same as weights of the functions themselves, RGB, where light below 0 does no harm: the
  /// constant 1 and y_lm of the upper hemisphere, then of the lower one. Small ones: mix() gives
  /// the constants what it takes to lift all others above 0, and takes it back.
  [[nodiscard]] std::vector<dvec3> weights(const daylight::Environment& environment) const;
  [[nodiscard]] std::size_t upperCount() const { return upper_.columns.size(); }
  [[nodiscard]] std::size_t functionCount() const {
    return upper_.columns.size() + lower_.columns.size();
  }
  /// Function k as a mix of columns, which live as long as this.
  [[nodiscard]] std::vector<WeightedColumn> function(std::size_t k) const;
  /// The discs that mix() leaves out: the brightest.
  [[nodiscard]] static std::vector<daylight::Spot> exactSpots(
      const daylight::Environment& environment);
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Hemisphere {
    std::vector<Column> columns;  ///< the constant 1, then the others in evenHarmonics()' order
  };
  SkyTransfer(int bands, bool whole) : bands_(bands), whole_(whole) {}
  void addMix(const Hemisphere& from, const std::vector<dvec3>& coefficients,
              std::vector<WeightedColumn>& out) const;

  int bands_;
  bool whole_;
  Hemisphere upper_;
  Hemisphere lower_;
};

}  // namespace soffit::relight
