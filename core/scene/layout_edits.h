// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>

/// Changes to the list of layouts, as values (edits.h adds one).
namespace soffit::scene {

/// Gives a layout another name. Errors: no layout of that name; the new one is empty or taken.
Result<Scene> withLayoutRenamed(const Scene& scene, std::string_view from, std::string_view to);

/// Removes a layout with the luminaires that it alone has. Errors: no layout of that name.
Result<Scene> withoutLayout(const Scene& scene, std::string_view name);

/// Moves a layout to a place in the list, 0 first; places beyond the end are the end.
/// Errors: no layout of that name.
Result<Scene> withLayoutAt(const Scene& scene, std::string_view name, std::size_t place);

/// A name that no layout bears: `stem` without its number, and the next number, "Plan 2".
std::string freeLayoutName(const Scene& scene, std::string_view stem);

}  // namespace soffit::scene
