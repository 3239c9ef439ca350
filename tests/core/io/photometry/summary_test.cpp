// SPDX-License-Identifier: MIT
#include "core/io/photometry/summary.h"

#include "tests/core/io/photometry/ies_text.h"

#include <gmock/gmock.h>

namespace soffit::io {
namespace {

using ::testing::HasSubstr;

TEST(Summary, GathersWhatTheCommandLineShows) {
  IesText text;
  text.vertical = "0 40 90";
  text.candela = "100 0 0";
  text.size = "2 -0.2 -0.2 0";
  text.tail = " 9";
  const PhotometrySummary s = summarize(text.parse().value());
  EXPECT_EQ(s.name, "Test");
  EXPECT_EQ(s.format, "IES LM-63-2002");
  EXPECT_EQ(s.n_vertical, 3);
  EXPECT_EQ(s.n_horizontal, 1);
  EXPECT_EQ(s.symmetry, "axial");
  EXPECT_EQ(s.peak_cd, 100.0);
  constexpr double kRoundoff = 1e-11;  // degrees
  EXPECT_NEAR(s.beam_deg.c0_deg, 40.0, kRoundoff);
  EXPECT_NEAR(s.field_deg.c90_deg, 72.0, kRoundoff);
  EXPECT_NEAR(s.centre_beam_deg.c0_deg, 40.0, kRoundoff);
  EXPECT_EQ(s.warnings.size(), 1u);
  EXPECT_DOUBLE_EQ(s.efficacy.value(), s.lumens / 5.0);
  const std::string shown = toText(s);
  EXPECT_THAT(shown, HasSubstr("angles       3 vertical x 1 horizontal\n"));
  EXPECT_THAT(shown, HasSubstr("beam angle   40.0 deg in C0-C180, 40.0 deg in C90-C270"));
  EXPECT_THAT(shown, HasSubstr("opening      0.2 x 0.2 x 0 m, round\n"));
  EXPECT_THAT(shown, HasSubstr("warning      1 numbers follow"));
}

TEST(Summary, RelativePhotometryShowsItsLamps) {
  IesText text;
  text.lamps = "2 500 1";
  const std::string shown = toText(summarize(text.parse().value()));
  EXPECT_THAT(shown, HasSubstr("lamps        1000 lm\n"));
  EXPECT_THAT(shown, HasSubstr("LOR          6.283 %\n"));
  EXPECT_THAT(shown, HasSubstr("opening      a point\n"));
}

}  // namespace
}  // namespace soffit::io
