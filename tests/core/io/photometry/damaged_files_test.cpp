// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_writer.h"
#include "core/io/photometry/ldt_writer.h"
#include "core/io/photometry/text_file.h"
#include "tests/core/io/photometry/ies_text.h"
#include "tests/core/io/photometry/ldt_text.h"
#include "tests/core/io/photometry/mutations.h"
#include "tests/core/io/photometry/round_trip.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

namespace soffit::io {
namespace {

double lobe(double c, double g) {
  return 1000.0 * (2.0 + std::cos(c)) * std::exp(-g * g);
}

void damage(const std::string& text, const std::string& name, unsigned seed, int times) {
  std::mt19937 random(seed);
  for (int i = 0; i < times && !::testing::Test::HasFailure(); ++i) {
    const std::string damaged = mutate(text, random);
    expectSound(damaged, name);
    if (::testing::Test::HasFailure()) ADD_FAILURE() << "mutation " << i << ":\n" << damaged;
  }
}

TEST(DamagedFiles, SmallIesFilesOfEveryType) {
  IesText text;
  damage(text.str(), "f.ies", 1, 3000);
  text.head = "IESNA:LM-63-1995\n[TEST] x\n[MORE] y\n[BLOCK]\n[ENDBLOCK]\n";
  text.tilt = "TILT=INCLUDE\n1\n2\n0 90\n1 0.9\n";
  text.counts = "3 3";
  text.horizontal = "0 45 90";
  text.candela = "1 2 3\n4 5 6\n7 8 9";
  damage(text.str(), "f.ies", 2, 3000);
  text.type = "2";
  text.vertical = "-80 0 80";
  damage(text.str(), "f.ies", 3, 150);
}

TEST(DamagedFiles, SmallLdtFilesOfEverySymmetry) {
  damage(LdtText{}.str(), "f.ldt", 4, 3000);
  LdtText text;
  text.planes("3", {"0", "90", "180", "270"});
  text.values.assign(9, "5,5");
  damage(text.str(), "f.ldt", 5, 3000);
}

TEST(DamagedFiles, WholeTables) {
  const auto file = synthetic(lobe, 12, 19);
  damage(toIes(file), "f.ies", 6, 1000);
  damage(toLdt(file), "f.ldt", 7, 1000);
}

TEST(DamagedFiles, EveryTruncationOfASmallFile) {
  for (const auto& [text, name] :
       {std::pair{IesText{}.str(), "f.ies"}, std::pair{LdtText{}.str(), "f.ldt"}}) {
    for (std::size_t length = 0; length < text.size(); ++length) {
      expectSound(text.substr(0, length), name);
    }
  }
}

TEST(DamagedFiles, Noise) {
  std::mt19937 random(8);
  for (int i = 0; i < 300; ++i) {
    std::string noise(random() % 5000, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    expectSound(noise, "f.ies");
    expectSound(noise, "f.ldt");
    expectSound("TILT=NONE\n" + noise, "f.ies");
  }
}

TEST(DamagedFiles, TheLargestFilesOfNothingStaySmallInMemory) {
  // Each byte at its most harmful: line ends, labels, numbers, brackets, at the size limit.
  for (const char* unit : {"\n", "\r", "a\n", "[", "[MORE]\n", "1 ", "0\n", "\0"}) {
    std::string text;
    text.reserve(kMaxTextBytes);
    const std::string piece = *unit == '\0' ? std::string(1, '\0') : std::string(unit);
    while (text.size() + piece.size() <= kMaxTextBytes) text += piece;
    expectSound(text, "f.ies");
    expectSound(text, "f.ldt");
    text.replace(0, 11, "TILT=NONE\n1");
    expectSound(text, "f.ies");
  }
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  // The process as a whole; sanitizers multiply it.
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, 64 * 1024) << "kB at the peak";
#endif
}

TEST(DamagedFiles, TheLargestClaimsThatAreKeptStaySmallInMemory) {
  // 3601 x 138 values with type C quadrant symmetry: four times that in memory.
  IesText text;
  text.counts = "3601 138";
  text.vertical.clear();
  for (int i = 0; i < 3601; ++i) text.vertical += std::to_string(0.025 * i) + ' ';
  text.horizontal.clear();
  for (int i = 0; i < 138; ++i) text.horizontal += std::to_string(90.0 * i / 137) + ' ';
  text.candela.clear();
  for (int i = 0; i < 3601 * 138; ++i) text.candela += "1 ";
  const auto file = text.parse();
  ASSERT_TRUE(file.ok()) << file.error().message();
  EXPECT_NEAR(file->lumens, 2 * kPi, 1e-4 * kPi);  // the angles above are rounded to 1e-6 degrees
}

}  // namespace
}  // namespace soffit::io
