// SPDX-License-Identifier: MIT
#include "core/io/photometry/tilt.h"

#include "core/io/photometry/text_file.h"
#include "tests/core/io/photometry/ies_text.h"

#include <gmock/gmock.h>

namespace soffit::io {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* kTable = "2\n2\n0 90\n1 0.75\n";

/// folder/lamps/lamp.ies with a TILT file beside it, one in a folder below and one outside.
class TiltFile : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(SOFFIT_BINARY_DIR) / "tilt_test" /
            ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(root_);
    fs::create_directories(root_ / "lamps" / "tilt");
    ASSERT_TRUE(saveText(root_ / "lamps" / "beside.tlt", kTable));
    ASSERT_TRUE(saveText(root_ / "lamps" / "tilt" / "below.tlt", kTable));
    ASSERT_TRUE(saveText(root_ / "outside.tlt", kTable));
  }
  void TearDown() override { fs::remove_all(root_); }

  Result<PhotometricFile> read(const std::string& tilt) {
    IesText text;
    text.tilt = "TILT=" + tilt + "\n";
    EXPECT_TRUE(saveText(root_ / "lamps" / "lamp.ies", text.str()));
    return readIes(root_ / "lamps" / "lamp.ies");
  }

  fs::path root_;
};

TEST_F(TiltFile, IsReadBesideAndBelow) {
  for (const char* name : {"beside.tlt", "tilt/below.tlt", "tilt\\below.tlt"}) {
    const auto file = read(name);
    ASSERT_TRUE(file.ok()) << file.error().message();
    EXPECT_EQ(file->tilt.value().lamp_geometry, 2);
    EXPECT_EQ(file->tilt->factors.back(), 0.75);
  }
}

TEST_F(TiltFile, MayNotLeaveTheFolder) {
  fs::create_symlink(root_ / "outside.tlt", root_ / "lamps" / "link.tlt");
  for (const std::string& name :
       {std::string("../outside.tlt"), std::string("tilt/../../outside.tlt"),
        (root_ / "outside.tlt").string(), std::string("C:\\outside.tlt"),
        std::string("\\\\server\\outside.tlt"), std::string("link.tlt")}) {
    const auto file = read(name);
    ASSERT_FALSE(file.ok()) << name;
    EXPECT_THAT(file.error().message(), HasSubstr("lamp.ies: expected a TILT file beside the IES"));
    EXPECT_THAT(file.error().hint, HasSubstr("may not lie outside the folder")) << name;
  }
}

TEST_F(TiltFile, ThatIsMissingIsAnError) {
  const auto file = read("gone.tlt");
  ASSERT_FALSE(file.ok());
  EXPECT_THAT(file.error().message(),
              HasSubstr("expected the TILT file 'gone.tlt', found none. Put it beside the IES"));
}

TEST_F(TiltFile, WithDamageNamesItself) {
  ASSERT_TRUE(saveText(root_ / "lamps" / "beside.tlt", "2\n2\n0 90\n1\n"));
  const auto file = read("beside.tlt");
  ASSERT_FALSE(file.ok());
  EXPECT_THAT(file.error().message(), HasSubstr("beside.tlt:4: expected 2 TILT factors, found 1"));
}

TEST(Tilt, FromMemoryANamedFileNeedsALoader) {
  IesText text;
  text.tilt = "TILT=lamp.tlt\n";
  EXPECT_EQ(text.error(),
            "lamp.ies:4: expected TILT=NONE or TILT=INCLUDE, found 'lamp.tlt'. Write TILT=NONE if "
            "the lamp may burn in any position.");
  text.tilt = "TILT=\n";
  EXPECT_THAT(text.error(), HasSubstr("found ''"));
  text.tilt = "TILT=lamp.tlt\n";
  const auto file = parseIes(text.str(), "lamp.ies",
                             [](const std::string&) { return Result<std::string>(kTable); });
  EXPECT_EQ(file.value().tilt.value().angles_deg.size(), 2u);
}

TEST(Tilt, DamagedBlocksAreRefused) {
  IesText text;
  text.tilt = "TILT=INCLUDE\n4 1 0 1\n";
  EXPECT_THAT(text.error(), HasSubstr("the lamp-to-luminaire geometry of TILT (1 to 3), found 4"));
  text.tilt = "TILT=INCLUDE\n1 -5\n";
  EXPECT_THAT(text.error(), HasSubstr("the number of TILT angles (1 to 1000), found -5"));
  text.tilt = "TILT=INCLUDE\n1 2 0 x\n";
  EXPECT_THAT(text.error(), HasSubstr("expected 2 TILT angles, found 'x'"));
  text.tilt = "TILT=INCLUDE\n1 2 0 90 1 -1\n";
  EXPECT_THAT(text.error(), HasSubstr("TILT factors of at least 0, found a negative one"));
}

}  // namespace
}  // namespace soffit::io
