// SPDX-License-Identifier: MIT
#include "core/io/photometry/ldt_writer.h"

#include "core/io/photometry/ldt_reader.h"
#include "tests/core/io/photometry/round_trip.h"

#include <gmock/gmock.h>

#include <limits>

namespace soffit::io {
namespace {

using ::testing::HasSubstr;

constexpr double kRoundoff = 8 * std::numeric_limits<double>::epsilon();

double lobe(double c, double g) {
  return 1000.0 * (2.0 + std::cos(c - 0.3)) * std::exp(-g * g / 3);
}

TEST(LdtWriter, RoundTripsToARoundingInEverySymmetry) {
  const struct {
    bool c0, c90;
    const char* symmetry;
  } cases[] = {{true, true, "Isym 4, quadrant"},
               {true, false, "Isym 2, bilateral about C0-C180"},
               {false, true, "Isym 3, bilateral about C90-C270"},
               {false, false, "Isym 0, none"}};
  for (const auto& k : cases) {
    const auto file =
        synthetic([&](double c, double g) { return lobe(foldedAngle(c, k.c0, k.c90), g); }, 24);
    const auto back = parseLdt(toLdt(file), "f.ldt");
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_EQ(back->symmetry, k.symmetry);
    EXPECT_EQ(back->distribution.c_deg, file.distribution.c_deg);
    EXPECT_EQ(back->distribution.gamma_deg, file.distribution.gamma_deg);
    ASSERT_EQ(back->distribution.candela.size(), file.distribution.candela.size());
    for (std::size_t i = 0; i < file.distribution.candela.size(); ++i) {
      const double cd = file.distribution.candela[i];
      EXPECT_NEAR(back->distribution.candela[i], cd, kRoundoff * cd);
    }
    EXPECT_NEAR(back->distribution.opening.y, 0.6, kRoundoff);
    EXPECT_EQ(back->distribution.name, "Synthetic");
    EXPECT_TRUE(back->absolute);
    EXPECT_TRUE(back->warnings.empty());
  }
}

TEST(LdtWriter, RelativePhotometryKeepsItsLamps) {
  auto file = synthetic([](double, double g) { return 100.0 * (1 - 2 * g / kPi); }, 1, 19, 90.0);
  file.distribution.candela.back() = 0.0;
  file.distribution.opening = {-0.2, -0.2, 0.0};
  file.absolute = false;
  file.lamp_lumens = 400.0;
  const auto back = parseLdt(toLdt(file), "f.ldt").value();
  EXPECT_EQ(back.symmetry, "Isym 1, axial");
  EXPECT_EQ(back.lamp_lumens, 400.0);
  EXPECT_NEAR(back.distribution.opening.x, -0.2, kRoundoff);
  EXPECT_NEAR(back.lumens, file.lumens, kRoundoff * file.lumens * 10);
}

TEST(LdtWriter, StatesTheDownwardShareAndTheOutputRatio) {
  // Uniform over the sphere, 4π lm of 8π lm: half goes down, half is lost.
  auto file = synthetic([](double, double) { return 1.0; }, 1, 5);
  file.absolute = false;
  file.lamp_lumens = 8.0 * kPi;
  std::string text = toLdt(file);
  std::vector<double> lines;
  for (std::size_t at = 0; at != std::string::npos && lines.size() < 23;) {
    const std::size_t end = text.find("\r\n", at);
    lines.push_back(std::atof(text.substr(at, end - at).c_str()));
    at = end + 2;
  }
  EXPECT_NEAR(lines[21], 50.0, 100 * kRoundoff);
  EXPECT_NEAR(lines[22], 50.0, 100 * kRoundoff);
}

TEST(LdtWriter, AFolderThatIsNotThereIsAnError) {
  const auto r =
      writeLdt(std::filesystem::path(SOFFIT_BINARY_DIR) / "gone" / "f.ldt", synthetic(lobe, 4));
  ASSERT_FALSE(r.ok());
  EXPECT_THAT(r.error().message(), HasSubstr("the file cannot be written. Check that"));
}

}  // namespace
}  // namespace soffit::io
