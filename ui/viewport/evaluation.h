// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include <cstdint>

namespace soffit::ui {

/// Where light that depends on what is in hand, or on the eye, is evaluated: by the processor, or
/// by shaders that give the same within one code value.
enum class Evaluation : std::uint8_t { automatic, cpu, gpu };

/// Whether what OpenGL calls itself (GL_RENDERER) is a program that runs on the processor.
[[nodiscard]] bool isSoftwareRenderer(const QString& renderer);

/// What the user chose, what the machine can, and what comes of it. The choice is kept in the
/// settings.
class EvaluationChoice : public QObject {
  Q_OBJECT

 public:
  explicit EvaluationChoice(QObject* parent = nullptr);

  [[nodiscard]] Evaluation wanted() const { return wanted_; }
  void setWanted(Evaluation wanted);
  /// GL_RENDERER of the views.
  void setRenderer(const QString& renderer);
  /// Why the graphics processor cannot do it, a sentence without its full stop; empty: it can.
  void setObstacle(const QString& why);

  /// Automatic: where there is a graphics processor. A program in its place would do the same work
  /// on the same cores, with more to carry.
  [[nodiscard]] bool onGpu() const;
  /// For the status bar: a word, and the sentence that says why. Empty before there is a renderer.
  [[nodiscard]] QString text() const;
  [[nodiscard]] QString reason() const;

 Q_SIGNALS:
  void changed();

 private:
  Evaluation wanted_;
  QString renderer_;
  QString obstacle_;
};

}  // namespace soffit::ui
