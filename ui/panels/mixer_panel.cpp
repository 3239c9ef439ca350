// SPDX-License-Identifier: MIT
#include "ui/panels/mixer_panel.h"

#include "core/color/srgb.h"
#include "ui/document/text.h"
#include "ui/panels/luminaire_text.h"

#include <QColorDialog>
#include <QFrame>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace soffit::ui {

MixerPanel::MixerPanel(QWidget* parent)
    : QWidget(parent),
      rows_(new QVBoxLayout),
      scenes_(new QHBoxLayout),
      empty_(new QLabel(tr("Luminaires with the same group are mixed here."))),
      add_(new QToolButton) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 6, 4, 6);
  layout->setSpacing(2);
  scenes_->setContentsMargins(8, 0, 8, 0);
  scenes_->setSpacing(3);
  auto* title = new QLabel(tr("Scenes"));
  title->setForegroundRole(QPalette::PlaceholderText);
  scenes_->addWidget(title);
  add_->setText(QStringLiteral("+"));
  add_->setToolTip(tr("Store what is lit now as a scene"));
  add_->setAccessibleName(add_->toolTip());
  scenes_->addWidget(add_);
  scenes_->addStretch(1);
  empty_->setWordWrap(true);
  empty_->setForegroundRole(QPalette::PlaceholderText);
  empty_->setContentsMargins(8, 4, 8, 4);
  rows_->setSpacing(0);
  layout->addLayout(scenes_);
  layout->addWidget(empty_);
  layout->addLayout(rows_);
  layout->addStretch(1);
  connect(add_, &QToolButton::clicked, this, [this] {
    if (document_ != nullptr) store(document_->lightScenes().size());
  });
  refresh();
}

void MixerPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  if (document_ != nullptr) {
    connect(document_, &Document::sceneChanged, this, &MixerPanel::refresh);
    connect(document_, &Document::soloChanged, this, &MixerPanel::refresh);
    connect(document_, &Document::lightScenesChanged, this, &MixerPanel::refreshScenes);
    connect(document_, &Document::layoutChanged, this, &MixerPanel::refreshScenes);
  }
  refresh();
}

void MixerPanel::recall(std::size_t number) {
  if (document_ == nullptr || number >= document_->lightScenes().size()) return;
  recallScene(*document_, io::LightScene(document_->lightScenes()[number]));
}

void MixerPanel::store(std::size_t number) {
  if (document_ != nullptr) storeScene(*document_, number);
}

GroupStrip* MixerPanel::addStrip() {
  auto* strip = new GroupStrip;
  rows_->addWidget(strip);
  strips_.push_back(strip);
  connect(strip, &GroupStrip::levelMoved, this,
          [this](const QString& group, double level) { setGroupLevel(*document_, group, level); });
  connect(strip, &GroupStrip::switched, this,
          [this](const QString& group, bool on) { setGroupOn(*document_, group, on); });
  connect(strip, &GroupStrip::soloed, this, [this](const QString& group, bool on) {
    QStringList solo = document_->soloGroups();
    solo.removeAll(group);
    if (on) solo.append(group);
    document_->setSoloGroups(solo);
  });
  connect(strip, &GroupStrip::cctChosen, this, [this](const QString& group, double cct_k) {
    setGroupColour(*document_, group, {cct_k, dvec3(1.0)});
  });
  connect(strip, &GroupStrip::colourWanted, this, &MixerPanel::chooseColour);
  connect(strip, &GroupStrip::selectWanted, this,
          [this](const QString& group) { document_->setSelection(membersOf(*document_, group)); });
  return strip;
}

void MixerPanel::chooseColour(const QString& group) {
  QColor start(Qt::white);
  for (const GroupState& state : groupsOf(*document_)) {
    if (state.name == group && state.colour) start = swatchOf(*state.colour);
  }
  const QColor chosen = QColorDialog::getColor(start, this, tr("Colour of the light"));
  if (!chosen.isValid()) return;
  const auto linear = [](double v) {
    return static_cast<double>(color::srgbDecode(static_cast<float>(v)));
  };
  setGroupColour(*document_, group,
                 {std::nullopt,
                  dvec3(linear(chosen.redF()), linear(chosen.greenF()), linear(chosen.blueF()))});
}

void MixerPanel::refresh() {
  const std::vector<GroupState> groups =
      document_ == nullptr ? std::vector<GroupState>{} : groupsOf(*document_);
  while (strips_.size() > groups.size()) {
    strips_.back()->deleteLater();
    strips_.pop_back();
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    GroupStrip* strip = i < strips_.size() ? strips_[i] : addStrip();
    strip->showGroup(groups[i], document_->soloGroups().contains(groups[i].name));
  }
  empty_->setVisible(groups.empty());
  refreshScenes();
}

void MixerPanel::refreshScenes() {
  static const std::vector<io::LightScene> kNone;
  const auto& scenes = document_ == nullptr ? kNone : document_->lightScenes();
  while (scene_buttons_.size() > scenes.size()) {
    scene_buttons_.back()->deleteLater();
    scene_buttons_.pop_back();
  }
  for (std::size_t i = scene_buttons_.size(); i < scenes.size(); ++i) {
    auto* button = new QToolButton;
    button->setCheckable(true);
    button->setText(QString::number(i + 1));
    button->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(button, &QToolButton::clicked, this, [this, i] {
      recall(i);
      refreshScenes();
    });
    connect(button, &QWidget::customContextMenuRequested, this,
            [this, i, button](const QPoint& at) { sceneMenu(i, button->mapToGlobal(at)); });
    scenes_->insertWidget(static_cast<int>(i) + 1, button);
    scene_buttons_.push_back(button);
  }
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const QString name = toQt(scenes[i].name);
    scene_buttons_[i]->setToolTip(
        tr("%1 (key %2). Right-click: rename, store, delete").arg(name).arg(i + 1));
    scene_buttons_[i]->setAccessibleName(name);
    scene_buttons_[i]->setChecked(isShown(*document_, scenes[i]));
  }
  add_->setEnabled(document_ != nullptr && scenes.size() < kMostScenes);
}

void MixerPanel::sceneMenu(std::size_t number, const QPoint& at) {
  QMenu menu;
  menu.addAction(tr("&Rename\u2026"), this, [this, number] {
    const QString before = toQt(document_->lightScenes()[number].name);
    const QString name =
        QInputDialog::getText(this, tr("Light scene"), tr("Name"), QLineEdit::Normal, before);
    renameScene(*document_, number, name);
  });
  menu.addAction(tr("&Store what is lit now"), this, [this, number] { store(number); });
  menu.addAction(tr("&Delete"), this, [this, number] { removeScene(*document_, number); });
  menu.exec(at);
}

}  // namespace soffit::ui
