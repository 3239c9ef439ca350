// SPDX-License-Identifier: MIT
#include "core/io/photometry/photometric_file.h"

#include "tests/core/io/photometry/ies_text.h"
#include "tests/core/io/photometry/ldt_text.h"

#include <gmock/gmock.h>

namespace soffit::io {
namespace {

TEST(PhotometricFile, TheContentDecidesWhateverTheExtension) {
  EXPECT_EQ(parsePhotometry(IesText{}.str(), "a.ldt").value().format, "IES LM-63-2002");
  EXPECT_EQ(parsePhotometry(LdtText{}.str(), "a.txt").value().format, "EULUMDAT");
  IesText old;
  old.head = "no tag\n";
  EXPECT_EQ(parsePhotometry(old.str(), "a").value().format, "IES LM-63-1986");
}

TEST(PhotometricFile, TheExtensionDecidesWhichErrorIsGiven) {
  EXPECT_THAT(parsePhotometry("garbage", "a.IES").error().message(),
              ::testing::HasSubstr("a.IES:1: expected a line TILT=NONE"));
  EXPECT_THAT(parsePhotometry("garbage", "a.ldt").error().message(),
              ::testing::HasSubstr("a.ldt:1: expected the type indicator"));
}

TEST(PhotometricFile, FilesThatCannotBeReadAreNamed) {
  namespace fs = std::filesystem;
  const fs::path gone = fs::path(SOFFIT_BINARY_DIR) / "gone.ies";
  EXPECT_EQ(readPhotometry(gone).error().message(),
            gone.string() +
                ": expected a photometric file, found no file of that name. Check the "
                "path.");
  EXPECT_EQ(readPhotometry(SOFFIT_BINARY_DIR).error().message(),
            std::string(SOFFIT_BINARY_DIR) +
                ": expected a photometric file, found a folder or a device. Name an .ies or .ldt "
                "file.");
  EXPECT_FALSE(readPhotometry("/dev/zero").ok());
}

}  // namespace
}  // namespace soffit::io
