// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

/// What the Luminaire menu does to the selection. Each is one undo step; nothing happens without
/// a selection.
namespace soffit::ui {

/// Copies beside the originals; the copies are selected.
void duplicateSelection(Document& document);
void deleteSelection(Document& document);
/// On when any is off, else off.
void toggleSelection(Document& document);
void selectAll(Document& document);

}  // namespace soffit::ui
