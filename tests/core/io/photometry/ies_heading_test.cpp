// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_heading.h"

#include <gtest/gtest.h>

namespace soffit::io {
namespace {

IesHeading heading(const std::string& text) {
  auto h = parseIesHeading(text, "f.ies");
  EXPECT_TRUE(h.ok()) << h.error().message();
  return h.ok() ? *h : IesHeading{};
}

int year(const std::string& first_line) {
  return heading(first_line + "\nTILT=NONE\n").year;
}

TEST(IesHeading, EditionsAreToldByTheFirstLine) {
  EXPECT_EQ(year("Some luminaire, free text"), 1986);
  EXPECT_EQ(year("[TEST] keyword without a tag"), 1986);
  EXPECT_EQ(year("IESNA91"), 1991);
  EXPECT_EQ(year("IESNA:LM-63-1991"), 1991);
  EXPECT_EQ(year("IESNA:LM-63-1995"), 1995);
  EXPECT_EQ(year("IESNA:LM-63-2002"), 2002);
  EXPECT_EQ(year("IES:LM-63-2019"), 2019);
  EXPECT_EQ(year("  iesna : lm-63-1995 \t"), 1995);
}

TEST(IesHeading, AnUnknownEditionIsReadAs2002WithAWarning) {
  const IesHeading h = heading("IES:LM-63-2031\nTILT=NONE\n");
  EXPECT_EQ(h.year, 2002);
  ASSERT_EQ(h.warnings.size(), 1u);
  EXPECT_EQ(h.warnings[0], "unknown edition 'IES:LM-63-2031' is read as LM-63-2002");
}

TEST(IesHeading, TiltMayBeLowerCaseOrSpaced) {
  for (const char* line :
       {"TILT=NONE", "tilt=none", "TILT = NONE", " Tilt\t= None  ", "TILT=NONE\r"}) {
    EXPECT_EQ(heading(std::string("label\n") + line + "\n1 2 3").tilt, "NONE") << line;
  }
  EXPECT_EQ(heading("TILT=Include\n").tilt, "INCLUDE");
  EXPECT_EQ(heading("TILT= Lamp.tlt \n").tilt, "Lamp.tlt");
  EXPECT_EQ(heading("TILTED luminaire\nTILT=NONE").tilt, "NONE");
}

TEST(IesHeading, NumbersStartOnTheLineAfterTilt) {
  const std::string text = "label\r\nTILT=NONE\r\n1 2 3";
  EXPECT_EQ(text.substr(heading(text).data_offset), "1 2 3");
}

TEST(IesHeading, MoreContinuesTheKeywordBefore) {
  const IesHeading h = heading(
      "IESNA:LM-63-2002\n[LUMCAT]A1\n[MORE] and\n[MORE]\n[ more ] A2\n[_USER_KEY] x\nTILT=NONE\n");
  ASSERT_EQ(h.keywords.size(), 2u);
  EXPECT_EQ(h.keywords[0].key, "LUMCAT");
  EXPECT_EQ(h.keywords[0].value, "A1 and A2");
  EXPECT_EQ(h.keywords[1].key, "_USER_KEY");
  EXPECT_EQ(h.keywords[1].value, "x");
  EXPECT_EQ(heading("IESNA91\n[MORE] of what\nTILT=NONE").warnings.at(0),
            "line 2: [MORE] continues no keyword");
}

TEST(IesHeading, BlocksAreKeptAndMustMatch) {
  const IesHeading h = heading("IESNA91\n[BLOCK]\n[TEST] 1\n[ENDBLOCK]\nTILT=NONE\n");
  EXPECT_EQ(h.keywords.size(), 3u);
  EXPECT_TRUE(h.warnings.empty());
  EXPECT_EQ(heading("IESNA91\n[BLOCK]\nTILT=NONE").warnings.at(0), "a [BLOCK] has no [ENDBLOCK]");
  EXPECT_EQ(heading("IESNA91\n[ENDBLOCK]\nTILT=NONE").warnings.at(0),
            "line 2: [ENDBLOCK] without a [BLOCK]");
}

TEST(IesHeading, FreeLinesOf1986AreLabels) {
  const IesHeading h = heading("ACME 5000\nunfinished [bracket\n[no end\nTILT=NONE\n");
  ASSERT_EQ(h.keywords.size(), 3u);
  EXPECT_EQ(h.keywords[0].key, "LABEL");
  EXPECT_EQ(h.keywords[0].value, "ACME 5000");
}

TEST(IesHeading, WithoutTiltItIsNoIesFile) {
  const auto h = parseIesHeading("IESNA:LM-63-2002\n[TEST] x\n1 2 3\n", "f.ies");
  ASSERT_FALSE(h.ok());
  EXPECT_EQ(h.error().message(),
            "f.ies:3: expected a line TILT=NONE, TILT=INCLUDE or TILT= with a file, found none. "
            "The file is cut off or no IES file. Download it again from the manufacturer.");
  EXPECT_FALSE(parseIesHeading(std::string(1 << 20, '\n'), "f.ies").ok());
}

TEST(IesHeading, IesFilesAreTold) {
  EXPECT_TRUE(looksLikeIes("\xef\xbb\xbfIESNA:LM-63-1995\n"));
  EXPECT_TRUE(looksLikeIes("label\ntilt = none\n"));
  EXPECT_FALSE(looksLikeIes("Maker\n1\n0\n24\n"));
}

}  // namespace
}  // namespace soffit::io
