// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/model/model_format.h"
#include "core/io/model/model_import.h"
#include "core/io/model/model_payload.h"

namespace soffit::io {

/// Reads a model file in this process, all of importModel() but cleaning. May crash on damaged
/// files; options are valid and options.folder is set. Starts no threads.
Result<ModelPayload> readModel(const std::filesystem::path& file, ModelFormat format,
                               const ImportOptions& options, const Job& job);

}  // namespace soffit::io
