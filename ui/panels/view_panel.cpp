// SPDX-License-Identifier: MIT
#include "ui/panels/view_panel.h"

#include "core/color/display_config.h"
#include "ui/document/text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <cmath>

namespace soffit::ui {
namespace {

constexpr int kSliderSteps = 20;  // per stop
constexpr double kMostStops = 8.0;
constexpr int kExposureWay = 20;

void addViews(QComboBox& box) {
  const auto config = color::findDisplayConfig();
  if (!config) return;
  const auto views = color::viewsOf(*config, "sRGB");
  if (!views) return;
  for (const std::string& view : *views) {
    if (view != color::kFalseColorView) box.addItem(toQt(view));
  }
}

}  // namespace

ViewPanel::ViewPanel(QWidget* parent) : QWidget(parent) {
  exposure_slider_ = new QSlider(Qt::Horizontal);
  exposure_slider_->setRange(static_cast<int>(-kMostStops * kSliderSteps),
                             static_cast<int>(kMostStops * kSliderSteps));
  exposure_slider_->setMinimumWidth(60);
  exposure_slider_->setAccessibleName(tr("Exposure"));
  exposure_ = new QuantityBox(Dimension::exposure);
  exposure_->setRange(-20.0, 20.0);
  exposure_->setSteps(0.25, 2);
  auto* automatic = new QPushButton(tr("Auto"));
  automatic->setToolTip(tr("Expose for what is seen now"));
  view_ = new QComboBox;
  addViews(*view_);
  view_->setToolTip(tr("OpenColorIO view transform, the same in exported pictures"));
  false_color_ = new QCheckBox(tr("False colours of illuminance"));
  range_min_ = new QuantityBox(Dimension::illuminance);
  range_max_ = new QuantityBox(Dimension::illuminance);
  for (QuantityBox* box : {range_min_, range_max_}) {
    box->setRange(0.0, 1e6);
    box->setSteps(50.0, 1);
  }
  logarithmic_ = new QCheckBox(tr("Logarithmic"));

  auto* form = new QFormLayout;
  form->setVerticalSpacing(6);
  auto* exposure_row = new QHBoxLayout;
  exposure_row->addWidget(exposure_slider_, 1);
  exposure_row->addWidget(exposure_);
  form->addRow(tr("Exposure"), exposure_row);
  auto* view_row = new QHBoxLayout;
  view_row->addWidget(view_, 1);
  view_row->addWidget(automatic);
  form->addRow(tr("View"), view_row);
  form->addRow(false_color_);
  range_fields_ = new QWidget;
  auto* range_row = new QHBoxLayout(range_fields_);
  range_row->setContentsMargins(0, 0, 0, 0);
  range_row->addWidget(range_min_);
  range_row->addWidget(new QLabel(QStringLiteral("\u2013")));
  range_row->addWidget(range_max_);
  range_row->addStretch(1);
  form->addRow(range_fields_);
  form->addRow(logarithmic_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  layout->addLayout(form);
  layout->addStretch(1);

  connect(exposure_slider_, &QSlider::valueChanged, this, [this](int steps) {
    editView(
        tr("Exposure"), [&](scene::View& v) { v.exposure = double{1.0} * steps / kSliderSteps; },
        kExposureWay);
  });
  connect(exposure_, &QuantityBox::edited, this, [this](double stops) {
    editView(
        tr("Exposure"), [&](scene::View& v) { v.exposure = stops; }, kExposureWay);
  });
  connect(view_, &QComboBox::textActivated, this, [this](const QString& name) {
    editView(tr("View transform"), [&](scene::View& v) { v.ocio_view = toStd(name); });
  });
  connect(automatic, &QPushButton::clicked, this, &ViewPanel::autoExposureRequested);
  connect(false_color_, &QCheckBox::toggled, this, [this](bool on) {
    range_fields_->setVisible(on);
    logarithmic_->setVisible(on);
    Q_EMIT falseColorChanged(on);
    Q_EMIT lookChanged();
  });
  connect(range_min_, &QuantityBox::edited, this, &ViewPanel::takeRange);
  connect(range_max_, &QuantityBox::edited, this, &ViewPanel::takeRange);
  connect(logarithmic_, &QCheckBox::toggled, this, &ViewPanel::takeRange);
  range_fields_->hide();
  logarithmic_->hide();
  refresh();
}

void ViewPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  range_chosen_ = false;
  if (document_ != nullptr) connect(document_, &Document::sceneChanged, this, &ViewPanel::refresh);
  refresh();
}

void ViewPanel::editView(const QString& text, const std::function<void(scene::View&)>& change,
                         int merge_key) {
  if (document_ == nullptr) return;
  scene::Scene next = *document_->scene();
  change(next.view);
  document_->edit(text, std::move(next), merge_key);
}

void ViewPanel::stepExposure(double stops) {
  editView(
      tr("Exposure"), [&](scene::View& v) { v.exposure += stops; }, kExposureWay);
}

void ViewPanel::refresh() {
  setEnabled(document_ != nullptr);
  range_min_->setValue(range_.min);
  range_max_->setValue(range_.max);
  if (document_ == nullptr) return;
  const scene::View& view = document_->scene()->view;
  {
    const QSignalBlocker quiet(exposure_slider_);
    exposure_slider_->setValue(static_cast<int>(std::lround(view.exposure * kSliderSteps)));
  }
  exposure_->setValue(view.exposure);
  view_->setCurrentText(toQt(view.ocio_view));
  Q_EMIT lookChanged();
}

Look ViewPanel::look() const {
  Look look;
  if (document_ != nullptr) {
    const scene::View& view = document_->scene()->view;
    look.display.display = view.ocio_display;
    look.display.view = view.ocio_view;
    look.display.look = view.ocio_look;
    look.exposure_ev = view.exposure;
    if (view.ocio_view == color::kFalseColorView) look.display.view = color::DisplayChoice{}.view;
  }
  look.false_color = false_color_->isChecked();
  look.range = range_;
  return look;
}

bool ViewPanel::falseColor() const {
  return false_color_->isChecked();
}

void ViewPanel::setFalseColor(bool on) {
  false_color_->setChecked(on);
}

void ViewPanel::suggestRange(const color::FalseColorRange& range) {
  if (range_chosen_) return;
  range_ = range;
  refresh();
}

void ViewPanel::takeRange() {
  color::FalseColorRange range{range_min_->value().value_or(0.0),
                               range_max_->value().value_or(1000.0), logarithmic_->isChecked()};
  if (range.logarithmic && range.min <= 0.0) range.min = range.max / 1000.0;
  if (range.check()) {
    range_ = range;
    range_chosen_ = true;
  }
  refresh();
}

}  // namespace soffit::ui
