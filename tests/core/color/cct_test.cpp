// SPDX-License-Identifier: MIT
#include "core/color/cct.h"

#include <gtest/gtest.h>

namespace soffit::color {
namespace {

// Error of the fit to the colour matching functions (stated in cct.h), in x and y.
constexpr double kFit = 0.003;

struct Chromaticity {
  double cct_k;
  double x;
  double y;
};

class PlanckianLocus : public testing::TestWithParam<Chromaticity> {};

TEST_P(PlanckianLocus, LiesOnTheTabulatedLocus) {
  const dvec3 xyz = planckianXyz(GetParam().cct_k);
  const double sum = xyz.x + xyz.y + xyz.z;
  EXPECT_NEAR(xyz.x / sum, GetParam().x, kFit);
  EXPECT_NEAR(xyz.y / sum, GetParam().y, kFit);
}

// Wyszecki & Stiles, Color Science (2nd ed.), Planckian radiators; 2856 K is CIE illuminant A.
INSTANTIATE_TEST_SUITE_P(Temperatures, PlanckianLocus,
                         testing::Values(Chromaticity{2000.0, 0.5267, 0.4133},
                                         Chromaticity{2856.0, 0.4476, 0.4074},
                                         Chromaticity{4000.0, 0.3805, 0.3768},
                                         Chromaticity{6500.0, 0.3135, 0.3237},
                                         Chromaticity{10000.0, 0.2807, 0.2884}));

TEST(PlanckianXyz, IsScaledToUnitLuminance) {
  for (const double cct_k : {500.0, 3000.0, 1e6}) {
    const dvec3 xyz = planckianXyz(cct_k);
    EXPECT_TRUE(isFinite(xyz)) << cct_k;
    EXPECT_DOUBLE_EQ(xyz.y, 1.0) << cct_k;
  }
}

TEST(Rec709FromXyz, TakesD65WhiteToEqualChannels) {
  const dvec3 white = rec709FromXyz({0.3127 / 0.3290, 1.0, (1.0 - 0.3127 - 0.3290) / 0.3290});
  constexpr double kDigits = 1e-3;  // of the white point's four decimals
  EXPECT_NEAR(white.x, 1.0, kDigits);
  EXPECT_NEAR(white.y, 1.0, kDigits);
  EXPECT_NEAR(white.z, 1.0, kDigits);
}

TEST(Rec709FromXyz, KeepsLuminance) {
  const dvec3 rgb = rec709FromXyz({0.2, 0.7, 0.4});
  EXPECT_NEAR(0.2126390058715104 * rgb.x + 0.7151686787677560 * rgb.y + 0.0721923153607336 * rgb.z,
              0.7, 1e-12);  // round-off of two inverse matrices
}

}  // namespace
}  // namespace soffit::color
