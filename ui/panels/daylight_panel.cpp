// SPDX-License-Identifier: MIT
#include "ui/panels/daylight_panel.h"

#include "core/io/image/read_image.h"
#include "core/io/project/atomic_file.h"
#include "ui/document/text.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

/// Ways that are one undo step each.
enum MergeKey {
  kAzimuthWay = 301,
  kAltitudeWay,
  kHorizontalWay,
  kDirectWay,
  kGroundWay,
  kRotationWay,
  kScaleWay,
  kTurnWay,
  kNumberWay  ///< and those after it
};

QFormLayout* formIn(QWidget* fields) {
  auto* form = new QFormLayout(fields);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(6);
  return form;
}

void addRow(QFormLayout* form, const QString& label, SliderBox* row) {
  row->setName(label);
  form->addRow(label, row);
}

template <class Light>
Light* lightOf(scene::Environment& environment) {
  return std::get_if<Light>(&environment.light);
}

}  // namespace

DaylightPanel::DaylightPanel(QWidget* parent)
    : QWidget(parent),
      kind_(new QComboBox),
      sky_fields_(new QWidget),
      picture_fields_(new QWidget),
      analytic_fields_(new QWidget),
      note_(new QLabel) {
  sky_.horizontal_illuminance = 10000.0;
  sky_.ground_reflectance = 0.2;
  patches_.scale = 1000.0;
  kind_->setObjectName(QStringLiteral("outside_kind"));
  kind_->addItems(
      {tr("None"), tr("Standard sky (CIE)"), tr("Light probe (picture)"), tr("Analytic light")});
  kind_->setToolTip(tr("What shines in through openings and glass; the same in all layouts"));
  note_->setWordWrap(true);
  note_->setForegroundRole(QPalette::PlaceholderText);
  makeSkyFields();
  makePictureFields();
  makeAnalyticFields();
  kind_->setAccessibleName(tr("Outside"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  layout->setSpacing(8);
  layout->addWidget(kind_);
  for (QWidget* fields : {sky_fields_, picture_fields_, analytic_fields_}) {
    layout->addWidget(fields);
  }
  layout->addWidget(note_);
  layout->addStretch(1);
  connect(kind_, &QComboBox::activated, this,
          [this](int index) { choose(static_cast<OutsideKind>(index)); });
  refresh();
}

void DaylightPanel::makeSkyFields() {
  auto* form = formIn(sky_fields_);
  type_ = new QComboBox;
  type_->setObjectName(QStringLiteral("sky_type"));
  const QStringList names = skyNames();
  for (int i = 0; i < names.size(); ++i) {
    type_->addItem(QStringLiteral("%1  %2").arg(i + 1).arg(names[i]));
  }
  // Long names would widen the dock: they are cut in the box, and whole in its list.
  type_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  type_->setMinimumContentsLength(12);
  type_->setToolTip(
      tr("Standard skies of ISO 15469 (CIE S 011), and the traditional overcast one"));
  azimuth_ = new SliderBox(Dimension::angle, 0.0, 360.0, 1.0);
  azimuth_->slider()->setObjectName(QStringLiteral("sun_azimuth"));
  azimuth_->setToolTip(tr("From north (+y) clockwise seen from above: 90\u00b0 is east (+x)"));
  altitude_ = new SliderBox(Dimension::angle, 0.0, 90.0, 1.0);
  altitude_->slider()->setObjectName(QStringLiteral("sun_altitude"));
  altitude_->box()->setRange(-90.0, 90.0);
  altitude_->setToolTip(tr("Above the horizon"));
  horizontal_ = new QuantityBox(Dimension::illuminance);
  horizontal_->setRange(0.0, 1e7);
  horizontal_->setSteps(500.0, 0);
  horizontal_->setToolTip(tr("Of the sky alone on an open horizontal plane, without the sun"));
  direct_ = new QuantityBox(Dimension::illuminance);
  direct_->setRange(0.0, 1e7);
  direct_->setSteps(5000.0, 0);
  direct_->setToolTip(tr("Of the sun alone on a plane that faces it; 0: no sun"));
  ground_ = new SliderBox(Dimension::share, 0.0, 1.0, 0.01);
  ground_->setToolTip(
      tr("Of the ground around the building, which mirrors the sky's light evenly"));
  form->addRow(tr("Sky"), type_);
  addRow(form, tr("Sun azimuth"), azimuth_);
  addRow(form, tr("Sun altitude"), altitude_);
  form->addRow(tr("Sky light"), horizontal_);
  form->addRow(tr("Sunlight"), direct_);
  addRow(form, tr("Ground"), ground_);
  connect(type_, &QComboBox::activated, this, [this](int index) {
    edit(
        tr("Sky type"),
        [&](scene::Environment& e) {
          if (auto* sky = lightOf<scene::Sky>(e)) sky->cie = index + 1;
        },
        -1);
  });
  const auto set = [](double scene::Sky::*field) -> Change {
    return [field](scene::Environment& e, double v) {
      if (auto* sky = lightOf<scene::Sky>(e)) sky->*field = v;
    };
  };
  connectSlider(azimuth_, tr("Sun azimuth"), kAzimuthWay, set(&scene::Sky::sun_azimuth_deg));
  connectSlider(altitude_, tr("Sun altitude"), kAltitudeWay, set(&scene::Sky::sun_altitude_deg));
  connectSlider(ground_, tr("Ground reflectance"), kGroundWay,
                set(&scene::Sky::ground_reflectance));
  connectBox(horizontal_, tr("Sky light"), kHorizontalWay,
             set(&scene::Sky::horizontal_illuminance));
  connectBox(direct_, tr("Sunlight"), kDirectWay, set(&scene::Sky::direct_normal_illuminance));
}

void DaylightPanel::makePictureFields() {
  auto* form = formIn(picture_fields_);
  file_ = new QPushButton;
  file_->setToolTip(tr("An HDR or EXR picture of the surroundings, all round"));
  layout_ = new QComboBox;
  layout_->addItems({tr("Latitude and longitude"), tr("Angular map (mirror ball)"), tr("Cross")});
  layout_->setToolTip(tr("How the picture is laid out; its centre looks to +y"));
  rotation_ = new SliderBox(Dimension::angle, -180.0, 180.0, 1.0);
  rotation_->slider()->setObjectName(QStringLiteral("picture_rotation"));
  rotation_->box()->setRange(-360.0, 360.0);
  rotation_->setToolTip(tr("Counter-clockwise seen from above"));
  scale_ = new QDoubleSpinBox;
  scale_->setRange(0.0, 1e9);
  scale_->setDecimals(3);
  scale_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  scale_->setKeyboardTracking(false);
  scale_->setToolTip(tr("Luminance of a pixel of value 1, cd/m\u00b2"));
  form->addRow(tr("Picture"), file_);
  form->addRow(tr("Layout"), layout_);
  addRow(form, tr("Rotation"), rotation_);
  form->addRow(tr("Scale"), scale_);
  connect(file_, &QPushButton::clicked, this, &DaylightPanel::askPicture);
  connect(layout_, &QComboBox::activated, this, [this](int index) {
    edit(
        tr("Layout of the light probe"),
        [&](scene::Environment& e) {
          if (auto* p = lightOf<scene::Probe>(e))
            p->layout = static_cast<scene::ProbeLayout>(index);
        },
        -1);
  });
  connectSlider(rotation_, tr("Turn the surroundings"), kRotationWay,
                [](scene::Environment& e, double v) {
                  if (auto* p = lightOf<scene::Probe>(e)) p->rotation_deg = v;
                });
  connect(scale_, &QDoubleSpinBox::valueChanged, this, [this](double v) {
    edit(
        tr("Scale of the light probe"),
        [&](scene::Environment& e) {
          if (auto* p = lightOf<scene::Probe>(e)) p->scale = v;
        },
        kScaleWay);
  });
}

QDoubleSpinBox* DaylightPanel::number(QFormLayout* form, const QString& label, int key,
                                      double scene::PatchLight::*field) {
  auto* box = new QDoubleSpinBox;
  box->setRange(field == &scene::PatchLight::scale ? 0.0 : -1e6, 1e9);
  box->setDecimals(2);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setKeyboardTracking(false);
  form->addRow(label, box);
  numbers_.emplace_back(box, field);
  connect(box, &QDoubleSpinBox::valueChanged, this, [this, key, field](double v) {
    edit(
        tr("Analytic light"),
        [&](scene::Environment& e) {
          if (auto* light = lightOf<scene::PatchLight>(e)) light->*field = v;
        },
        key);
  });
  return box;
}

void DaylightPanel::makeAnalyticFields() {
  auto* form = formIn(analytic_fields_);
  turn_ = new SliderBox(Dimension::angle, -180.0, 180.0, 1.0);
  turn_->slider()->setObjectName(QStringLiteral("analytic_rotation"));
  turn_->box()->setRange(-360.0, 360.0);
  turn_->setToolTip(tr("Counter-clockwise seen from above"));
  addRow(form, tr("Rotation"), turn_);
  connectSlider(turn_, tr("Turn the surroundings"), kTurnWay, [](scene::Environment& e, double v) {
    if (auto* light = lightOf<scene::PatchLight>(e)) light->rotation_deg = v;
  });
  using P = scene::PatchLight;
  number(form, tr("Scale"), kNumberWay, &P::scale)
      ->setToolTip(tr("Luminance of the formula's value 1, cd/m\u00b2"));
  number(form, tr("Overhead gain"), kNumberWay + 1, &P::overhead_gain)
      ->setToolTip(tr("max(0, gain \u00b7 cos \u03b8 \u2212 threshold): the patch overhead"));
  number(form, tr("Overhead threshold"), kNumberWay + 2, &P::overhead_threshold);
  number(form, tr("Side gain"), kNumberWay + 3, &P::side_gain)
      ->setToolTip(tr("The patch at the horizon"));
  number(form, tr("Side threshold"), kNumberWay + 4, &P::side_threshold);
}

void DaylightPanel::connectSlider(SliderBox* row, const QString& text, int key,
                                  const Change& change) {
  connect(row, &SliderBox::held, this, [this, change](double v) {
    if (document_ == nullptr || !shown()) return;
    Q_EMIT held(true);
    scene::Environment next = *shown();
    change(next, v);
    previewEnvironment(*document_, std::move(next));
  });
  connect(row, &SliderBox::released, this, [this, text] {
    Q_EMIT held(false);
    if (document_ != nullptr) document_->commitPreview(text);
  });
  connect(row, &SliderBox::edited, this, [this, text, key, change](double v) {
    edit(
        text, [&](scene::Environment& e) { change(e, v); }, key);
  });
}

void DaylightPanel::connectBox(QuantityBox* box, const QString& text, int key,
                               const Change& change) {
  connect(box, &QuantityBox::edited, this, [this, text, key, change](double v) {
    edit(
        text, [&](scene::Environment& e) { change(e, v); }, key);
  });
}

void DaylightPanel::edit(const QString& text,
                         const std::function<void(scene::Environment&)>& change, int key) {
  if (document_ == nullptr || !shown()) return;
  scene::Environment next = *shown();
  change(next);
  editEnvironment(*document_, text, std::move(next), key);
}

const std::optional<scene::Environment>& DaylightPanel::shown() const {
  return document_->scene()->environment;
}

void DaylightPanel::choose(OutsideKind kind) {
  if (document_ == nullptr || kind == kindOf(shown())) return;
  if (kind == OutsideKind::picture && picture_.image == nullptr) {
    refresh();  // stays as it is until there is a picture
    askPicture();
    return;
  }
  std::optional<scene::Environment> next;
  if (kind == OutsideKind::sky) next = scene::Environment{{}, sky_};
  if (kind == OutsideKind::picture) next = scene::Environment{{}, picture_};
  if (kind == OutsideKind::analytic) next = scene::Environment{{}, patches_};
  editEnvironment(*document_, tr("Light from outside"), std::move(next));
}

void DaylightPanel::askPicture() {
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Light probe"), {},
      tr("Pictures (%1)").arg(QStringLiteral("*.hdr *.exr *.pic *.tif *.tiff *.png *.jpg")));
  if (!path.isEmpty()) usePicture(path);
}

void DaylightPanel::usePicture(const QString& path) {
  if (document_ == nullptr) return;
  reading_ = true;
  refresh();
  background_.run([this, path, document = document_]() -> Background::End {
    auto bytes = io::readFile(toPath(path));
    auto image = bytes ? io::readImage(toPath(path)) : Result<scene::Image>(bytes.error());
    return [this, path, document, bytes = std::move(bytes), image = std::move(image)]() mutable {
      reading_ = false;
      if (document_ == document && image) {
        takePicture(QFileInfo(path).fileName(), std::move(*bytes), std::move(*image));
      }
      refresh();
      if (!image) Q_EMIT failed(messageOf(image.error()));
    };
  });
}

void DaylightPanel::takePicture(const QString& name, std::string bytes, scene::Image image) {
  scene::Probe probe = picture_;
  probe.layout = likelyLayout(image);
  probe.file = document_->addFile(toStd(name), std::move(bytes));
  probe.image = std::make_shared<const scene::Image>(std::move(image));
  editEnvironment(*document_, tr("Light probe"), scene::Environment{{}, probe});
}

void DaylightPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  picture_ = {};
  if (document_ != nullptr) {
    connect(document_, &Document::sceneChanged, this, &DaylightPanel::refresh);
  }
  refresh();
}

void DaylightPanel::refresh() {
  setEnabled(document_ != nullptr);
  const OutsideKind kind = document_ == nullptr ? OutsideKind::none : kindOf(shown());
  kind_->setCurrentIndex(static_cast<int>(kind));
  sky_fields_->setVisible(kind == OutsideKind::sky);
  picture_fields_->setVisible(kind == OutsideKind::picture);
  analytic_fields_->setVisible(kind == OutsideKind::analytic);
  note_->setText(reading_                    ? tr("Reading the picture\u2026")
                 : kind == OutsideKind::none ? tr("Nothing shines in. Windows need an opening or a "
                                                  "material that is glass (see Materials).")
                                             : QString());
  note_->setVisible(!note_->text().isEmpty());
  if (kind == OutsideKind::sky) {
    sky_ = std::get<scene::Sky>(shown()->light);
    type_->setCurrentIndex(sky_.cie - 1);
    type_->setToolTip(type_->currentText());
    azimuth_->setValue(sky_.sun_azimuth_deg - 360.0 * std::floor(sky_.sun_azimuth_deg / 360.0));
    altitude_->setValue(sky_.sun_altitude_deg);
    horizontal_->setValue(sky_.horizontal_illuminance);
    direct_->setValue(sky_.direct_normal_illuminance);
    ground_->setValue(sky_.ground_reflectance);
  } else if (kind == OutsideKind::picture) {
    picture_ = std::get<scene::Probe>(shown()->light);
    const QString name = toQt(picture_.file);
    file_->setText(name.size() > 28 ? name.left(12) + QChar(0x2026) + name.right(14) : name);
    layout_->setCurrentIndex(static_cast<int>(picture_.layout));
    rotation_->setValue(picture_.rotation_deg);
    const QSignalBlocker quiet(scale_);
    scale_->setValue(picture_.scale);
  } else if (kind == OutsideKind::analytic) {
    patches_ = std::get<scene::PatchLight>(shown()->light);
    turn_->setValue(patches_.rotation_deg);
    for (const auto& [box, field] : numbers_) {
      const QSignalBlocker quiet(box);
      box->setValue(patches_.*field);
    }
  }
}

}  // namespace soffit::ui
