// SPDX-License-Identifier: MIT
#include "ui/actions/keys_dialog.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace soffit::ui {
namespace {

constexpr int kId = Qt::UserRole;
constexpr QSize kSize(620, 560);

}  // namespace

KeysDialog::KeysDialog(KeyBindings& bindings, QWidget* parent)
    : QDialog(parent),
      bindings_(bindings),
      search_(new QLineEdit),
      list_(new QTreeWidget),
      preset_(new QComboBox),
      edit_(new QKeySequenceEdit),
      assign_(new QPushButton(tr("&Assign"))),
      reset_(new QPushButton(tr("&Reset"))),
      conflict_(new QLabel) {
  setObjectName(QStringLiteral("keys"));
  setWindowTitle(tr("Mouse and keys"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* tabs = new QTabWidget;
  tabs->addTab(makeKeys(), tr("&Keys"));
  tabs->addTab(makeMouse(), tr("&Mouse and dragging"));
  auto* box = new QVBoxLayout(this);
  box->addWidget(tabs);
  connect(&bindings_, &KeyBindings::changed, this, &KeysDialog::fill);
  connect(search_, &QLineEdit::textChanged, this, &KeysDialog::filter);
  connect(list_, &QTreeWidget::currentItemChanged, this, &KeysDialog::showCurrent);
  connect(preset_, &QComboBox::textActivated, &bindings_, &KeyBindings::setPreset);
  connect(edit_, &QKeySequenceEdit::keySequenceChanged, this, [this](const QKeySequence& keys) {
    const Command* other = bindings_.takenBy(keys, current());
    conflict_->setText(
        other == nullptr
            ? QString()
            : tr("%1 › %2 has these keys and will lose them.").arg(other->place, other->name));
  });
  connect(assign_, &QPushButton::clicked, this, &KeysDialog::assign);
  connect(reset_, &QPushButton::clicked, this, [this] { bindings_.reset(current()); });
  resize(kSize);
  fill();
  search_->setFocus();
}

QWidget* KeysDialog::makeKeys() {
  auto* page = new QWidget;
  search_->setPlaceholderText(tr("Command or key"));
  search_->setClearButtonEnabled(true);
  list_->setColumnCount(2);
  list_->setHeaderLabels({tr("Command"), tr("Keys")});
  list_->setUniformRowHeights(true);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  preset_->addItems(KeyBindings::presets());
  preset_->setToolTip(tr("Keys as in another program, for the commands that Soffit has, too"));
  auto* all = new QPushButton(tr("Reset a&ll"));
  connect(all, &QPushButton::clicked, &bindings_, &KeyBindings::resetAll);
  auto* top = new QHBoxLayout;
  top->addWidget(search_, 1);
  top->addWidget(new QLabel(tr("As in")));
  top->addWidget(preset_);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(new QLabel(tr("New keys")));
  bottom->addWidget(edit_, 1);
  for (QPushButton* b : {assign_, reset_, all}) {
    b->setAutoDefault(false);
    bottom->addWidget(b);
  }
  conflict_->setWordWrap(true);
  auto* box = new QVBoxLayout(page);
  box->addLayout(top);
  box->addWidget(list_);
  box->addLayout(bottom);
  box->addWidget(conflict_);
  return page;
}

QWidget* KeysDialog::makeMouse() {
  const std::pair<QString, QString> rows[] = {
      {tr("Left"), tr("select; drag a luminaire or the gizmo; elsewhere orbit")},
      {tr("Shift or Ctrl + click"), tr("add to the selection, remove from it")},
      {tr("Shift or Ctrl + drag"), tr("from an empty place: select by a rubber band")},
      {tr("Shift + drag a luminaire"), tr("drag a copy")},
      {tr("Double click"), tr("a luminaire: its properties; a surface: its material")},
      {tr("Middle, or Shift + right"), tr("pan")},
      {tr("Right"), tr("look round")},
      {tr("Right held: W, A, S, D"), tr("walk; Q down, E up, Shift faster, wheel: speed")},
      {tr("Wheel"), tr("move toward what is under the cursor")},
      {tr("Plans and sections"), tr("drag to shift; Ctrl + wheel moves the cut")},
      {tr("While dragging: X, Y, Z"), tr("lock an axis")},
      {tr("While dragging: digits"), tr("type a value, such as 1.2 or 120 cm")},
      {tr("While dragging: Ctrl"), tr("whole steps")},
      {tr("While dragging: Alt"), tr("do not snap")},
      {tr("Enter, Esc"), tr("end a drag; give it up, or select nothing")},
      {tr("1 to 9, Ctrl + 1 to 9"), tr("recall a light scene, store one")},
      {tr("V"), tr("next layout")}};
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setVerticalSpacing(9);
  form->setHorizontalSpacing(18);
  for (const auto& [what, does] : rows) {
    auto* text = new QLabel(does);
    text->setWordWrap(true);
    form->addRow(what, text);
  }
  auto* scroll = new QScrollArea;
  scroll->setWidget(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  return scroll;
}

void KeysDialog::fill() {
  const QString kept = current();
  const QSignalBlocker quiet(list_);
  list_->clear();
  QMap<QString, QTreeWidgetItem*> groups;
  for (const Command& c : bindings_.commands()) {
    if (c.action == nullptr) continue;
    QTreeWidgetItem*& group = groups[c.place];
    if (group == nullptr) {
      group = new QTreeWidgetItem(list_, QStringList(c.place));
      group->setFirstColumnSpanned(true);
      group->setFlags(Qt::ItemIsEnabled);
      QFont bold = group->font(0);
      bold.setBold(true);
      group->setFont(0, bold);
    }
    QStringList keys;
    for (const QKeySequence& k : c.action->shortcuts())
      keys.append(k.toString(QKeySequence::NativeText));
    auto* item = new QTreeWidgetItem(group, {c.name, keys.join(QStringLiteral(", "))});
    item->setData(0, kId, c.id);
    item->setToolTip(0, c.action->toolTip());
    if (bindings_.isChanged(c.id)) {
      QFont bold = item->font(1);
      bold.setBold(true);
      item->setFont(1, bold);
    }
    if (c.id == kept) list_->setCurrentItem(item);
  }
  list_->expandAll();
  preset_->setCurrentText(bindings_.preset());
  filter(search_->text());
  showCurrent();
}

void KeysDialog::filter(const QString& text) {
  for (int g = 0; g < list_->topLevelItemCount(); ++g) {
    QTreeWidgetItem* group = list_->topLevelItem(g);
    bool any = false;
    for (int i = 0; i < group->childCount(); ++i) {
      QTreeWidgetItem* item = group->child(i);
      const bool shown = text.isEmpty() || item->text(0).contains(text, Qt::CaseInsensitive) ||
                         item->text(1).contains(text, Qt::CaseInsensitive) ||
                         group->text(0).contains(text, Qt::CaseInsensitive);
      item->setHidden(!shown);
      any = any || shown;
    }
    group->setHidden(!any);
  }
}

QString KeysDialog::current() const {
  const QTreeWidgetItem* item = list_->currentItem();
  return item == nullptr ? QString() : item->data(0, kId).toString();
}

void KeysDialog::showCurrent() {
  const QString id = current();
  edit_->setEnabled(!id.isEmpty());
  assign_->setEnabled(!id.isEmpty());
  reset_->setEnabled(!id.isEmpty() && bindings_.isChanged(id));
  const QSignalBlocker quiet(edit_);
  edit_->setKeySequence(bindings_.keys(id));
  conflict_->clear();
}

void KeysDialog::assign() {
  bindings_.assign(current(), edit_->keySequence());
}

}  // namespace soffit::ui
