// SPDX-License-Identifier: MIT
#include "ui/panels/group_strip.h"

#include "ui/panels/luminaire_text.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace soffit::ui {
namespace {

QToolButton* toggle(const QString& text, const QString& hint) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setToolTip(hint);
  button->setAccessibleName(hint);
  button->setCheckable(true);
  return button;
}

QIcon swatch(const std::optional<light::Colour>& colour, const QPalette& palette) {
  constexpr int kSide = 32;
  QPixmap pixmap(kSide, kSide);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette.color(QPalette::PlaceholderText), 2.0));
  painter.setBrush(colour ? QBrush(swatchOf(*colour)) : QBrush(Qt::NoBrush));
  painter.drawEllipse(3, 3, kSide - 6, kSide - 6);
  if (!colour) painter.drawLine(8, kSide - 8, kSide - 8, 8);
  return QIcon(pixmap);
}

}  // namespace

GroupStrip::GroupStrip(QWidget* parent)
    : QWidget(parent),
      name_(new QPushButton),
      on_(toggle(tr("On"), tr("Switch the group"))),
      solo_(toggle(tr("Solo"), tr("Only this group, to look at it; others go dark until then"))),
      fader_(new QSlider(Qt::Horizontal)),
      level_(new QuantityBox(Dimension::share)),
      cct_(new QuantityBox(Dimension::temperature)),
      colour_(new QToolButton) {
  name_->setFlat(true);
  name_->setToolTip(tr("Select its luminaires"));
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  name_->setStyleSheet(QStringLiteral("text-align: left; padding: 2px 0;"));
  QFont bold = name_->font();
  bold.setBold(true);
  name_->setFont(bold);
  fader_->setRange(0, 100);
  fader_->setPageStep(10);
  fader_->setMinimumWidth(50);
  fader_->setAccessibleName(tr("Dimming"));
  level_->setRange(0.0, 10.0);
  level_->setSteps(0.05, 1);
  level_->setToolTip(tr("Dimming of the group; where its luminaires differ, of the brightest"));
  // Narrow, for the fader's sake.
  level_->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("100 %")) + 30);
  cct_->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("mixed 0")) + 34);
  cct_->setRange(1000.0, 20000.0);
  cct_->setSteps(100.0, 0);
  cct_->setToolTip(tr("Correlated colour temperature"));
  colour_->setToolTip(tr("Coloured light\u2026"));
  colour_->setAccessibleName(tr("Coloured light"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(8, 5, 8, 5);
  rows->setSpacing(3);
  auto* upper = new QHBoxLayout;
  auto* lower = new QHBoxLayout;
  upper->setSpacing(4);
  lower->setSpacing(6);
  upper->addWidget(name_, 1);
  for (QToolButton* button : {on_, solo_, colour_}) upper->addWidget(button);
  lower->addWidget(fader_, 1);
  lower->addWidget(level_);
  lower->addWidget(cct_);
  rows->addLayout(upper);
  rows->addLayout(lower);
  connect(fader_, &QSlider::valueChanged, this,
          [this](int percent) { Q_EMIT levelMoved(group_, percent / 100.0); });
  connect(level_, &QuantityBox::edited, this,
          [this](double level) { Q_EMIT levelMoved(group_, level); });
  connect(cct_, &QuantityBox::edited, this, [this](double k) { Q_EMIT cctChosen(group_, k); });
  connect(on_, &QToolButton::clicked, this, [this](bool on) { Q_EMIT switched(group_, on); });
  connect(solo_, &QToolButton::clicked, this, [this](bool on) { Q_EMIT soloed(group_, on); });
  connect(colour_, &QToolButton::clicked, this, [this] { Q_EMIT colourWanted(group_); });
  connect(name_, &QToolButton::clicked, this, [this] { Q_EMIT selectWanted(group_); });
}

void GroupStrip::showGroup(const GroupState& group, bool solo) {
  group_ = group.name;
  name_->setText(QStringLiteral("%1  (%2)")
                     .arg(group.name.isEmpty() ? tr("No group") : group.name)
                     .arg(group.count));
  on_->setChecked(group.on.value_or(true));
  on_->setText(!group.on ? tr("Some") : *group.on ? tr("On") : tr("Off"));
  solo_->setChecked(solo);
  const QSignalBlocker quiet(fader_);
  fader_->setValue(static_cast<int>(std::lround(100.0 * group.level)));
  level_->setValue(group.level);
  cct_->setEmptyText(group.colour ? tr("RGB") : tr("mixed"));
  cct_->setValue(group.colour ? group.colour->cct_k : std::nullopt);
  colour_->setIcon(swatch(group.colour, palette()));
}

}  // namespace soffit::ui
