// SPDX-License-Identifier: MIT
#include "ui/widgets/table_text.h"

#include <QSet>
#include <QStringList>

namespace soffit::ui {
namespace {

QString field(QString text) {
  text.replace(QLatin1Char('\t'), QLatin1Char(' '));
  text.replace(QLatin1Char('\n'), QLatin1Char(' '));
  text.replace(QChar::Nbsp, QLatin1Char(' '));
  return text;
}

}  // namespace

QString tableText(const QAbstractItemModel& model, const QModelIndexList& selected) {
  QSet<int> rows;
  for (const QModelIndex& index : selected) rows.insert(index.row());
  QStringList fields;
  for (int c = 0; c < model.columnCount(); ++c) {
    fields.append(field(model.headerData(c, Qt::Horizontal, Qt::DisplayRole).toString()));
  }
  QString text = fields.join(QLatin1Char('\t')) + QLatin1Char('\n');
  for (int r = 0; r < model.rowCount(); ++r) {
    if (!rows.isEmpty() && !rows.contains(r)) continue;
    fields.clear();
    for (int c = 0; c < model.columnCount(); ++c) {
      fields.append(field(model.index(r, c).data().toString()));
    }
    text += fields.join(QLatin1Char('\t')) + QLatin1Char('\n');
  }
  return text;
}

}  // namespace soffit::ui
