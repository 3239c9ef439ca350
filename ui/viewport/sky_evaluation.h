// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/held_sky.h"
#include "ui/viewport/display_mesh.h"
#include "ui/viewport/gl_objects.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace soffit::ui {

/// Adds up the light of surroundings in hand (HeldSky) on the graphics processor, by vertex shaders
/// whose results go into buffers: the light of each texel, then that of each vertex of the mesh
/// from its texels. Transfer vectors are uploaded once per sky, bake and mesh; a step of the slider
/// uploads its weights, and the rest where that changed. Equal to relight::SkyVectors::evaluate()
/// and lightVertices() but for rounding.
///
/// All calls but the getters need the context to be current.
class SkyEvaluation {
 public:
  /// What was done last.
  struct Figures {
    enum class Where : std::uint8_t { nowhere, gpu, refused };
    Where where = Where::nowhere;  ///< refused: the buffers do not fit, the processor added it up
    std::size_t bytes = 0;         ///< that all of it takes on the graphics processor
    double milliseconds = 0.0;     ///< of the last step, finished
  };

  /// RGB lux and 0 per vertex, into `light`. False where there is no room; nothing is written then.
  bool evaluate(const HeldSky& sky, const std::shared_ptr<const DisplayMesh>& mesh,
                GlBuffer& light);
  [[nodiscard]] const Figures& figures() const { return figures_; }
  /// Of the machine's texture buffers, at most so many texels; for tests of what happens then.
  void setMost(std::size_t texels) { most_ = texels; }
  /// No sky is in hand any more: the buffers go; evaluate() fills them again.
  void letGo();
  void release();

 private:
  [[nodiscard]] bool fits(const relight::SkyVectors& vectors, const DisplayMesh& mesh) const;
  void make();
  bool take(const HeldSky& sky, const std::shared_ptr<const DisplayMesh>& mesh);
  void takeRest(const HeldSky& sky);
  void lightTexels(const HeldSky& sky);
  void lightCorners(GlBuffer& light);

  /// A buffer and the texture to fetch from it.
  struct Fetched {
    GlBuffer buffer;
    unsigned texture = 0;
  };

  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  std::shared_ptr<const relight::SkyVectors> vectors_;
  std::shared_ptr<const DisplayMesh> mesh_;
  std::shared_ptr<const relight::SkyRest> rest_;
  Figures figures_;
  unsigned rest_array_ = 0;
  unsigned empty_array_ = 0;
  Fetched texels_;  ///< the vectors
  Fetched first_;   ///< the mesh's shares of texels, as DisplayMesh has them
  Fetched slots_;
  Fetched weights_;
  Fetched lit_;  ///< four floats per slot
  GlBuffer rest_buffer_;
  GlProgram texel_program_;
  GlProgram corner_program_;
};

/// The same without OpenGL: RGB lux per vertex.
std::vector<vec3> evaluated(const HeldSky& sky, const DisplayMesh& mesh);

}  // namespace soffit::ui
