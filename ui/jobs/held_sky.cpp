// SPDX-License-Identifier: MIT
#include "ui/jobs/held_sky.h"

namespace soffit::ui {

void HeldSkies::prepare(const relight::SkyParts& parts, const transfer::Operators& operators,
                        const Job& job) {
  if (fits(parts)) return;
  forget();
  vectors_ = relight::SkyVectors::make(parts.transfer, operators, job);
}

}  // namespace soffit::ui
