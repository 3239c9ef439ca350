// SPDX-License-Identifier: MIT
#include "core/io/photometry/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace soffit::io {
namespace {

TEST(Text, NumbersAreParsedFromEndToEnd) {
  EXPECT_EQ(parseNumber("12"), 12.0);
  EXPECT_EQ(parseNumber("+1.5e3"), 1500.0);
  EXPECT_EQ(parseNumber("-.5"), -0.5);
  EXPECT_EQ(parseNumber("7."), 7.0);
  EXPECT_EQ(parseNumber("1E-400"), 0.0);
  EXPECT_TRUE(std::isinf(parseNumber("1e400").value()));
  EXPECT_TRUE(std::isnan(parseNumber("nan").value()));
  for (const char* wrong : {"", "+", "-", "1.2.3", "12cd", "0x10", "+-1", "1,5", "--1"}) {
    EXPECT_FALSE(parseNumber(wrong)) << wrong;
  }
}

TEST(Text, LinesEndWithLfCrOrBoth) {
  const auto split = [](std::string_view text) {
    std::vector<std::string> lines;
    for (LineCursor cursor(text); !cursor.atEnd();) lines.emplace_back(cursor.next());
    return lines;
  };
  const std::vector<std::string> wanted{"a", "", "b"};
  EXPECT_EQ(split("a\n\nb\n"), wanted);
  EXPECT_EQ(split("a\r\n\r\nb"), wanted);
  EXPECT_EQ(split("a\r\rb\r"), wanted);
  EXPECT_EQ(split("a\r\r\n\r\r\nb\r\r\n"), wanted);
  EXPECT_TRUE(split("").empty());
}

TEST(Text, LineNumbersStartAtOne) {
  const std::string_view text = "ab\r\ncd\nef\rgh";
  EXPECT_EQ(lineAt(text, 0), 1);
  EXPECT_EQ(lineAt(text, 2), 1);
  EXPECT_EQ(lineAt(text, 4), 2);
  EXPECT_EQ(lineAt(text, 7), 3);
  EXPECT_EQ(lineAt(text, 11), 4);
  EXPECT_EQ(lineAt(text, 99), 4);
  EXPECT_EQ(lineAt("", 0), 1);
}

TEST(Text, Latin1BecomesUtf8AndUtf8Stays) {
  EXPECT_EQ(toUtf8("Stra\xdf"
                   "e"),
            "Straße");
  EXPECT_EQ(toUtf8("Straße"), "Straße");
  EXPECT_EQ(toUtf8("\xf0\x9f\x92\xa1"), "\xf0\x9f\x92\xa1");
  EXPECT_EQ(toUtf8("a\tb\x01"), "a b ");
  // Overlong and surrogate sequences are no UTF-8; byte by byte they are harmless.
  EXPECT_EQ(toUtf8("\xc0\xaf"), "\xc3\x80\xc2\xaf");
  EXPECT_EQ(toUtf8("\xed\xa0\x80"), "\xc3\xad\xc2\xa0\xc2\x80");
}

TEST(Text, TokensAreQuotedForOneLine) {
  EXPECT_EQ(shown("ab\ncd"), "'ab?cd'");
  EXPECT_EQ(shown(std::string(100, 'x')), "'" + std::string(24, 'x') + "...'");
}

TEST(Text, BomsAndWideTextAreSeen) {
  EXPECT_EQ(withoutBom("\xef\xbb\xbfIES"), "IES");
  EXPECT_EQ(withoutBom("IES"), "IES");
  EXPECT_TRUE(checkReadable("x", "f", "a file").ok());
  EXPECT_EQ(checkReadable("\xff\xfeI", "f.ies", "an IES file").error().message(),
            "f.ies:1: expected an IES file in ASCII or UTF-8, found UTF-16. Save it again as plain "
            "text (ASCII or UTF-8).");
  EXPECT_EQ(checkReadable(" \r\n\t", "f.ies", "an IES file").error().message(),
            "f.ies:1: expected an IES file, found an empty file. Download it again from the "
            "manufacturer.");
}

}  // namespace
}  // namespace soffit::io
