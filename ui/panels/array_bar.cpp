// SPDX-License-Identifier: MIT
#include "ui/panels/array_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

namespace soffit::ui {

ArrayBar::ArrayBar(QWidget* parent)
    : QFrame(parent),
      kind_(new QComboBox),
      columns_(new QSpinBox),
      rows_(new QSpinBox),
      spacing_x_(new QuantityBox(Dimension::length)),
      spacing_y_(new QuantityBox(Dimension::length)),
      radius_(new QuantityBox(Dimension::length)),
      times_(new QLabel(QStringLiteral("\u00d7"))),
      walls_(new QLabel) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  kind_->addItem(tr("Line along x"), static_cast<int>(ArrayKind::line_x));
  kind_->addItem(tr("Line along y"), static_cast<int>(ArrayKind::line_y));
  kind_->addItem(tr("Rectangle"), static_cast<int>(ArrayKind::rectangle));
  kind_->addItem(tr("Circle"), static_cast<int>(ArrayKind::circle));
  for (QSpinBox* box : {columns_, rows_}) {
    box->setRange(1, kMostPerSide);
    box->setKeyboardTracking(false);
  }
  columns_->setToolTip(tr("Luminaires along x"));
  rows_->setToolTip(tr("Luminaires along y"));
  for (QuantityBox* box : {spacing_x_, spacing_y_, radius_}) {
    box->setRange(0.0, 1000.0);
    box->setSteps(0.1, 3);
  }
  spacing_x_->setToolTip(tr("Spacing along x; 0: the walls half a spacing away"));
  spacing_y_->setToolTip(tr("Spacing along y; 0: the walls half a spacing away"));
  radius_->setToolTip(tr("Radius of the circle"));
  auto* apply = new QPushButton(tr("Apply"));
  apply->setDefault(true);
  auto* cancel = new QToolButton;  // narrow: the bar fits a small view in every language
  cancel->setText(QStringLiteral("\u2715"));
  cancel->setToolTip(tr("Cancel"));
  cancel->setAccessibleName(tr("Cancel"));
  cancel->setAutoRaise(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 6, 8, 6);
  row->setSpacing(6);
  for (QWidget* widget : {static_cast<QWidget*>(kind_), static_cast<QWidget*>(columns_),
                          static_cast<QWidget*>(times_), static_cast<QWidget*>(rows_),
                          static_cast<QWidget*>(spacing_x_), static_cast<QWidget*>(spacing_y_),
                          static_cast<QWidget*>(radius_), static_cast<QWidget*>(walls_),
                          static_cast<QWidget*>(apply), static_cast<QWidget*>(cancel)}) {
    row->addWidget(widget);
  }
  connect(kind_, &QComboBox::activated, this, [this] {
    settings_.kind = static_cast<ArrayKind>(kind_->currentData().toInt());
    settings_.spacing = dvec2(0.0);
    settings_.radius = 0.0;
    tell();
  });
  connect(columns_, &QSpinBox::valueChanged, this, [this](int n) {
    settings_.columns = n;
    settings_.spacing.x = 0.0;
    if (settings_.kind == ArrayKind::line_y) settings_.spacing.y = 0.0;
    tell();
  });
  connect(rows_, &QSpinBox::valueChanged, this, [this](int n) {
    settings_.rows = n;
    settings_.spacing.y = 0.0;
    tell();
  });
  connect(spacing_x_, &QuantityBox::edited, this, [this](double v) {
    settings_.spacing.x = v;
    tell();
  });
  connect(spacing_y_, &QuantityBox::edited, this, [this](double v) {
    settings_.spacing.y = v;
    tell();
  });
  connect(radius_, &QuantityBox::edited, this, [this](double v) {
    settings_.radius = v;
    tell();
  });
  connect(apply, &QPushButton::clicked, this, &ArrayBar::applied);
  connect(cancel, &QToolButton::clicked, this, &ArrayBar::cancelled);
}

void ArrayBar::tell() {
  Q_EMIT changed(settings_);
}

void ArrayBar::showPlan(const ArrayPlan& plan, const ArraySettings& wanted) {
  settings_ = wanted;
  const bool circle = plan.settings.kind == ArrayKind::circle;
  const bool along_x =
      plan.settings.kind == ArrayKind::rectangle || plan.settings.kind == ArrayKind::line_x;
  const bool along_y =
      plan.settings.kind == ArrayKind::rectangle || plan.settings.kind == ArrayKind::line_y;
  const QSignalBlocker quiet_columns(columns_);
  const QSignalBlocker quiet_rows(rows_);
  kind_->setCurrentIndex(kind_->findData(static_cast<int>(plan.settings.kind)));
  columns_->setValue(plan.settings.columns);
  rows_->setValue(plan.settings.rows);
  rows_->setVisible(plan.settings.kind == ArrayKind::rectangle);
  times_->setVisible(plan.settings.kind == ArrayKind::rectangle);
  spacing_x_->setValue(plan.settings.spacing.x);
  spacing_y_->setValue(plan.settings.spacing.y);
  radius_->setValue(plan.settings.radius);
  spacing_x_->setVisible(along_x);
  spacing_y_->setVisible(along_y);
  radius_->setVisible(circle);
  QStringList walls;
  if (along_x || circle) walls.append(formatQuantity(plan.wall_distance.x, Dimension::length, 2));
  if (along_y) walls.append(formatQuantity(plan.wall_distance.y, Dimension::length, 2));
  walls_->setText(tr("to the walls %1").arg(walls.join(QStringLiteral(" \u00b7 "))));
  adjustSize();
}

}  // namespace soffit::ui
