// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <string_view>

namespace soffit::ui {

/// What core says in few words (a stage of its work, a need of a scene) in the window's language;
/// unknown words stay as they are.
QString coreWords(std::string_view text);

}  // namespace soffit::ui
