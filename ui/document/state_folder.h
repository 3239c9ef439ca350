// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

/// Where the program keeps what is neither settings nor cache: unsaved work.
namespace soffit::ui {

/// A folder of the user's state, made if need be: $XDG_STATE_HOME/soffit/NAME, by default below
/// ~/.local/state.
QString stateFolder(const QString& name);

/// The file of a new project that has no place yet: in a folder of its own below the state folder,
/// with nothing in it but the project. Empty where it cannot be written.
QString makeUntitledProject(const QString& name);

/// Removes the folder that makeUntitledProject() made; other files are left alone.
void removeUntitledProject(const QString& path);

/// Whether a project is one that makeUntitledProject() made.
bool isUntitledProject(const QString& path);

}  // namespace soffit::ui
