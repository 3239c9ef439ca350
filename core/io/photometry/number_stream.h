// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace soffit::io {

/// How a stream reads the comma.
enum class Comma {
  separator,  ///< between two numbers (LM-63)
  decimal,    ///< inside a number (EULUMDAT of German, French ... programs)
};

/// A text as a free stream of numbers: blanks, tabs, line ends, NULs and 0x1A separate, however
/// the lines are wrapped. Errors carry the file's name and the line.
class NumberStream {
 public:
  /// `text` is the whole file (for line numbers) and must outlive the stream; reading starts at
  /// `offset`.
  NumberStream(std::string_view text, std::size_t offset, std::string name,
               Comma comma = Comma::separator);

  /// The next number, finite. `what` names it: "expected WHAT, found ...".
  Result<double> number(std::string_view what);
  /// The next number, which must be whole and within min..max.
  Result<int> whole(std::string_view what, int min, int max);
  /// The next `count` numbers: "expected COUNT WHAT, found 12". Takes no memory for numbers that
  /// the text has no room for.
  Result<std::vector<double>> numbers(std::size_t count, std::string_view what);
  /// The same for angles, each of which must be greater than the one before.
  Result<std::vector<double>> ascending(std::size_t count, std::string_view what);
  /// Numbers that are still there before other text or the end.
  std::size_t remaining();

  /// An error at the line of what was read last.
  [[nodiscard]] Error error(std::string what, std::string hint) const;

 private:
  Result<std::vector<double>> read(std::size_t count, std::string_view what, bool ascending);
  std::string_view token();
  [[nodiscard]] std::size_t charactersLeft() const { return text_.size() - offset_; }

  std::string_view text_;
  std::size_t offset_;
  std::size_t token_offset_;
  std::string name_;
  Comma comma_;
};

}  // namespace soffit::io
