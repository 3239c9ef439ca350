// SPDX-License-Identifier: MIT
#include "core/io/photometry/ldt_header.h"

#include "tests/core/io/photometry/ldt_text.h"

#include <gmock/gmock.h>

namespace soffit::io {
namespace {

using ::testing::HasSubstr;

LdtHeader header(const LdtText& text) {
  auto h = parseLdtHeader(text.str(), "lamp.ldt");
  EXPECT_TRUE(h.ok()) << h.error().message();
  return h.ok() ? *h : LdtHeader{};
}

TEST(LdtHeader, FieldsAreByLine) {
  const LdtHeader h = header({});
  EXPECT_EQ(h.symmetry, 1);
  EXPECT_EQ(h.n_gamma, 3);
  EXPECT_EQ(h.gamma_step_deg, 45.0);
  EXPECT_EQ(h.lamp_lumens, 1000.0);
  EXPECT_EQ(h.watts, 25.0);
  EXPECT_TRUE(h.warnings.empty());
}

TEST(LdtHeader, TheOpeningIsTheLuminousAreaLengthOnC90) {
  constexpr double kRoundoff = 1e-15;
  const dvec3 opening = header({}).opening;
  EXPECT_NEAR(opening.x, 0.28, kRoundoff);
  EXPECT_NEAR(opening.y, 0.58, kRoundoff);
  EXPECT_NEAR(opening.z, 0.02, kRoundoff);  // the highest of the four sides
  LdtText round;
  round.head[16] = "0";
  EXPECT_NEAR(header(round).opening.x, -0.58, kRoundoff);
  EXPECT_NEAR(header(round).opening.y, -0.58, kRoundoff);
  LdtText point;
  for (const int i : {15, 16, 18, 20}) point.head[static_cast<std::size_t>(i)] = "0";
  EXPECT_EQ(header(point).opening, dvec3(0.0));
  LdtText negative;
  negative.head[15] = "-580";
  EXPECT_NEAR(header(negative).opening.y, 0.58, kRoundoff);
  EXPECT_THAT(header(negative).warnings.at(0), HasSubstr("negative sides"));
}

TEST(LdtHeader, BlankNumbersAreZeroButCountsAreNeeded) {
  LdtText text;
  text.head[4] = "";
  text.head[13] = "   ";
  text.set[5] = "";
  EXPECT_EQ(header(text).watts, 0.0);
  text.head[5] = "";
  EXPECT_THAT(text.error(), HasSubstr("lamp.ldt:6: expected the number of gamma angles Ng (2 to "
                                      "3601), found 0"));
}

TEST(LdtHeader, FieldsThatAreNoNumbersAreNamed) {
  LdtText text;
  text.head[2] = "axial";
  EXPECT_EQ(text.error(),
            "lamp.ldt:3: expected the symmetry indicator Isym, found 'axial'. The file is damaged "
            "or no EULUMDAT file: it has one field per line. Download it again.");
  text = {};
  text.head[2] = "5";
  EXPECT_THAT(text.error(), HasSubstr("lamp.ldt:3: expected the symmetry indicator Isym (0 to 4)"));
  text = {};
  text.head[3] = "1000000000";
  EXPECT_THAT(text.error(), HasSubstr("Mc (1 to 3601), found 1e+09"));
  text = {};
  text.set[2] = "nan";
  EXPECT_THAT(text.error(),
              HasSubstr("lamp.ldt:29: expected the total luminous flux of the lamps, found 'nan'"));
  text = {};
  text.sets[0] = "0";
  EXPECT_THAT(text.error(), HasSubstr("lamp.ldt:26: expected the number of lamp sets (1 to 20)"));
}

TEST(LdtHeader, OddNumbersAreReported) {
  LdtText text;
  text.head[23] = "0";
  EXPECT_EQ(header(text).factor, 1.0);
  EXPECT_THAT(header(text).warnings.at(0), HasSubstr("factor for luminous intensities is 0"));
  text = {};
  text.set[5] = "-3";
  EXPECT_THAT(header(text).warnings.at(0), HasSubstr("the watts are negative"));
}

TEST(LdtHeader, ATruncatedHeaderSaysWhatIsMissing) {
  const std::string whole = LdtText{}.str();
  EXPECT_EQ(parseLdtHeader(whole.substr(0, whole.find("\r\n")), "lamp.ldt").error().message(),
            "lamp.ldt:1: expected the type indicator, found the end of the file. The file is "
            "damaged or no EULUMDAT file: it has one field per line. Download it again.");
}

}  // namespace
}  // namespace soffit::io
