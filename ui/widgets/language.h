// SPDX-License-Identifier: MIT
#pragma once

/// The language that the window speaks.
namespace soffit::ui {

enum class Language { system, english, german };

/// The language of the user's settings, the system's when there is none.
Language savedLanguage();
/// Takes effect at the next start: texts that stand in the window stay.
void saveLanguage(Language language);

/// The desktop's first language that the window can speak; English where it can speak none.
Language systemLanguage();

/// Loads the application's and Qt's own texts in a language and writes numbers as it does; before
/// the first widget. Files and figures in them are left alone: C's locale keeps its decimal point.
///
/// Errors: none; where the texts are missing, the window speaks English.
void applyLanguage(Language language);

}  // namespace soffit::ui
