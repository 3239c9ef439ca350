// SPDX-License-Identifier: MIT
#include "core/io/model/reading_error.h"

namespace soffit::io {

Error readingError(ChildEnd end, const std::filesystem::path& file) {
  const std::string place = file.string();
  const char* hint = "Export the model again, or to another format such as glTF or OBJ";
  switch (end) {
    case ChildEnd::kCancelled:
      return {place, "the import was cancelled", {}};
    case ChildEnd::kTimedOut:
      return {place, "is damaged or too large: reading it did not come to an end", hint};
    case ChildEnd::kFailed:
      return {place, "no process could be started to read it",
              "Close other programs and try again"};
    case ChildEnd::kCrashed:
    case ChildEnd::kDone:
      break;
  }
  return {place, "is damaged: its reader failed", hint};
}

}  // namespace soffit::io
