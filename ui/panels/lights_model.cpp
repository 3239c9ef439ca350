// SPDX-License-Identifier: MIT
#include "ui/panels/lights_model.h"

#include "core/scene/equality.h"
#include "ui/document/text.h"
#include "ui/panels/luminaire_text.h"
#include "ui/widgets/quantity.h"

#include <algorithm>

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

QString LightsModel::textOf(const light::Luminaire& luminaire, int column) const {
  switch (column) {
    case kName:
      return toQt(luminaire.name);
    case kDimming:
      return formatQuantity(luminaire.dimming, Dimension::share, 0);
    case kFlux: {
      const int row = rowOf(toQt(luminaire.name));
      return formatQuantity(flux_[static_cast<std::size_t>(row)], Dimension::flux, 0);
    }
    case kColour:
      return describeColour(luminaire.colour);
    default:
      return toQt(luminaire.group);
  }
}

QVariant LightsModel::sortKeyOf(const light::Luminaire& luminaire, int column) const {
  switch (column) {
    case kDimming:
      return luminaire.on ? luminaire.dimming : -1.0;
    case kFlux:
      return flux_[static_cast<std::size_t>(rowOf(toQt(luminaire.name)))];
    case kColour:
      return luminaire.colour.cct_k.value_or(0.0);
    default:
      return textOf(luminaire, column);
  }
}

QVariant LightsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const light::Luminaire& luminaire = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return textOf(luminaire, index.column());
    case Qt::UserRole:
      return sortKeyOf(luminaire, index.column());
    case Qt::CheckStateRole:
      if (index.column() == kName) return luminaire.on ? Qt::Checked : Qt::Unchecked;
      return {};
    case Qt::DecorationRole:
      if (index.column() == kColour) return swatchOf(luminaire.colour);
      return {};
    case Qt::TextAlignmentRole:
      return index.column() == kDimming || index.column() == kFlux
                 ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                 : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
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
    default:
      return tr("Group");
  }
}

Qt::ItemFlags LightsModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
  if (index.column() == kName) return flags | Qt::ItemIsUserCheckable;
  return flags | Qt::ItemIsEditable;
}

bool LightsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (document_ == nullptr || !index.isValid()) return false;
  const QStringList names{nameAt(index.row())};
  if (role == Qt::CheckStateRole) {
    const bool on = value.toInt() == Qt::Checked;
    document_->editLuminaires(on ? tr("Switch on") : tr("Switch off"), names,
                              [on](light::Luminaire& l) { l.on = on; });
    return true;
  }
  const QString text = value.toString();
  const auto number = [&](Dimension dimension, double least) -> std::optional<double> {
    const auto read = parseQuantity(text, dimension);
    return read && *read >= least ? read : std::nullopt;
  };
  switch (index.column()) {
    case kDimming:
      if (const auto v = number(Dimension::share, 0.0)) {
        document_->editLuminaires(tr("Dim"), names, [v](light::Luminaire& l) { l.dimming = *v; });
      }
      return true;
    case kFlux:
      if (const auto v = number(Dimension::flux, 0.0)) {
        document_->editLuminaires(tr("Change flux"), names,
                                  [v](light::Luminaire& l) { l.flux = v; });
      }
      return true;
    case kColour:
      if (const auto v = number(Dimension::temperature, 1000.0)) {
        document_->editLuminaires(tr("Change colour temperature"), names,
                                  [v](light::Luminaire& l) { l.colour.cct_k = v; });
      }
      return true;
    case kGroup:
      document_->editLuminaires(tr("Change group"), names,
                                [&](light::Luminaire& l) { l.group = toStd(text); });
      return true;
    default:
      return false;
  }
}

}  // namespace soffit::ui
