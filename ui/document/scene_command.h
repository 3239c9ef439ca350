// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/scene.h"

#include <QUndoCommand>

#include <functional>
#include <memory>
#include <utility>

namespace soffit::ui {

using ScenePtr = std::shared_ptr<const scene::Scene>;

/// Any change to the scene as one undo step: the snapshot before and the one after. Snapshots share
/// what did not change, so a step costs the lists of luminaires and layouts, never the geometry.
class SceneCommand : public QUndoCommand {
 public:
  /// Shows a snapshot; `layout` is the layout that is shown with it.
  using Show = std::function<void(const ScenePtr&, const QString& layout)>;

  /// merge_key  changes with the same key other than -1 that follow one another are one step (a
  ///            slider's, the digits typed into a box).
  SceneCommand(const QString& text, ScenePtr before, ScenePtr after, QString layout, int merge_key,
               Show show);
  /// Another layout is shown after the change than before it (it came, went or was renamed).
  void setLayoutAfter(QString layout) { layout_after_ = std::move(layout); }

  [[nodiscard]] int id() const override { return merge_key_; }
  bool mergeWith(const QUndoCommand* other) override;
  void undo() override;
  void redo() override;

 private:
  ScenePtr before_;
  ScenePtr after_;
  QString layout_;
  QString layout_after_;
  int merge_key_;
  Show show_;
};

}  // namespace soffit::ui
