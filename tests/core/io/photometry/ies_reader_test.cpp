// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_reader.h"

#include "tests/core/io/photometry/ies_text.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

namespace soffit::io {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kRoundoff = 1e4 * std::numeric_limits<double>::epsilon();
constexpr double kBaseLumens = 20.0 * kPi;  // 10 cd over a hemisphere

PhotometricFile read(const IesText& text) {
  auto file = text.parse();
  EXPECT_TRUE(file.ok()) << file.error().message();
  return file.ok() ? *file : PhotometricFile{};
}

TEST(IesReader, APlainFile) {
  const PhotometricFile file = read({});
  EXPECT_EQ(file.format, "IES LM-63-2002");
  EXPECT_EQ(file.n_vertical, 3);
  EXPECT_EQ(file.n_horizontal, 1);
  EXPECT_EQ(file.symmetry, "axial");
  EXPECT_EQ(file.distribution.name, "Test");
  EXPECT_EQ(file.watts, 5.0);
  EXPECT_NEAR(file.lumens, kBaseLumens, kRoundoff);
  EXPECT_THAT(file.warnings, IsEmpty());
}

TEST(IesReader, DataAreAFreeStream) {
  IesText one_per_line;
  std::string text = one_per_line.str();
  const std::size_t data = text.find("TILT=NONE\n") + 10;
  std::replace(text.begin() + static_cast<std::ptrdiff_t>(data), text.end(), ' ', '\n');
  EXPECT_NEAR(parseIes(text, "f").value().lumens, kBaseLumens, kRoundoff);
  for (char& c : text) c = c == '\n' ? '\r' : c;  // old Macintosh
  EXPECT_NEAR(parseIes(text, "f").value().lumens, kBaseLumens, kRoundoff);
  IesText wild;
  wild.lamps = "1,-1 ,1.0E+00";
  wild.vertical = "0,\t4.5e1\r\n\r\n90.";
  wild.candela = "+10\t1e1,1.E1";
  EXPECT_NEAR(read(wild).lumens, kBaseLumens, kRoundoff);
}

TEST(IesReader, EndsAndBeginningsOfManyPrograms) {
  IesText text;
  for (const std::string& tail :
       {std::string(), std::string("\x1a"), std::string(5, '\0'), std::string("\r\n\r\n"),
        std::string("\nEND OF FILE"), std::string("\n[END] 12")}) {
    text.tail = tail;
    EXPECT_THAT(read(text).warnings, IsEmpty());
  }
  const auto bom = parseIes("\xef\xbb\xbf" + text.str(), "f");
  EXPECT_EQ(bom.value().format, "IES LM-63-2002");
}

TEST(IesReader, ExtraNumbersAreReported) {
  IesText text;
  text.tail = " 1 2 3\n";
  EXPECT_EQ(read(text).warnings.at(0), "3 numbers follow the candela values; ignored");
}

TEST(IesReader, TheMeaningOfTheFactorsFollowsTheEdition) {
  const auto lumens = [](const std::string& head) {
    IesText text;
    text.head = head;
    text.lamps = "2 1000 3";
    text.factors = "0.5 0.25 5";
    return read(text).lumens;
  };
  constexpr double kBoth = 3 * 0.5 * 0.25;
  EXPECT_NEAR(lumens("An old luminaire\n"), kBaseLumens * kBoth, kRoundoff);
  EXPECT_NEAR(lumens("IESNA91\n"), kBaseLumens * kBoth, kRoundoff);
  EXPECT_NEAR(lumens("IESNA:LM-63-1995\n"), kBaseLumens * kBoth, kRoundoff);
  EXPECT_NEAR(lumens("IESNA:LM-63-2002\n"), kBaseLumens * 3 * 0.5, kRoundoff);
  EXPECT_NEAR(lumens("IES:LM-63-2019\n"), kBaseLumens * 3 * 0.5, kRoundoff);
}

TEST(IesReader, TheReservedFieldOf2002IsReportedIfUsedAndIsTheFileTypeIn2019) {
  IesText text;
  text.factors = "1 0.9 5";
  EXPECT_THAT(read(text).warnings.at(0), HasSubstr("LM-63-2002 reserves it as 1"));
  text.head = "IES:LM-63-2019\n";
  text.factors = "1 1.00010 5";
  EXPECT_THAT(read(text).warnings, IsEmpty());
}

TEST(IesReader, CandelaAreForAllLampsAndLumensPerLampScaleNothing) {
  IesText text;
  text.lamps = "4 2500 1";
  const PhotometricFile relative = read(text);
  EXPECT_NEAR(relative.lumens, kBaseLumens, kRoundoff);
  EXPECT_EQ(relative.lamp_lumens, 10000.0);
  EXPECT_FALSE(relative.absolute);
  EXPECT_NEAR(relative.lightOutputRatio().value(), kBaseLumens / 10000.0, kRoundoff);
  const PhotometricFile absolute = read({});
  EXPECT_TRUE(absolute.absolute);
  EXPECT_FALSE(absolute.lamp_lumens);
  EXPECT_FALSE(absolute.lightOutputRatio());
  text.lamps = "1 -2 1";
  EXPECT_EQ(read(text).warnings.at(0), "lumens per lamp are -2; taken as -1, absolute photometry");
}

TEST(IesReader, MoreLightThanTheLampsIsReported) {
  IesText text;
  text.lamps = "1 10 1";
  EXPECT_EQ(read(text).warnings.at(0),
            "the candela integrate to 63 lm, 628.3 % of the 10 lm declared for the lamps; the "
            "candela are used as they stand");
}

TEST(IesReader, OpeningsAreMetresWidthOnC0AndRoundWhenNegative) {
  IesText text;
  text.size = "1 1 2 0.5";
  EXPECT_EQ(read(text).distribution.opening, dvec3(0.3048, 2 * 0.3048, 0.5 * 0.3048));
  text.size = "2 1 2 0.5";
  EXPECT_EQ(read(text).distribution.opening, dvec3(1, 2, 0.5));
  text.size = "2 -0.12 0 0";
  EXPECT_EQ(read(text).distribution.opening, dvec3(-0.12, -0.12, 0));
  text.size = "2 -0.2 -0.2 0.1";
  EXPECT_EQ(read(text).distribution.opening, dvec3(-0.2, -0.2, 0.1));
  EXPECT_EQ(read({}).distribution.opening, dvec3(0.0));
}

TEST(IesReader, PhotometricTypesOneTwoThreeAreCBA) {
  IesText text;
  text.counts = "3 3";
  text.vertical = "-90 0 90";
  text.horizontal = "-90 0 90";
  text.candela = "0 0 0 0 10 0 0 0 0";
  text.type = "2";
  EXPECT_EQ(read(text).symmetry, "type B -90-90 (none)");
  EXPECT_NEAR(read(text).distribution.flux(), read(text).lumens, kRoundoff);
  text.type = "3";
  EXPECT_EQ(read(text).symmetry, "type A -90-90 (none)");
  text.type = "1";
  EXPECT_THAT(text.error(), HasSubstr("the photometric type is another one"));
}

TEST(IesReader, TiltIncludeComesBeforeTheLamps) {
  IesText text;
  text.tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1.0 0.9 0.8\n";
  const PhotometricFile file = read(text);
  EXPECT_NEAR(file.lumens, kBaseLumens, kRoundoff) << "the factors hold for tilted mounting only";
  EXPECT_EQ(file.tilt.value().factors.back(), 0.8);
  EXPECT_EQ(file.warnings.at(0), "TILT factors are for tilted mounting; not applied");
}

TEST(IesReader, SlightlyNegativeCandelaAreNoise) {
  IesText text;
  text.candela = "10 10 -0.001";
  const PhotometricFile file = read(text);
  EXPECT_EQ(file.distribution.candela.back(), 0.0);
  EXPECT_EQ(file.warnings.at(0), "small negative candela (down to -0.001) are set to 0");
}

TEST(IesReader, NamesComeFromTheBestKeywordAndAreUtf8) {
  IesText text;
  text.head =
      "IESNA:LM-63-1995\n[LUMCAT] K7\n[LUMINAIRE] Stra\xdf"
      "enleuchte\n[MORE] II\n";
  EXPECT_EQ(read(text).distribution.name, "Straßenleuchte II");
  text.head = "IESNA:LM-63-1995\n[LUMCAT] K7\n[LUMINAIRE]\n";
  EXPECT_EQ(read(text).distribution.name, "K7");
  text.head = "Just a line\n";
  EXPECT_EQ(read(text).distribution.name, "Just a line");
}

TEST(IesReader, ErrorsAreOneLineWithFileLineExpectedFoundAndHint) {
  IesText text;
  text.candela = "10 10";
  EXPECT_EQ(text.error(),
            "lamp.ies:8: expected 3 candela values (3 vertical x 1 horizontal angles), found 2. "
            "The file ends too early. Download it again.");
  text = {};
  text.candela = "10 ten 10";
  EXPECT_THAT(text.error(), HasSubstr("lamp.ies:8: expected 3 candela values"));
  EXPECT_THAT(text.error(), HasSubstr("found 'ten' after 1 of them"));
  text = {};
  text.vertical = "0 90 45";
  EXPECT_THAT(text.error(),
              HasSubstr("lamp.ies:6: expected ascending vertical angles, found 45 after 90"));
  text = {};
  text.horizontal = "nan";
  EXPECT_THAT(text.error(), HasSubstr("lamp.ies:7: expected 1 horizontal angles, found 'nan'"));
  text = {};
  text.lamps = "1 -1 inf";
  EXPECT_THAT(text.error(), HasSubstr("lamp.ies:4: expected the candela multiplier, found 'inf'"));
}

TEST(IesReader, AbsurdNumbersAreRefused) {
  const auto with = [](std::string IesText::*field, const char* value) {
    IesText text;
    text.*field = value;
    return text.error();
  };
  EXPECT_THAT(with(&IesText::counts, "1000000000 1"),
              HasSubstr("expected the number of vertical angles (2 to 3601), found 1e+09"));
  EXPECT_THAT(with(&IesText::counts, "3 -1"),
              HasSubstr("expected the number of horizontal angles (1 to 3601), found -1"));
  EXPECT_THAT(with(&IesText::counts, "2.5 1"), HasSubstr("(2 to 3601), found 2.5"));
  EXPECT_THAT(with(&IesText::counts, "3000 3000"),
              HasSubstr("expected at most 500000 candela values, found a claim of 3000 x 3000"));
  EXPECT_THAT(with(&IesText::type, "4"), HasSubstr("the photometric type (1 to 3), found 4"));
  EXPECT_THAT(with(&IesText::size, "3 0 0 0"), HasSubstr("the units (1 to 2), found 3"));
  EXPECT_THAT(with(&IesText::factors, "0 1 5"),
              HasSubstr("expected a multiplier and ballast factors above 0, found 1 x 0. Set"));
  EXPECT_THAT(with(&IesText::candela, "0 0 0"),
              HasSubstr("lamp.ies:8: expected some candela above 0, found that all are 0"));
  EXPECT_THAT(with(&IesText::candela, "10\n-10\n10"),
              HasSubstr("lamp.ies:9: expected candela of at least 0, found -10"));
  EXPECT_THAT(with(&IesText::candela, "1 1 1e30"),
              HasSubstr("lamp.ies:8: expected candela below 1e+12, found 1e+30"));
}

}  // namespace
}  // namespace soffit::io
