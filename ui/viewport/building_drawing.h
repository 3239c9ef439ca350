// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/display_mesh.h"
#include "ui/viewport/gl_objects.h"
#include "ui/viewport/luminaire_mesh.h"
#include "ui/viewport/outside_drawing.h"
#include "ui/viewport/reflection_drawing.h"
#include "ui/viewport/seen_surfaces.h"
#include "ui/viewport/sky_evaluation.h"

#include <memory>
#include <vector>

namespace soffit::ui {

/// Draws the building and its luminaires in scene-linear light: rgb is luminance in cd/m^2, alpha
/// is illuminance in lux, or what kind of thing is seen (kLamp, kBeyond).
///
/// The static mesh is uploaded once; when light changes, three floats per vertex are.
class BuildingDrawing {
 public:
  static constexpr float kLamp = -1.0F;
  static constexpr float kBeyond = -2.0F;

  /// What to draw from the next draw() on. Null: nothing.
  void setMesh(std::shared_ptr<const DisplayMesh> mesh);
  /// RGB lux per vertex of the mesh; views of one building share it.
  void setLight(std::shared_ptr<const std::vector<vec3>> lux);
  /// Draws the light of a sky in hand in its place, until the next setLight(). Of the texels that
  /// the mesh was cut from.
  void setSky(std::shared_ptr<const HeldSky> sky);
  [[nodiscard]] const std::shared_ptr<const HeldSky>& sky() const { return sky_; }
  [[nodiscard]] SkyEvaluation& skyEvaluation() { return sky_evaluation_; }
  [[nodiscard]] const std::shared_ptr<const std::vector<vec3>>& light() const { return light_; }
  /// What is added to the illuminance of each vertex (withoutSpecks()); empty: nothing. Goes with
  /// the light, and with it.
  void setShift(std::vector<float> lux);
  [[nodiscard]] const std::vector<float>& shift() const { return shift_; }
  void setLuminaires(LuminaireMesh luminaires);
  /// What lies beyond the scene, and its glass. Flat views show no surroundings.
  [[nodiscard]] OutsideDrawing& outside() { return outside_; }

  /// What is reflected; goes with the mesh.
  [[nodiscard]] ReflectionDrawing& reflections() { return reflections_; }

  /// The camera of the next draws, and where its eye is (scene-local, visibleIndices()). What
  /// cannot be seen from there is not drawn. cuts: the near plane cuts the building, not the
  /// luminaires.
  void setView(const glm::mat4& clip_from_scene, const glm::vec4& eye, bool cuts);
  /// Into the framebuffer that is bound; clears it. shift: of the picture, in clip coordinates.
  /// From the second picture of a view on, what is seen is known (seen_surfaces.h).
  void draw(const vec2& shift, const vec3& background);
  /// Whether the picture is drawn in pieces, each seen through a viewport larger than the target:
  /// nothing of the view is kept then.
  void setInPieces(bool in_pieces) { in_pieces_ = in_pieces; }
  void release();

 private:
  void upload();
  void uploadLight();
  void drawMesh(const glm::mat4& clip_from_scene, const GlProgram& program);
  /// Whether the picture came from what is known of the view.
  bool drawSeen(const SeenSurfaces::View& view, const vec3& background);
  void drawLuminaires(const glm::mat4& clip_from_scene);

  std::shared_ptr<const DisplayMesh> mesh_;
  std::shared_ptr<const std::vector<vec3>> light_;
  std::shared_ptr<const HeldSky> sky_;
  std::vector<float> shift_;
  LuminaireMesh luminaires_;
  OutsideDrawing outside_;
  ReflectionDrawing reflections_;
  glm::mat4 clip_from_scene_{1.0F};
  glm::vec4 eye_{0.0F};
  bool cuts_ = false;
  bool in_pieces_ = false;
  std::vector<std::uint32_t> visible_counts_;  ///< indices per part
  bool view_dirty_ = true;
  bool mesh_dirty_ = false;
  bool light_dirty_ = false;
  bool luminaires_dirty_ = false;
  int luminaire_corners_ = 0;
  SeenSurfaces seen_;
  SkyEvaluation sky_evaluation_;
  SeenSurfaces::View last_view_;

  unsigned mesh_array_ = 0;
  unsigned luminaire_array_ = 0;
  GlBuffer positions_;
  GlBuffer albedo_;
  GlBuffer uvs_;
  GlBuffer lux_;
  GlBuffer indices_;
  GlBuffer corners_;
  std::vector<GlTexture> maps_;  ///< per part; empty without a map
  GlProgram mesh_program_;
  GlProgram number_program_;
  GlProgram luminaire_program_;
};

}  // namespace soffit::ui
