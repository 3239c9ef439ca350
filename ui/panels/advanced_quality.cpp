// SPDX-License-Identifier: MIT
#include "ui/panels/advanced_quality.h"

#include "ui/document/text.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <string>

namespace soffit::ui {
namespace {

struct Words {
  const char* name;
  QString label;
  QString tip;
};

/// What the settings mean to people.
std::array<Words, 17> words() {
  const auto tr = [](const char* text) { return AdvancedQuality::tr(text); };
  return {
      {{"texels", tr("Points"), tr("Where light is computed and sent on")},
       {"least_cell", tr("Least distance of points, m"), {}},
       {"most_cell", tr("Greatest distance of points, m"),
        tr("Large buildings get up to four times as many points for it")},
       {"patch", tr("Points per patch"), tr("Further reflections go from patch to patch")},
       {"node_rays", tr("Rays per point between patches, squared"), {}},
       {"trainings", tr("Training lights"), tr("From them the program learns where light differs")},
       {"field_rays", tr("Rays per point and training, squared"), {}},
       {"list_rays", tr("Rays per gather point, squared"), tr("Noise of the first reflection")},
       {"max_rank", tr("Gather points per group, at most"), {}},
       {"lists", tr("Gather points per point, at most"), {}},
       {"tolerance", tr("What a gather point must tell"),
        tr("One that tells less than this share of the mean is left out")},
       {"sweeps", tr("Reflections from point to point"),
        tr("Once more between all points, for what patches are too coarse for")},
       {"sensor_rays", tr("Rays per calculation point, squared"),
        tr("Noise of values on work planes")},
       {"bands", tr("Bands of harmonics"), tr("Sharper shadows and more ringing with more")},
       {"directions", tr("Directions of shadows"), tr("Rays per point, harmonics alone")},
       {"reach", tr("Reach of shadows, m"),
        tr("What lies farther from a point does not shade it, harmonics alone")},
       {"cube_side", tr("Texels along a cube's edge"), tr("Cube maps alone")}}};
}

QString directName(const char* method) {
  const std::string name = method;
  if (name == "harmonics") return AdvancedQuality::tr("Harmonics times transfer");
  if (name == "cubes") return AdvancedQuality::tr("Dynamic cube maps");
  return AdvancedQuality::tr("Exact");
}

int decimalsFor(const relight::SettingInfo& info) {
  if (info.whole) return 0;
  return info.lowest < 1e-3 ? 5 : 3;
}

}  // namespace

AdvancedQuality::AdvancedQuality(const scene::Quality& quality, QWidget* parent)
    : QDialog(parent), direct_(new QComboBox), form_(new QFormLayout) {
  setWindowTitle(tr("Advanced quality"));
  preset_.preset = quality.preset;
  for (const char* method : relight::kDirectMethods) {
    direct_->addItem(directName(method), QString::fromLatin1(method));
  }
  direct_->setObjectName(QStringLiteral("direct_method"));
  direct_->setToolTip(
      tr("How the direct light of luminaires is computed in the view. The exact method is faster "
         "and nearer to the truth; the others are those of the founding papers, to compare."));
  if (const auto chosen = quality.methods.find("direct"); chosen != quality.methods.end()) {
    direct_->setCurrentIndex(std::max(0, direct_->findData(toQt(chosen->second))));
  }
  form_->addRow(tr("Direct light"), direct_);
  const auto list = relight::listSettings(preset_);
  const auto names = words();
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const relight::SettingInfo& info = (*list)[i];
    const auto word = std::find_if(names.begin(), names.end(),
                                   [&](const Words& w) { return info.name == w.name; });
    if (word == names.end()) continue;
    Row row{info, new QDoubleSpinBox, new QLabel(word->label)};
    row.box->setObjectName(toQt(row.info.name));
    row.box->setAccessibleName(word->label);
    row.box->setDecimals(decimalsFor(row.info));
    row.box->setRange(row.info.lowest, row.info.highest);
    row.box->setGroupSeparatorShown(true);
    row.box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    // As the box rounds it.
    row.box->setValue(row.info.value);
    row.info.value = row.box->value();
    const auto own = quality.settings.find(row.info.name);
    row.box->setValue(own != quality.settings.end() ? own->second : row.info.value);
    const QString range =
        tr("%1 to %2, preset %3").arg(row.info.lowest).arg(row.info.highest).arg(row.info.value);
    row.box->setToolTip(word->tip.isEmpty() ? range : word->tip + QLatin1Char('\n') + range);
    row.label->setBuddy(row.box);
    form_->addRow(row.label, row.box);
    connect(row.box, &QDoubleSpinBox::valueChanged, this, &AdvancedQuality::mark);
    rows_.push_back(row);
  }
  auto* page = new QWidget;
  page->setLayout(form_);
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidget(page);
  auto* note = new QLabel(
      tr("Changes are precomputed in the background. What differs from the preset is bold."));
  note->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel |
                                       QDialogButtonBox::RestoreDefaults);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(note);
  layout->addWidget(area, 1);
  layout->addWidget(buttons);
  connect(direct_, &QComboBox::currentIndexChanged, this, &AdvancedQuality::mark);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
          &AdvancedQuality::reset);
  mark();
  resize(560, 600);
}

void AdvancedQuality::mark() {
  const bool exact = direct_->currentIndex() <= 0;
  for (const Row& row : rows_) {
    QFont font = row.label->font();
    font.setBold(row.box->value() != row.info.value);
    row.label->setFont(font);
    if (row.info.of_method) form_->setRowVisible(row.box, !exact);
  }
}

void AdvancedQuality::reset() {
  direct_->setCurrentIndex(0);
  for (const Row& row : rows_) row.box->setValue(row.info.value);
}

scene::Quality AdvancedQuality::quality() const {
  scene::Quality out = preset_;
  const bool exact = direct_->currentIndex() <= 0;
  if (!exact) out.methods["direct"] = toStd(direct_->currentData().toString());
  for (const Row& row : rows_) {
    if (row.info.of_method && exact) continue;
    if (row.box->value() != row.info.value) out.settings[row.info.name] = row.box->value();
  }
  return out;
}

}  // namespace soffit::ui
