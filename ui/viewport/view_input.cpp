// SPDX-License-Identifier: MIT
#include "ui/viewport/view_input.h"

#include "ui/document/luminaire_type_mime.h"
#include "ui/document/text.h"
#include "ui/viewport/placing.h"

#include <QApplication>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <utility>

namespace soffit::ui {
namespace {

constexpr Qt::KeyboardModifiers kAdding = Qt::ShiftModifier | Qt::ControlModifier;

}  // namespace

ViewInput::ViewInput(SceneView& view, QObject* parent)
    : QObject(parent), view_(view), camera_(view), overlay_(new ViewOverlay(view)) {
  view_.installEventFilter(this);
  view_.setAcceptDrops(true);
  connect(&camera_, &CameraControl::hintChanged, this, [this](const QString& hint) {
    Q_EMIT hintChanged(hint.isEmpty() && tool_ != nullptr ? tool_->hint() : hint);
  });
}

ViewInput::~ViewInput() = default;

void ViewInput::setDocument(Document* document) {
  setTool(nullptr);
  if (document_ != nullptr && mode_ != Mode::none) endMode();
  document_ = document;
  camera_.forget();
}

void ViewInput::setOnlyLooking(bool only) {
  if (only == only_looking_) return;
  setTool(nullptr);
  only_looking_ = only;
  view_.setGizmoShown(!only);
}

void ViewInput::setGizmoTool(GizmoTool tool) {
  if (mode_ == Mode::drag || tool == view_.gizmoTool()) return;
  view_.setGizmoTool(tool);
  Q_EMIT gizmoToolChanged(tool);
}

void ViewInput::setTool(std::unique_ptr<ViewTool> tool) {
  overlay_->setContent({});
  // Later, for a tool ends from within its own signals.
  if (tool_ != nullptr) {
    ViewTool* old = tool_.release();
    old->end();
    old->deleteLater();
  }
  if (mode_ == Mode::tool) mode_ = Mode::none;
  tool_ = std::move(tool);
  view_.setGizmoShown(tool_ == nullptr && !only_looking_);
  view_.setCursor(tool_ == nullptr ? Qt::ArrowCursor : Qt::CrossCursor);
  if (tool_ != nullptr) {
    ViewTool* now = tool_.get();
    connect(now, &ViewTool::contentChanged, overlay_, &ViewOverlay::setContent);
    connect(now, &ViewTool::hintChanged, this, &ViewInput::hintChanged);
    connect(now, &ViewTool::finished, this, [this, now] {
      if (tool_.get() == now) setTool(nullptr);
    });
    view_.setHovered({});
    view_.setGizmoHighlight(GizmoPart::none);
    view_.setFocus();
  }
  Q_EMIT hintChanged(tool_ == nullptr ? QString() : tool_->hint());
}

bool ViewInput::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return move(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      return release(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonDblClick:
      return doubleClick(static_cast<const QMouseEvent&>(*event));
    case QEvent::Wheel:
      return wheel(static_cast<const QWheelEvent&>(*event));
    case QEvent::ShortcutOverride:
      // Else a typed 3 would be a shortcut of the menus.
      if (!wantsKey(static_cast<const QKeyEvent&>(*event))) return false;
      event->accept();
      return true;
    case QEvent::KeyRelease:
      if (!camera_.wantsKey(static_cast<const QKeyEvent&>(*event))) return false;
      camera_.key(static_cast<const QKeyEvent&>(*event), false);
      return true;
    case QEvent::FocusOut:
      // Keys that are let go elsewhere are not told of.
      if (mode_ == Mode::camera) endMode();
      return false;
    case QEvent::KeyPress:
      return key(static_cast<const QKeyEvent&>(*event));
    case QEvent::DragEnter:
    case QEvent::DragMove:
    case QEvent::Drop:
      return drop(static_cast<QDropEvent&>(*event), event->type());
    case QEvent::DragLeave:
      setTool(nullptr);
      return true;
    case QEvent::Leave:
      view_.setHovered({});
      view_.setGizmoHighlight(GizmoPart::none);
      Q_EMIT left();
      return false;
    default:
      return false;
  }
}

bool ViewInput::press(const QMouseEvent& event) {
  if (mode_ != Mode::none || document_ == nullptr) return true;
  start_ = last_ = event.position();
  pressed_ = view_.pointAt(start_);
  if (only_looking_) pressed_.luminaire.clear();
  const bool shift = (event.modifiers() & Qt::ShiftModifier) != 0;
  if (event.button() == Qt::MiddleButton || (event.button() == Qt::RightButton && shift)) {
    mode_ = Mode::camera;
    camera_.begin(CameraControl::Way::pan, pressed_);
  } else if (event.button() == Qt::RightButton) {
    mode_ = Mode::camera;
    camera_.begin(CameraControl::Way::look, pressed_);
  } else if (event.button() == Qt::LeftButton) {
    pressed_part_ = tool_ != nullptr ? GizmoPart::none : view_.gizmoPartAt(start_);
    mode_ = tool_ != nullptr && tool_->grab(start_) ? Mode::tool : Mode::pressed;
    if (mode_ == Mode::tool) view_.setMoving(true);
  }
  return true;
}

void ViewInput::select(const std::string& name, bool add) {
  if (only_looking_) return;
  QStringList names = add ? document_->selection() : QStringList();
  const QString luminaire = toQt(name);
  if (!name.empty()) {
    if (add && names.contains(luminaire)) {
      names.removeAll(luminaire);
    } else {
      names.append(luminaire);
    }
  }
  document_->setSelection(names);
}

/// The press became a drag.
void ViewInput::beginPressed(const QMouseEvent& event) {
  const bool shift = (event.modifiers() & Qt::ShiftModifier) != 0;
  const bool body =
      tool_ == nullptr && pressed_part_ == GizmoPart::none && !pressed_.luminaire.empty();
  if (body && !document_->selection().contains(toQt(pressed_.luminaire))) {
    select(pressed_.luminaire, (event.modifiers() & Qt::ControlModifier) != 0);
  }
  const bool grabbed = (body || pressed_part_ != GizmoPart::none) && view_.gizmoPlace();
  if (!grabbed && tool_ == nullptr && !only_looking_ && (event.modifiers() & kAdding) != 0) {
    mode_ = Mode::band;
    return;
  }
  if (!grabbed) {
    mode_ = Mode::camera;
    camera_.begin(CameraControl::Way::orbit, pressed_);
    return;
  }
  view_.setMoving(true);
  mode_ = Mode::drag;
  const GizmoTool tool = body ? GizmoTool::move : view_.gizmoTool();
  drag_ = std::make_unique<DragSession>(view_, *overlay_, *document_, tool,
                                        body ? freePart(view_.viewCamera()) : pressed_part_, start_,
                                        shift, rules_);
}

void ViewInput::hover(const QMouseEvent& event) {
  const QPointF mouse = event.position();
  const PointedAt at = view_.pointAt(mouse);
  Q_EMIT pointed(at);
  if (tool_ != nullptr) {
    tool_->hover(at, mouse, event.modifiers());
    return;
  }
  if (only_looking_) return;
  const GizmoPart part = view_.gizmoPartAt(mouse);
  view_.setGizmoHighlight(part);
  view_.setHovered(part == GizmoPart::none ? at.luminaire : std::string());
  const bool hand = part != GizmoPart::none || !at.luminaire.empty();
  view_.setCursor(hand ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

bool ViewInput::move(const QMouseEvent& event) {
  const QPointF now = event.position();
  if (mode_ == Mode::none) {
    hover(event);
    return true;
  }
  if (mode_ == Mode::pressed) {
    if ((now - start_).manhattanLength() < QApplication::startDragDistance()) return true;
    beginPressed(event);
  }
  const QPointF delta = now - std::exchange(last_, now);
  switch (mode_) {
    case Mode::drag:
      drag_->moveTo(now, event.modifiers());
      break;
    case Mode::tool:
      tool_->dragTo(now);
      break;
    case Mode::band:
      overlay_->setBand(QRectF(start_, now).normalized());
      break;
    default:
      camera_.moveBy(delta);
      overlay_->update();
  }
  return true;
}

void ViewInput::endMode() {
  mode_ = Mode::none;
  drag_.reset();
  overlay_->setBand(std::nullopt);
  camera_.end();
}

/// Shift adds what the band touches, Control changes over.
void ViewInput::endBand(const QMouseEvent& event) {
  QStringList names = document_->selection();
  const bool toggle = (event.modifiers() & Qt::ControlModifier) != 0;
  for (const QString& name : view_.luminairesIn(QRectF(start_, event.position()).normalized())) {
    if (!names.contains(name)) {
      names.append(name);
    } else if (toggle) {
      names.removeAll(name);
    }
  }
  document_->setSelection(names);
}

void ViewInput::click(const QMouseEvent& event) {
  if (tool_ != nullptr) {
    tool_->click(pressed_, event.position(), event.modifiers());
    return;
  }
  // A click takes the luminaire behind the gizmo; only a drag is the gizmo's.
  if (pressed_part_ != GizmoPart::none && pressed_.luminaire.empty()) return;
  const bool add = (event.modifiers() & kAdding) != 0;
  if (!add || !pressed_.luminaire.empty()) select(pressed_.luminaire, add);
  if (pressed_.luminaire.empty() && pressed_.surface) Q_EMIT surfaceClicked(*pressed_.surface);
}

bool ViewInput::release(const QMouseEvent& event) {
  if (event.buttons() != Qt::NoButton) return true;
  const Mode ended = mode_;
  if (document_ == nullptr) {
    endMode();
    return true;
  }
  if (ended == Mode::pressed) click(event);
  if (ended == Mode::band) endBand(event);
  if (ended == Mode::drag) drag_->commit();
  if (ended == Mode::tool && tool_ != nullptr) tool_->letGo();
  endMode();
  hover(event);
  return true;
}

bool ViewInput::doubleClick(const QMouseEvent& event) {
  if (tool_ != nullptr) {
    tool_->doubleClick();
    return true;
  }
  const PointedAt at = view_.pointAt(event.position());
  if (!at.luminaire.empty() && !only_looking_) {
    Q_EMIT editRequested();
  } else if (at.surface) {
    Q_EMIT surfaceDoubleClicked(*at.surface);
  }
  return true;
}

bool ViewInput::wheel(const QWheelEvent& event) {
  if (document_ == nullptr || mode_ == Mode::drag) return true;
  camera_.wheel(event.angleDelta().y() / 120.0, view_.pointAt(event.position()), event.position(),
                (event.modifiers() & Qt::ControlModifier) != 0);
  overlay_->update();
  return true;
}

/// A kind of luminaire from the library: placed where it is let go.
bool ViewInput::drop(QDropEvent& event, QEvent::Type what) {
  const LuminaireType* type = typeOf(event.mimeData());
  if (type == nullptr || document_ == nullptr || only_looking_) return false;
  event.acceptProposedAction();
  if (what == QEvent::DragEnter) {
    setTool(std::make_unique<Placing>(*document_, view_, *type, rules_));
  } else if (tool_ != nullptr) {
    const PointedAt at = view_.pointAt(event.position());
    const Qt::KeyboardModifiers free = event.modifiers() & Qt::AltModifier;
    if (what == QEvent::Drop) {
      tool_->click(at, event.position(), free);
    } else {
      tool_->hover(at, event.position(), free);
    }
  }
  return true;
}

bool ViewInput::wantsKey(const QKeyEvent& event) const {
  if (mode_ == Mode::drag || camera_.wantsKey(event)) return true;
  if (tool_ == nullptr) return false;
  return event.key() == Qt::Key_Escape || event.key() == Qt::Key_Return ||
         event.key() == Qt::Key_Enter || event.key() == Qt::Key_Backspace || tool_->wantsKey(event);
}

bool ViewInput::key(const QKeyEvent& event) {
  if (document_ == nullptr) return false;
  if (camera_.wantsKey(event)) {
    camera_.key(event, true);
    return true;
  }
  const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
  if (event.key() == Qt::Key_Escape) {
    if (mode_ == Mode::drag || mode_ == Mode::band || mode_ == Mode::camera) {
      endMode();
    } else if (tool_ != nullptr) {
      setTool(nullptr);
    } else {
      document_->setSelection({});
    }
    return true;
  }
  if (mode_ == Mode::drag) {
    if (!enter) return drag_->key(event);
    drag_->commit();
    endMode();
    return true;
  }
  return tool_ != nullptr && tool_->key(event);
}

}  // namespace soffit::ui
