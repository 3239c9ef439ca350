// SPDX-License-Identifier: MIT
#include "ui/panels/lights_model.h"

#include "core/scene/equality.h"
#include "ui/document/text.h"
#include "ui/panels/luminaire_text.h"
#include "ui/widgets/quantity.h"
#include "ui/widgets/value_change.h"

#include <algorithm>
#include <functional>

namespace soffit::ui {

void LightsModel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  if (document_ != nullptr)
    connect(document_, &Document::sceneChanged, this, &LightsModel::refresh);
  refresh();
}

void LightsModel::refresh() {
  static const std::vector<light::Luminaire> kNone;
  const auto& now = document_ == nullptr ? kNone : document_->luminaires();
  const bool same_rows =
      std::ranges::equal(rows_, now, {}, &light::Luminaire::name, &light::Luminaire::name);
  if (!same_rows) beginResetModel();
  std::vector<double> flux(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    // A drag changes one row many times a second: only that is computed and told.
    const bool same = same_rows && scene::same(rows_[i], now[i]);
    flux[i] = same ? flux_[i] : fluxOf(now[i]);
    if (!same_rows || same) continue;
    rows_[i] = now[i];
    flux_[i] = flux[i];
    Q_EMIT dataChanged(index(static_cast<int>(i), 0), index(static_cast<int>(i), kColumns - 1));
  }
  flux_ = std::move(flux);
  if (same_rows) return;
  rows_ = now;
  endResetModel();
}

int LightsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int LightsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(kColumns);
}

QString LightsModel::nameAt(int row) const {
  return toQt(rows_[static_cast<std::size_t>(row)].name);
}

int LightsModel::rowOf(const QString& name) const {
  const auto found = std::ranges::find(rows_, toStd(name), &light::Luminaire::name);
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

QString LightsModel::textOf(int row, int column) const {
  const light::Luminaire& luminaire = rows_[static_cast<std::size_t>(row)];
  switch (column) {
    case kName:
      return toQt(luminaire.name);
    case kDimming:
      return formatQuantity(luminaire.dimming, Dimension::share, 0);
    case kFlux:
      return formatQuantity(flux_[static_cast<std::size_t>(row)], Dimension::flux, 0);
    case kColour:
      return describeColour(luminaire.colour);
    case kX:
    case kY:
    case kZ:
      return formatQuantity(luminaire.position[column - kX], Dimension::length, 3);
    default:
      return toQt(luminaire.group);
  }
}

QVariant LightsModel::sortKeyOf(int row, int column) const {
  const light::Luminaire& luminaire = rows_[static_cast<std::size_t>(row)];
  switch (column) {
    case kDimming:
      return luminaire.on ? luminaire.dimming : -1.0;
    case kFlux:
      return flux_[static_cast<std::size_t>(row)];
    case kColour:
      return luminaire.colour.cct_k.value_or(0.0);
    case kX:
    case kY:
    case kZ:
      return luminaire.position[column - kX];
    default:
      return textOf(row, column);
  }
}

QVariant LightsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const light::Luminaire& luminaire = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return textOf(index.row(), index.column());
    case Qt::UserRole:
      return sortKeyOf(index.row(), index.column());
    case Qt::CheckStateRole:
      if (index.column() == kName) return luminaire.on ? Qt::Checked : Qt::Unchecked;
      return {};
    case Qt::DecorationRole:
      if (index.column() == kColour) return swatchOf(luminaire.colour);
      return {};
    case Qt::TextAlignmentRole:
      return index.column() == kName || index.column() == kColour || index.column() == kGroup
                 ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                 : QVariant(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ToolTipRole:
      return QStringLiteral("%1\n%2\n%3")
          .arg(toQt(luminaire.name), describeShape(luminaire.shape),
               describeDistribution(luminaire.distribution));
    default:
      return {};
  }
}

QVariant LightsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kName:
      return tr("Luminaire");
    case kDimming:
      return tr("Dim");
    case kFlux:
      return tr("Flux");
    case kColour:
      return tr("Colour");
    case kX:
      return QStringLiteral("x");
    case kY:
      return QStringLiteral("y");
    case kZ:
      return QStringLiteral("z");
    default:
      return tr("Group");
  }
}

Qt::ItemFlags LightsModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable;
  return index.column() == kName ? flags | Qt::ItemIsUserCheckable : flags;
}

QStringList LightsModel::targetsOf(const QModelIndex& index) const {
  const QString name = nameAt(index.row());
  return document_->selection().contains(name) ? document_->selection() : QStringList{name};
}

void LightsModel::rename(const QString& from, const QString& to) {
  const QString name = to.trimmed();
  if (name == from) return;
  auto renamed = scene::withLuminaireRenamed(*document_->scene(), toStd(from), toStd(name));
  if (!renamed) return;  // the old name comes back
  document_->edit(tr("Rename to %1").arg(name), std::move(*renamed));
  document_->setSelection({name});
}

void LightsModel::change(int column, const QString& text, const QStringList& names) {
  const auto by = [&](const QString& step, Dimension dimension, double least, const auto& apply) {
    const auto changed = parseChange(text, dimension, least);
    if (!changed) return;
    document_->editLuminaires(step, names, [&](light::Luminaire& l) { apply(l, *changed); });
  };
  using Change = std::function<double(double)>;
  switch (column) {
    case kDimming:
      by(tr("Dim"), Dimension::share, 0.0,
         [](light::Luminaire& l, const Change& f) { l.dimming = f(l.dimming); });
      break;
    case kFlux:
      by(tr("Change flux"), Dimension::flux, 0.0,
         [](light::Luminaire& l, const Change& f) { l.flux = f(fluxOf(l)); });
      break;
    case kColour:
      by(tr("Change colour temperature"), Dimension::temperature, 1000.0,
         [](light::Luminaire& l, const Change& f) {
           l.colour.cct_k = f(l.colour.cct_k.value_or(4000.0));
         });
      break;
    case kX:
    case kY:
    case kZ:
      by(tr("Move"), Dimension::length, -1e7, [column](light::Luminaire& l, const Change& f) {
        l.position[column - kX] = f(l.position[column - kX]);
      });
      break;
    case kGroup:
      document_->editLuminaires(tr("Change group"), names,
                                [&](light::Luminaire& l) { l.group = toStd(text.trimmed()); });
      break;
    default:
      break;
  }
}

bool LightsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (document_ == nullptr || !index.isValid()) return false;
  if (role == Qt::CheckStateRole) {
    const bool on = value.toInt() == Qt::Checked;
    document_->editLuminaires(on ? tr("Switch on") : tr("Switch off"), targetsOf(index),
                              [on](light::Luminaire& l) { l.on = on; });
  } else if (index.column() == kName) {
    rename(nameAt(index.row()), value.toString());
  } else if (value.toString() != textOf(index.row(), index.column())) {
    change(index.column(), value.toString(), targetsOf(index));
  }
  return true;
}

}  // namespace soffit::ui
