// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// The characters of photometric files: decades of DOS, Windows and Unix programs wrote them.
namespace soffit::io {

/// Without the bytes in front that some editors add (UTF-8's byte order mark).
std::string_view withoutBom(std::string_view text);

/// An error if the text is empty, or UTF-16, which none of the formats allows. `kind` is "an IES
/// file", say.
Result<void> checkReadable(std::string_view text, const std::string& name, std::string_view kind);

/// Without blanks, tabs, NULs and other control characters at both ends.
std::string_view trimmed(std::string_view text);

/// ASCII capitals.
std::string upper(std::string_view text);

/// The text if it is UTF-8, else each byte read as Latin-1. Control characters become blanks.
std::string toUtf8(std::string_view text);

/// A token for an error message: in quotes, at most 24 characters, what is not printable ASCII as
/// '?'; "an empty line" and the like are the caller's business.
std::string shown(std::string_view token);

/// The whole token as a number, the locale notwithstanding; +1, .5, 1e3 are numbers, and so are
/// "nan" and "inf" (check for finite!); too small is 0, too large is infinite. Nothing if it is
/// not a number from end to end.
std::optional<double> parseNumber(std::string_view token);

/// 1-based line of an offset. A line ends with LF, CR or CR LF.
int lineAt(std::string_view text, std::size_t offset);

/// "name:line".
std::string placeAt(const std::string& name, int line);

/// Goes through a text line by line without copying it. CR, LF, CR LF and CR CR LF (a text file
/// sent twice through a DOS translation) end a line.
class LineCursor {
 public:
  explicit LineCursor(std::string_view text) : text_(text) {}

  [[nodiscard]] bool atEnd() const { return offset_ >= text_.size(); }
  /// The next line without its end; empty at the end of the text.
  std::string_view next();
  /// Number of the line that next() gave last; 0 before the first.
  [[nodiscard]] int line() const { return line_; }
  /// Where the following line starts.
  [[nodiscard]] std::size_t offset() const { return offset_; }

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  int line_ = 0;
};

}  // namespace soffit::io
