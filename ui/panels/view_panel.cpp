// SPDX-License-Identifier: MIT
#include "ui/panels/view_panel.h"

#include "core/color/display_config.h"
#include "core/light/white.h"
#include "ui/document/text.h"
#include "ui/panels/finish_fields.h"
#include "ui/panels/white_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

constexpr int kSliderSteps = 20;  // per stop
constexpr double kMostStops = 8.0;
constexpr int kExposureWay = 20;
constexpr int kWhiteBalanceWay = 21;
/// Of the box that says where lines are drawn; the third is both.
enum LinesOn { kOnSurfaces, kOnPlanes };

QStringList viewsOf(const QString& display) {
  QStringList names;
  const auto config = color::findDisplayConfig();
  if (!config) return names;
  const auto views = color::viewsOf(*config, toStd(display));
  if (!views) return names;
  for (const std::string& view : *views) {
    if (view != color::kFalseColorView) names += toQt(view);
  }
  return names;
}

color::DisplayNames displayNames() {
  const auto config = color::findDisplayConfig();
  if (!config) return {};
  auto names = color::displaysOf(*config);
  return names ? std::move(*names) : color::DisplayNames{};
}

/// A long name does not widen the dock.
QComboBox* nameBox(const QString& name, const QString& tip) {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  box->setAccessibleName(name);
  box->setToolTip(tip);
  return box;
}

}  // namespace

ViewPanel::ViewPanel(QWidget* parent) : QWidget(parent) {
  exposure_slider_ = new QSlider(Qt::Horizontal);
  exposure_slider_->setRange(static_cast<int>(-kMostStops * kSliderSteps),
                             static_cast<int>(kMostStops * kSliderSteps));
  exposure_slider_->setMinimumWidth(40);
  exposure_slider_->setAccessibleName(tr("Exposure"));
  exposure_ = new QuantityBox(Dimension::exposure);
  exposure_->setRange(-20.0, 20.0);
  exposure_->setSteps(0.25, 2);
  auto* automatic = new QToolButton;
  automatic->setText(tr("Auto"));
  automatic->setToolTip(tr("Expose for what is seen now"));
  makeTransformFields();
  makeLightFields();

  auto* form = new QFormLayout;
  form->setVerticalSpacing(6);
  auto* exposure_row = new QHBoxLayout;
  exposure_row->addWidget(exposure_slider_, 1);
  exposure_row->addWidget(exposure_);
  form->addRow(tr("Exposure"), exposure_row);
  exposure_row->addWidget(automatic);
  form->addRow(tr("White"), white_);
  form->addRow(tr("View"), view_);
  if (look_->count() > 1) form->addRow(tr("Look"), look_);
  if (display_->count() > 1) form->addRow(tr("Display"), display_);
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
  connect(automatic, &QToolButton::clicked, this, &ViewPanel::autoExposureRequested);
  showScale();
  refresh();
}

void ViewPanel::makeTransformFields() {
  white_ = new WhiteFields;
  view_ = nameBox(tr("View"), tr("OpenColorIO view transform, the same in exported pictures"));
  look_ = nameBox(tr("Look"), tr("OpenColorIO look, on top of the view"));
  display_ = nameBox(tr("Display"),
                     tr("What the picture is shown on: code values are made for this device"));
  look_->setObjectName(QStringLiteral("look"));
  display_->setObjectName(QStringLiteral("display"));
  const color::DisplayNames names = displayNames();
  look_->addItem(tr("None"), QString());
  for (const std::string& look : names.looks) look_->addItem(toQt(look), toQt(look));
  for (const std::string& display : names.displays) display_->addItem(toQt(display));

  connect(white_, &WhiteFields::edited, this, [this](double kelvin) {
    editView(
        tr("White balance"), [&](scene::View& v) { v.white_balance = kelvin; }, kWhiteBalanceWay);
  });
  connect(white_, &WhiteFields::chosen, this, [this](double kelvin) {
    editView(tr("White balance"), [&](scene::View& v) { v.white_balance = kelvin; });
  });
  connect(white_, &WhiteFields::luminairesRequested, this, [this] {
    if (document_ == nullptr) return;
    const double kelvin = std::round(light::whiteOf(document_->luminaires()));
    editView(tr("White balance"), [&](scene::View& v) { v.white_balance = kelvin; });
    refresh();
  });
  connect(view_, &QComboBox::textActivated, this, [this](const QString& name) {
    editView(tr("View transform"), [&](scene::View& v) { v.ocio_view = toStd(name); });
  });
  connect(look_, &QComboBox::activated, this, [this](int index) {
    const std::string look = toStd(look_->itemData(index).toString());
    editView(tr("Look"), [&](scene::View& v) { v.ocio_look = look; });
  });
  connect(display_, &QComboBox::textActivated, this, [this](const QString& name) {
    const QStringList views = viewsOf(name);
    editView(tr("Display"), [&](scene::View& v) {
      v.ocio_display = toStd(name);
      if (!views.isEmpty() && !views.contains(toQt(v.ocio_view))) v.ocio_view = toStd(views[0]);
    });
  });
}

void ViewPanel::showTransform(const scene::View& view) {
  white_->showView(view);
  if (const QString display = toQt(view.ocio_display); display != views_of_) {
    view_->clear();
    view_->addItems(viewsOf(display));
    views_of_ = display;
  }
  view_->setCurrentText(toQt(view.ocio_view));
  display_->setCurrentText(toQt(view.ocio_display));
  look_->setCurrentIndex(std::max(0, look_->findData(toQt(view.ocio_look))));
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
  showTransform(view);
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
    look.display.white_balance = view.white_balance;
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
