// SPDX-License-Identifier: MIT
#include "ui/panels/shape_fields.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

#include <vector>

namespace soffit::ui {
namespace {

/// Kinds in the order of light::Shape's alternatives.
enum Kind { kPoint, kRectangle, kDisk, kSphere, kTube, kPolygon, kMesh };

light::Shape madeShape(int kind) {
  switch (kind) {
    case kRectangle:
      return light::Rectangle{};
    case kDisk:
      return light::Disk{};
    case kSphere:
      return light::Sphere{};
    case kTube:
      return light::Tube{1.2, 0.025};
    default:
      return light::PointShape{};
  }
}

/// A size that a person changes: its name, and where it is kept, with the factor from what is
/// shown.
struct Size {
  QString name;
  double* value = nullptr;
  double factor = 1.0;
};

std::vector<Size> sizesOf(light::Shape& shape) {
  if (auto* r = std::get_if<light::Rectangle>(&shape)) {
    return {{ShapeFields::tr("along x"), &r->width, 1.0},
            {ShapeFields::tr("along y"), &r->height, 1.0}};
  }
  if (auto* d = std::get_if<light::Disk>(&shape))
    return {{QStringLiteral("\u2300"), &d->radius, 0.5}};
  if (auto* s = std::get_if<light::Sphere>(&shape)) {
    return {{QStringLiteral("\u2300"), &s->radius, 0.5}};
  }
  if (auto* t = std::get_if<light::Tube>(&shape)) {
    return {{ShapeFields::tr("length"), &t->length, 1.0},
            {QStringLiteral("\u2300"), &t->radius, 0.5}};
  }
  return {};
}

}  // namespace

ShapeFields::ShapeFields(QWidget* parent) : QWidget(parent), kind_(new QComboBox) {
  for (const QString& name : {tr("Point"), tr("Rectangle"), tr("Disk"), tr("Sphere"), tr("Tube")}) {
    kind_->addItem(name);
  }
  kind_->setAccessibleName(tr("Shape"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(3);
  grid->addWidget(kind_, 0, 0, 1, 2);
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    labels_[i] = new QLabel;
    sizes_[i] = new QuantityBox(Dimension::length);
    sizes_[i]->setRange(1e-3, 1000.0);
    sizes_[i]->setSteps(0.05, 3);
    grid->addWidget(labels_[i], static_cast<int>(i) + 1, 0);
    grid->addWidget(sizes_[i], static_cast<int>(i) + 1, 1);
    connect(sizes_[i], &QuantityBox::edited, this, [this, i](double v) { take(i, v); });
  }
  grid->setColumnStretch(1, 1);
  connect(kind_, &QComboBox::activated, this, [this](int kind) {
    if (kind >= kPolygon || kind == static_cast<int>(shape_.index())) return;
    shape_ = madeShape(kind);
    showSizes();
    Q_EMIT edited(light::Shape(shape_));
  });
}

void ShapeFields::take(std::size_t size, double value) {
  const auto sizes = sizesOf(shape_);
  if (size >= sizes.size()) return;
  *sizes[size].value = value * sizes[size].factor;
  Q_EMIT edited(light::Shape(shape_));
}

void ShapeFields::showShape(const light::Shape* shape) {
  setEnabled(shape != nullptr);
  if (shape == nullptr) {
    kind_->setCurrentIndex(-1);
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      labels_[i]->hide();
      sizes_[i]->hide();
    }
    return;
  }
  shape_ = *shape;
  // What cannot be chosen is listed only while it is there.
  while (kind_->count() > kPolygon) kind_->removeItem(kind_->count() - 1);
  if (shape_.index() >= kPolygon) {
    kind_->addItem(shape_.index() == kPolygon ? tr("Polygon") : tr("Mesh"));
    kind_->setCurrentIndex(kPolygon);
  } else {
    kind_->setCurrentIndex(static_cast<int>(shape_.index()));
  }
  showSizes();
}

void ShapeFields::showSizes() {
  const auto sizes = sizesOf(shape_);
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    const bool there = i < sizes.size();
    labels_[i]->setVisible(there);
    sizes_[i]->setVisible(there);
    if (!there) continue;
    labels_[i]->setText(sizes[i].name);
    sizes_[i]->setAccessibleName(sizes[i].name);
    sizes_[i]->setValue(*sizes[i].value / sizes[i].factor);
  }
}

}  // namespace soffit::ui
