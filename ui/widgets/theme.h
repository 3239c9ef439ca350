// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

/// The application's dress: a neutral palette that leaves the colours to the picture.
namespace soffit::ui {

enum class Theme { system, dark, light };

/// The theme of the user's settings, the system's when there is none.
Theme savedTheme();
void saveTheme(Theme theme);
/// Whether the desktop looks dark.
bool systemIsDark();
/// Dresses the whole application.
void applyTheme(Theme theme);

}  // namespace soffit::ui
