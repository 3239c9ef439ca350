// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/luminaire.h"

#include <vector>

namespace soffit::ui {

/// Puts luminaires on the clipboard, whole, for this program; their names as text for others.
void copyLuminaires(std::vector<light::Luminaire> luminaires);

/// What copyLuminaires() put there last; empty when something else was copied since.
std::vector<light::Luminaire> copiedLuminaires();

}  // namespace soffit::ui
