// SPDX-License-Identifier: MIT
#include "core/io/model/mtl_colors.h"

#include <gtest/gtest.h>

namespace soffit::io {
namespace {

TEST(MtlColors, ListsMaterialsThatStateADiffuseColor) {
  const std::set<std::string> expected{"oak wood", "steel"};
  EXPECT_EQ(
      materialsWithColor("# comment\nnewmtl oak wood\r\n\tKd 1 1 1\r\nnewmtl plain\nKa 1 1 1\n"
                         "newmtl  steel \n  Ks 1 1 1\n Kd 0 0 0"),
      expected);
}

TEST(MtlColors, NonsenseHasNone) {
  EXPECT_TRUE(materialsWithColor("").empty());
  EXPECT_TRUE(materialsWithColor("\n\n \t\nKd\nnewmtl\nmap_Kd x.png").empty());
}

}  // namespace
}  // namespace soffit::io
