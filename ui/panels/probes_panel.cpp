// SPDX-License-Identifier: MIT
#include "ui/panels/probes_panel.h"

#include "ui/document/text.h"
#include "ui/widgets/quantity.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace soffit::ui {
namespace {

const QString kNone = QStringLiteral("\u2013");

QTableWidget* makeTable(const QString& name, int columns) {
  auto* table = new QTableWidget(0, columns);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setAlternatingRowColors(true);
  table->setShowGrid(false);
  table->setWordWrap(false);
  table->setAccessibleName(name);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 8);
  table->horizontalHeader()->setHighlightSections(false);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  const int digit = table->fontMetrics().horizontalAdvance(QLatin1Char('0'));
  for (int i = 1; i < columns; ++i) table->setColumnWidth(i, 10 * digit);
  return table;
}

void setText(QTableWidget& table, int row, int column, const QString& text) {
  QTableWidgetItem* item = table.item(row, column);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    if (column > 0) {
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setFlags(item->flags() & ~Qt::ItemIsEditable);
    }
    table.setItem(row, column, item);
  }
  if (item->text() != text) item->setText(text);
}

QString candelas(double value) {
  return QString::number(value, value >= 100.0 ? 'f' : 'g', value >= 100.0 ? 0 : 3);
}

}  // namespace

ProbesPanel::ProbesPanel(QWidget* parent)
    : QWidget(parent),
      table_(makeTable(tr("Probes"), 3)),
      shares_(makeTable(tr("Who lights the probe"), 3)),
      whose_(new QLabel),
      remove_(new QToolButton) {
  shares_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  remove_->setText(tr("Remove"));
  remove_->setToolTip(tr("Removes the chosen probe (Del)"));
  auto* hint = new QLabel(tr("P pins one under the cursor"));
  auto* head = new QHBoxLayout;
  head->addWidget(hint, 1);
  head->addWidget(remove_);
  auto* left = new QVBoxLayout;
  left->addLayout(head);
  left->addWidget(table_, 1);
  auto* right = new QVBoxLayout;
  whose_->setMinimumHeight(remove_->sizeHint().height());  // the tables begin side by side
  right->addWidget(whose_);
  right->addWidget(shares_, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addLayout(left, 1);
  layout->addLayout(right, 1);
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    if (filling_) return;
    showShares();
    Q_EMIT chosenChanged(chosen());
  });
  connect(table_, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
    if (!filling_ && item->column() == 0) takeName(*item);
  });
  connect(remove_, &QToolButton::clicked, this, &ProbesPanel::removeChosen);
  auto* keys = new QShortcut(QKeySequence::Delete, table_);
  keys->setContext(Qt::WidgetWithChildrenShortcut);
  connect(keys, &QShortcut::activated, this, &ProbesPanel::removeChosen);
  refresh();
}

void ProbesPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  frame_.reset();
  probes_.clear();
  if (document_ != nullptr) {
    probes_ = document_->probes();
    connect(document_, &Document::probesChanged, this, [this] { setPlaces(document_->probes()); });
  }
  refresh();
}

void ProbesPanel::setFrame(LightFramePtr frame) {
  frame_ = std::move(frame);
  refresh();
}

void ProbesPanel::setPlaces(const std::vector<io::Probe>& probes) {
  probes_ = probes;
  refresh();
}

int ProbesPanel::chosen() const {
  const auto rows = table_->selectionModel()->selectedRows();
  return rows.isEmpty() ? -1 : rows.front().row();
}

void ProbesPanel::choose(int probe) {
  if (probe == chosen()) return;
  if (probe < 0) {
    table_->clearSelection();
  } else {
    table_->selectRow(probe);
  }
}

void ProbesPanel::removeChosen() {
  const int probe = chosen();
  if (document_ == nullptr || probe < 0) return;
  std::vector<io::Probe> rest = document_->probes();
  rest.erase(rest.begin() + probe);
  document_->editProbes(tr("Remove probe"), std::move(rest));
}

void ProbesPanel::takeName(const QTableWidgetItem& item) {
  if (document_ == nullptr) return;
  std::vector<io::Probe> probes = document_->probes();
  const auto row = static_cast<std::size_t>(item.row());
  const QString name = item.text().trimmed();
  if (row >= probes.size()) return;
  if (!name.isEmpty()) probes[row].name = toStd(name);
  document_->editProbes(tr("Rename probe"), std::move(probes));
  refresh();
}

void ProbesPanel::refresh() {
  const QScopedValueRollback filling(filling_, true);
  table_->setHorizontalHeaderLabels(
      {tr("Probe"), unitOf(Dimension::illuminance), QStringLiteral("cd/m\u00b2")});
  const int before = chosen();
  table_->setRowCount(static_cast<int>(probes_.size()));
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const int row = static_cast<int>(i);
    const auto light = document_ == nullptr || frame_ == nullptr
                           ? std::nullopt
                           : readProbe(*frame_, *document_->scene(), probes_[i]);
    setText(*table_, row, 0, toQt(probes_[i].name));
    setText(*table_, row, 1, light ? formatReading(light->lux, Dimension::illuminance) : kNone);
    setText(*table_, row, 2, light ? candelas(light->luminance) : kNone);
  }
  if (chosen() < 0 && !probes_.empty()) {
    table_->selectRow(std::clamp(before, 0, static_cast<int>(probes_.size()) - 1));
  }
  showShares();
}

void ProbesPanel::showShares() {
  const int probe = chosen();
  remove_->setEnabled(probe >= 0);
  const auto at = static_cast<std::size_t>(probe);
  std::vector<double> lux;
  if (probe >= 0 && frame_ != nullptr && at < frame_->shares.size()) lux = frame_->shares[at];
  const double sum = std::accumulate(lux.begin(), lux.end(), 0.0);
  std::vector<std::size_t> order(lux.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return lux[i] <= 0.0 || i > frame_->names.size(); });
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return lux[i]; });
  whose_->setText(probe < 0 ? tr("Who lights a probe")
                            : tr("Who lights %1").arg(toQt(probes_[at].name)));
  shares_->setHorizontalHeaderLabels(
      {tr("Luminaire"), unitOf(Dimension::illuminance), QStringLiteral("%")});
  shares_->setRowCount(static_cast<int>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int row = static_cast<int>(k);
    const double own = lux[order[k]];
    const bool lamp = order[k] < frame_->names.size();
    setText(*shares_, row, 0, lamp ? toQt(frame_->names[order[k]]) : tr("Light from outside"));
    setText(*shares_, row, 1, formatReading(own, Dimension::illuminance));
    setText(*shares_, row, 2, QString::number(100.0 * own / sum, 'f', 1));
  }
}

void ProbesPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) refresh();
}

}  // namespace soffit::ui
