// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/daylight/environment.h"
#include "core/light/emitter.h"
#include "core/relight/light_sum.h"
#include "core/relight/outdoors.h"
#include "core/relight/sensors.h"
#include "core/relight/sky_transfer.h"
#include "core/relight/sky_vectors.h"
#include "core/relight/solver.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace soffit::relight {

/// Light under surroundings in hand, in parts for someone else to add up: direct and reflected
/// light are each the rest + the sum of weights[k] * what function k of `transfer` gives; reflected
/// light below 0 is 0, and so is their sum.
struct SkyParts {
  std::shared_ptr<const SkyTransfer> transfer;
  std::vector<dvec3> weights;  ///< SkyTransfer::weights()
  /// Of luminaires and the brightest discs; the same object for as long as those do not change.
  std::shared_ptr<const SkyRest> rest;
};

/// The light of a set of luminaires in one scene, a column each: what moved is computed, what only
/// changed its dimming, colour or switch is mixed again (design.md § 1).
///
/// Lux everywhere; RGB planes per slot of the operators' texels. Not thread-safe.
class Lighting {
 public:
  explicit Lighting(std::shared_ptr<const Solver> solver) : solver_(std::move(solver)) {}

  [[nodiscard]] const Solver& solver() const { return *solver_; }
  [[nodiscard]] std::span<const light::Emitter> emitters() const { return emitters_; }

  /// Replaces all luminaires; columns of emitters whose light is unchanged are kept.
  /// Errors: makeEmitter's, with the luminaire's name as the place.
  Result<void> setLuminaires(std::span<const light::Luminaire> luminaires, const Job& job = {});

  /// What shines in from outside from now on, null: nothing. Its light is computed here, luminaires
  /// stay as they are; another sky over the same building takes no rays but the sun's. The body of
  /// a luminaire shades the sun, and not the sky; while one is in hand, the sun's shadow of its
  /// body stays where it was, until the next setLuminaires(). Errors: cancelled; nothing shines in
  /// then.
  Result<void> setEnvironment(std::shared_ptr<const daylight::Environment> environment,
                              const Job& job = {});
  /// The total under other surroundings while a slider turns or changes them: smooth light as a mix
  /// of columns (sky_transfer.h, made at the first call), the brightest discs exactly; nothing but
  /// the columns is kept. Takes no rays after the first call.
  /// Errors: cancelled.
  Result<Planes> totalUnderSky(const daylight::Environment& environment, const Job& job = {});
  /// The same in parts, for who can add them up more quickly (sky_vectors.h).
  Result<SkyParts> partsUnderSky(const daylight::Environment& environment, const Job& job = {});
  [[nodiscard]] const daylight::Environment* environment() const { return environment_.get(); }
  /// Direct light of the sky at the texels, RGB lux, the sun left out; empty without surroundings.
  [[nodiscard]] const Planes& skyDirect() const { return outdoors_.sky; }
  /// The bodies of all luminaires.
  [[nodiscard]] std::vector<light::MaskBlocker> allBodies() const;

  /// The same luminaires under a solver of other reflectances (Solver::repainted()): direct light
  /// stays, its reflections are computed anew. A luminaire in hand is let go.
  /// Errors: cancelled; what was not reached is computed by the next setLuminaires(), and direct
  /// light stays all the same.
  Result<void> repaint(std::shared_ptr<const Solver> solver, const Job& job = {});
  /// The total under other reflectances at once, for a slider that moves: light of one colour is
  /// reflected together and not per luminaire; nothing is kept. Differs from repaint() and total()
  /// in how energy is conserved alone (by the sum instead of by the luminaire), far below the
  /// error of either. Nothing where the direct light of a luminaire is missing.
  [[nodiscard]] std::optional<Planes> totalUnder(const Solver& painted) const;

  /// The light of luminaire i at dimming 1, as it was computed last.
  [[nodiscard]] const Column& column(std::size_t i) const { return entries_[i].column; }
  /// Its gain times its colour: 0 when it is off.
  [[nodiscard]] dvec3 weight(std::size_t i) const { return emitters_[i].gain * emitters_[i].color; }

  /// What shines in from outside.
  [[nodiscard]] std::vector<WeightedColumn> outdoorLights() const;

  /// Reflected light alone under other reflectances, with that of `thrown`: light that reaches the
  /// texels by ways that the operators do not know (RGB lux per slot; empty: none). What is thrown
  /// is not in the result, its reflections are. Nothing where totalUnder() has nothing.
  [[nodiscard]] std::optional<Planes> reflectedUnder(const Solver& painted,
                                                     const Planes& thrown) const;

  /// New gain and colour of luminaire i: no light is computed.
  void setMix(std::size_t i, double gain, const dvec3& color);

  /// Takes luminaires in hand: sums all others once. Ends when others are grabbed.
  void grab(std::span<const std::size_t> which);
  void grab(std::size_t i) { grab({&i, 1}); }
  /// The luminaires in hand, in the order of grab(), as they are now, and the total at every
  /// display point after it. Several are reflected together; their own columns follow at the next
  /// setLuminaires(). Where one has a body, what it shades of the others is computed anew, between
  /// where it was and where it is. What differs in gain and colour alone takes no direct light.
  /// Times hold the stages in ms.
  StageTimes move(std::span<const light::Emitter> emitters, light::DirectCounts* counts = nullptr);
  StageTimes move(const light::Emitter& emitter, light::DirectCounts* counts = nullptr) {
    return move({&emitter, 1}, counts);
  }
  /// Total after the last move().
  [[nodiscard]] const Planes& moved() const { return moved_; }

  /// Total light of all luminaires at the texels; invalid texels filled.
  [[nodiscard]] Planes total() const;
  /// The indirect part of it alone (for pictures, which compute direct light per pixel).
  [[nodiscard]] Planes indirectTotal() const;

  /// Readings of all luminaires and the surroundings, or of one luminaire.
  [[nodiscard]] std::vector<SensorLight> read(const Sensors& sensors,
                                              std::optional<std::size_t> only = {}) const;

  [[nodiscard]] const light::DirectCounts& counts() const { return counts_; }

 private:
  struct Entry {
    Column column;
    std::vector<light::MaskBlocker> body;
    bool direct = false;  ///< column.direct is there
    bool ready = false;   ///< all of the column is
  };
  void compute(std::size_t i);
  [[nodiscard]] std::optional<Planes> under(const Solver& painted, const Planes& thrown,
                                            LightPart part) const;
  /// While surroundings are in hand: what does not change with them, or seldom.
  struct SkyHand {
    LightSum lamps;                       ///< all luminaires
    std::vector<daylight::Spot> spots;    ///< those that are computed exactly
    std::vector<Column> discs;            ///< the light of each at 1 lx
    std::shared_ptr<const SkyRest> rest;  ///< lamps and discs; null: not asked for
    [[nodiscard]] std::vector<WeightedColumn> discLights() const;
  };
  Result<void> computeOutdoors(const Job& job);
  Result<void> holdSky(const daylight::Environment& environment, const Job& job);
  Result<void> holdSpots(std::vector<daylight::Spot> spots, const Job& job);
  /// The entry whose column is the light of this emitter, entries_.size() for none.
  [[nodiscard]] std::size_t columnFor(const light::Emitter& emitter, std::size_t at) const;
  [[nodiscard]] std::vector<light::MaskBlocker> otherBodies(std::size_t i) const;
  [[nodiscard]] std::vector<float> openShare() const;
  /// All that are on, but some, and what shines in.
  [[nodiscard]] std::vector<WeightedColumn> lights(std::span<const std::size_t> but = {}) const;
  [[nodiscard]] bool inHand(std::size_t i) const;
  std::vector<Box> takeBodies(std::span<const light::Emitter> emitters);
  void letGo() {
    hand_.clear();
    moving_.clear();
  }

  std::shared_ptr<const Solver> solver_;
  std::vector<light::Emitter> emitters_;
  std::vector<Entry> entries_;
  std::shared_ptr<const daylight::Environment> environment_;
  Outdoors outdoors_;
  std::shared_ptr<const SkyTransfer> sky_transfer_;  ///< null: not asked for
  std::optional<SkyHand> sky_hand_;                  ///< nothing: luminaires have changed since
  bool outdoors_stale_ = false;      ///< bodies shade the sun otherwise than outdoors_ has it
  std::vector<std::size_t> hand_;    ///< luminaires in hand
  std::vector<std::size_t> moving_;  ///< those whose light a move may change
  LightSum rest_;
  Planes moved_;
  light::DirectCounts counts_;
};

}  // namespace soffit::relight
