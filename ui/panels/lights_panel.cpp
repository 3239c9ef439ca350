// SPDX-License-Identifier: MIT
#include "ui/panels/lights_panel.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLineEdit>
#include <QTableView>
#include <QVBoxLayout>

#include <utility>

namespace soffit::ui {

LightsPanel::LightsPanel(QWidget* parent)
    : QWidget(parent), filter_(new QLineEdit), table_(new QTableView) {
  sorted_.setSourceModel(&model_);
  sorted_.setSortRole(Qt::UserRole);
  sorted_.setFilterKeyColumn(-1);
  sorted_.setFilterCaseSensitivity(Qt::CaseInsensitive);
  sorted_.setSortLocaleAware(true);
  filter_->setPlaceholderText(tr("Filter by name, group, colour"));
  filter_->setClearButtonEnabled(true);
  table_->setModel(&sorted_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setSortingEnabled(true);
  table_->sortByColumn(-1, Qt::AscendingOrder);
  table_->setAlternatingRowColors(true);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->setAccessibleName(tr("Luminaires"));
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table_->setToolTip(tr("Double-click or F2 to edit all that are selected: 80 %, +=10, *=1.2"));
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 8);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  const int digit = table_->fontMetrics().horizontalAdvance(QLatin1Char('0'));
  const int widths[] = {16 * digit, 8 * digit, 10 * digit, 11 * digit,
                        10 * digit, 8 * digit, 8 * digit,  8 * digit};
  for (int i = 0; i < LightsModel::kColumns; ++i) table_->setColumnWidth(i, widths[i]);
  table_->horizontalHeader()->setSectionResizeMode(LightsModel::kName, QHeaderView::Stretch);
  table_->horizontalHeader()->setMinimumSectionSize(8 * digit);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(6);
  layout->addWidget(filter_);
  layout->addWidget(table_);
  connect(filter_, &QLineEdit::textChanged, &sorted_, &QSortFilterProxyModel::setFilterFixedString);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &LightsPanel::takeSelection);
  connect(&model_, &QAbstractItemModel::modelReset, this, &LightsPanel::showSelection);
}

void LightsPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  model_.setDocument(document);
  if (document_ == nullptr) return;
  connect(document_, &Document::selectionChanged, this, &LightsPanel::showSelection);
  showSelection();
}

void LightsPanel::takeSelection() {
  if (following_ || document_ == nullptr) return;
  QStringList names;
  for (const QModelIndex& index : table_->selectionModel()->selectedRows()) {
    names.append(model_.nameAt(sorted_.mapToSource(index).row()));
  }
  following_ = true;
  document_->setSelection(names);
  following_ = false;
}

void LightsPanel::showSelection() {
  if (following_ || document_ == nullptr) return;
  following_ = true;
  QItemSelection chosen;
  QModelIndex first;
  for (const QString& name : document_->selection()) {
    const int row = model_.rowOf(name);
    if (row < 0) continue;
    const QModelIndex index = sorted_.mapFromSource(model_.index(row, 0));
    chosen.select(index, index);
    if (!first.isValid()) first = index;
  }
  table_->selectionModel()->select(chosen,
                                   QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (first.isValid()) table_->scrollTo(first);
  following_ = false;
}

}  // namespace soffit::ui
