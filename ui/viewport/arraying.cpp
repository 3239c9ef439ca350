// SPDX-License-Identifier: MIT
#include "ui/viewport/arraying.h"

#include "core/light/emitter.h"
#include "ui/document/luminaire_changes.h"
#include "ui/document/text.h"
#include "ui/viewport/gizmo.h"
#include "ui/widgets/quantity.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kReachPixels = 10.0;
constexpr double kCountHandle = 0.35;  // of a spacing beyond the last luminaire
constexpr double kTenthOfMillimetre = 1e4;

double rounded(double v) {
  return std::round(v * kTenthOfMillimetre) / kTenthOfMillimetre;
}

/// The walls about a place, or the building's box where there are none.
ArrayField fieldAround(const Surroundings& around, const dvec3& place, const Box& bounds,
                       const dvec3& origin) {
  ArrayField field;
  const dvec3 from = place - dvec3(0.0, 0.0, 0.05);
  for (int axis = 0; axis < 2; ++axis) {
    const auto low = around.distance(from, -axisOf(axis));
    const auto high = around.distance(from, axisOf(axis));
    const double box_low =
        bounds.empty() ? place[axis] - 3.0 : origin[axis] + static_cast<double>(bounds.lo[axis]);
    const double box_high =
        bounds.empty() ? place[axis] + 3.0 : origin[axis] + static_cast<double>(bounds.hi[axis]);
    field.lo[axis] = low ? place[axis] - *low : std::min(box_low, place[axis] - 0.5);
    field.hi[axis] = high ? place[axis] + *high : std::max(box_high, place[axis] + 0.5);
  }
  field.through = dvec2(place);
  return field;
}

}  // namespace

Arraying::Arraying(Document& document, SceneView& view, ArrayKind kind)
    : document_(document), view_(view), before_(document.scene()) {
  const light::Luminaire* seed =
      document.selection().isEmpty() ? nullptr : document.luminaire(document.selection().front());
  if (seed == nullptr) return;
  seed_ = *seed;
  settings_.kind = kind;
  if (kind == ArrayKind::circle) settings_.columns = 8;
  // Luminaires are no walls: rays meet the building alone.
  field_ = fieldAround(view_.surroundings({}), seed_.position, view_.bounds(), view_.origin());
  if (const auto emitter = light::makeEmitter(seed_); emitter && !emitter->bounds.empty()) {
    size_ = dvec2(emitter->bounds.size());
  }
  connect(&document_, &Document::sceneChanged, this, [this] {
    // Something else was edited, or undone: the array is given up.
    if (!updating_ && !document_.previewing()) Q_EMIT finished();
  });
  update();
}

void Arraying::end() {
  disconnect(&document_, nullptr, this, nullptr);
  if (document_.previewing()) document_.cancelPreview();
}

void Arraying::setSettings(const ArraySettings& settings) {
  settings_ = settings;
  update();
}

void Arraying::update() {
  if (seed_.name.empty()) return;
  plan_ = planArray(settings_, field_, size_);
  std::vector<light::Luminaire> copies;
  const auto placed = [&](std::size_t i) {
    light::Luminaire one = seed_;
    one.position.x = rounded(plan_.places[i].x);
    one.position.y = rounded(plan_.places[i].y);
    one.rotation_deg.z = rounded(std::remainder(seed_.rotation_deg.z + plan_.turn_deg[i], 360.0));
    return one;
  };
  for (std::size_t i = 1; i < plan_.places.size(); ++i) copies.push_back(placed(i));
  const std::string layout = toStd(document_.layout());
  QStringList names;
  scene::Scene next = withAdded(*before_, layout, copies, names);
  next = withChanged(next, layout, {toQt(seed_.name)}, [&](light::Luminaire& l) { l = placed(0); });
  updating_ = true;
  document_.previewScene(std::move(next));
  document_.setSelection(QStringList{toQt(seed_.name)} + names);
  updating_ = false;
  show();
  // Counts that were cut down to fit go on from there.
  settings_.columns = plan_.settings.columns;
  settings_.rows = plan_.settings.rows;
  Q_EMIT planChanged(plan_, settings_);
}

void Arraying::apply() {
  updating_ = true;
  const QStringList names = document_.selection();
  document_.commitPreview(
      tr("Array of %n luminaires", nullptr, static_cast<int>(plan_.places.size())));
  document_.setSelection(names);
  updating_ = false;
  Q_EMIT finished();
}

std::vector<Arraying::Grip> Arraying::grips() const {
  std::vector<Grip> all;
  if (plan_.places.empty()) return all;
  const double z = seed_.position.z;
  if (settings_.kind == ArrayKind::circle) {
    all.push_back({Handle::spacing_x, dvec3(plan_.places.front(), z)});
    return all;
  }
  const dvec2 last = plan_.places.back();
  const dvec2 first = plan_.places.front();
  const dvec2 step = plan_.settings.spacing;
  if (settings_.kind != ArrayKind::line_y) {
    const dvec3 end(last.x, first.y, z);
    if (plan_.settings.columns > 1) all.push_back({Handle::spacing_x, end});
    all.push_back({Handle::columns, end + dvec3(kCountHandle * step.x, 0, 0)});
  }
  if (settings_.kind != ArrayKind::line_x) {
    const dvec3 end(first.x, last.y, z);
    if (last.y > first.y) all.push_back({Handle::spacing_y, end});
    all.push_back({Handle::rows, end + dvec3(0, kCountHandle * step.y, 0)});
  }
  return all;
}

Arraying::Handle Arraying::handleAt(const QPointF& mouse) const {
  for (const Grip& grip : grips()) {
    const dvec3 at = view_.viewCamera().project(grip.at, view_.viewSize());
    if (at.z > 0.0 && glm::length(dvec2(at) - dvec2(mouse.x(), mouse.y())) < kReachPixels) {
      return grip.handle;
    }
  }
  return Handle::none;
}

std::optional<dvec2> Arraying::onPlan(const QPointF& mouse) const {
  const ViewCamera& camera = view_.viewCamera();
  const dvec2 pixel(mouse.x(), mouse.y());
  const auto hit = onPlane(seed_.position, axisOf(2), camera.rayOrigin(pixel, view_.viewSize()),
                           camera.rayThrough(pixel, view_.viewSize()));
  if (!hit) return std::nullopt;
  return dvec2(*hit);
}

bool Arraying::grab(const QPointF& mouse) {
  held_ = handleAt(mouse);
  const auto from = onPlan(mouse);
  if (held_ == Handle::none || !from) return false;
  held_from_ = *from;
  held_settings_ = plan_.settings;
  return true;
}

void Arraying::dragTo(const QPointF& mouse) {
  const auto to = onPlan(mouse);
  if (!to) return;
  const dvec2 center = 0.5 * (field_.lo + field_.hi);
  const auto spacing = [&](int axis, int count) {
    // Both ends move apart: the array stays in the middle of the field.
    return std::max(2.0 * ((*to)[axis] - center[axis]) / std::max(count - 1, 1), 0.01);
  };
  const auto count = [&](int axis, int before) {
    const double step = held_settings_.spacing[axis];
    return std::max(1, before + static_cast<int>(std::lround(((*to)[axis] - held_from_[axis]) /
                                                             std::max(0.5 * step, 0.1))));
  };
  const bool line_y = settings_.kind == ArrayKind::line_y;
  switch (held_) {
    case Handle::spacing_x:
      if (settings_.kind == ArrayKind::circle) {
        settings_.radius = std::round(100.0 * glm::length(*to - center)) / 100.0;
      } else {
        settings_.spacing.x = std::round(100.0 * spacing(0, plan_.settings.columns)) / 100.0;
      }
      break;
    case Handle::spacing_y:
      settings_.spacing.y =
          std::round(100.0 * spacing(1, line_y ? plan_.settings.columns : plan_.settings.rows)) /
          100.0;
      break;
    case Handle::columns:
      settings_.columns = count(0, held_settings_.columns);
      settings_.spacing.x = 0.0;
      break;
    case Handle::rows:
      (line_y ? settings_.columns : settings_.rows) =
          count(1, line_y ? held_settings_.columns : held_settings_.rows);
      settings_.spacing.y = 0.0;
      break;
    case Handle::none:
      return;
  }
  update();
}

void Arraying::letGo() {
  held_ = Handle::none;
  show();
}

void Arraying::hover(const PointedAt&, const QPointF& mouse, Qt::KeyboardModifiers) {
  const Handle now = handleAt(mouse);
  if (now == lit_) return;
  lit_ = now;
  show();
}

void Arraying::show() {
  ViewOverlay::Content content;
  const double z = seed_.position.z;
  const auto place = [&](const dvec2& p) { return dvec3(p, z); };
  const auto measure = [&](const dvec2& from, const dvec2& to) {
    content.lines.push_back({place(from), place(to), ViewOverlay::Stroke::measure,
                             formatQuantity(glm::length(to - from), Dimension::length, 2)});
  };
  const dvec2 lo = field_.lo;
  const dvec2 hi = field_.hi;
  const dvec2 corners[] = {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
  for (int i = 0; i < 4; ++i) {
    content.lines.push_back(
        {place(corners[i]), place(corners[(i + 1) % 4]), ViewOverlay::Stroke::guide, {}});
  }
  const auto& places = plan_.places;
  if (settings_.kind == ArrayKind::circle && !places.empty()) {
    measure(0.5 * (lo + hi), places.front());
  } else if (!places.empty()) {
    const dvec2 first = places.front();
    if (settings_.kind != ArrayKind::line_y) measure({lo.x, first.y}, first);
    if (settings_.kind != ArrayKind::line_x) measure({first.x, lo.y}, first);
    const dvec2 step = plan_.settings.spacing;
    if (places.back().x > first.x) measure(first, first + dvec2(step.x, 0.0));
    if (places.back().y > first.y) measure(first, first + dvec2(0.0, step.y));
  }
  for (const Grip& grip : grips()) {
    const bool count = grip.handle == Handle::columns || grip.handle == Handle::rows;
    content.handles.push_back({grip.at, count, grip.handle == lit_ || grip.handle == held_});
  }
  Q_EMIT contentChanged(content);
}

bool Arraying::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter) return false;
  apply();
  return true;
}

QString Arraying::hint() const {
  return tr("Drag squares for the spacing, disks for the count. Enter: apply. Esc: give up.");
}

}  // namespace soffit::ui
