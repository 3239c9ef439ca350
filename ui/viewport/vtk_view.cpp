// SPDX-License-Identifier: MIT
#include "ui/viewport/vtk_view.h"

#include "ui/viewport/gl_window.h"
#include "ui/viewport/picture_pass.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

namespace soffit::ui {
namespace {

constexpr unsigned kDrawFramebuffer = 0x8CA9;  // GL_DRAW_FRAMEBUFFER
constexpr unsigned kLessOrEqual = 0x0203;      // GL_LEQUAL
constexpr unsigned kRenderer = 0x1F01;         // GL_RENDERER

}  // namespace

VtkView::VtkView(QWidget* parent)
    : QOpenGLWidget(parent),
      window_(vtkSmartPointer<GlWindow>::New()),
      scene_(vtkSmartPointer<vtkRenderer>::New()),
      overlay_(vtkSmartPointer<vtkRenderer>::New()),
      camera_(vtkSmartPointer<vtkCamera>::New()),
      pass_(vtkSmartPointer<PicturePass>::New()) {
  window_->SetReadyForRendering(false);
  window_->SetOwnContext(0);
  window_->SetFrameBlitModeToNoBlit();
  window_->SetMultiSamples(0);
  window_->SetNumberOfLayers(2);
  scene_->SetLayer(0);
  scene_->SetPass(pass_);
  scene_->SetActiveCamera(camera_);
  overlay_->SetLayer(1);
  overlay_->InteractiveOff();
  overlay_->SetActiveCamera(camera_);
  window_->AddRenderer(scene_);
  window_->AddRenderer(overlay_);

  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(this);
  observer->SetCallback([](vtkObject*, unsigned long event, void* self, void* payload) {
    static_cast<VtkView*>(self)->onWindowEvent(event, payload);
  });
  for (const auto event : {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
                           vtkCommand::WindowFrameEvent}) {
    window_->AddObserver(event, observer);
  }
}

VtkView::~VtkView() {
  if (context() != nullptr) {
    // Else aboutToBeDestroyed would reach a half-destroyed object from ~QOpenGLWidget.
    disconnect(context(), nullptr, this, nullptr);
    finalize();
  }
  window_->RemoveAllObservers();
}

void VtkView::finalize() {
  makeCurrent();
  pass_->ReleaseGraphicsResources(window_);
  window_->Finalize();
  window_->SetReadyForRendering(false);
  doneCurrent();
}

void VtkView::onWindowEvent(unsigned long event, void* payload) {
  switch (event) {
    case vtkCommand::WindowMakeCurrentEvent:
      // Qt's makeCurrent() binds Qt's framebuffer as well: only when it is needed.
      if (isValid() && QOpenGLContext::currentContext() != context()) {
        makeCurrent();
        window_->GetState()->ResetFramebufferBindings();
      }
      break;
    case vtkCommand::WindowIsCurrentEvent:
      *static_cast<bool*>(payload) =
          context() != nullptr && QOpenGLContext::currentContext() == context();
      break;
    case vtkCommand::WindowFrameEvent:
      if (!painting_) update();
      break;
    default:
      break;
  }
}

PicturePass& VtkView::pass() {
  return *pass_;
}

vtkRenderer* VtkView::overlay() {
  return overlay_;
}

vtkCamera* VtkView::camera() {
  return camera_;
}

QSize VtkView::pixelSize() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize();
}

void VtkView::initializeGL() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { finalize(); });
  window_->SetReadyForRendering(true);
  window_->SetMapped(1);
  // Not OpenGLInitContext() alone: that would skip the set-up of VTK's state.
  window_->OpenGLInit();
  const auto* renderer = context()->functions()->glGetString(kRenderer);
  Q_EMIT contextMade(QString::fromLatin1(reinterpret_cast<const char*>(renderer)));  // NOLINT
}

void VtkView::resizeGL(int, int) {
  window_->SetSize(pixelSize().width(), pixelSize().height());
  window_->SetDPI(static_cast<int>(72 * devicePixelRatioF()));
}

void VtkView::paintGL() {
  QElapsedTimer timer;
  timer.start();
  QOpenGLFunctions* gl = context()->functions();
  vtkOpenGLState* state = window_->GetState();
  state->Reset();  // Qt has changed it behind VTK's back
  state->Push();
  state->vtkglDepthFunc(kLessOrEqual);
  painting_ = true;
  window_->Render();
  gl->glBindFramebuffer(kDrawFramebuffer, defaultFramebufferObject());
  state->ResetFramebufferBindings();
  gl->glViewport(0, 0, pixelSize().width(), pixelSize().height());
  window_->BlitDisplayFramebuffer();
  state->Pop();
  painting_ = false;
  gl->glFinish();
  frame_ms_ = static_cast<double>(timer.nsecsElapsed()) / 1e6;
  ++frame_count_;
  Q_EMIT painted();
}

QImage VtkView::picture(const QSize& pixels, bool with_overlay, int samples,
                        const std::function<void()>& after_sample) {
  if (!isValid()) return {};
  makeCurrent();
  vtkOpenGLState* state = window_->GetState();
  state->Reset();
  state->Push();
  painting_ = true;
  overlay_->SetDraw(with_overlay);
  window_->SetSize(pixels.width(), pixels.height());
  if (samples <= 0) samples = PicturePass::kMostSamples;
  for (int sample = 0; sample < samples; ++sample) {
    pass_->setSample(sample, 1.0);
    window_->Render();
    if (after_sample) after_sample();
  }
  QOpenGLFramebufferObject target(pixels, QOpenGLFramebufferObject::NoAttachment);
  target.bind();
  state->ResetFramebufferBindings();
  context()->functions()->glViewport(0, 0, pixels.width(), pixels.height());
  window_->BlitDisplayFramebuffer();
  QImage image = target.toImage().convertToFormat(QImage::Format_RGB888);
  overlay_->SetDraw(1);
  window_->SetSize(pixelSize().width(), pixelSize().height());
  state->Pop();
  painting_ = false;
  pass_->setSample(0, 1.0);
  doneCurrent();
  update();
  return image;
}

}  // namespace soffit::ui
