// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/picture_pass.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

glm::mat4 clipFromScene(vtkCamera& camera, double aspect) {
  vtkMatrix4x4* m = camera.GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  glm::mat4 clip;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      clip[column][row] = static_cast<float>(m->GetElement(row, column));
    }
  }
  return clip;
}

glm::vec4 eyeOf(vtkCamera& camera) {
  const bool parallel = camera.GetParallelProjection() != 0;
  const double* v = parallel ? camera.GetDirectionOfProjection() : camera.GetPosition();
  const vec3 place(dvec3(v[0], v[1], v[2]));
  return parallel ? glm::vec4(-place, 0.0F) : glm::vec4(place, 1.0F);
}

}  // namespace

vec2 sampleOffset(int k) {
  constexpr std::array<vec2, PicturePass::kMostSamples> kOffsets{{{0.0F, 0.0F},
                                                                  {-0.375F, 0.125F},
                                                                  {0.25F, -0.375F},
                                                                  {0.375F, 0.25F},
                                                                  {-0.125F, -0.25F},
                                                                  {0.125F, 0.375F},
                                                                  {-0.25F, 0.4375F},
                                                                  {-0.4375F, -0.4375F}}};
  return kOffsets[static_cast<std::size_t>(k)];
}

DrawnView drawnView(vtkCamera& camera, double aspect, double cut) {
  std::array<double, 2> range{};
  camera.GetClippingRange(range.data());
  if (cut > 0.0) camera.SetClippingRange(cut, std::max(range[1], cut + 1.0));
  const DrawnView view{clipFromScene(camera, aspect), eyeOf(camera), cut > 0.0};
  // The overlay, which has the same camera, is not cut.
  camera.SetClippingRange(range[0], range[1]);
  return view;
}

vtkStandardNewMacro(PicturePass);

void PicturePass::setSample(int sample, double scale) {
  sample_ = std::clamp(sample, 0, kMostSamples - 1);
  scale_ = scale;
}

void PicturePass::shoot(vtkRenderer* renderer, int width, int height) {
  linear_.resize(width, height, GlTarget::Format::linear_with_depth);
  finished_.resize(width, height, GlTarget::Format::display);
  if (traced_ != nullptr) {
    linear_.write(*traced_);
  } else {
    linear_.bind();
    const int* size = renderer->GetRenderWindow()->GetSize();
    const vec2 shift = 2.0F * sampleOffset(sample_) / vec2(width, height);
    const double aspect = static_cast<double>(size[0]) / size[1];
    const DrawnView view = drawnView(*renderer->GetActiveCamera(), aspect, cut_);
    building.setView(view.clip_from_scene, view.eye, view.cuts);
    building.draw(shift, vec3(0.0F));
  }
  if (sample_ == 0) display.learn(linear_);
  finished_.bind();
  display.draw(linear_);
  summed_ = false;
  if (scale_ < 1.0) return;
  // The first sample is what the sum begins with.
  sum_.resize(width, height, GlTarget::Format::sum);
  sum_.bind();
  display.copy(finished_, 1.0F / static_cast<float>(sample_ + 1));
  summed_ = sample_ > 0;
}

void PicturePass::Render(const vtkRenderState* state) {
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const int* size = window->GetSize();
  if (size[0] < 1 || size[1] < 1) return;
  const int width = std::max(1, static_cast<int>(std::lround(size[0] * scale_)));
  const int height = std::max(1, static_cast<int>(std::lround(size[1] * scale_)));
  const bool reuse =
      std::exchange(reuse_, false) && finished_.width() == width && finished_.height() == height;

  vtkOpenGLState* gl = window->GetState();
  window->GetShaderCache()->ReleaseCurrentShader();
  gl->PushFramebufferBindings();
  glDisable(GL_SCISSOR_TEST);
  if (!reuse) shoot(renderer, width, height);
  gl->PopFramebufferBindings();
  glViewport(0, 0, size[0], size[1]);
  display.copy(shown());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glUseProgram(0);
  gl->Reset();
  this->NumberOfRenderedProps = 1;
}

void PicturePass::ReleaseGraphicsResources(vtkWindow* window) {
  building.release();
  display.release();
  for (GlTarget* target : {&linear_, &finished_, &sum_}) target->release();
  vtkRenderPass::ReleaseGraphicsResources(window);
}

std::vector<float> PicturePass::readLinear(int& width, int& height) const {
  width = linear_.width();
  height = linear_.height();
  return linear_.read();
}

}  // namespace soffit::ui
