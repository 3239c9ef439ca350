// SPDX-License-Identifier: MIT
#include "ui/panels/materials_panel.h"

#include "core/color/srgb.h"
#include "core/scene/equality.h"
#include "core/scene/reflectances.h"
#include "ui/document/material_edits.h"
#include "ui/document/text.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

/// Ways that are one undo step each.
enum MergeKey { kRhoWay = 201, kMaterialColourWay, kSpecularWay, kRoughnessWay, kGlassWay };

QColor shown(const dvec3& linear) {
  const auto code = [](double v) {
    return std::clamp(color::srgbEncode(static_cast<float>(v)), 0.0F, 1.0F);
  };
  return QColor::fromRgbF(code(linear.x), code(linear.y), code(linear.z));
}

QIcon swatch(const scene::Material& material, const QColor& frame) {
  constexpr int kSide = 28;
  QPixmap pixmap(kSide, kSide);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(frame, 1.5));
  painter.setBrush(material.glass ? QColor(120, 160, 180, 90) : shown(material.diffuse));
  painter.drawRoundedRect(2, 2, kSide - 4, kSide - 4, 4, 4);
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // a colour is not tinted with the accent
  return icon;
}

QWidget* pair(QSlider* slider, QWidget* box) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(slider, 1);
  layout->addWidget(box);
  return row;
}

}  // namespace

MaterialsPanel::MaterialsPanel(QWidget* parent)
    : QWidget(parent),
      list_(new QListWidget),
      fields_(new QWidget),
      rho_slider_(new QSlider(Qt::Horizontal)),
      rho_box_(new QuantityBox(Dimension::share)),
      warning_(new QLabel),
      colour_(new QToolButton),
      specular_(new QuantityBox(Dimension::share)),
      roughness_slider_(new QSlider(Qt::Horizontal)),
      roughness_(new QuantityBox(Dimension::share)),
      glass_(new QCheckBox(tr("Clear glass"))),
      transmittance_(new QuantityBox(Dimension::share)),
      note_(new QLabel) {
  list_->setAccessibleName(tr("Materials"));
  list_->setIconSize({16, 16});
  list_->setMinimumHeight(120);
  rho_slider_->setRange(0, 100);
  rho_slider_->setMinimumWidth(50);
  rho_slider_->setAccessibleName(tr("Reflectance"));
  rho_box_->setRange(0.0, 1.0);
  rho_box_->setSteps(0.01, 1);
  rho_box_->setToolTip(tr("Reflectance \u03c1: the share of white light that comes back"));
  warning_->setWordWrap(true);
  warning_->setObjectName(QStringLiteral("warning"));
  warning_->setText(tr("More than 90 %: white paint reaches 85 to 90 %"));
  colour_->setToolTip(tr("Its colour; the reflectance stays"));
  colour_->setText(tr("Choose\u2026"));
  colour_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  specular_->setRange(0.0, 1.0);
  specular_->setSteps(0.01, 1);
  specular_->setToolTip(
      tr("Gloss seen straight on: 4 % for paint, wood and plastics, more for "
         "metals"));
  roughness_slider_->setRange(0, 100);
  roughness_slider_->setMinimumWidth(50);
  roughness_slider_->setAccessibleName(tr("Roughness"));
  roughness_->setRange(0.0, 1.0);
  roughness_->setSteps(0.05, 1);
  roughness_->setToolTip(tr("0 % is a mirror, 100 % the widest gloss"));
  glass_->setToolTip(tr("A sheet that light shines through; the building is computed anew"));
  transmittance_->setRange(0.0, 1.0);
  transmittance_->setSteps(0.01, 1);
  transmittance_->setToolTip(tr("Of the whole sheet, seen straight on; double glazing has two"));
  note_->setWordWrap(true);
  note_->setForegroundRole(QPalette::PlaceholderText);
  auto* form = new QFormLayout(fields_);
  form->setContentsMargins(10, 4, 10, 8);
  form->setVerticalSpacing(5);
  form->addRow(tr("Reflectance"), pair(rho_slider_, rho_box_));
  form->addRow(warning_);
  form->addRow(tr("Colour"), colour_);
  form->addRow(tr("Specular"), specular_);
  form->addRow(tr("Roughness"), pair(roughness_slider_, roughness_));
  form->addRow(glass_);
  form->addRow(tr("Transmittance"), transmittance_);
  form->addRow(note_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(list_, 1);
  layout->addWidget(fields_);
  connectEdits();
  refresh();
}

void MaterialsPanel::connectEdits() {
  connect(list_, &QListWidget::currentRowChanged, this, [this] {
    if (!following_) showChosen();
  });
  const auto take_rho = [this](double rho) {
    edit(
        tr("Change reflectance"),
        [rho](const scene::Material& m) { return withReflectance(m, rho); }, kRhoWay);
  };
  connect(rho_slider_, &QSlider::valueChanged, this,
          [take_rho](int percent) { take_rho(percent / 100.0); });
  connect(rho_box_, &QuantityBox::edited, this, take_rho);
  connect(colour_, &QToolButton::clicked, this, &MaterialsPanel::chooseColour);
  connect(specular_, &QuantityBox::edited, this, [this](double v) {
    edit(
        tr("Change gloss"), [v](const scene::Material& m) { return withSpecular(m, v); },
        kSpecularWay);
  });
  connect(glass_, &QCheckBox::clicked, this, [this](bool on) {
    edit(
        tr("Glass"),
        [on](const scene::Material& m) {
          scene::Material changed = m;
          changed.glass = on ? std::optional(scene::Glass{}) : std::nullopt;
          return changed;
        },
        -1);
  });
  connect(transmittance_, &QuantityBox::edited, this, [this](double v) {
    edit(
        tr("Transmittance"),
        [v](const scene::Material& m) {
          scene::Material changed = m;
          if (changed.glass) changed.glass->transmittance = v;
          return changed;
        },
        kGlassWay);
  });
  const auto take_roughness = [this](double v) {
    edit(
        tr("Change roughness"),
        [v](const scene::Material& m) {
          scene::Material changed = m;
          changed.roughness = v;
          return changed;
        },
        kRoughnessWay);
  };
  connect(roughness_slider_, &QSlider::valueChanged, this,
          [take_roughness](int percent) { take_roughness(percent / 100.0); });
  connect(roughness_, &QuantityBox::edited, this, take_roughness);
}

void MaterialsPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  if (document_ != nullptr) {
    connect(document_, &Document::sceneChanged, this, &MaterialsPanel::refresh);
  }
  refresh();
}

QString MaterialsPanel::chosen() const {
  const QListWidgetItem* item = list_->currentItem();
  return item == nullptr ? QString() : item->data(Qt::UserRole).toString();
}

void MaterialsPanel::choose(const QString& material) {
  for (int i = 0; i < list_->count(); ++i) {
    if (list_->item(i)->data(Qt::UserRole).toString() == material) list_->setCurrentRow(i);
  }
}

const scene::Material* MaterialsPanel::material() const {
  const int row = list_->currentRow();
  return row < 0 || row >= static_cast<int>(known_.size()) ? nullptr
                                                           : &known_[static_cast<std::size_t>(row)];
}

void MaterialsPanel::edit(const QString& text,
                          const std::function<scene::Material(const scene::Material&)>& change,
                          int merge_key) {
  const scene::Material* now = material();
  if (document_ != nullptr && now != nullptr) {
    editMaterial(*document_, text, std::string(now->name), change, merge_key);
  }
}

void MaterialsPanel::chooseColour() {
  const scene::Material* now = material();
  if (now == nullptr) return;
  const QColor color = QColorDialog::getColor(shown(now->diffuse), this, tr("Colour"));
  if (!color.isValid()) return;
  const auto linear = [](float v) { return static_cast<double>(color::srgbDecode(v)); };
  const dvec3 colour(linear(color.redF()), linear(color.greenF()), linear(color.blueF()));
  edit(
      tr("Change colour"), [&](const scene::Material& m) { return withColour(m, colour); }, -1);
}

void MaterialsPanel::refresh() {
  static const std::vector<scene::Material> kNone;
  const auto& now = document_ == nullptr ? kNone : document_->scene()->materials;
  const QString before = chosen();
  const bool same_rows =
      std::ranges::equal(known_, now, {}, &scene::Material::name, &scene::Material::name);
  following_ = true;
  if (!same_rows) {
    list_->clear();
    known_.clear();
    rho_.clear();
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (same_rows && scene::sameReflectance(known_[i], now[i])) continue;
    if (!same_rows) {
      known_.push_back(now[i]);
      rho_.push_back(0.0);
      list_->addItem(new QListWidgetItem);
      list_->item(static_cast<int>(i))->setData(Qt::UserRole, toQt(now[i].name));
    }
    known_[i] = now[i];
    rho_[i] = scene::reflectance(now[i]);
    QListWidgetItem* item = list_->item(static_cast<int>(i));
    const QString share = now[i].glass ? tr("glass") : formatQuantity(rho_[i], Dimension::share, 0);
    item->setText(QStringLiteral("%1   %2").arg(toQt(now[i].name), share));
    item->setIcon(swatch(now[i], palette().color(QPalette::PlaceholderText)));
  }
  if (!same_rows) choose(before);
  following_ = false;
  showChosen();
}

void MaterialsPanel::showChosen() {
  const scene::Material* m = material();
  fields_->setVisible(m != nullptr);
  if (m == nullptr) return;
  const double rho = rho_[static_cast<std::size_t>(list_->currentRow())];
  const QSignalBlocker quiet_rho(rho_slider_);
  const QSignalBlocker quiet_roughness(roughness_slider_);
  rho_slider_->setValue(static_cast<int>(std::lround(100.0 * rho)));
  rho_box_->setValue(rho);
  warning_->setVisible(rho > kWhitest + 1e-9 && !m->glass);
  colour_->setIcon(swatch(*m, palette().color(QPalette::PlaceholderText)));
  specular_->setValue(m->specular);
  roughness_slider_->setValue(static_cast<int>(std::lround(100.0 * m->roughness)));
  roughness_->setValue(m->roughness);
  const bool opaque = !m->glass.has_value();
  for (QWidget* widget : {static_cast<QWidget*>(rho_slider_), static_cast<QWidget*>(rho_box_),
                          static_cast<QWidget*>(colour_), static_cast<QWidget*>(specular_)}) {
    widget->setEnabled(opaque);
  }
  glass_->setChecked(!opaque);
  transmittance_->setEnabled(!opaque);
  transmittance_->setValue(opaque ? std::nullopt : std::optional(m->glass->transmittance));
  transmittance_->setEmptyText(QStringLiteral("\u2013"));
  QStringList notes;
  if (!opaque) {
    notes << tr("Glass: it lets light through and mirrors some; it has no colour of its own.");
  } else {
    if (!m->diffuse_map.empty())
      notes << tr("Its picture %1 is multiplied by the colour.").arg(toQt(m->diffuse_map));
    if (!m->roughness_map.empty())
      notes << tr("The roughness is multiplied by the picture %1.").arg(toQt(m->roughness_map));
  }
  note_->setText(notes.join(QLatin1Char('\n')));
  note_->setVisible(!note_->text().isEmpty());
}

}  // namespace soffit::ui
