// SPDX-License-Identifier: MIT
#include "ui/viewport/luminaire_drag.h"

#include "ui/document/luminaire_pose.h"
#include "ui/widgets/quantity.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr double kFineStep = 1e-3;  // m: dragged places are whole millimetres
constexpr double kReachPixels = 9.0;
constexpr double kAngleStep = 1.0;    // deg
constexpr double kAngleNotch = 15.0;  // deg, stepped
constexpr double kFactorStep = 0.01;
constexpr double kFactorNotch = 0.1;

double rounded(double v, double step) {
  return std::round(v / step) / std::round(1.0 / step);
}

QString axisName(int axis) {
  return QString(QLatin1Char("xyz"[axis]));
}

QString signedLength(double metres) {
  const QString text = formatQuantity(std::abs(metres), Dimension::length, 3);
  return (metres < 0.0 ? QStringLiteral("\u2212") : QStringLiteral("+")) + text;
}

GizmoPart partOf(int axis) {
  constexpr GizmoPart kParts[] = {GizmoPart::x, GizmoPart::y, GizmoPart::z};
  return kParts[axis];
}

}  // namespace

LuminaireDrag::LuminaireDrag(const Start& start, Surroundings around, const SnapRules& rules)
    : start_(start),
      around_(std::move(around)),
      rules_(rules),
      part_(start.part),
      mouse_(start.mouse) {
  restart();
}

void LuminaireDrag::restart() {
  moving_.reset();
  turning_.reset();
  scaling_.reset();
  switch (start_.tool) {
    case GizmoTool::move:
      moving_.emplace(part_, start_.pivot, start_.camera, start_.view_size, start_.mouse);
      break;
    case GizmoTool::rotate:
      turning_.emplace(part_, start_.pivot, start_.camera, start_.view_size, start_.mouse);
      break;
    case GizmoTool::scale:
      scaling_.emplace(part_, start_.pivot, start_.frame, start_.camera, start_.view_size,
                       start_.mouse);
      break;
  }
}

void LuminaireDrag::moveTo(const dvec2& mouse, bool stepped, bool free) {
  mouse_ = mouse;
  stepped_ = stepped;
  free_ = free;
  update();
}

void LuminaireDrag::lockAxis(int axis) {
  part_ = part_ == partOf(axis) && part_ != start_.part ? start_.part : partOf(axis);
  restart();
  update();
}

bool LuminaireDrag::type(QChar character) {
  if (character == QLatin1Char('\b')) {
    if (typed_.isEmpty()) return false;
    typed_.chop(1);
  } else if (character.isDigit() || QStringLiteral("+-.,%").contains(character) ||
             (!typed_.isEmpty() &&
              (character.isLetter() || character == QLatin1Char(' ') ||
               character == QLatin1Char('\'') || character == QLatin1Char('"')))) {
    typed_.append(character);
  } else {
    return false;
  }
  update();
  return true;
}

std::optional<double> LuminaireDrag::typedValue() const {
  if (typed_.isEmpty()) return std::nullopt;
  switch (start_.tool) {
    case GizmoTool::move:
      return parseQuantity(typed_, Dimension::length);
    case GizmoTool::rotate:
      return parseQuantity(typed_, Dimension::angle);
    case GizmoTool::scale: {
      // A bare number is a factor, with % a percentage.
      const auto share = parseQuantity(typed_, Dimension::share);
      if (!share || *share <= 0.0) return std::nullopt;
      return typed_.contains(QLatin1Char('%')) ? *share : 100.0 * *share;
    }
  }
  return std::nullopt;
}

glm::bvec3 LuminaireDrag::axes() const {
  const int axis = axisIndexOf(part_);
  glm::bvec3 along(false);
  for (int i = 0; i < 3; ++i) along[i] = isAxis(part_) == (i == axis);
  return along;
}

void LuminaireDrag::update() {
  guides_.clear();
  if (moving_) updateMove();
  if (turning_) updateTurn();
  if (scaling_) updateScale();
}

void LuminaireDrag::updateMove() {
  const dvec3 at = moving_->moved(start_.camera, start_.view_size, mouse_);
  const glm::bvec3 along = axes();
  offset_ = dvec3(0.0);
  for (int i = 0; i < 3; ++i) {
    if (along[i]) offset_[i] = at[i] - start_.pivot[i];
  }
  if (const auto value = typedValue()) {
    // Along the axis, or the way that the mouse went.
    const double length = glm::length(offset_);
    if (isAxis(part_)) {
      offset_ = *value * axisOf(axisIndexOf(part_));
    } else if (length > 0.0) {
      offset_ *= *value / length;
    }
    return;
  }
  const double depth = glm::dot(start_.pivot - start_.camera.position, start_.camera.forward);
  const double reach =
      kReachPixels * start_.camera.pixelSize(std::max(depth, 0.1), start_.view_size);
  SnapRules rules = rules_;
  rules.grid = !free_ && (stepped_ || rules_.grid);
  const Snapped snapped =
      snap(around_, rules, start_.pivot + offset_, along, start_.half_size, free_ ? 0.0 : reach);
  for (int i = 0; i < 3; ++i) {
    if (!along[i]) continue;
    const double place = snapped.place[i];
    // Rounded as a way, so that what moves together keeps its distances.
    offset_[i] = rounded(place - start_.pivot[i], free_ ? 1e-4 : kFineStep);
  }
  guides_ = snapped.guides;
}

void LuminaireDrag::updateTurn() {
  const double angle = turning_->angleDeg(start_.camera, start_.view_size, mouse_);
  const double step = stepped_ ? kAngleNotch : kAngleStep;
  angle_deg_ =
      typedValue().value_or(free_ ? rounded(angle, 0.01) : step * std::round(angle / step));
}

void LuminaireDrag::updateScale() {
  const double factor = scaling_->factor(mouse_);
  const double step = stepped_ ? kFactorNotch : kFactorStep;
  factor_ = typedValue().value_or(free_ ? factor : std::max(rounded(factor, step), step));
}

dvec3 LuminaireDrag::factors() const {
  if (!isAxis(part_)) return dvec3(factor_);
  dvec3 f(1.0);
  f[axisIndexOf(part_)] = factor_;
  return f;
}

void LuminaireDrag::apply(light::Luminaire& luminaire) const {
  switch (start_.tool) {
    case GizmoTool::move:
      for (int i = 0; i < 3; ++i) {
        if (offset_[i] == 0.0) continue;
        luminaire.position[i] = rounded(luminaire.position[i] + offset_[i], 1e-4);
      }
      break;
    case GizmoTool::rotate:
      if (angle_deg_ != 0.0) turn(luminaire, axisIndexOf(part_), angle_deg_, start_.pivot);
      break;
    case GizmoTool::scale:
      if (factor_ != 1.0) resize(luminaire, factors());
      break;
  }
}

DragReadout LuminaireDrag::readout() const {
  DragReadout out;
  out.at = start_.pivot + (start_.tool == GizmoTool::move ? offset_ : dvec3(0.0));
  out.guides = guides_;
  const int axis = axisIndexOf(part_);
  QString value;
  switch (start_.tool) {
    case GizmoTool::move: {
      const glm::bvec3 along = axes();
      QStringList parts;
      for (int i = 0; i < 3; ++i) {
        if (along[i]) parts.append(axisName(i) + QLatin1Char(' ') + signedLength(offset_[i]));
      }
      value = parts.join(QStringLiteral("   "));
      out.clearances = clearances(around_, out.at, along);
      break;
    }
    case GizmoTool::rotate:
      value = axisName(axis) + QLatin1Char(' ') + formatQuantity(angle_deg_, Dimension::angle, 2);
      break;
    case GizmoTool::scale:
      value = (isAxis(part_) ? axisName(axis) + QLatin1Char(' ') : QString()) +
              formatQuantity(factor_, Dimension::share, 1);
      break;
  }
  if (typed_.isEmpty()) {
    out.text = value;
  } else {
    const bool understood = typedValue().has_value();
    out.text = (isAxis(part_) ? axisName(axis) + QLatin1Char(' ') : QString()) + typed_ +
               (understood ? QStringLiteral("_") : QStringLiteral("_ ?"));
  }
  return out;
}

}  // namespace soffit::ui
