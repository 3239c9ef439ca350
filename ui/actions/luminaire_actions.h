// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

/// What the Edit and Luminaire menus do to the selection. What changes the scene is one undo step;
/// nothing happens without a selection.
namespace soffit::ui {

/// Copies beside the originals; the copies are selected.
void duplicateSelection(Document& document);
void deleteSelection(Document& document);
void copySelection(const Document& document);
void cutSelection(Document& document);
/// Pastes what was copied, in its place when that is free, else beside it; it is selected. Nothing
/// happens when the clipboard holds no luminaires.
/// Errors: a file that they need is not in the project's folder (they come from another project).
Result<void> paste(Document& document);
/// On when any is off, else off.
void toggleSelection(Document& document);
void dimSelection(Document& document, double dimming);
void selectAll(Document& document);
/// Puts the selection out of sight, or everything else, or nothing.
void hideSelection(Document& document);
void hideOthers(Document& document);
void showHidden(Document& document);

}  // namespace soffit::ui
