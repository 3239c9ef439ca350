// SPDX-License-Identifier: MIT
#pragma once

#include "ui/widgets/quantity.h"

#include <functional>
#include <optional>

namespace soffit::ui {

/// What a text makes of a value: `1200 lm` sets it; `+=50`, `-=5 %` and `*=1.2` change it, each
/// from its own. Nothing for what cannot be read. The result is at least `least`.
std::optional<std::function<double(double)>> parseChange(QStringView text, Dimension dimension,
                                                         double least);

}  // namespace soffit::ui
