// SPDX-License-Identifier: MIT
#include "ui/panels/view_panel.h"

#include "core/color/display_config.h"
#include "ui/document/text.h"
#include "ui/panels/finish_fields.h"

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
/// Of the box that says where lines are drawn; the third is both.
enum LinesOn { kOnSurfaces, kOnPlanes };

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
  // A long name does not widen the dock.
  view_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  view_->setMinimumContentsLength(8);
  view_->setToolTip(tr("OpenColorIO view transform, the same in exported pictures"));
  makeLightFields();

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
  finish_ = new FinishFields;
  form->addRow(finish_);
  connect(finish_, &FinishFields::edited, this,
          [this](const QString& text, const FinishFields::Change& change, int merge_key) {
            editView(text, change, merge_key);
          });
  form->addRow(false_color_);
  auto* lines_row = new QHBoxLayout;
  lines_row->addWidget(isolines_);
  lines_row->addWidget(lines_on_, 1);
  form->addRow(lines_row);
  form->addRow(values_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  layout->addLayout(form);
  layout->addWidget(scale_);
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
  showScale();
  refresh();
}

void ViewPanel::makeLightFields() {
  false_color_ = new QCheckBox(tr("False colours of illuminance"));
  isolines_ = new QCheckBox(tr("Isolux lines"));
  lines_on_ = new QComboBox;
  lines_on_->setObjectName(QStringLiteral("lines_on"));
  lines_on_->addItems({tr("on surfaces"), tr("on work planes"), tr("on both")});
  lines_on_->setAccessibleName(tr("Where isolux lines are drawn"));
  values_ = new QCheckBox(tr("Values on work planes"));
  values_->setToolTip(tr("A number at each point that there is room for"));
  scale_ = new LuxScaleFields;
  connect(false_color_, &QCheckBox::toggled, this, &ViewPanel::falseColorChanged);
  connect(isolines_, &QCheckBox::toggled, this, &ViewPanel::isolinesChanged);
  connect(values_, &QCheckBox::toggled, this, &ViewPanel::valuesChanged);
  for (QCheckBox* box : {false_color_, isolines_, values_}) {
    connect(box, &QCheckBox::toggled, this, [this] {
      showScale();
      Q_EMIT lookChanged();
    });
  }
  connect(lines_on_, &QComboBox::activated, this, &ViewPanel::lookChanged);
  connect(scale_, &LuxScaleFields::changed, this, &ViewPanel::lookChanged);
}

void ViewPanel::showScale() {
  lines_on_->setVisible(isolines_->isChecked());
  scale_->setVisible(false_color_->isChecked() || isolines_->isChecked() || values_->isChecked());
}

void ViewPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  scale_->forgetRange();
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
  if (document_ == nullptr) return;
  const scene::View& view = document_->scene()->view;
  {
    const QSignalBlocker quiet(exposure_slider_);
    exposure_slider_->setValue(static_cast<int>(std::lround(view.exposure * kSliderSteps)));
  }
  exposure_->setValue(view.exposure);
  view_->setCurrentText(toQt(view.ocio_view));
  finish_->showView(view);
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
    look.tone = {.key = view.tone_key, .white = view.tone_white};
    look.bloom = {.threshold = view.bloom_threshold, .strength = view.bloom_strength};
    if (view.ocio_view == color::kFalseColorView) look.display.view = color::DisplayChoice{}.view;
  }
  look.false_color = false_color_->isChecked();
  look.scale = scale_->scale();
  if (isolines_->isChecked() && lines_on_->currentIndex() != kOnPlanes) {
    look.levels = scale_->levels();
  }
  return look;
}

PlaneLook ViewPanel::planeLook() const {
  PlaneLook look;
  look.values = values_->isChecked();
  if (isolines_->isChecked() && lines_on_->currentIndex() != kOnSurfaces) {
    look.levels = scale_->levels();
  }
  return look;
}

void ViewPanel::setIsolines(bool on) {
  isolines_->setChecked(on);
}

void ViewPanel::setValues(bool on) {
  values_->setChecked(on);
}

bool ViewPanel::falseColor() const {
  return false_color_->isChecked();
}

void ViewPanel::setFalseColor(bool on) {
  false_color_->setChecked(on);
}

void ViewPanel::suggestRange(const color::FalseColorRange& range) {
  scale_->suggestRange(range);
}

}  // namespace soffit::ui
