// SPDX-License-Identifier: MIT
#include "ui/document/scene_command.h"

#include <utility>

namespace soffit::ui {

SceneCommand::SceneCommand(const QString& text, ScenePtr before, ScenePtr after, QString layout,
                           int merge_key, Show show)
    : QUndoCommand(text),
      before_(std::move(before)),
      after_(std::move(after)),
      layout_(std::move(layout)),
      layout_after_(layout_),
      merge_key_(merge_key),
      show_(std::move(show)) {}

bool SceneCommand::mergeWith(const QUndoCommand* other) {
  const auto* later = dynamic_cast<const SceneCommand*>(other);
  if (later == nullptr || later->layout_ != layout_ || later->text() != text()) return false;
  after_ = later->after_;
  return true;
}

void SceneCommand::undo() {
  show_(before_, layout_);
}

void SceneCommand::redo() {
  show_(after_, layout_after_);
}

}  // namespace soffit::ui
