// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/photometric_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string>

/// Random damage to photometric files, the same on every run and machine.
namespace soffit::io {

/// Damages a text: bytes flipped, cut, doubled, spliced, or a number replaced by a nasty one.
/// std::mt19937 is specified to the bit; distributions are not, so plain remainders are used.
inline std::string mutate(std::string text, std::mt19937& random) {
  static const char* const kNasty[] = {
      "1e9",    "-1",   "nan", "inf", "1e308", "-1e308",    "0", "1e-320", "99999999999999999999",
      "3601",   "2",    "abc", "",    "\n\n",  "1,5",       "+", ".",      "TILT=INCLUDE\n",
      "[MORE]", "\x1a", "360", "180", "-90",   "1000000000"};
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const std::size_t rounds = 1 + below(4);
  for (std::size_t i = 0; i < rounds && !text.empty(); ++i) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(std::min<std::size_t>(text.size() - at, 200));
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text.resize(at);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      case 4:
        text.insert(at, 1, static_cast<char>(random()));
        break;
      default: {
        // Replace the token at this place.
        const std::size_t start = text.find_last_of(" \n\t,", at);
        const std::size_t from = start == std::string::npos ? 0 : start + 1;
        const std::size_t stop = std::min(text.find_first_of(" \r\n\t,", from), text.size());
        text.replace(from, stop - from, kNasty[below(std::size(kNasty))]);
      }
    }
  }
  return text;
}

/// What must hold of any input: a sound distribution, or an error of one line with a place.
inline void expectSound(const std::string& text, const std::string& name) {
  const auto file = parsePhotometry(text, name);
  if (!file) {
    const std::string message = file.error().message();
    EXPECT_EQ(message.find_first_of("\r\n"), std::string::npos) << message;
    EXPECT_EQ(message.substr(0, name.size()), name) << message;
    EXPECT_LT(message.size(), 400u);
    return;
  }
  const photometry::IntensityDistribution& d = file->distribution;
  ASSERT_EQ(d.candela.size(), d.c_deg.size() * d.gamma_deg.size());
  ASSERT_FALSE(d.c_deg.empty());
  EXPECT_EQ(d.c_deg.front(), 0.0);
  EXPECT_LT(d.c_deg.back(), 360.0);
  EXPECT_GE(d.gamma_deg.front(), 0.0);
  EXPECT_LE(d.gamma_deg.back(), 180.0);
  for (std::size_t i = 1; i < d.c_deg.size(); ++i) EXPECT_LT(d.c_deg[i - 1], d.c_deg[i]);
  for (std::size_t i = 1; i < d.gamma_deg.size(); ++i)
    EXPECT_LT(d.gamma_deg[i - 1], d.gamma_deg[i]);
  for (const double cd : d.candela) ASSERT_TRUE(cd >= 0.0 && std::isfinite(cd));
  EXPECT_TRUE(file->lumens >= 0.0 && std::isfinite(file->lumens));
  EXPECT_NEAR(d.flux(), file->lumens, 1e-9 * file->lumens);  // rounding of long sums
}

}  // namespace soffit::io
