// SPDX-License-Identifier: MIT
#include "ui/panels/comparison_bar.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

namespace soffit::ui {
namespace {

QString nameOf(const QString& layout) {
  return layout.isEmpty() ? ComparisonBar::tr("Base") : layout;
}

}  // namespace

ComparisonBar::ComparisonBar(QWidget* parent)
    : QFrame(parent),
      first_(new QLabel),
      second_(new QComboBox),
      modes_(new QButtonGroup(this)),
      range_fields_(new QWidget),
      range_(new QuantityBox(Dimension::illuminance)) {
  setObjectName(QStringLiteral("comparison_bar"));
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 4, 4, 4);
  row->setSpacing(6);
  QFont bold = first_->font();
  bold.setBold(true);
  first_->setFont(bold);
  row->addWidget(first_);
  auto* swap = new QToolButton;
  swap->setText(QStringLiteral("\u21c4"));
  swap->setToolTip(tr("Swap: edit the other layout"));
  swap->setAccessibleName(tr("Swap the layouts"));
  swap->setAutoRaise(true);
  row->addWidget(swap);
  second_->setAccessibleName(tr("Layout to compare with"));
  second_->setToolTip(tr("Layout to compare with"));
  second_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  row->addWidget(second_);
  row->addSpacing(8);
  const std::pair<ComparisonMode, std::pair<QString, QString>> modes[] = {
      {ComparisonMode::split, {tr("Split"), tr("A slider between the two")}},
      {ComparisonMode::side_by_side, {tr("Side by side"), tr("Two pictures, one camera")}},
      {ComparisonMode::blink, {tr("Blink"), tr("One after the other (B)")}},
      {ComparisonMode::difference,
       {tr("Difference"), tr("Illuminance of the second minus that of the first, in lux")}}};
  for (const auto& [mode, text] : modes) {
    auto* button = new QToolButton;
    button->setText(text.first);
    button->setToolTip(text.second);
    button->setCheckable(true);
    modes_->addButton(button, static_cast<int>(mode));
    row->addWidget(button);
  }
  auto* range_row = new QHBoxLayout(range_fields_);
  range_row->setContentsMargins(0, 0, 0, 0);
  range_row->addWidget(new QLabel(QStringLiteral("\u00b1")));
  range_row->addWidget(range_);
  range_->setRange(0.1, 1e6);
  range_->setSteps(10.0, 1);
  range_->setToolTip(tr("Ends of the scale"));
  row->addWidget(range_fields_);
  auto* close = new QToolButton;
  close->setText(QStringLiteral("\u2715"));
  close->setToolTip(tr("End the comparison (Shift+B)"));
  close->setAccessibleName(tr("End the comparison"));
  close->setAutoRaise(true);
  row->addWidget(close);

  connect(swap, &QToolButton::clicked, this, &ComparisonBar::swapRequested);
  connect(close, &QToolButton::clicked, this, &ComparisonBar::closeRequested);
  connect(modes_, &QButtonGroup::idClicked, this,
          [this](int id) { Q_EMIT modeChosen(static_cast<ComparisonMode>(id)); });
  connect(second_, &QComboBox::activated, this,
          [this](int i) { Q_EMIT otherChosen(second_->itemData(i).toString()); });
  connect(range_, &QuantityBox::edited, this, &ComparisonBar::rangeChosen);
}

void ComparisonBar::setMode(ComparisonMode mode) {
  if (auto* button = modes_->button(static_cast<int>(mode))) button->setChecked(true);
  range_fields_->setVisible(mode == ComparisonMode::difference);
  adjustSize();
}

void ComparisonBar::setLayouts(const QString& shown, const QStringList& others,
                               const QString& other) {
  first_->setText(nameOf(shown));
  const QSignalBlocker quiet(second_);
  second_->clear();
  for (const QString& name : others) second_->addItem(nameOf(name), name);
  second_->setCurrentIndex(static_cast<int>(others.indexOf(other)));
  adjustSize();
}

void ComparisonBar::setRange(double lux) {
  range_->setValue(lux);
}

}  // namespace soffit::ui
