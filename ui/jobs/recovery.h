// SPDX-License-Identifier: MIT
#pragma once

#include <QDateTime>
#include <QImage>
#include <QList>
#include <QString>

/// Versions of projects that a run of the program kept and did not live to save.
namespace soffit::ui {

/// One kept version: NAME.soffit is its text, NAME.json says of what, NAME.png shows it, NAME.lock
/// is held while its program runs.
struct Recovery {
  QString id;        ///< of the files in the folder
  QString path;      ///< the project that it is a version of
  QString name;      ///< of the project
  QDateTime saved;   ///< when it was kept
  QImage thumbnail;  ///< may be null
};

/// The folder, and the files of a version in it: "soffit", "json", "png", "lock".
QString recoveryFolder();
QString recoveryFile(const QString& id, const QString& ending);

/// The versions whose program runs no longer, the newest first.
QList<Recovery> findRecoveries();

/// The text of a version; empty when it cannot be read.
QByteArray recoveredText(const QString& id);

/// Removes a version.
void discardRecovery(const QString& id);

}  // namespace soffit::ui
