// SPDX-License-Identifier: MIT
#include "core/io/image/file_name.h"

#include <gtest/gtest.h>

namespace soffit::io {
namespace {

TEST(FileNameOf, KeepsWhatIsPlainAndHidesNothing) {
  EXPECT_EQ(fileNameOf("Wall washers 2 (warm)"), "Wall washers 2 (warm)");
  EXPECT_EQ(fileNameOf("B\xC3\xBCro"), "B\xC3\xBCro");
  EXPECT_EQ(fileNameOf("a/b\\c:d*e?"), "a_b_c_d_e_");
  EXPECT_EQ(fileNameOf(".hidden"), "_.hidden");
  EXPECT_EQ(fileNameOf(""), "_");
}

}  // namespace
}  // namespace soffit::io
