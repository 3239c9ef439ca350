// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractItemModel>
#include <QModelIndexList>
#include <QString>

namespace soffit::ui {

/// A table as text that a spreadsheet takes: tabs between columns, a line per row, the headings
/// first. rows: those with a selected cell, in order; empty: all.
QString tableText(const QAbstractItemModel& model, const QModelIndexList& selected = {});

}  // namespace soffit::ui
