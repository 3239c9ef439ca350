// SPDX-License-Identifier: MIT
#pragma once

namespace soffit::ui {

/// Runs the application until its window closes: `soffit-gui [PROJECT]`.
/// version: of the program. Returns the exit status.
int runApplication(int argc, char** argv, const char* version);

}  // namespace soffit::ui
