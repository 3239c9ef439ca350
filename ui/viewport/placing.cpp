// SPDX-License-Identifier: MIT
#include "ui/viewport/placing.h"

#include "core/light/emitter.h"
#include "ui/document/luminaire_changes.h"
#include "ui/document/text.h"
#include "ui/viewport/luminaire_mesh.h"
#include "ui/widgets/quantity.h"

#include <algorithm>
#include <utility>

namespace soffit::ui {
namespace {

constexpr double kReachPixels = 9.0;

}  // namespace

void addLuminaire(Document& document, const LuminaireType& type, light::Luminaire luminaire) {
  if (!type.photometry.bytes.empty()) {
    luminaire.distribution.file = document.addFile(type.photometry.name, type.photometry.bytes);
  }
  auto* mesh = std::get_if<light::MeshShape>(&luminaire.shape);
  if (mesh != nullptr && !type.mesh.bytes.empty()) {
    mesh->file = document.addFile(type.mesh.name, type.mesh.bytes);
  }
  luminaire.name = toStd(type.name) + " 1";
  QStringList names;
  scene::Scene next =
      withAdded(*document.scene(), toStd(document.layout()), std::span(&luminaire, 1), names);
  document.edit(Placing::tr("Place %1").arg(type.name), std::move(next));
  document.setSelection(names);
}

Placing::Placing(Document& document, SceneView& view, LuminaireType type, const SnapRules& rules)
    : document_(document), view_(view), type_(std::move(type)), rules_(rules) {}

std::optional<Placement> Placing::placementAt(const PointedAt& at,
                                              Qt::KeyboardModifiers keys) const {
  if (!at.surface) return std::nullopt;
  PlacementRules rules;
  rules.snap = rules_;
  const bool free = (keys & Qt::AltModifier) != 0;
  rules.snap.grid = !free && (rules_.grid || (keys & Qt::ControlModifier) != 0);
  const ViewCamera& camera = view_.viewCamera();
  const double depth = glm::dot(at.surface->position - camera.position, camera.forward);
  rules.reach =
      free ? 0.0 : kReachPixels * camera.pixelSize(std::max(depth, 0.1), view_.viewSize());
  rules.turn_deg = turn_deg_;
  return placeOn(type_, *at.surface, view_.surroundings({}), rules);
}

void Placing::show(const std::optional<Placement>& placement) {
  ViewOverlay::Content content;
  if (placement) {
    const dvec3 origin = view_.origin();
    const auto emitter = light::makeEmitter(placement->luminaire, origin);
    if (emitter) {
      const std::vector<vec3> ends = outlineOf(*emitter);
      for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        content.lines.push_back({origin + dvec3(ends[i]),
                                 origin + dvec3(ends[i + 1]),
                                 ViewOverlay::Stroke::outline,
                                 {}});
      }
    }
    for (const Snapped::Guide& g : placement->guides) {
      content.lines.push_back({g.from, g.to, ViewOverlay::Stroke::guide, {}});
    }
    for (const Clearance& c : placement->clearances) {
      content.lines.push_back({c.from, c.to, ViewOverlay::Stroke::measure,
                               formatQuantity(glm::length(c.to - c.from), Dimension::length, 2)});
    }
  }
  Q_EMIT contentChanged(content);
}

void Placing::hover(const PointedAt& at, const QPointF&, Qt::KeyboardModifiers keys) {
  last_ = at;
  last_keys_ = keys;
  show(placementAt(at, keys));
}

void Placing::click(const PointedAt& at, const QPointF&, Qt::KeyboardModifiers keys) {
  const auto placement = placementAt(at, keys);
  if (!placement) return;
  addLuminaire(document_, type_, placement->luminaire);
  if ((keys & Qt::ShiftModifier) == 0) Q_EMIT finished();
}

bool Placing::wantsKey(const QKeyEvent& event) const {
  return event.key() == Qt::Key_Space;
}

bool Placing::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Space) return false;
  turn_deg_ = turn_deg_ >= 180.0 ? turn_deg_ - 270.0 : turn_deg_ + 90.0;
  show(placementAt(last_, last_keys_));
  return true;
}

QString Placing::hint() const {
  return tr("%1: click where it goes. Space: turn. Shift: place several. Alt: no snapping. Esc: "
            "done.")
      .arg(type_.name);
}

}  // namespace soffit::ui
