// SPDX-License-Identifier: MIT
#include "core/io/photometry/ldt_reader.h"

#include "tests/core/io/photometry/ldt_text.h"

#include <gmock/gmock.h>

#include <limits>

namespace soffit::io {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kRoundoff = 1e4 * std::numeric_limits<double>::epsilon();
constexpr double kBaseLumens = 20.0 * kPi;

PhotometricFile read(const LdtText& text) {
  auto file = text.parse();
  EXPECT_TRUE(file.ok()) << file.error().message();
  return file.ok() ? *file : PhotometricFile{};
}

/// Values for `planes` stored planes: plane i has i + 1 at its three gamma angles.
std::vector<std::string> ramp(int planes) {
  std::vector<std::string> v;
  for (int i = 0; i < planes; ++i) v.insert(v.end(), 3, std::to_string(i + 1));
  return v;
}

TEST(LdtReader, APlainFile) {
  const PhotometricFile file = read({});
  EXPECT_EQ(file.format, "EULUMDAT");
  EXPECT_EQ(file.n_vertical, 3);
  EXPECT_EQ(file.n_horizontal, 1);
  EXPECT_EQ(file.symmetry, "Isym 1, axial");
  EXPECT_EQ(file.distribution.name, "Lamp");
  EXPECT_EQ(file.keyword("MANUFAC"), "Maker");
  EXPECT_EQ(file.keyword("CRI"), "80");
  EXPECT_NEAR(file.lumens, kBaseLumens, kRoundoff);
  EXPECT_THAT(file.warnings, IsEmpty());
}

TEST(LdtReader, LinesMayEndInAnyWay) {
  for (const char* end : {"\n", "\r", "\r\n", "\r\r\n"}) {
    LdtText text;
    text.end = end;
    EXPECT_NEAR(read(text).lumens, kBaseLumens, kRoundoff);
  }
  std::string bare = LdtText{}.str();
  bare.resize(bare.size() - 2);
  EXPECT_NEAR(parseLdt(bare, "f").value().lumens, kBaseLumens, kRoundoff);
  EXPECT_NEAR(parseLdt("\xef\xbb\xbf" + bare + "\r\n\x1a", "f").value().lumens, kBaseLumens,
              kRoundoff);
}

TEST(LdtReader, DecimalCommas) {
  LdtText text;
  text.set[2] = "1000,0";
  text.head[23] = "1,5";
  text.gamma = {"0,0", "45,5", "90"};
  text.values = {"10,0", "1,0e1", "10."};
  EXPECT_NEAR(read(text).lumens, 1.5 * kBaseLumens, kRoundoff);
}

TEST(LdtReader, ValuesArePerThousandLumensOfTheSetsTotalFluxWhateverTheNumberOfLamps) {
  LdtText text;
  text.set[0] = "4";
  text.set[2] = "8000";
  EXPECT_NEAR(read(text).lumens, 8.0 * kBaseLumens, kRoundoff);
  EXPECT_EQ(read(text).lamp_lumens, 8000.0);
}

TEST(LdtReader, TheFirstOfSeveralLampSetsCounts) {
  LdtText text;
  text.sets[0] = "2";
  text.set.insert(text.set.end(), {"2", "HIT", "5000", "3000", "90", "70"});
  const PhotometricFile file = read(text);
  EXPECT_NEAR(file.lumens, kBaseLumens, kRoundoff);
  EXPECT_EQ(file.watts, 25.0);
  EXPECT_EQ(file.warnings.at(0), "2 lamp sets are given; the first is used");
}

TEST(LdtReader, NegativeLampCountsAreAbsolute) {
  LdtText text;
  text.set[0] = "-1";
  EXPECT_TRUE(read(text).absolute);
  EXPECT_NEAR(read(text).lumens, kBaseLumens, kRoundoff);
  text.set[2] = "0";
  EXPECT_NEAR(read(text).lumens, kBaseLumens, kRoundoff);
  EXPECT_FALSE(read(text).lamp_lumens);
  EXPECT_THAT(read(text).warnings.at(0), HasSubstr("absolute photometry without a flux"));
  text.set[0] = "1";
  EXPECT_EQ(text.error(),
            "lamp.ldt: expected a lamp flux and a factor above 0, found 0 lm x 1. The values are "
            "cd per 1000 lm of the lamps: give their total flux.");
}

TEST(LdtReader, IsymZeroStoresEveryPlane) {
  LdtText text;
  text.planes("0", {"0", "90", "180", "270"});
  text.values = ramp(4);
  const PhotometricFile file = read(text);
  EXPECT_EQ(file.symmetry, "Isym 0, none");
  for (int i = 0; i < 4; ++i) EXPECT_EQ(file.distribution.intensityAt(90.0 * i, 45), i + 1.0);
  text.planes("0", {"0", "90", "180", "270", "360"});
  text.values = ramp(5);
  text.values.back() = text.values[13] = text.values[12] = "1";
  EXPECT_NEAR(read(text).lumens, file.lumens, kRoundoff) << "a closing plane is understood";
}

TEST(LdtReader, IsymOneStoresOnePlaneWhateverTheList) {
  LdtText text;
  text.planes("1", {"0", "0", "0", "0"});
  const PhotometricFile file = read(text);
  EXPECT_EQ(file.n_horizontal, 4);
  EXPECT_NEAR(file.lumens, kBaseLumens, kRoundoff);
}

TEST(LdtReader, IsymTwoStoresC0ToC180) {
  LdtText text;
  text.planes("2", {"0", "90", "180", "270"});
  text.values = ramp(3);
  const PhotometricFile file = read(text);
  EXPECT_EQ(file.symmetry, "Isym 2, bilateral about C0-C180");
  EXPECT_EQ(file.distribution.intensityAt(90, 45), 2.0);
  EXPECT_EQ(file.distribution.intensityAt(270, 45), 2.0);
  EXPECT_EQ(file.distribution.intensityAt(180, 45), 3.0);
}

TEST(LdtReader, IsymThreeStoresC270OverC0ToC90) {
  LdtText text;
  text.planes("3", {"0", "30", "90", "150", "180", "210", "270", "330"});
  text.values = ramp(5);  // 270, 330, 0, 30, 90
  const PhotometricFile file = read(text);
  EXPECT_EQ(file.symmetry, "Isym 3, bilateral about C90-C270");
  const auto at = [&](double c) { return file.distribution.intensityAt(c, 45); };
  EXPECT_EQ(at(270), 1.0);
  EXPECT_EQ(at(330), 2.0);
  EXPECT_EQ(at(210), 2.0);
  EXPECT_EQ(at(0), 3.0);
  EXPECT_EQ(at(180), 3.0);
  EXPECT_EQ(at(30), 4.0);
  EXPECT_EQ(at(150), 4.0);
  EXPECT_EQ(at(90), 5.0);
}

TEST(LdtReader, IsymFourStoresAQuadrant) {
  LdtText text;
  text.planes("4", {"0", "45", "90", "135", "180", "225", "270", "315"});
  text.values = ramp(3);
  const PhotometricFile file = read(text);
  EXPECT_EQ(file.symmetry, "Isym 4, quadrant");
  for (const double c : {45.0, 135.0, 225.0, 315.0}) {
    EXPECT_EQ(file.distribution.intensityAt(c, 45), 2.0);
  }
  EXPECT_EQ(file.distribution.intensityAt(270, 45), 3.0);
}

TEST(LdtReader, TheListsDecideNotTheSteps) {
  LdtText text;
  text.head[6] = "0";
  text.gamma = {"0", "10", "90"};
  EXPECT_NEAR(read(text).lumens, kBaseLumens, kRoundoff);
  EXPECT_THAT(read(text).warnings, IsEmpty());
  text.head[6] = "45";
  EXPECT_NEAR(read(text).lumens, kBaseLumens, kRoundoff);
  EXPECT_EQ(read(text).warnings.at(0),
            "the gamma angles are not 45 degrees apart as stated; the list is used");
  text.planes("0", {"0", "90", "180", "270"});
  text.head[4] = "15";
  text.values = ramp(4);
  EXPECT_EQ(read(text).warnings.at(0),
            "the C-planes are not 15 degrees apart as stated; the list is used");
}

TEST(LdtReader, OutsideItsGammaRangeItIsDark) {
  LdtText text;
  text.gamma = {"90", "135", "180"};
  EXPECT_NEAR(read(text).lumens, kBaseLumens, kRoundoff);
  EXPECT_EQ(read(text).distribution.intensityAt(0, 80), 0.0);
}

TEST(LdtReader, LightBeyondTheLampsAndExtraNumbersAreReported) {
  LdtText text;
  text.values.emplace_back("7");
  EXPECT_EQ(read(text).warnings.at(0), "1 numbers follow the candela values; ignored");
  text = {};
  text.values = {"500", "500", "500"};
  EXPECT_THAT(read(text).warnings.at(0), HasSubstr("314.2 % of the 1000 lm declared"));
}

TEST(LdtReader, DamageIsNamedWithItsLine) {
  LdtText text;
  text.values.pop_back();
  EXPECT_EQ(text.error(),
            "lamp.ldt:48: expected 3 candela values (3 gamma angles x 1 stored C-planes), found 2. "
            "The file ends too early. Download it again.");
  text = {};
  text.values[1] = "much";
  EXPECT_THAT(text.error(), HasSubstr("lamp.ldt:48: expected 3 candela values"));
  text = {};
  text.values[1] = "-7";
  EXPECT_THAT(text.error(), HasSubstr("lamp.ldt:48: expected candela of at least 0, found -7"));
  text = {};
  text.gamma[2] = "30";
  EXPECT_THAT(text.error(), HasSubstr("lamp.ldt:46: expected ascending gamma angles, found 30"));
  text.gamma[2] = "200";
  EXPECT_THAT(text.error(), HasSubstr("gamma angles within 0..180, found 0..200"));
}

TEST(LdtReader, PlanesThatContradictIsymAreNamed) {
  LdtText text;
  text.planes("2", {"0", "90", "170", "270"});
  EXPECT_THAT(text.error(), HasSubstr("expected C-planes 0..180 for Isym 2, found 0..170"));
  text.planes("4", {"0"});
  EXPECT_THAT(text.error(), HasSubstr("expected C-planes 0..90 for Isym 4, found 0..0"));
  text.planes("3", {"0", "100", "200", "300"});
  EXPECT_THAT(text.error(), HasSubstr("expected C-planes with 270, 0 and 90 for Isym 3"));
  text.planes("0", {"0", "10", "20", "30"});
  EXPECT_THAT(text.error(), HasSubstr("expected C-planes all round for Isym 0, found 0..30"));
  text.planes("0", {"0", "30", "20", "40"});
  EXPECT_THAT(text.error(), HasSubstr("expected ascending C angles, found 20 after 30"));
}

TEST(LdtReader, AbsurdCountsAreRefused) {
  LdtText text;
  text.planes("0", std::vector<std::string>(1));
  text.c.clear();
  text.gamma.clear();
  for (int i = 0; i < 1000; ++i) text.c.push_back(std::to_string(0.36 * i));
  for (int i = 0; i < 1000; ++i) text.gamma.push_back(std::to_string(0.18 * i));
  text.head[3] = "1000";
  text.head[5] = "1000";
  EXPECT_THAT(text.error(),
              HasSubstr("expected at most 500000 candela values, found a claim of 1000 x 1000"));
}

}  // namespace
}  // namespace soffit::io
