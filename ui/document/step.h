// SPDX-License-Identifier: MIT
#pragma once

#include <QUndoCommand>

#include <functional>
#include <utility>

namespace soffit::ui {

/// An undo step of two ways: what SceneCommand does not cover because it is no part of the scene.
class Step : public QUndoCommand {
 public:
  Step(const QString& text, std::function<void()> forth, std::function<void()> back)
      : QUndoCommand(text), forth_(std::move(forth)), back_(std::move(back)) {}
  void redo() override { forth_(); }
  void undo() override { back_(); }

 private:
  std::function<void()> forth_;
  std::function<void()> back_;
};

}  // namespace soffit::ui
