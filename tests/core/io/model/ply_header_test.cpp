// SPDX-License-Identifier: MIT
#include "core/io/model/ply_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/io/model/sample_models.h"
#include "tests/core/io/model/scratch_folder.h"

namespace soffit::io {
namespace {

using ::testing::HasSubstr;

TEST(PlyHeader, GoodOnesPassWithAnyLineEnds) {
  const ScratchFolder folder;
  EXPECT_EQ(plyHeaderProblem(folder.write("a.ply", kBlockPly)), "");
  std::string text(kBlockPly);
  for (char& c : text) c = c == '\n' ? '\r' : c;
  EXPECT_EQ(plyHeaderProblem(folder.write("b.ply", text)), "");
}

TEST(PlyHeader, BadOnesAreNamed) {
  const ScratchFolder folder;
  const auto problem = [&](const std::string& text) {
    return plyHeaderProblem(folder.write("a.ply", text));
  };
  EXPECT_THAT(problem(""), HasSubstr("does not begin with 'ply'"));
  EXPECT_THAT(problem("ply\nelement vertex 1\n"), HasSubstr("without 'end_header'"));
  EXPECT_THAT(problem("ply\nelement vertex 4000000000\nend_header\n"),
              HasSubstr("impossible number of elements 'vertex'"));
  EXPECT_THAT(problem("ply\nelement face -1\nend_header\n"), HasSubstr("'face'"));
  EXPECT_THAT(problem("ply\nelement face many\nend_header\n"), HasSubstr("'face'"));
}

}  // namespace
}  // namespace soffit::io
