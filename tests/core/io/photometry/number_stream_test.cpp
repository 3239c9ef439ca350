// SPDX-License-Identifier: MIT
#include "core/io/photometry/number_stream.h"

#include <gmock/gmock.h>

#include <limits>

namespace soffit::io {
namespace {

using ::testing::ElementsAre;

TEST(NumberStream, WrappingAndSeparatorsDoNotMatter) {
  const std::string text(
      "1, 2,3\t4\r\n5\r6\n\n7 ,8\0"
      "9\x1a",
      22);
  NumberStream in(text, 0, "f");
  EXPECT_THAT(in.numbers(9, "numbers").value(), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
  EXPECT_EQ(in.remaining(), 0u);
}

TEST(NumberStream, DecimalCommasAreAChoice) {
  NumberStream in("1,5 2.5\n3", 0, "f", Comma::decimal);
  EXPECT_THAT(in.numbers(3, "numbers").value(), ElementsAre(1.5, 2.5, 3));
  NumberStream wrong("1,5,2", 0, "f", Comma::decimal);
  EXPECT_FALSE(wrong.number("a number").ok());
}

TEST(NumberStream, ErrorsSayTheLineAndWhatWasThere) {
  NumberStream in("1\n2 x\n", 0, "f.ies");
  EXPECT_EQ(in.numbers(4, "angles").error().message(),
            "f.ies:2: expected 4 angles, found 'x' after 2 of them. The file is damaged or no "
            "photometric file. Download it again.");
  NumberStream shorter("1\n2\n\n", 0, "f.ies");
  EXPECT_EQ(shorter.numbers(4, "angles").error().message(),
            "f.ies:2: expected 4 angles, found 2. The file ends too early. Download it again.");
  NumberStream end("\n", 0, "f.ies");
  EXPECT_EQ(end.number("the watts").error().message(),
            "f.ies:1: expected the watts, found the end of the file. The file ends too early. "
            "Download it again.");
}

TEST(NumberStream, NotFiniteIsNotANumber) {
  for (const char* text : {"nan", "inf", "-inf", "1e999"}) {
    NumberStream in(text, 0, "f");
    EXPECT_FALSE(in.number("a number").ok()) << text;
    NumberStream list(text, 0, "f");
    EXPECT_FALSE(list.numbers(1, "numbers").ok()) << text;
  }
}

TEST(NumberStream, CountsAreWholeAndBounded) {
  for (const char* text : {"0", "1.5", "11", "-3", "1e9"}) {
    NumberStream in(text, 0, "f");
    const auto count = in.whole("the count", 1, 10);
    ASSERT_FALSE(count.ok()) << text;
    EXPECT_THAT(count.error().what, ::testing::StartsWith("expected the count (1 to 10), found"));
  }
  NumberStream in("7.0", 0, "f");
  EXPECT_EQ(in.whole("the count", 1, 10).value(), 7);
}

TEST(NumberStream, AnglesMustAscend) {
  NumberStream in("0\n10\n5", 0, "f");
  EXPECT_EQ(in.ascending(3, "angles").error().message(),
            "f:3: expected ascending angles, found 5 after 10. The angles are damaged, or a number "
            "before them is missing or too much.");
  NumberStream equal("0 10 10", 0, "f");
  EXPECT_FALSE(equal.ascending(3, "angles").ok());
  NumberStream close("0 1e-320 10", 0, "f");
  EXPECT_FALSE(close.ascending(3, "angles").ok());
}

TEST(NumberStream, AClaimOfABillionTakesNoMemoryForIt) {
  NumberStream in("1 2 3", 0, "f");
  const auto r = in.numbers(std::numeric_limits<std::size_t>::max() / 16, "numbers");
  EXPECT_FALSE(r.ok());  // reserving that much would have thrown
}

}  // namespace
}  // namespace soffit::io
