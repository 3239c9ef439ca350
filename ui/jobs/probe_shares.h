// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/light_columns.h"
#include "ui/jobs/light_frame.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soffit::ui {

/// Who lights the probes: the light of each luminaire at each of them, as the picture shows it.
///
/// While one luminaire is in hand all others stay as they were and it has the rest. Belongs to one
/// thread.
class ProbeShares {
 public:
  /// Lux per probe and luminaire, in the order of both, and one more of what shines in from outside
  /// where something does; empty for a probe on no lit surface.
  /// lux: the light of all at the texels of the columns' solver.
  std::vector<std::vector<double>> of(const std::vector<io::Probe>& probes,
                                      const LightColumns& columns, const std::string& layout,
                                      const relight::Planes& lux,
                                      std::optional<std::size_t> in_hand);
  /// As computed last for these probes, for a picture that is shown until they follow; else empty.
  [[nodiscard]] std::vector<std::vector<double>> last(const std::vector<io::Probe>& probes,
                                                      const std::string& layout) const;

 private:
  [[nodiscard]] bool knows(const std::vector<io::Probe>& probes, const LightColumns& columns,
                           const std::string& layout, std::size_t in_hand) const;
  void giveRest(const relight::Planes& lux, std::size_t in_hand);

  std::vector<io::Probe> probes_;
  std::string layout_;
  std::shared_ptr<const relight::Solver> solver_;
  std::vector<std::optional<ProbePlace>> places_;
  std::vector<std::vector<double>> shares_;
  const daylight::Environment* outside_ = nullptr;  ///< what shone in
};

}  // namespace soffit::ui
