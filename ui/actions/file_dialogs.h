// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

#include <QString>

class QWidget;

/// The dialogs of the File menu. Each returns an empty path, or false, when it was cancelled.
namespace soffit::ui {

QString askProjectToOpen(QWidget* parent);
QString askModelToImport(QWidget* parent);

/// Saves to the document's own file, or asks for a place; a new project has none yet. At another
/// place the project takes all files with it that it names.
bool save(QWidget* parent, Document& document);
bool saveAs(QWidget* parent, Document& document);
/// The same without asking for the place.
bool saveAs(QWidget* parent, Document& document, const QString& path);

/// Asks what becomes of unsaved changes, and saves them if that is wished. False: stay.
bool mayClose(QWidget* parent, Document& document);

void showError(QWidget* parent, const QString& title, const QString& message);

}  // namespace soffit::ui
