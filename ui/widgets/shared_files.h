// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace soffit::ui {

/// A folder of files that came with the program, such as "help" or "translations": in
/// ../share/soffit as seen from the program, in the build tree as in the install tree.
QString sharedFolder(const QString& name);

}  // namespace soffit::ui
