// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/held_sky.h"
#include "ui/viewport/gl_objects.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace soffit::ui {

/// Adds up the light of surroundings in hand (HeldSky) where it is drawn: one vertex shader run per
/// vertex, whose result goes into the buffer that the mesh is lit from. Transfer vectors are
/// uploaded once per sky, bake and mesh; a step of the slider uploads its weights, and the rest
/// where it changed. Equal to relight::SkyVectors::evaluate() but for rounding.
///
/// All calls but the getters need the context to be current.
class SkyEvaluation {
 public:
  /// What was done last.
  struct Figures {
    enum class Where : std::uint8_t { nowhere, gpu, refused };
    Where where = Where::nowhere;  ///< refused: the buffers do not fit, the processor added it up
    std::size_t bytes = 0;         ///< that the vectors take on the graphics processor
    double milliseconds = 0.0;     ///< of the last step, finished
  };

  /// RGB lux and 0 per vertex, into `light`. False where the vectors do not fit; nothing is written
  /// then.
  bool evaluate(const HeldSky& sky, GlBuffer& light);
  [[nodiscard]] const Figures& figures() const { return figures_; }
  /// Of the machine's texture buffers, at most so many texels; for tests of what happens then.
  void setMost(std::size_t texels) { most_ = texels; }
  /// No sky is in hand any more: the vectors go; evaluate() takes them again.
  void letGo();
  void release();

 private:
  [[nodiscard]] bool fits(const relight::SkyVectors& vectors) const;
  bool take(const HeldSky& sky);

  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  std::shared_ptr<const relight::SkyVectors> vectors_;
  std::shared_ptr<const std::vector<vec3>> rest_;
  Figures figures_;
  unsigned array_ = 0;
  unsigned fetch_ = 0;  ///< buffer texture
  GlBuffer texels_;
  GlBuffer rest_buffer_;
  GlProgram program_;
};

/// The same without OpenGL.
std::vector<vec3> evaluated(const HeldSky& sky);

}  // namespace soffit::ui
