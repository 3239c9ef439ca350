// SPDX-License-Identifier: MIT
#include "ui/document/environment_edits.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace soffit::ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

}  // namespace

QStringList skyNames() {
  return {tr("Overcast, steep gradation"),
          tr("Overcast, steep, brighter toward the sun"),
          tr("Overcast, moderate gradation"),
          tr("Overcast, moderate, brighter toward the sun"),
          tr("Uniform"),
          tr("Partly cloudy, slightly brighter toward the sun"),
          tr("Partly cloudy, bright around the sun"),
          tr("Partly cloudy, distinct corona"),
          tr("Partly cloudy, sun obscured"),
          tr("Partly cloudy, bright around the sun, darker zenith"),
          tr("White-blue, distinct corona"),
          tr("Clear, low turbidity"),
          tr("Clear, polluted air"),
          tr("Cloudless, turbid, broad corona"),
          tr("White-blue, turbid, broad corona"),
          tr("Traditional overcast (1 : 3)")};
}

OutsideKind kindOf(const std::optional<scene::Environment>& environment) {
  if (!environment) return OutsideKind::none;
  if (std::holds_alternative<scene::Sky>(environment->light)) return OutsideKind::sky;
  const bool picture = std::holds_alternative<scene::Probe>(environment->light);
  return picture ? OutsideKind::picture : OutsideKind::analytic;
}

scene::ProbeLayout likelyLayout(const scene::Image& image) {
  const double ratio = static_cast<double>(image.width) / std::max(1, image.height);
  if (ratio > 1.6) return scene::ProbeLayout::lat_long;
  return ratio > 0.9 && ratio < 1.15 ? scene::ProbeLayout::angular : scene::ProbeLayout::cross;
}

void editEnvironment(Document& document, const QString& text,
                     std::optional<scene::Environment> environment, int merge_key) {
  document.cancelPreview();
  scene::Scene next = *document.scene();
  next.environment = std::move(environment);
  document.edit(text, std::move(next), merge_key);
}

void previewEnvironment(Document& document, std::optional<scene::Environment> environment) {
  scene::Scene next = *document.scene();
  next.environment = std::move(environment);
  document.previewScene(std::move(next));
}

}  // namespace soffit::ui
