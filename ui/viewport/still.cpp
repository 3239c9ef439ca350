// SPDX-License-Identifier: MIT
#include "ui/viewport/still.h"

#include "ui/viewport/pointing.h"

#include <QPainter>

#include <algorithm>

namespace soffit::ui {
namespace {

void paintLines(QPainter& painter, const Still& still, const dvec2& size) {
  const dvec3 origin = still.scene->mesh->origin;
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Still::Lines& lines : still.lines) {
    painter.setPen(QPen(QColor::fromRgbF(lines.color.x, lines.color.y, lines.color.z), lines.width,
                        Qt::SolidLine, Qt::FlatCap));
    for (std::size_t i = 0; i + 1 < lines.ends.size(); i += 2) {
      const dvec3 a = still.camera.project(origin + dvec3(lines.ends[i]), size);
      const dvec3 b = still.camera.project(origin + dvec3(lines.ends[i + 1]), size);
      if (a.z <= 0.0 || b.z <= 0.0) continue;
      painter.drawLine(QPointF(a.x, a.y), QPointF(b.x, b.y));
    }
  }
}

}  // namespace

void paintMarks(const Still& still, Picture& picture) {
  if (picture.image.isNull() || still.scene == nullptr) return;
  const double ratio =
      std::max(1.0, static_cast<double>(picture.image.height()) / std::max(1.0, still.view_height));
  const dvec2 size = dvec2(picture.image.width(), picture.image.height()) / ratio;
  const Pointable things{still.scene.get(), still.frame.get(), still.luminaires.get(),
                         still.cut_away};
  const Sight sight{still.camera, size,
                    [&](const dvec3& place) { return isSeen(things, still.camera, place); }};
  SeenMarks seen = seenFrom(still.marks, sight, still.font);
  if (!picture.lux.lux.empty()) {
    const auto labels =
        render::placeLineLabels(picture.lux, still.look.levels, labelRoom(still.font, 1.0 / ratio));
    addLineLabels(labels, 1.0 / ratio, still.look.scale, still.font, seen);
  }
  QPainter painter(&picture.image);
  painter.scale(ratio, ratio);
  painter.setFont(still.font);
  paintLines(painter, still, size);
  paint(painter, seen);
}

}  // namespace soffit::ui
