// SPDX-License-Identifier: MIT
#include "core/io/photometry/photometric_file.h"
#include "core/io/photometry/text_file.h"
#include "tests/core/io/photometry/mutations.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace soffit::io {
namespace {

struct Known {
  const char* file;
  const char* symmetry;
  int n_vertical;
  int n_horizontal;
  double lumens;
  double output_ratio;  ///< percent; 0: not stated
};

void PrintTo(const Known& known, std::ostream* out) {
  *out << known.file;
}

std::filesystem::path pathOf(const Known& known) {
  return std::filesystem::path(SOFFIT_SHARED_DIR) / "photometry" / known.file;
}

class SharedPhotometry : public ::testing::TestWithParam<Known> {};

TEST_P(SharedPhotometry, HasTheLumensThatWereComputedIndependently) {
  const Known& known = GetParam();
  const auto file = readPhotometry(pathOf(known));
  ASSERT_TRUE(file.ok()) << file.error().message();
  // The list gives 8 digits; the formula is the same one, so only its rounding is left.
  constexpr double kListed = 1e-7;
  EXPECT_NEAR(file->lumens / known.lumens, 1.0, kListed);
  EXPECT_NEAR(file->distribution.flux() / known.lumens, 1.0, kListed);
  EXPECT_EQ(file->n_vertical, known.n_vertical);
  EXPECT_EQ(file->n_horizontal, known.n_horizontal);
  EXPECT_EQ(file->symmetry, known.symmetry);
  if (known.output_ratio > 0.0) {
    // Listed to four digits.
    EXPECT_NEAR(100.0 * file->lightOutputRatio().value(), known.output_ratio,
                5e-4 * known.output_ratio);
  }
}

TEST_P(SharedPhotometry, SurvivesDamage) {
  const auto text = loadText(pathOf(GetParam()));
  ASSERT_TRUE(text.ok());
  const bool is_type_b = std::string(GetParam().file) == "flood_2_1.ies";  // slow: it is resampled
  std::mt19937 random(99);
  for (int i = 0; i < (is_type_b ? 40 : 400) && !HasFailure(); ++i) {
    expectSound(mutate(*text, random), GetParam().file);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, SharedPhotometry,
    ::testing::Values(
        Known{"cu_1.ies", "quadrant 0-90", 74, 12, 9218.2617, 0},
        Known{"flood_2_1.ies", "type B 0-90 (H mirrored)", 45, 23, 10698.335, 0},
        Known{"absolute_led.ies", "none 0-360", 19, 37, 5174.1318, 0},
        Known{"maxwell_iesna.ies", "none 0-360", 91, 73, 999.92718, 0},
        Known{"imperial.ies", "axial", 37, 1, 904.52453, 0},
        Known{"relative_multiplier.ies", "axial", 37, 1, 1356.7868, 0},
        Known{"road.ldt", "Isym 3, bilateral about C90-C270", 25, 52, 27933.951, 84.14},
        Known{"projector.ldt", "Isym 2, bilateral about C0-C180", 55, 72, 5157.9763, 79.35},
        Known{"asym_flood.ldt", "Isym 0, none", 19, 8, 122787.92, 99.83},
        Known{"nosym.ldt", "Isym 0, none", 37, 24, 3722.0199, 372.2},
        Known{"ugr_01.ldt", "Isym 4, quadrant", 37, 24, 12417.085, 100.7}));

}  // namespace
}  // namespace soffit::io
