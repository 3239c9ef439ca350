// SPDX-License-Identifier: MIT
#include "core/render/stroke_font.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace soffit::render {
namespace {

// A sign is a list of strokes. '-' starts a polyline, '~' a smooth curve through the points. A
// point is two characters, x and y in base 20 (0-9, a-j); y counts from the descender: the
// baseline is 4, lower-case letters reach c, capitals and digits g.
struct Glyph {
  char32_t code;
  const char* strokes;
};

constexpr std::array kGlyphs{
    Glyph{U'!', "-1g18-1514"},
    Glyph{U'"', "-1g1c-4g4c"},
    Glyph{U'#', "-2g14-6g54-0b8b-0787"},
    Glyph{U'$', "~7d5f3f1d1b3a5a7977535 31517-4h43"},
    Glyph{U'%', "-8g04~2g0e2c4e2g~684656646886"},
    Glyph{U'&', "~84 5a2d3f5g6e5c2a0827444 65788"},
    Glyph{U'\'', "-1g1c"},
    Glyph{U'(', "~3h1e0b081532"},
    Glyph{U')', "~0h2e3b382502"},
    Glyph{U'*', "-3g38-0e6a-6e0a"},
    Glyph{U'+', "-4d45-0989"},
    Glyph{U',', "-151402"},
    Glyph{U'-', "-0959"},
    Glyph{U'.', "-1514"},
    Glyph{U'/', "-026h"},
    Glyph{U'0', "~4g1e0a1644768a7e4g"},
    Glyph{U'1', "-1d4g44"},
    Glyph{U'2', "~0d1f4g7f8c6804-0484"},
    Glyph{U'3', "~0e2g5g7e6b3a~3a6a88764406"},
    Glyph{U'4', "-646g0787"},
    Glyph{U'5', "-7g1g1b~1b4c7b88754405"},
    Glyph{U'6', "~7g3e091544758 87b4c1b09"},
    Glyph{U'7', "-0g8g34"},
    Glyph{U'8', "~4g1f1c4b7c7f4g~4b1a07154475877a4b"},
    Glyph{U'9', "~14568b7f4g1f0c1948798b"},
    Glyph{U':', "-1b1a-1514"},
    Glyph{U';', "-1b1a-151402"},
    Glyph{U'<', "-7d0975"},
    Glyph{U'=', "-0b7b-0777"},
    Glyph{U'>', "-0d7905"},
    Glyph{U'?', "~0e2g5g7e5b37-3534"},
    Glyph{U'@', "~7b5c3a3857797d5g3g0d07447 4"},
    Glyph{U'A', "-044g84-1878"},
    Glyph{U'B', "-040g5g~5g7f7c5b-5b0b~5b8a8654-5404"},
    Glyph{U'C', "~8e6g3g0d073464 86"},
    Glyph{U'D', "-040g4g~4g8d8744-4404"},
    Glyph{U'E', "-7g0g0474-0b5b"},
    Glyph{U'F', "-7g0g04-0b5b"},
    Glyph{U'G', "~8e6g3g0d07346486-868a5a"},
    Glyph{U'H', "-040g-848g-0a8a"},
    Glyph{U'I', "-0g04"},
    Glyph{U'J', "-5g57~5744240 6"},
    Glyph{U'K', "-0g04-8g08-2a84"},
    Glyph{U'L', "-0g0474"},
    Glyph{U'M', "-040g479g94"},
    Glyph{U'N', "-040g848g"},
    Glyph{U'O', "~4g1f0a15447 58a7f4g"},
    Glyph{U'P', "-040g5g~5g8e8b59-5909"},
    Glyph{U'Q', "~4g1f0a15447 58a7f4g-5884"},
    Glyph{U'R', "-040g5g~5g8e8b59-5909-4984"},
    Glyph{U'S', "~8e6g2g0e1b4a7986646 42406"},
    Glyph{U'T', "-0g8g-4g44"},
    Glyph{U'U', "-0g08~0815447 588-888g"},
    Glyph{U'V', "-0g448g"},
    Glyph{U'W', "-0g345e74ag"},
    Glyph{U'X', "-0g84-048g"},
    Glyph{U'Y', "-0g4a8g-4a44"},
    Glyph{U'Z', "-0g8g0484"},
    Glyph{U'[', "-3h0h0333"},
    Glyph{U'\\', "-0h62"},
    Glyph{U']', "-0h3h3303"},
    Glyph{U'^', "-0c3g6c"},
    Glyph{U'_', "-0383"},
    Glyph{U'`', "-0g2e"},
    Glyph{U'a', "-6c64~6a3c0b0534 66"},
    Glyph{U'b', "-0g04~0a3c6a6634 06"},
    Glyph{U'c', "~6b4c2c0a0624446 5"},
    Glyph{U'd', "-6g64~6a3c0a0634 66"},
    Glyph{U'e', "-0868~686a3c0a0635 465"},
    Glyph{U'f', "~4g2g1d-1d14-0c4c"},
    Glyph{U'g', "-6c62~624 01011~6a3c0a0634 66"},
    Glyph{U'h', "-0g04~093c5c69-6964"},
    Glyph{U'i', "-0c04-0g0f"},
    Glyph{U'j', "-2c22~221000-2g2f"},
    Glyph{U'k', "-0g04-5c08-2954"},
    Glyph{U'l', "-0g04"},
    Glyph{U'm', "-0c04~093c4c59-5954~598c9ca9-a9a4"},
    Glyph{U'n', "-0c04~093c5c69-6964"},
    Glyph{U'o', "~3c0a0634666a3c"},
    Glyph{U'p', "-0c00~0a3c6a6634 06"},
    Glyph{U'q', "-6c60~6a3c0a0634 66"},
    Glyph{U'r', "-0c04~092b4c"},
    Glyph{U's', "~5b3c1c0a2948554 32405"},
    Glyph{U't', "-1f16~162444-0c4c"},
    Glyph{U'u', "-0c07~0714345 7-6c64~5764"},
    Glyph{U'v', "-0c346c"},
    Glyph{U'w', "-0c244a648c"},
    Glyph{U'x', "-0c64-046c"},
    Glyph{U'y', "-0c34-6c20"},
    Glyph{U'z', "-0c6c0464"},
    Glyph{U'{', "~4h2g2c0a-0a0a~0a282424-2443"},
    Glyph{U'|', "-0h02"},
    Glyph{U'}', "~0h2g2c4a~4a282403"},
    Glyph{U'~', "~082a4858 7a"},
    Glyph{U'\u00b0', "~2g0e2c4e2g"},
    Glyph{U'\u00b2', "~0f2g4f3d0a-0a4a"},
    Glyph{U'\u00b3', "~0f2g4f2d~2d4b2a0b"},
    Glyph{U'\u00b5', "-0c00~0714345 7-6c64"},
    Glyph{U'\u00b7', "-1a19"},
    Glyph{U'\u00d7', "-1c76-167c"},
    Glyph{U'\u00df', "-0404~040d2g5e4b~4b6a6844 24"},
    Glyph{U'\u2013', "-0969"},
    Glyph{U'\u2014', "-09a9"},
};

constexpr const char* kBox = "-0c6c64040c";
constexpr float kGap = 3.6F;    // between signs
constexpr float kSpace = 5.0F;  // a blank, besides the gap
constexpr float kBaseline = 4.0F;

/// Typographic signs that have a plain form.
char32_t plain(char32_t code) {
  if (code == 0x2018 || code == 0x2019 || code == 0x201a) return U'\'';
  if (code == 0x201c || code == 0x201d || code == 0x201e || code == 0xab || code == 0xbb)
    return U'"';
  if (code == 0x2010 || code == 0x2011 || code == 0x2212) return U'-';
  if (code == 0x3bc) return 0xb5;  // the Greek letter for the micro sign
  return code;
}

/// Latin-1 letters from U+00C0 without their accents; '?' where there is none to take off.
constexpr std::string_view kPlainLetters =
    "AAAAAAACEEEEIIIIDNOOOOO?OUUUUY??aaaaaaaceeeeiiiidnooooo?ouuuuy?y";

const char* strokesOf(char32_t code) {
  const auto find = [](char32_t wanted) -> const char* {
    for (const Glyph& glyph : kGlyphs) {
      if (glyph.code == wanted) return glyph.strokes;
    }
    return nullptr;
  };
  code = plain(code);
  const char* own = find(code);
  if (own == nullptr && code >= 0xc0 && code <= 0xff) {
    own = find(static_cast<char32_t>(kPlainLetters[code - 0xc0]));
  }
  return own == nullptr ? kBox : own;
}

/// The next code point of UTF-8 text; 0xfffd for a broken sequence.
char32_t nextCode(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  std::size_t length = 1;
  char32_t code = lead;
  if (lead >= 0xf0) {
    length = 4;
    code = lead & 0x07U;
  } else if (lead >= 0xe0) {
    length = 3;
    code = lead & 0x0fU;
  } else if (lead >= 0xc0) {
    length = 2;
    code = lead & 0x1fU;
  } else if (lead >= 0x80) {
    code = 0xfffd;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if (i >= text.size() || (byte(i) & 0xc0U) != 0x80U) {
      text.remove_prefix(i);
      return 0xfffd;
    }
    code = code << 6U | (byte(i) & 0x3fU);
  }
  text.remove_prefix(length);
  return code;
}

float digit(char c) {
  return static_cast<float>(c <= '9' ? c - '0' : c - 'a' + 10);
}

struct Path {
  bool smooth = false;
  std::vector<vec2> points;
};

std::vector<Path> parse(std::string_view strokes) {
  std::vector<Path> paths;
  std::string pending;
  for (const char c : strokes) {
    if (c == '-' || c == '~') {
      paths.push_back({c == '~', {}});
    } else if (c != ' ') {
      pending.push_back(c);
      if (pending.size() < 2) continue;
      paths.back().points.emplace_back(digit(pending[0]), digit(pending[1]) - kBaseline);
      pending.clear();
    }
  }
  return paths;
}

/// Catmull-Rom through the points (closed where the last is the first), as chords.
std::vector<vec2> flattened(const std::vector<vec2>& p, float chord) {
  const std::size_t n = p.size();
  const bool closed = n > 2 && p.front() == p.back();
  const auto at = [&](std::ptrdiff_t i) {
    const auto last = static_cast<std::ptrdiff_t>(n) - 1;
    if (closed) return p[static_cast<std::size_t>((i + last) % last)];
    return p[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
  };
  std::vector<vec2> line{p.front()};
  for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(n); ++i) {
    const vec2 a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(c - b) / chord)));
    for (int k = 1; k <= steps; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(steps);
      line.push_back(0.5F * (2.0F * b + t * (c - a) + t * t * (2.0F * a - 5.0F * b + 4.0F * c - d) +
                             t * t * t * (3.0F * b - a - 3.0F * c + d)));
    }
  }
  return line;
}

}  // namespace

StrokeText layOut(std::string_view text, float chord) {
  StrokeText laid;
  float x = 0.0F;
  while (!text.empty()) {
    const char32_t code = nextCode(text);
    if (code == U' ' || code == U'\t' || code == 0xa0) {
      x += kSpace + kGap;
      continue;
    }
    float right = 0.0F;
    for (const Path& path : parse(strokesOf(code))) {
      const auto line = path.smooth ? flattened(path.points, chord) : path.points;
      for (const vec2& p : path.points) right = std::max(right, p.x);
      for (std::size_t i = 1; i < line.size(); ++i) {
        laid.strokes.push_back({line[i - 1] + vec2(x, 0.0F), line[i] + vec2(x, 0.0F)});
      }
    }
    laid.width = x + right;
    x += right + kGap;
  }
  return laid;
}

}  // namespace soffit::render
