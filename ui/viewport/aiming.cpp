// SPDX-License-Identifier: MIT
#include "ui/viewport/aiming.h"

#include "ui/document/luminaire_pose.h"
#include "ui/widgets/quantity.h"

namespace soffit::ui {

void Aiming::hover(const PointedAt& at, const QPointF&, Qt::KeyboardModifiers) {
  ViewOverlay::Content content;
  if (at.surface) {
    for (const QString& name : document_.selection()) {
      const light::Luminaire* luminaire = document_.luminaire(name);
      if (luminaire == nullptr) continue;
      const double distance = glm::length(at.surface->position - luminaire->position);
      content.lines.push_back({luminaire->position, at.surface->position,
                               ViewOverlay::Stroke::outline,
                               formatQuantity(distance, Dimension::length, 2)});
    }
  }
  Q_EMIT contentChanged(content);
}

void Aiming::click(const PointedAt& at, const QPointF&, Qt::KeyboardModifiers keys) {
  if (!at.surface) return;
  const dvec3 target = at.surface->position;
  document_.editLuminaires(tr("Aim"), document_.selection(), [&](light::Luminaire& l) {
    const dvec3 way = target - l.position;
    const double length = glm::length(way);
    if (length > 1e-6) l.rotation_deg = aimedAlong(way / length, l.rotation_deg);
  });
  if ((keys & Qt::ShiftModifier) == 0) Q_EMIT finished();
}

QString Aiming::hint() const {
  return tr("Click the point to aim at. Shift: aim again. Esc: done.");
}

}  // namespace soffit::ui
