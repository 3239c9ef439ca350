// SPDX-License-Identifier: MIT
#include "ui/widgets/lux_scale_fields.h"

#include "ui/widgets/units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>

namespace soffit::ui {
namespace {

const QString kMapKey = QStringLiteral("scale/colours");
const QString kSeriesKey = QStringLiteral("scale/levels");
/// A logarithmic scale that would start at 0 starts at this share of its end.
constexpr double kLogStart = 1e-3;
constexpr QSize kSwatch(48, 12);

QIcon swatchOf(color::ColorMap map) {
  QPixmap picture(kSwatch);
  QPainter painter(&picture);
  for (int x = 0; x < kSwatch.width(); ++x) {
    const vec3 c =
        color::colorMapAt(map, static_cast<float>(x) / static_cast<float>(kSwatch.width() - 1));
    painter.fillRect(x, 0, 1, kSwatch.height(), QColor::fromRgbF(c.x, c.y, c.z));
  }
  return QIcon(picture);
}

template <class Choice>
Choice savedChoice(const QString& key, int count) {
  const int number = QSettings().value(key, 0).toInt();
  return static_cast<Choice>(number < 0 || number >= count ? 0 : number);
}

}  // namespace

std::vector<double> parseLevels(const QString& text) {
  // A comma parts numbers here, so decimals have a point; a unit may follow after a space.
  static const QRegularExpression kLevel(
      QStringLiteral("([0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)\\s*(klx|lx|lux|fc)?"),
      QRegularExpression::CaseInsensitiveOption);
  std::vector<double> levels;
  for (auto found = kLevel.globalMatch(text); found.hasNext();) {
    const auto lux = parseQuantity(found.next().captured(0), Dimension::illuminance);
    if (lux && *lux > 0.0) levels.push_back(*lux);
  }
  std::ranges::sort(levels);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

LuxScaleFields::LuxScaleFields(QWidget* parent)
    : QWidget(parent),
      min_(new QuantityBox(Dimension::illuminance)),
      max_(new QuantityBox(Dimension::illuminance)),
      logarithmic_(new QCheckBox(tr("Logarithmic"))),
      map_(new QComboBox),
      steps_(new QSpinBox),
      levels_(new QComboBox),
      chosen_levels_(new QLineEdit) {
  scale_.map = savedChoice<color::ColorMap>(kMapKey, static_cast<int>(color::kColorMaps.size()));
  series_ = savedChoice<color::LevelSeries>(kSeriesKey, 2);
  for (QuantityBox* box : {min_, max_}) {
    box->setRange(0.0, 1e6);
    box->setSteps(50.0, 1);
  }
  min_->setAccessibleName(tr("Least illuminance of the scale"));
  max_->setAccessibleName(tr("Greatest illuminance of the scale"));
  map_->setIconSize(kSwatch);
  const QString names[] = {tr("Violet to yellow"), tr("Blue to yellow"), tr("Greys"),
                           tr("Spectrum")};
  for (const color::ColorMap map : color::kColorMaps) {
    map_->addItem(swatchOf(map), names[static_cast<std::size_t>(map)]);
    map_->setItemData(map_->count() - 1,
                      color::isColorBlindSafe(map) ? tr("Safe for color blindness and prints")
                                                   : tr("As in other programs; red and green look "
                                                        "alike to many"),
                      Qt::ToolTipRole);
  }
  steps_->setRange(0, color::kMostSteps);
  steps_->setSpecialValueText(tr("Smooth"));
  steps_->setToolTip(tr("Bands of one colour each"));
  levels_->addItems({tr("Round values"), tr("Standard series"), tr("Own values")});
  levels_->setToolTip(tr("Standard series: 0.5 1 2 3 5 7.5 10 \u2026 500 750 1000 \u2026"));
  chosen_levels_->setPlaceholderText(tr("300, 500, 750"));
  chosen_levels_->setAccessibleName(tr("Values of the isolux lines"));

  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(6);
  auto* range = new QHBoxLayout;
  range->addWidget(min_);
  range->addWidget(new QLabel(QStringLiteral("\u2013")));
  range->addWidget(max_);
  range->addStretch(1);
  form->addRow(tr("Scale"), range);
  auto* row = new QHBoxLayout;
  row->addWidget(steps_);
  row->addWidget(logarithmic_);
  row->addStretch(1);
  form->addRow(tr("Steps"), row);
  form->addRow(tr("Colours"), map_);
  form->addRow(tr("Lines at"), levels_);
  form->addRow(QString(), chosen_levels_);
  connectFields();
  refresh();
}

void LuxScaleFields::connectFields() {
  connect(min_, &QuantityBox::edited, this, &LuxScaleFields::takeRange);
  connect(max_, &QuantityBox::edited, this, &LuxScaleFields::takeRange);
  connect(logarithmic_, &QCheckBox::toggled, this, &LuxScaleFields::takeRange);
  connect(steps_, &QSpinBox::valueChanged, this, [this](int steps) {
    // One step would be no scale: on the way up it is passed over, and so it is on the way down.
    if (steps == 1) steps_->setValue(scale_.steps == 0 ? 2 : 0);
    scale_.steps = steps_->value();
    Q_EMIT changed();
  });
  connect(map_, &QComboBox::activated, this, [this](int map) {
    scale_.map = static_cast<color::ColorMap>(map);
    QSettings().setValue(kMapKey, map);
    Q_EMIT changed();
  });
  connect(levels_, &QComboBox::activated, this, [this](int series) {
    if (series == static_cast<int>(color::LevelSeries::chosen) && chosen_.empty()) {
      chosen_ = levels();
    }
    series_ = static_cast<color::LevelSeries>(series);
    QSettings().setValue(kSeriesKey, series);
    showLevels();
    Q_EMIT changed();
  });
  connect(chosen_levels_, &QLineEdit::editingFinished, this, &LuxScaleFields::takeLevels);
}

color::LuxScale LuxScaleFields::scale() const {
  color::LuxScale scale = scale_;
  scale.unit = luxUnitOf(shownUnits());
  return scale;
}

std::vector<double> LuxScaleFields::levels() const {
  return color::isoLevels(scale(), series_, chosen_);
}

void LuxScaleFields::suggestRange(const color::FalseColorRange& range) {
  if (range_chosen_ || range == scale_.range) return;
  scale_.range = range;
  refresh();
  Q_EMIT changed();
}

void LuxScaleFields::forgetRange() {
  range_chosen_ = false;
}

void LuxScaleFields::takeRange() {
  color::FalseColorRange range{min_->value().value_or(0.0), max_->value().value_or(1000.0),
                               logarithmic_->isChecked()};
  if (range.logarithmic && range.min <= 0.0) range.min = kLogStart * range.max;
  if (range.check()) {
    scale_.range = range;
    range_chosen_ = true;
  }
  refresh();
  Q_EMIT changed();
}

void LuxScaleFields::takeLevels() {
  const auto levels = parseLevels(chosen_levels_->text());
  if (!levels.empty()) chosen_ = levels;
  showLevels();
  Q_EMIT changed();
}

void LuxScaleFields::showLevels() {
  const bool own = series_ == color::LevelSeries::chosen;
  chosen_levels_->setVisible(own);
  QStringList texts;
  for (const double lux : chosen_) texts.append(formatNumber(lux, Dimension::illuminance, 2));
  const QSignalBlocker quiet(chosen_levels_);
  chosen_levels_->setText(texts.join(QStringLiteral(", ")));
}

void LuxScaleFields::refresh() {
  min_->setValue(scale_.range.min);
  max_->setValue(scale_.range.max);
  {
    const QSignalBlocker quiet(logarithmic_);
    logarithmic_->setChecked(scale_.range.logarithmic);
  }
  map_->setCurrentIndex(static_cast<int>(scale_.map));
  levels_->setCurrentIndex(static_cast<int>(series_));
  showLevels();
}

void LuxScaleFields::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::LocaleChange) return;
  showLevels();
  Q_EMIT changed();
}

}  // namespace soffit::ui
