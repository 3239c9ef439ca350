// SPDX-License-Identifier: MIT
#include "ui/viewport/evaluation.h"

#include <QSettings>

#include <algorithm>
#include <array>

namespace soffit::ui {
namespace {

const QString kKey = QStringLiteral("view/evaluation");
const std::array<QString, 3> kNames{QStringLiteral("automatic"), QStringLiteral("cpu"),
                                    QStringLiteral("gpu")};

Evaluation saved() {
  const QString name = QSettings().value(kKey).toString();
  const auto found = std::ranges::find(kNames, name);
  return found == kNames.end() ? Evaluation::automatic
                               : static_cast<Evaluation>(found - kNames.begin());
}

}  // namespace

bool isSoftwareRenderer(const QString& renderer) {
  constexpr std::array kPrograms{"llvmpipe",
                                 "softpipe",
                                 "swiftshader",
                                 "swrast",
                                 "software rasterizer",
                                 "microsoft basic render"};
  return std::ranges::any_of(kPrograms, [&](const char* program) {
    return renderer.contains(QLatin1String(program), Qt::CaseInsensitive);
  });
}

EvaluationChoice::EvaluationChoice(QObject* parent) : QObject(parent), wanted_(saved()) {}

void EvaluationChoice::setWanted(Evaluation wanted) {
  if (wanted == wanted_) return;
  wanted_ = wanted;
  QSettings().setValue(kKey, kNames[static_cast<std::size_t>(wanted)]);
  Q_EMIT changed();
}

void EvaluationChoice::setRenderer(const QString& renderer) {
  if (renderer == renderer_) return;
  renderer_ = renderer;
  Q_EMIT changed();
}

void EvaluationChoice::setObstacle(const QString& why) {
  if (why == obstacle_) return;
  obstacle_ = why;
  Q_EMIT changed();
}

bool EvaluationChoice::onGpu() const {
  if (renderer_.isEmpty() || !obstacle_.isEmpty()) return false;
  if (wanted_ != Evaluation::automatic) return wanted_ == Evaluation::gpu;
  return !isSoftwareRenderer(renderer_);
}

QString EvaluationChoice::text() const {
  if (renderer_.isEmpty()) return {};
  return onGpu() ? tr("GPU") : tr("CPU");
}

QString EvaluationChoice::reason() const {
  if (renderer_.isEmpty()) return {};
  if (wanted_ == Evaluation::cpu) {
    return tr("Light in the views is evaluated by the processor, as chosen in the View menu.");
  }
  if (!obstacle_.isEmpty()) {
    return tr("Light in the views is evaluated by the processor: %1.").arg(obstacle_);
  }
  if (wanted_ == Evaluation::gpu) {
    return tr("Light in the views is evaluated by shaders on %1, as chosen in the View menu.")
        .arg(renderer_);
  }
  if (!onGpu()) {
    return tr("Light in the views is evaluated by the processor: there is no graphics processor, "
              "pictures are drawn by a program (%1).")
        .arg(renderer_);
  }
  return tr("Light in the views is evaluated by shaders on the graphics processor (%1).")
      .arg(renderer_);
}

}  // namespace soffit::ui
