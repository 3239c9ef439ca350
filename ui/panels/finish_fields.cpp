// SPDX-License-Identifier: MIT
#include "ui/panels/finish_fields.h"

#include "core/color/tone_operator.h"
#include "ui/widgets/quantity_box.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>

#include <initializer_list>

namespace soffit::ui {
namespace {

enum MergeKey { kKeyWay = 401, kWhiteWay, kThresholdWay, kStrengthWay };
/// cd/m^2: above white paper under an office's light, below any luminaire.
constexpr double kUsualThreshold = 1000.0;

QDoubleSpinBox* toneBox(double most, double step, const QString& name, const QString& tip) {
  auto* box = new QDoubleSpinBox;
  box->setRange(0.0, most);
  box->setDecimals(2);
  box->setSingleStep(step);
  box->setSpecialValueText(FinishFields::tr("automatic"));
  box->setAccessibleName(name);
  box->setToolTip(tip);
  return box;
}

}  // namespace

FinishFields::FinishFields(QWidget* parent)
    : QWidget(parent),
      form_(new QFormLayout(this)),
      key_(toneBox(100.0, 0.02, tr("Key"),
                   tr("What the average of the picture becomes; 0.18 is mid grey"))),
      white_(
          toneBox(1e6, 0.5, tr("White point"),
                  tr("The smallest brightness that becomes white, where the average is the key"))),
      bloom_(new QCheckBox(tr("Bloom above"))),
      threshold_(new QuantityBox(Dimension::luminance)),
      strength_(new QuantityBox(Dimension::share)) {
  bloom_->setToolTip(tr("Spreads light about what is brighter, in pictures alone"));
  threshold_->setRange(1.0, 1e9);
  threshold_->setSteps(100.0, 0);
  threshold_->setAccessibleName(tr("Luminance above which light is spread"));
  strength_->setRange(0.0, 1.0);
  strength_->setSteps(0.05, 2);
  strength_->setAccessibleName(tr("Share of the light that is spread"));
  strength_->setToolTip(strength_->accessibleName());
  for (QWidget* box : std::initializer_list<QWidget*>{key_, white_, threshold_, strength_}) {
    box->setMinimumWidth(60);
  }
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setVerticalSpacing(6);
  form_->addRow(tr("Key"), key_);
  form_->addRow(tr("White point"), white_);
  form_->addRow(bloom_, threshold_);
  form_->addRow(tr("Strength"), strength_);

  connect(key_, &QDoubleSpinBox::valueChanged, this, [this](double v) {
    Q_EMIT edited(
        tr("Key of the picture"), [v](scene::View& view) { view.tone_key = v; }, kKeyWay);
  });
  connect(white_, &QDoubleSpinBox::valueChanged, this, [this](double v) {
    Q_EMIT edited(
        tr("White point"), [v](scene::View& view) { view.tone_white = v; }, kWhiteWay);
  });
  connect(bloom_, &QCheckBox::clicked, this, [this](bool on) {
    Q_EMIT edited(
        tr("Bloom"), [on](scene::View& view) { view.bloom_threshold = on ? kUsualThreshold : 0.0; },
        -1);
  });
  connect(threshold_, &QuantityBox::edited, this, [this](double v) {
    Q_EMIT edited(
        tr("Bloom"), [v](scene::View& view) { view.bloom_threshold = v; }, kThresholdWay);
  });
  connect(strength_, &QuantityBox::edited, this, [this](double v) {
    Q_EMIT edited(
        tr("Bloom"), [v](scene::View& view) { view.bloom_strength = v; }, kStrengthWay);
  });
}

void FinishFields::showView(const scene::View& view) {
  const QSignalBlocker quiet_key(key_);
  const QSignalBlocker quiet_white(white_);
  const bool tone = view.ocio_view == color::kReinhard2002View;
  form_->setRowVisible(key_, tone);
  form_->setRowVisible(white_, tone);
  key_->setValue(view.tone_key);
  white_->setValue(view.tone_white);
  const bool blooms = view.bloom_threshold > 0.0;
  bloom_->setChecked(blooms);
  bloom_->setText(blooms ? tr("Bloom above") : tr("Bloom"));
  threshold_->setVisible(blooms);
  form_->setRowVisible(strength_, blooms);
  if (blooms) threshold_->setValue(view.bloom_threshold);
  strength_->setValue(view.bloom_strength);
}

}  // namespace soffit::ui
