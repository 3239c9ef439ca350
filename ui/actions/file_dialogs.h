// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

#include <QImage>
#include <QString>

class QWidget;

/// The dialogs of the File menu. Each returns an empty path, or false, when it was cancelled.
namespace soffit::ui {

QString askProjectToOpen(QWidget* parent);

/// Saves to the document's own file, or asks for another name in the project's folder: the files
/// that a project names lie beside it and may not leave that folder.
bool save(QWidget* parent, Document& document);
bool saveAs(QWidget* parent, Document& document);

/// Asks what becomes of unsaved changes, and saves them if that is wished. False: stay.
bool mayClose(QWidget* parent, Document& document);

/// Asks for a file and writes a picture of the view to it (PNG, JPEG or TIFF).
bool exportPicture(QWidget* parent, const Document& document, const QImage& picture);

/// The same without asking. Errors: io::writeImage()'s.
Result<void> writePicture(const QString& path, const Document& document, const QImage& picture);

void showError(QWidget* parent, const QString& title, const QString& message);

}  // namespace soffit::ui
