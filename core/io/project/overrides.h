// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/project/json.h"
#include "core/io/project/report.h"

#include <string>
#include <string_view>
#include <vector>

/// A layout and `--set` applied to the document itself, so that what they bring is read and
/// checked by the same code as the file (internal to io_project).
namespace soffit::io {

/// Puts a layout's luminaires over the base's, field by field, appends those that the base lacks,
/// and leaves of `layouts` just this one's name. Errors: no layout of that name.
Result<void> applyLayout(Json& root, std::string_view layout, const std::string& file);

/// Applies one "KEY=VALUE". The path is marked in `report`, so that a field that does not exist
/// is an error. Errors: no "=", a path that leads nowhere.
///
/// return the material's name when KEY is one of a material that the document does not mention:
/// the caller checks that the geometry has it.
Result<std::string> applySet(Json& root, std::string_view set, Report& report);

/// The value of a --set: a number, numbers with commas, true, false, null, JSON, else text.
Result<Json> parseSetValue(std::string_view text);

}  // namespace soffit::io
