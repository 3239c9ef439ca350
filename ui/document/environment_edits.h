// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

#include <optional>

/// What the user changes of a building's surroundings, as values.
namespace soffit::ui {

/// The 16 standard skies in words, in order.
QStringList skyNames();

/// Which kind of light shines in, as the panel lists them.
enum class OutsideKind { none, sky, picture, analytic };
OutsideKind kindOf(const std::optional<scene::Environment>& environment);

/// How a picture with these sides is most likely laid out: 2 : 1, 1 : 1, or a cross.
scene::ProbeLayout likelyLayout(const scene::Image& image);

/// Other surroundings as one undo step; consecutive ones with one merge_key are one.
void editEnvironment(Document& document, const QString& text,
                     std::optional<scene::Environment> environment, int merge_key = -1);
/// The same without an undo step, while a slider moves: Document::commitPreview() ends it.
void previewEnvironment(Document& document, std::optional<scene::Environment> environment);

}  // namespace soffit::ui
