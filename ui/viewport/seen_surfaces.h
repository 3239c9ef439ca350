// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/gl_objects.h"

#include <functional>

namespace soffit::ui {

/// Which triangle each pixel shows and where on it, kept while neither camera nor building moves.
/// New light is then three fetches per pixel instead of a pass over all triangles: what a dragged
/// luminaire costs on a machine without a GPU.
///
/// All calls need the context to be current.
class SeenSurfaces {
 public:
  struct View {
    glm::mat4 clip_from_scene{0.0F};
    int width = 0;
    int height = 0;
    bool operator==(const View&) const = default;
  };
  /// Buffers of the mesh: three floats per position, four per light (RGB lux and
  /// what is added to the illuminance), and the
  /// corners of the triangles that are drawn.
  struct Mesh {
    unsigned positions = 0;
    unsigned light = 0;
    unsigned indices = 0;
    std::size_t vertex_count = 0;
    std::size_t index_count = 0;
  };

  /// The building has changed.
  void forget() { view_ = {}; }
  [[nodiscard]] bool holds(const View& view) const { return view_ == view; }
  /// Whether a mesh of that size can be fetched from at all.
  [[nodiscard]] static bool fits(const Mesh& mesh);
  /// Looks. `draw` draws the mesh with a program whose fragments write the triangle's number plus
  /// one to output 0 (unsigned) and reflectances to output 1.
  void see(const View& view, const Mesh& mesh, const std::function<void()>& draw);
  /// Writes luminance and lux (BuildingDrawing) and the depth of what is held into the framebuffer
  /// `target`, which must have the view's size.
  void shade(unsigned target, const Mesh& mesh, const vec3& background, float beyond);
  void release();

 private:
  void make(int width, int height);
  void releaseTargets();

  View view_;
  unsigned array_ = 0;
  unsigned seen_ = 0;  ///< framebuffer: numbers, reflectances, depth
  unsigned numbers_ = 0;
  unsigned albedo_ = 0;
  unsigned depth_ = 0;
  unsigned places_ = 0;   ///< framebuffer: corners
  unsigned corners_ = 0;  ///< texture: three vertices and two packed weights
  unsigned fetch_ = 0;    ///< buffer textures: indices, positions, light
  unsigned fetch_positions_ = 0;
  unsigned fetch_light_ = 0;
  int width_ = 0;
  int height_ = 0;
  GlProgram place_program_;
  GlProgram shade_program_;
};

}  // namespace soffit::ui
