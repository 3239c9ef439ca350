// SPDX-License-Identifier: MIT
#include "core/io/photometry/text_file.h"

#include <gtest/gtest.h>

#include <fstream>

namespace soffit::io {
namespace {

namespace fs = std::filesystem;

TEST(TextFile, WhatIsSavedIsLoadedAndNothingElseIsLeft) {
  const fs::path folder = fs::path(SOFFIT_BINARY_DIR) / "text_file_test";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string text("a\0b\r\n", 5);
  ASSERT_TRUE(saveText(folder / "f", text));
  EXPECT_EQ(loadText(folder / "f").value(), text);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  fs::remove_all(folder);
}

TEST(TextFile, HugeFilesAreRefusedUnread) {
  const fs::path path = fs::path(SOFFIT_BINARY_DIR) / "huge.ies";
  std::ofstream(path).put('x');
  fs::resize_file(path, std::uintmax_t{1} << 30);  // sparse: takes no disk
  EXPECT_EQ(loadText(path).error().message(),
            path.string() +
                ": expected at most 8388608 bytes, found 1073741824. This is no "
                "photometric file.");
  fs::remove(path);
}

}  // namespace
}  // namespace soffit::io
