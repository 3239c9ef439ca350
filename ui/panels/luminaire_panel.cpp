// SPDX-License-Identifier: MIT
#include "ui/panels/luminaire_panel.h"

#include "core/scene/equality.h"
#include "ui/document/text.h"
#include "ui/panels/luminaire_text.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

/// Ways that are one undo step each: a slider's, and the steps of an arrow key.
enum MergeKey { kDimmingWay = 1, kFluxWay, kColourWay, kPlaceWay, kTurnWay, kShapeWay };

/// What all have in common; nothing when they differ.
template <class Get>
auto common(const std::vector<const light::Luminaire*>& all, const Get& get)
    -> std::optional<decltype(get(*all.front()))> {
  const auto value = get(*all.front());
  const bool same = std::ranges::all_of(all, [&](const auto* l) { return get(*l) == value; });
  return same ? std::optional(value) : std::nullopt;
}

}  // namespace

LuminairePanel::LuminairePanel(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  title_ = new QLabel;
  title_->setWordWrap(true);
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  kind_ = new QLabel;
  kind_->setWordWrap(true);
  kind_->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(title_);
  layout->addWidget(kind_);

  fields_ = new QWidget;
  auto* form = new QFormLayout(fields_);
  form->setContentsMargins(0, 4, 0, 0);
  form->setVerticalSpacing(5);
  form->setLabelAlignment(Qt::AlignLeft);
  on_ = new QCheckBox(tr("Switched on"));
  dimming_slider_ = new QSlider(Qt::Horizontal);
  dimming_slider_->setRange(0, 100);
  dimming_slider_->setMinimumWidth(60);
  dimming_slider_->setAccessibleName(tr("Dimming"));
  dimming_ = addBox(Dimension::share, 0.0, 10.0, 0.05, 1, tr("Share of the full flux"));
  auto* dimming = new QWidget;
  auto* dimming_row = new QHBoxLayout(dimming);
  dimming_row->setContentsMargins(0, 0, 0, 0);
  dimming_row->addWidget(dimming_slider_, 1);
  dimming_row->addWidget(dimming_);
  flux_ = addBox(Dimension::flux, 0.0, 1e7, 100.0, 1,
                 tr("Luminous flux over the whole luminaire, undimmed: 1200 lm, 1.2 klm"));
  cct_ = addBox(Dimension::temperature, 1000.0, 20000.0, 100.0, 0,
                tr("Correlated colour temperature"));
  shape_ = new ShapeFields;
  group_ = new QLineEdit;
  group_->setPlaceholderText(tr("mixed or none"));
  casts_shadow_ = new QCheckBox(tr("Its body casts shadows"));
  form->addRow(on_);
  form->addRow(tr("Dimming"), dimming);
  form->addRow(tr("Flux"), flux_);
  form->addRow(tr("Colour"), cct_);
  form->addRow(tr("Position"),
               addTriple(position_, Dimension::length, 0.1, 3,
                         tr("x, y, z of the luminaire's origin: 3.2 m, 320 cm, 10' 6\"")));
  form->addRow(tr("Rotation"),
               addTriple(rotation_, Dimension::angle, 5.0, 2,
                         tr("About the fixed x, y and z axes, in that order: 40 deg")));
  form->addRow(tr("Shape"), shape_);
  form->addRow(tr("Group"), group_);
  form->addRow(casts_shadow_);
  layout->addWidget(fields_);
  layout->addStretch(1);
  connectEdits();
  refresh();
}

QuantityBox* LuminairePanel::addBox(Dimension dimension, double least, double most, double step,
                                    int decimals, const QString& hint) {
  auto* box = new QuantityBox(dimension);
  box->setRange(least, most);
  box->setSteps(step, decimals);
  box->setToolTip(hint);
  return box;
}

QWidget* LuminairePanel::addTriple(std::array<QuantityBox*, 3>& boxes, Dimension dimension,
                                   double step, int decimals, const QString& hint) {
  auto* row = new QWidget;
  auto* layout = new QVBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    boxes[i] = addBox(dimension, -1e7, 1e7, step, decimals, hint);
    boxes[i]->setAccessibleName(QString::fromLatin1(axes[i]));
    auto* line = new QHBoxLayout;
    line->addWidget(new QLabel(QString::fromLatin1(axes[i])));
    line->addWidget(boxes[i], 1);
    layout->addLayout(line);
  }
  return row;
}

void LuminairePanel::connectEdits() {
  connect(on_, &QCheckBox::clicked, this, [this](bool on) {
    on_->setTristate(false);
    edit(on ? tr("Switch on") : tr("Switch off"), [on](light::Luminaire& l) { l.on = on; });
  });
  connect(dimming_slider_, &QSlider::valueChanged, this, [this](int percent) {
    edit(
        tr("Dim"), [percent](light::Luminaire& l) { l.dimming = percent / 100.0; }, kDimmingWay);
  });
  connect(dimming_, &QuantityBox::edited, this, [this](double v) {
    edit(
        tr("Dim"), [v](light::Luminaire& l) { l.dimming = v; }, kDimmingWay);
  });
  connect(flux_, &QuantityBox::edited, this, [this](double v) {
    edit(
        tr("Change flux"), [v](light::Luminaire& l) { l.flux = v; }, kFluxWay);
  });
  connect(cct_, &QuantityBox::edited, this, [this](double v) {
    edit(
        tr("Change colour temperature"), [v](light::Luminaire& l) { l.colour.cct_k = v; },
        kColourWay);
  });
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    connect(position_[k], &QuantityBox::edited, this, [this, i](double v) {
      edit(
          tr("Move"), [i, v](light::Luminaire& l) { l.position[i] = v; }, kPlaceWay);
    });
    connect(rotation_[k], &QuantityBox::edited, this, [this, i](double v) {
      edit(
          tr("Rotate"), [i, v](light::Luminaire& l) { l.rotation_deg[i] = v; }, kTurnWay);
    });
  }
  connect(shape_, &ShapeFields::edited, this, [this](const light::Shape& shape) {
    edit(
        tr("Change shape"), [&](light::Luminaire& l) { l.shape = shape; }, kShapeWay);
  });
  connect(group_, &QLineEdit::editingFinished, this, [this] {
    if (!group_->isModified()) return;
    group_->setModified(false);
    edit(tr("Change group"),
         [name = toStd(group_->text())](light::Luminaire& l) { l.group = name; });
  });
  connect(casts_shadow_, &QCheckBox::clicked, this, [this](bool on) {
    casts_shadow_->setTristate(false);
    edit(on ? tr("Let it cast shadows") : tr("Let it cast no shadows"),
         [on](light::Luminaire& l) { l.casts_shadow = on; });
  });
}

void LuminairePanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  if (document_ != nullptr) {
    connect(document_, &Document::sceneChanged, this, &LuminairePanel::refresh);
    connect(document_, &Document::selectionChanged, this, &LuminairePanel::refresh);
  }
  refresh();
}

std::vector<const light::Luminaire*> LuminairePanel::selected() const {
  std::vector<const light::Luminaire*> all;
  if (document_ == nullptr) return all;
  for (const QString& name : document_->selection()) {
    if (const auto* luminaire = document_->luminaire(name)) all.push_back(luminaire);
  }
  return all;
}

void LuminairePanel::edit(const QString& text, const Change& change, int merge_key) {
  if (document_ == nullptr || document_->selection().isEmpty()) return;
  document_->editLuminaires(text, document_->selection(), change, merge_key);
}

void LuminairePanel::refresh() {
  const auto all = selected();
  fields_->setVisible(!all.empty());
  kind_->setVisible(!all.empty());
  if (all.empty()) {
    title_->setText(tr("Select a luminaire in the view or in the list."));
    return;
  }
  const light::Luminaire& first = *all.front();
  title_->setText(all.size() == 1 ? toQt(first.name)
                                  : tr("%n luminaires", nullptr, static_cast<int>(all.size())));
  kind_->setText(all.size() == 1 ? describeShape(first.shape) + QStringLiteral("\n") +
                                       describeDistribution(first.distribution)
                                 : QString());
  const auto check = [&](QCheckBox* box, const std::optional<bool>& state) {
    box->setTristate(!state.has_value());
    box->setCheckState(!state ? Qt::PartiallyChecked : *state ? Qt::Checked : Qt::Unchecked);
  };
  check(on_, common(all, [](const auto& l) { return l.on; }));
  check(casts_shadow_, common(all, [](const auto& l) { return l.casts_shadow; }));
  const auto dimming = common(all, [](const auto& l) { return l.dimming; });
  const QSignalBlocker quiet(dimming_slider_);
  dimming_slider_->setValue(static_cast<int>(std::lround(100.0 * dimming.value_or(first.dimming))));
  dimming_->setValue(dimming);
  flux_->setValue(common(all, [](const auto& l) { return fluxOf(l); }));
  const bool one_colour =
      std::ranges::all_of(all, [&](const auto* l) { return scene::same(l->colour, first.colour); });
  cct_->setEmptyText(one_colour ? tr("RGB") : tr("mixed"));
  cct_->setValue(common(all, [](const auto& l) { return l.colour.cct_k; }).value_or(std::nullopt));
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    position_[k]->setValue(common(all, [i](const auto& l) { return l.position[i]; }));
    rotation_[k]->setValue(common(all, [i](const auto& l) { return l.rotation_deg[i]; }));
  }
  const bool one_shape =
      std::ranges::all_of(all, [&](const auto* l) { return scene::same(l->shape, first.shape); });
  shape_->showShape(one_shape ? &first.shape : nullptr);
  if (!group_->isModified()) {
    group_->setText(toQt(common(all, [](const auto& l) { return l.group; }).value_or("")));
  }
}

}  // namespace soffit::ui
