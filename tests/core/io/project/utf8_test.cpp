// SPDX-License-Identifier: MIT
#include "core/io/project/utf8.h"

#include <gtest/gtest.h>

namespace soffit::io {
namespace {

TEST(Utf8SequenceLength, FollowsRfc3629) {
  EXPECT_EQ(utf8SequenceLength("a"), 1U);
  EXPECT_EQ(utf8SequenceLength("\xC3\xA4"), 2U);
  EXPECT_EQ(utf8SequenceLength("\xE2\x82\xAC"), 3U);
  EXPECT_EQ(utf8SequenceLength("\xF0\x9F\x92\xA1"), 4U);
  for (const char* wrong :
       {"\x80", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
        "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xC3", "\xC3z", ""}) {
    EXPECT_EQ(utf8SequenceLength(wrong), 0U) << wrong;
  }
}

TEST(Utf8FromUnknown, ReadsOtherBytesAsLatin1) {
  EXPECT_EQ(utf8FromUnknown("T\xC3\xBCr"), "T\xC3\xBCr");
  EXPECT_EQ(utf8FromUnknown("T\xFCr"), "T\xC3\xBCr");
  EXPECT_EQ(utf8FromUnknown(""), "");
}

}  // namespace
}  // namespace soffit::io
