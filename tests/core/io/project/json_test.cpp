// SPDX-License-Identifier: MIT
#include "core/io/project/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>

namespace soffit::io {
namespace {

std::string errorOf(std::string_view text) {
  const auto json = parseJson(text, "f");
  return json ? std::string() : json.error().message();
}

TEST(ParseJson, KeepsTheOrderOfMembersAndTheSpellingOfNumbers) {
  const std::string text =
      "{\n  \"z\": 1.50,\n  \"a\": 1e3,\n  \"m\": [0.10, -0.0, 12345678901234567890]\n}\n";
  const auto json = parseJson(text, "f");
  ASSERT_TRUE(json);
  EXPECT_EQ(formatJson(*json), text);
}

TEST(ParseJson, AllowsCommentsAndAByteOrderMark) {
  const auto json = parseJson("\xEF\xBB\xBF{ // one\n \"a\": /* two */ 1 }", "f");
  ASSERT_TRUE(json);
  EXPECT_EQ(json->find("a")->asNumber()->value, 1.0);
}

TEST(ParseJson, SyntaxErrorsNameLineAndColumn) {
  EXPECT_TRUE(errorOf("{\n  \"a\": 1,\n  \"b\" 2\n}").starts_with("f:3:7: this is not JSON: "))
      << errorOf("{\n  \"a\": 1,\n  \"b\" 2\n}");
  EXPECT_TRUE(errorOf("").starts_with("f:1:1: this is not JSON: ")) << errorOf("");
  EXPECT_TRUE(errorOf("[1, 2").starts_with("f:1:6: this is not JSON: ")) << errorOf("[1, 2");
  EXPECT_TRUE(errorOf("[NaN]").starts_with("f:1:2: this is not JSON: ")) << errorOf("[NaN]");
  EXPECT_TRUE(errorOf("[1] 2").starts_with("f:1:5: this is not JSON: ")) << errorOf("[1] 2");
  EXPECT_EQ(errorOf("[1] 2").find('\n'), std::string::npos);
}

TEST(ParseJson, RefusesNumbersOutOfRangeAndBrokenText) {
  EXPECT_NE(errorOf("[1e999]").find("1e999"), std::string::npos) << errorOf("[1e999]");
  EXPECT_NE(errorOf("[\"\xff\"]"), "");
  EXPECT_NE(errorOf("[\"\\ud800\"]"), "");
}

TEST(ParseJson, RefusesAKeyThatOccursTwice) {
  EXPECT_EQ(errorOf("{\"a\": {\"b\": 1, \"b\": 2}}"),
            "f: the key \"b\" occurs twice in one object. Keep one of the two.");
}

TEST(ParseJson, RefusesBottomlessNesting) {
  const std::string deep(1'000'000, '[');
  EXPECT_EQ(errorOf(deep),
            "f: more than 64 levels of brackets. This is not a project file; give one.");
}

TEST(FormatJson, DoublesReadBackBitForBit) {
  std::mt19937_64 random(7);
  JsonArray numbers;
  for (const double special : {0.1, 1.0 / 3.0, 1e-308, 5e-324, 1.7976931348623157e308, -0.0}) {
    numbers.emplace_back(special);
  }
  while (numbers.size() < 2000) {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) numbers.emplace_back(value);
  }
  const auto again = parseJson(formatJson(Json(numbers)), "f");
  ASSERT_TRUE(again);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double before = numbers[i].asNumber()->value;
    const double after = (*again->asArray())[i].asNumber()->value;
    EXPECT_EQ(before, after);
    EXPECT_EQ(std::signbit(before), std::signbit(after));
  }
}

TEST(FormatJson, TextSurvivesWhateverItHolds) {
  const std::string text = "quote \" back \\ line\n tab\t bell\a umlaut \xC3\xA4 \xF0\x9F\x92\xA1";
  const auto again = parseJson(formatJson(Json::array({text})), "f");
  ASSERT_TRUE(again);
  EXPECT_EQ(*(*again->asArray())[0].asText(), text);
}

TEST(FormatJson, BytesThatAreNoTextBecomeTheReplacementCharacter) {
  const auto again = parseJson(formatJson(Json::array({std::string("a\xff"
                                                                   "b")})),
                               "f");
  ASSERT_TRUE(again);
  EXPECT_EQ(*(*again->asArray())[0].asText(),
            "a\xEF\xBF\xBD"
            "b");
}

TEST(FormatJson, WhatIsNotFiniteIsNull) {
  EXPECT_EQ(formatJsonLine(Json::array({std::numeric_limits<double>::infinity(), std::nan("")})),
            "[null, null]");
}

TEST(FormatJson, KeepsVectorsOnOneLine) {
  const Json json =
      Json::object({{"a", Json::object({{"b", Json::array({1, 2.5, 3})}})}, {"c", Json::array()}});
  EXPECT_EQ(formatJson(json), "{\n  \"a\": { \"b\": [1, 2.5, 3] },\n  \"c\": []\n}\n");
  EXPECT_EQ(formatJsonLine(json), "{ \"a\": { \"b\": [1, 2.5, 3] }, \"c\": [] }");
}

TEST(Json, EqualityIgnoresTheOrderOfMembersAndTheSpelling) {
  EXPECT_EQ(*parseJson("{\"a\": 1, \"b\": [2.0]}", "f"),
            *parseJson("{\"b\": [2], \"a\": 1.0}", "f"));
  EXPECT_FALSE(*parseJson("{\"a\": 1}", "f") == *parseJson("{\"a\": 1, \"b\": 2}", "f"));
  EXPECT_FALSE(*parseJson("[1]", "f") == *parseJson("[true]", "f"));
}

TEST(Json, DescribesItselfForMessages) {
  EXPECT_EQ(Json().describe(), "null");
  EXPECT_EQ(Json(true).describe(), "true");
  EXPECT_EQ(Json(1.5).describe(), "1.5");
  EXPECT_EQ(Json("a").describe(), "\"a\"");
  EXPECT_EQ(Json::array({1}).describe(), "an array of 1 element");
  EXPECT_EQ(Json::array({1, 2}).describe(), "an array of 2 elements");
  EXPECT_EQ(Json::object().describe(), "an object");
  EXPECT_EQ(Json(std::string(100, 'x')).describe(), "\"" + std::string(40, 'x') + "...\"");
}

}  // namespace
}  // namespace soffit::io
