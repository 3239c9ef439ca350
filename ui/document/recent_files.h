// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

/// The projects opened last, kept in the user's settings.
namespace soffit::ui {

/// The newest first; files that are gone are left out.
QStringList recentFiles();

/// Puts a file in front.
void rememberFile(const QString& path);

/// The samples that came with the program: their project files, in the order they are shown.
QStringList sampleProjects();

}  // namespace soffit::ui
