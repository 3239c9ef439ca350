// SPDX-License-Identifier: MIT
#include "core/transfer/content_hash.h"

#include <gtest/gtest.h>

#include <span>
#include <string>

namespace soffit::transfer {
namespace {

std::span<const std::byte> bytes(const std::string& text) {
  return std::as_bytes(std::span(text));
}

// Test vectors of the XXH3 specification: stored bakes stay readable with any version of the
// library.
TEST(ContentHash, IsXxh3) {
  EXPECT_EQ(hash64({}), 0x2d06800538d394c2ULL);
  EXPECT_EQ(hash128({})[0], 0x99aa06d3014798d8ULL);
  EXPECT_EQ(hash128({})[1], 0x6001c324468d497fULL);
}

TEST(ContentHash, EveryByteCounts) {
  const std::string text(1000, 'a');
  for (const std::size_t at : {0U, 1U, 239U, 240U, 500U, 999U}) {
    std::string other = text;
    other[at] = 'b';
    EXPECT_NE(hash64(bytes(text)), hash64(bytes(other))) << at;
    EXPECT_NE(hash128(bytes(text)), hash128(bytes(other))) << at;
  }
  EXPECT_NE(hash64(bytes(text)), hash64(bytes(text).first(999)));
}

}  // namespace
}  // namespace soffit::transfer
