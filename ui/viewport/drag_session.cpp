// SPDX-License-Identifier: MIT
#include "ui/viewport/drag_session.h"

#include "ui/document/luminaire_changes.h"
#include "ui/document/text.h"
#include "ui/widgets/quantity.h"

#include <QKeyEvent>

namespace soffit::ui {

DragSession::DragSession(SceneView& view, ViewOverlay& overlay, Document& document, GizmoTool tool,
                         GizmoPart part, const QPointF& mouse, bool copies, const SnapRules& rules)
    : view_(view),
      overlay_(overlay),
      document_(document),
      copies_(copies),
      originals_(document.selection()),
      names_(document.selection()) {
  LuminaireDrag::Start start;
  start.tool = tool;
  start.part = part;
  start.pivot = view_.gizmoPlace().value_or(dvec3(0.0));
  start.frame = view_.gizmoFrame();
  start.half_size = view_.selectionHalfSize();
  start.camera = view_.viewCamera();
  start.view_size = view_.viewSize();
  start.mouse = {mouse.x(), mouse.y()};
  // Copies are measured against their originals, too.
  drag_.emplace(start, view_.surroundings(copies ? QStringList() : names_), rules);
  if (!copies_) return;
  std::vector<light::Luminaire> added;
  for (const QString& name : names_) {
    if (const light::Luminaire* original = document_.luminaire(name)) added.push_back(*original);
  }
  names_.clear();
  document_.previewScene(withAdded(*document_.scene(), toStd(document_.layout()), added, names_));
  document_.setSelection(names_);
}

DragSession::~DragSession() {
  overlay_.setContent({});
  if (!document_.previewing()) return;
  document_.cancelPreview();
  if (copies_) document_.setSelection(originals_);
}

void DragSession::moveTo(const QPointF& mouse, Qt::KeyboardModifiers modifiers) {
  drag_->moveTo({mouse.x(), mouse.y()}, (modifiers & Qt::ControlModifier) != 0,
                (modifiers & Qt::AltModifier) != 0);
  show();
}

bool DragSession::key(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_X:
    case Qt::Key_Y:
    case Qt::Key_Z:
      drag_->lockAxis(event.key() - Qt::Key_X);
      break;
    case Qt::Key_Backspace:
      if (!drag_->type(QLatin1Char('\b'))) return false;
      break;
    default:
      if (event.text().size() != 1 || !drag_->type(event.text().front())) return false;
  }
  show();
  return true;
}

void DragSession::show() {
  document_.preview(names_, [this](light::Luminaire& l) { drag_->apply(l); });
  view_.setGizmoHighlight(drag_->part());
  const DragReadout readout = drag_->readout();
  ViewOverlay::Content content;
  for (const Snapped::Guide& g : readout.guides) {
    content.lines.push_back({g.from, g.to, ViewOverlay::Stroke::guide, {}});
  }
  for (const Clearance& c : readout.clearances) {
    content.lines.push_back({c.from, c.to, ViewOverlay::Stroke::measure,
                             formatQuantity(glm::length(c.to - c.from), Dimension::length, 2)});
  }
  content.labels.push_back({readout.at, readout.text});
  overlay_.setContent(std::move(content));
}

QString DragSession::stepText() const {
  const int count = static_cast<int>(names_.size());
  const QString one = names_.isEmpty() ? QString() : names_.front();
  if (copies_)
    return count == 1 ? tr("Copy to %1").arg(one) : tr("Copy %n luminaires", nullptr, count);
  switch (drag_->tool()) {
    case GizmoTool::rotate:
      return count == 1 ? tr("Rotate %1").arg(one) : tr("Rotate %n luminaires", nullptr, count);
    case GizmoTool::scale:
      return count == 1 ? tr("Resize %1").arg(one) : tr("Resize %n luminaires", nullptr, count);
    default:
      return count == 1 ? tr("Move %1").arg(one) : tr("Move %n luminaires", nullptr, count);
  }
}

void DragSession::commit() {
  document_.commitPreview(stepText());
}

}  // namespace soffit::ui
