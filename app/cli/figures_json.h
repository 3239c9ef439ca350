// SPDX-License-Identifier: MIT
#pragma once

#include "core/design/error_figures.h"
#include "core/io/project/json.h"

namespace soffit::cli {

/// receivers, mean_lux, rms, p95, bias, reference_stderr, seconds (of the whole call) and, beside
/// them, rms_raw (noise not subtracted), rms_stderr and bias_stderr.
inline io::Json figuresJson(const design::ErrorFigures& f, double seconds) {
  return io::Json::object({{"receivers", f.receivers},
                           {"mean_lux", f.mean_lux},
                           {"rms", f.rms},
                           {"p95", f.p95},
                           {"bias", f.bias},
                           {"reference_stderr", f.reference_stderr},
                           {"seconds", seconds},
                           {"rms_raw", f.rms_raw},
                           {"rms_stderr", f.rms_stderr},
                           {"bias_stderr", f.bias_stderr}});
}

}  // namespace soffit::cli
