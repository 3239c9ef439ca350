// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/group_sums.h"
#include "core/relight/lighting.h"
#include "core/scene/scene.h"

#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soffit::ui {

/// Light that was computed stays: a Lighting per layout, so that going to and fro between layouts
/// costs a sum, and a drag keeps one luminaire in hand. Belongs to one thread.
class LightColumns {
 public:
  /// Whether light() finds what shines in where that is not known, or goes on with what was.
  enum class Outside { found, as_it_was };
  struct Answer {
    relight::Planes lux;
    relight::StageTimes times;
    light::DirectCounts counts;
    std::vector<light::Emitter> emitters;
  };

  /// The solver with other reflectances: direct light stays, its reflections follow at the next
  /// light() of each layout.
  void repaint(std::shared_ptr<const relight::Solver> solver);
  /// After repaint(): the light of a layout that is otherwise as it was, at the price of a few
  /// luminaires however many it has (relight::Lighting::totalUnder()); light() follows with every
  /// luminaire's own. Nothing where that would not be quicker.
  std::optional<Answer> paintedLight(const std::string& layout,
                                     const std::vector<light::Luminaire>& luminaires) const;

  /// Another solver: all light is computed anew.
  void setSolver(std::shared_ptr<const relight::Solver> solver);
  [[nodiscard]] const std::shared_ptr<const relight::Solver>& solver() const { return solver_; }

  /// What shines in from outside, in every layout, from the next light() on; null: nothing. Its
  /// light is computed there, other light stays.
  void setOutside(std::shared_ptr<const daylight::Environment> outside);
  [[nodiscard]] const std::shared_ptr<const daylight::Environment>& outside() const {
    return outside_;
  }
  /// Whether the next light() of a layout has to find what shines in, which takes seconds where it
  /// is not known.
  [[nodiscard]] bool lacksOutside(const std::string& layout) const;
  /// The light of a layout that is otherwise as it was under other surroundings, for a slider that
  /// moves (relight::Lighting::totalUnderSky()). Nothing where the layout's light is not known.
  std::optional<Answer> lightUnder(const daylight::Environment& outside, const std::string& layout,
                                   const std::vector<light::Luminaire>& luminaires, const Job& job);
  /// The same in parts (relight::Lighting::partsUnderSky()).
  std::optional<relight::SkyParts> partsUnder(const daylight::Environment& outside,
                                              const std::string& layout,
                                              const std::vector<light::Luminaire>& luminaires,
                                              const Job& job);

  /// The layout whose light is never dropped for that of another: the one in the view.
  void keep(const std::string& layout) { kept_ = layout; }

  /// Total light of a layout's luminaires. in_hand: those that are being dragged, rising; as long
  /// as they stay the same and nothing else changes, a call costs one move of them together.
  /// Errors: makeEmitter's; cancelled (what was computed until then is kept).
  Result<Answer> light(const std::string& layout, const std::vector<light::Luminaire>& luminaires,
                       const std::vector<std::size_t>& in_hand, const Job& job,
                       Outside part = Outside::found);
  /// The light of a layout as it was computed last; null when it was not, or was dropped.
  [[nodiscard]] const relight::Lighting* lightingOf(const std::string& layout) const;

 private:
  struct Entry {
    std::string layout;
    std::unique_ptr<relight::Lighting> lighting;
    std::vector<light::Luminaire> luminaires;  ///< the state of `lighting`
    std::vector<std::size_t> grabbed;
    std::shared_ptr<const daylight::Environment> outside;  ///< that shines in
    bool half_painted = false;  ///< a repaint was given up: reflections are old and new
    relight::GroupSums sums;
    std::vector<bool> changed;  ///< since the sums were made
  };
  Entry& entryOf(const std::string& layout);
  Entry* unchanged(const std::string& layout, const std::vector<light::Luminaire>& luminaires);
  static bool onlyMoved(const Entry& entry, const std::vector<light::Luminaire>& luminaires,
                        const std::vector<std::size_t>& in_hand);
  Result<void> moveHand(Entry& entry, const std::vector<light::Luminaire>& luminaires,
                        const std::vector<std::size_t>& in_hand, Answer& answer) const;
  static relight::Planes mixed(Entry& entry);
  Result<void> take(Entry& entry, const std::vector<light::Luminaire>& luminaires, const Job& job,
                    Outside part);

  std::shared_ptr<const relight::Solver> solver_;
  std::shared_ptr<const daylight::Environment> outside_;
  std::string kept_;
  std::list<Entry> entries_;  ///< the layout used last in front
};

}  // namespace soffit::ui
