// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/geometry/cleaning.h"
#include "core/io/model/model_import.h"

namespace soffit::io {

/// A model as read, before cleaning: what the reading process hands to the asking one.
struct ModelPayload {
  geometry::RawMesh raw;
  ImportedModel model;  ///< all but mesh and cleaning
};

/// The payload, or why there is none, as bytes for the same program on the same machine.
std::string toBytes(const Result<ModelPayload>& payload);

/// The reverse; absent if the bytes are not whole.
std::optional<Result<ModelPayload>> payloadFromBytes(std::string_view bytes);

}  // namespace soffit::io
