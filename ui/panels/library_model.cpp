// SPDX-License-Identifier: MIT
#include "ui/panels/library_model.h"

#include "core/light/emitter.h"
#include "ui/document/luminaire_type_mime.h"
#include "ui/document/text.h"
#include "ui/panels/luminaire_text.h"
#include "ui/widgets/polar_diagram.h"

#include <QDir>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

constexpr int kThumbnail = 44;
constexpr double kAngleStepDeg = 3.0;
const QColor kCurve(232, 148, 40);
const QColor kGrid(128, 128, 132, 120);

/// Candela of the whole luminaire toward an angle from straight down in the plane through C.
double intensity(const light::Emitter& emitter, const light::Luminaire& luminaire, double c_deg,
                 double angle_deg) {
  const auto& table = luminaire.distribution.table;
  if (table != nullptr) {
    const double c = angle_deg < 0.0 ? c_deg + 180.0 : c_deg;
    return table->intensityAt(c, std::abs(angle_deg));
  }
  const double gamma = radians(std::abs(angle_deg));
  switch (emitter.kind) {
    case light::EmitterKind::sphere:
      return 1.0;
    case light::EmitterKind::tube:
      // Across its axis the same all round, along it like the sine from the axis.
      return c_deg == 0.0 ? std::abs(std::cos(gamma)) : 1.0;
    default:
      return std::max(std::cos(gamma), 0.0);
  }
}

PolarCurve curveOf(const light::Emitter& emitter, const light::Luminaire& luminaire, double c_deg) {
  PolarCurve curve;
  for (int i = 0; kAngleStepDeg * i <= 360.0; ++i) {
    const double a = kAngleStepDeg * i - 180.0;
    curve.points.push_back({a, intensity(emitter, luminaire, c_deg, a)});
  }
  return curve;
}

QString factsOf(const LibraryEntry& entry) {
  QStringList facts{QStringLiteral("%1 lm").arg(std::lround(entry.lumens))};
  if (entry.beam_deg > 0.0)
    facts.append(QStringLiteral("%1\u00b0").arg(std::lround(entry.beam_deg)));
  if (entry.watts > 0.0) facts.append(QStringLiteral("%1 W").arg(entry.watts, 0, 'g', 3));
  return facts.join(QStringLiteral(" \u00b7 "));
}

}  // namespace

QImage thumbnailOf(const LuminaireType& type, int pixels) {
  const auto emitter = light::makeEmitter(type.prototype);
  if (!emitter) return {};
  return polarDiagram(curveOf(*emitter, type.prototype, 0.0),
                      curveOf(*emitter, type.prototype, 90.0), pixels, kCurve, kGrid);
}

LibraryModel::LibraryModel(QObject* parent) : QAbstractListModel(parent) {
  for (LuminaireType& type : builtInTypes()) {
    rows_.push_back({std::move(type), {}, {}, {}});
  }
  built_in_ = rows_.size();
}

void LibraryModel::add(std::vector<LibraryEntry> entries) {
  if (entries.empty()) return;
  const int first = static_cast<int>(rows_.size());
  beginInsertRows({}, first, first + static_cast<int>(entries.size()) - 1);
  for (LibraryEntry& entry : entries) {
    QString facts = factsOf(entry);
    rows_.push_back({std::move(entry.type), std::move(facts), std::move(entry.path), {}});
  }
  endInsertRows();
}

void LibraryModel::dropUserTypes() {
  if (rows_.size() == built_in_) return;
  beginResetModel();
  rows_.resize(built_in_);
  endResetModel();
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

const QIcon& LibraryModel::iconOf(const Row& row) const {
  // Made when it is first seen: a folder may hold thousands.
  if (row.icon.isNull()) {
    QImage image = thumbnailOf(row.type, 2 * kThumbnail);
    image.setDevicePixelRatio(2.0);
    const QPixmap pixmap = QPixmap::fromImage(image);
    row.icon.addPixmap(pixmap);
    row.icon.addPixmap(pixmap, QIcon::Selected);  // else tinted with the accent, curve and all
  }
  return row.icon;
}

QString LibraryModel::textOf(const Row& row) {
  // Built-in kinds say their lengths in the units that are shown now.
  const QString facts = row.path.isEmpty() ? describeType(row.type) : row.facts;
  return row.type.name + QLatin1Char('\n') + facts;
}

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return textOf(row);
    case Qt::DecorationRole:
      return iconOf(row);
    case Qt::ToolTipRole:
      return row.path.isEmpty() ? textOf(row) : QDir::toNativeSeparators(row.path);
    default:
      return {};
  }
}

Qt::ItemFlags LibraryModel::flags(const QModelIndex& index) const {
  return QAbstractListModel::flags(index) | Qt::ItemIsDragEnabled;
}

QStringList LibraryModel::mimeTypes() const {
  return {QString::fromLatin1(kLuminaireTypeFormat)};
}

QMimeData* LibraryModel::mimeData(const QModelIndexList& indexes) const {
  return indexes.isEmpty() ? nullptr : new LuminaireTypeMime(type(indexes.front().row()));
}

}  // namespace soffit::ui
