// SPDX-License-Identifier: MIT
#pragma once

#include "core/render/lit_probes.h"
#include "ui/viewport/display_mesh.h"
#include "ui/viewport/gl_objects.h"

#include <memory>
#include <vector>

namespace soffit::ui {

/// Adds what specular surfaces reflect to a picture of the building, pixel by pixel, by the maps
/// of probes (reflection_shader.h). Nothing is built, uploaded or drawn without such surfaces.
///
/// All but the setters need the context to be current.
class ReflectionDrawing {
 public:
  void setMesh(std::shared_ptr<const DisplayMesh> mesh);
  /// Null: no reflections.
  void setLight(std::shared_ptr<const render::LitProbes> probes);
  [[nodiscard]] const std::shared_ptr<const render::LitProbes>& light() const { return light_; }

  /// Into the framebuffer that is bound and has the building's depth. eye: its place and 1, or the
  /// direction toward one that is infinitely far away and 0.
  void draw(const glm::mat4& clip_from_scene, const glm::vec4& eye);
  void release();

 private:
  void upload();
  void uploadMesh();
  void uploadMaps();
  void uploadLobes();
  void uploadLamps();
  void drawRuns() const;
  void releaseRuns();
  void setUniforms(const glm::mat4& clip_from_scene, const glm::vec4& eye) const;

  std::shared_ptr<const DisplayMesh> mesh_;
  std::shared_ptr<const render::LitProbes> light_;
  bool mesh_dirty_ = false;
  bool light_dirty_ = false;

  GlProgram program_;
  unsigned array_ = 0;
  GlBuffer positions_;
  GlBuffer normals_;
  GlBuffer gloss_;
  GlBuffer uvs_;
  GlBuffer indices_;
  /// Triangles of one roughness map; those without come first.
  struct Run {
    int first = 0;
    int count = 0;
    GlTexture map;  ///< not made: none
  };
  std::vector<Run> runs_;
  GlLayers maps_;
  GlLayers depths_;
  GlLayers sights_;
  GlLayers lobes_;
  GlLayers lamps_;
  std::vector<float> atlas_;  ///< kept: filled at every light
  std::vector<std::shared_ptr<const glossy::ProbeDepth>> uploaded_;  ///< that depths_ holds
  std::vector<std::shared_ptr<const render::LampMap>> lamp_maps_;    ///< that lamps_ holds
  int atlas_width_ = 0;
  int atlas_height_ = 0;
};

}  // namespace soffit::ui
