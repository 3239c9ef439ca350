// SPDX-License-Identifier: MIT
#include "ui/viewport/still_renderer.h"

#include "ui/document/text.h"

#include <QCoreApplication>
#include <QThread>

#include <new>

namespace soffit::ui {
namespace {

std::string tr(const char* text) {
  return toStd(QCoreApplication::translate("soffit::ui", text));
}

Error noContext() {
  return {{},
          tr("The graphics driver gives no second OpenGL context"),
          tr("Take the picture with \u201csoffit render\u201d, or as a screenshot.")};
}

Error noMemory() {
  return {{},
          tr("There is not enough memory for a picture of this size"),
          tr("Choose a smaller size.")};
}

}  // namespace

StillRenderer::StillRenderer() {
  surface_.setFormat(QSurfaceFormat::defaultFormat());
  surface_.create();
}

StillRenderer::~StillRenderer() {
  release();
}

Result<void> StillRenderer::begin() {
  if (context_ == nullptr) {
    context_ = std::make_unique<QOpenGLContext>();
    context_->setFormat(surface_.format());
    if (!context_->create()) {
      context_.reset();
      return noContext();
    }
  } else {
    context_->moveToThread(QThread::currentThread());
  }
  if (context_->makeCurrent(&surface_)) return {};
  context_->moveToThread(nullptr);
  return noContext();
}

/// The next picture may be made by another thread.
void StillRenderer::end() {
  context_->doneCurrent();
  context_->moveToThread(nullptr);
}

void StillRenderer::release() {
  if (context_ == nullptr || !begin()) return;
  drawing_.release();
  context_->doneCurrent();
  context_.reset();
}

Result<Picture> StillRenderer::render(const Still& still, const Job& job) {
  if (auto begun = begin(); !begun) return begun.error();
  Result<Picture> picture = [&]() -> Result<Picture> {
    try {
      return drawing_.draw(still, job);
    } catch (const std::bad_alloc&) {
      return noMemory();
    }
  }();
  end();
  return picture;
}

}  // namespace soffit::ui
