// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QOpenGLWidget>

#include <vtkSmartPointer.h>

#include <functional>

class vtkCamera;
class vtkRenderer;

namespace soffit::ui {

class GlWindow;
class PicturePass;

/// A VTK render window inside a Qt widget: the adapter, and nothing of what is shown.
///
/// Two layers share one camera: the scene, drawn by a PicturePass, and an overlay of VTK actors.
/// There is no VTK interactor; mouse and keys stay with Qt.
class VtkView : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit VtkView(QWidget* parent = nullptr);
  ~VtkView() override;

  [[nodiscard]] PicturePass& pass();
  [[nodiscard]] vtkRenderer* overlay();
  [[nodiscard]] vtkCamera* camera();
  /// Size in physical pixels.
  [[nodiscard]] QSize pixelSize() const;
  /// Milliseconds that the last frame took inside paintGL, drawing finished.
  [[nodiscard]] double frameMilliseconds() const { return frame_ms_; }
  [[nodiscard]] int frameCount() const { return frame_count_; }

  /// The picture as it is, drawn anew at a size, with or without the overlay; samples 0: all.
  /// after_sample: called while the context is current, once a sample is drawn.
  QImage picture(const QSize& pixels, bool with_overlay, int samples = 0,
                 const std::function<void()>& after_sample = {});

 Q_SIGNALS:
  void painted();
  /// There is an OpenGL context; renderer: what draws there (GL_RENDERER).
  void contextMade(const QString& renderer);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;

 private:
  void onWindowEvent(unsigned long event, void* payload);
  void finalize();

  vtkSmartPointer<GlWindow> window_;
  vtkSmartPointer<vtkRenderer> scene_;
  vtkSmartPointer<vtkRenderer> overlay_;
  vtkSmartPointer<vtkCamera> camera_;
  vtkSmartPointer<PicturePass> pass_;
  bool painting_ = false;
  double frame_ms_ = 0.0;
  int frame_count_ = 0;
};

}  // namespace soffit::ui
