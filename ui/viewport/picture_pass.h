// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/building_drawing.h"
#include "ui/viewport/display_drawing.h"

#include <vtkRenderPass.h>

#include <memory>
#include <utility>
#include <vector>

class vtkCamera;
class vtkRenderer;

namespace soffit::ui {

/// How BuildingDrawing is to see (setView()).
struct DrawnView {
  glm::mat4 clip_from_scene{1.0F};
  glm::vec4 eye{0.0F};
  bool cuts = false;
};

/// As a camera sees it in a picture of that width over height. cut: of a parallel camera, m; the
/// building is cut away up to there; 0: it is not.
DrawnView drawnView(vtkCamera& camera, double aspect, double cut);

/// Where the k-th sample lies in its pixel, from its middle: Hammersley's points, the first in the
/// middle.
vec2 sampleOffset(int k);

/// The render pass of the scene layer: building and luminaires in scene-linear light, then the view
/// transform, into VTK's framebuffer. Actors of this layer are not drawn; those of the overlay are,
/// on top and untouched by the view transform.
///
/// A frame at rest is refined: each further one shifts the samples within the pixel, and the
/// finished code values are averaged, so that edges, those of lamps too, become smooth.
class PicturePass : public vtkRenderPass {
 public:
  static PicturePass* New();
  vtkTypeMacro(PicturePass, vtkRenderPass)

      BuildingDrawing building;
  DisplayDrawing display;

  /// Samples per pixel after which a picture is finished.
  static constexpr int kMostSamples = 8;
  /// sample  0 starts a new picture; k is averaged with the k before it.
  /// scale   pixels computed per pixel shown, along each side, up to 1 (less while things move).
  void setSample(int sample, double scale);
  /// Of a parallel camera: the building is cut away up to this depth, m; 0: it is not.
  void setCut(double depth) { cut_ = depth; }
  /// Shows this picture of the building in place of its own: as GlTarget::read() has it, in the
  /// window's size. Null: its own.
  void setTraced(std::shared_ptr<const std::vector<float>> light) { traced_ = std::move(light); }
  /// Shows the last picture again under a changed overlay, if it has the window's size.
  void reuseOnce() { reuse_ = true; }
  [[nodiscard]] int sample() const { return sample_; }

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// The scene-linear picture of the last frame; four floats per pixel, bottom row first.
  [[nodiscard]] std::vector<float> readLinear(int& width, int& height) const;

 protected:
  PicturePass() = default;

 private:
  void shoot(vtkRenderer* renderer, int width, int height);
  [[nodiscard]] const GlTarget& shown() const { return summed_ ? sum_ : finished_; }

  int sample_ = 0;
  bool reuse_ = false;
  bool summed_ = false;
  double scale_ = 1.0;
  double cut_ = 0.0;
  std::shared_ptr<const std::vector<float>> traced_;
  GlTarget linear_;
  GlTarget finished_;
  GlTarget sum_;
};

}  // namespace soffit::ui
