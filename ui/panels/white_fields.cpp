// SPDX-License-Identifier: MIT
#include "ui/panels/white_fields.h"

#include "core/color/white_balance.h"
#include "ui/widgets/quantity_box.h"

#include <QComboBox>
#include <QHBoxLayout>

namespace soffit::ui {
namespace {

enum Choice { kDaylight, kLuminaires, kOwn };
/// Where a temperature of one's own starts: neutral white, between warm lamps and daylight.
constexpr double kUsualWhite = 4000.0;

}  // namespace

WhiteFields::WhiteFields(QWidget* parent)
    : QWidget(parent), choice_(new QComboBox), kelvin_(new QuantityBox(Dimension::temperature)) {
  choice_->setObjectName(QStringLiteral("white"));
  choice_->addItems({tr("Daylight"), tr("Luminaires"), tr("Kelvin")});
  choice_->setToolTip(
      tr("White balance: the colour of light that looks white, as eyes and cameras adapt to it"));
  choice_->setAccessibleName(tr("White balance"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(5);
  kelvin_->setRange(color::kWarmestWhite, color::kCoolestWhite);
  kelvin_->setSteps(100.0, 0);
  kelvin_->setAccessibleName(tr("Colour temperature that looks white"));
  kelvin_->setToolTip(kelvin_->accessibleName());
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(choice_, 1);
  row->addWidget(kelvin_);
  connect(choice_, &QComboBox::activated, this, [this](int choice) {
    if (choice == kLuminaires) {
      Q_EMIT luminairesRequested();
    } else if (choice == kDaylight) {
      Q_EMIT chosen(0.0);
    } else {
      Q_EMIT chosen(kelvin_->value().value_or(kUsualWhite));
    }
  });
  connect(kelvin_, &QuantityBox::edited, this, &WhiteFields::edited);
}

void WhiteFields::showView(const scene::View& view) {
  const bool daylight = view.white_balance <= 0.0;
  choice_->setCurrentIndex(daylight ? kDaylight : kOwn);
  kelvin_->setVisible(!daylight);
  if (!daylight) kelvin_->setValue(view.white_balance);
}

}  // namespace soffit::ui
