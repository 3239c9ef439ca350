// SPDX-License-Identifier: MIT
#include "ui/panels/results_panel.h"

#include "ui/widgets/quantity.h"
#include "ui/widgets/table_text.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QShortcut>
#include <QStackedWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

namespace soffit::ui {

namespace {

/// width: of a column of numbers, in digits.
QTableView* makeTable(QAbstractItemModel& model, const QString& name, int width, int stretched) {
  constexpr int kNames = 2;
  auto* table = new QTableView;
  table->setModel(&model);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setAlternatingRowColors(true);
  table->setShowGrid(false);
  table->setWordWrap(false);
  table->setAccessibleName(name);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 8);
  QHeaderView* header = table->horizontalHeader();
  header->setHighlightSections(false);
  const int digit = table->fontMetrics().horizontalAdvance(QLatin1Char('0'));
  header->setMinimumSectionSize(6 * digit);
  for (int i = 0; i < model.columnCount(); ++i) {
    table->setColumnWidth(i, (i < kNames ? 16 : width) * digit);
  }
  header->setSectionResizeMode(stretched, QHeaderView::Stretch);
  return table;
}

}  // namespace

ResultsPanel::ResultsPanel(QWidget* parent)
    : QWidget(parent),
      tables_(new QStackedWidget),
      all_(makeTable(model_, tr("Readings of the work planes"), 9, ResultsModel::kPlane)),
      pair_(makeTable(difference_, tr("Two layouts compared"), 14, DifferenceModel::kPlane)),
      against_(new QToolButton),
      state_(new QLabel),
      copy_(new QToolButton),
      export_(new QToolButton) {
  all_->setObjectName(QStringLiteral("all_layouts"));
  pair_->setObjectName(QStringLiteral("differences"));
  tables_->addWidget(all_);
  tables_->addWidget(pair_);
  against_->setText(tr("Differences"));
  against_->setToolTip(tr("The two layouts that are compared, and what differs"));
  against_->setCheckable(true);
  against_->hide();
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("The table as text for a spreadsheet (Ctrl+C): the rows selected, or all"));
  export_->setText(tr("Export CSV\u2026"));
  export_->setToolTip(tr("The figures of all layouts, as soffit compare writes them"));

  auto* row = new QHBoxLayout;
  row->addWidget(state_, 1);
  row->addWidget(against_);
  row->addWidget(copy_);
  row->addWidget(export_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(6);
  layout->addLayout(row);
  layout->addWidget(tables_, 1);

  auto* keys = new QShortcut(QKeySequence::Copy, tables_);
  keys->setContext(Qt::WidgetWithChildrenShortcut);
  connect(keys, &QShortcut::activated, this, &ResultsPanel::copy);
  connect(copy_, &QToolButton::clicked, this, &ResultsPanel::copy);
  connect(export_, &QToolButton::clicked, this, &ResultsPanel::exportRequested);
  connect(against_, &QToolButton::toggled, tables_, &QStackedWidget::setCurrentIndex);
  connect(all_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    const auto chosen = model_.layoutAt(index.row());
    if (chosen) Q_EMIT layoutChosen(*chosen);
  });
  showState();
}

void ResultsPanel::setReadings(ReadingsPtr readings) {
  difference_.setReadings(readings);
  model_.setReadings(std::move(readings));
  showState();
}

void ResultsPanel::setComparison(const std::optional<std::pair<QString, QString>>& layouts) {
  difference_.setLayouts(layouts);
  const bool begins = layouts && !against_->isVisibleTo(this);
  against_->setVisible(layouts.has_value());
  if (begins || !layouts) against_->setChecked(layouts.has_value());
}

QTableView* ResultsPanel::table() const {
  return against_->isChecked() ? pair_ : all_;
}

void ResultsPanel::showState() {
  const ReadingsPtr& readings = model_.readings();
  copy_->setEnabled(readings != nullptr);
  export_->setEnabled(readings != nullptr);
  if (readings == nullptr) {
    state_->setText(tr("No readings yet"));
  } else if (readings->area_m2 <= 0.0) {
    state_->setText(tr("The project has no work planes: flux and power alone"));
  } else {
    state_->setText(
        readings->coarse
            ? tr("Preview: the light transport is still being computed")
            : tr("Work planes of %1 m\u00b2 in all").arg(formatNumber(readings->area_m2, 1)));
  }
}

QString ResultsPanel::text() const {
  return tableText(*table()->model(), table()->selectionModel()->selectedRows());
}

void ResultsPanel::copy() const {
  QGuiApplication::clipboard()->setText(text());
}

}  // namespace soffit::ui
