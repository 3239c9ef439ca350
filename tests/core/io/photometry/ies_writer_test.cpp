// SPDX-License-Identifier: MIT
#include "core/io/photometry/ies_writer.h"

#include "core/io/photometry/ies_reader.h"
#include "core/io/photometry/text.h"
#include "tests/core/io/photometry/round_trip.h"

#include <gmock/gmock.h>

namespace soffit::io {
namespace {

double lobe(double c, double g) {
  return 1000.0 * (2.0 + std::cos(c - 0.3)) * std::exp(-g * g / 3);
}

TEST(IesWriter, RoundTripsToTheBit) {
  const struct {
    bool c0, c90;
    const char* symmetry;
    int stored;
  } cases[] = {{true, true, "quadrant 0-90", 7},
               {true, false, "bilateral 0-180", 13},
               {false, true, "bilateral 90-270", 13},
               {false, false, "none 0-360", 25}};
  for (const auto& k : cases) {
    const auto file =
        synthetic([&](double c, double g) { return lobe(foldedAngle(c, k.c0, k.c90), g); }, 24);
    const auto back = parseIes(toIes(file), "f.ies");
    ASSERT_TRUE(back.ok()) << back.error().message();
    EXPECT_EQ(back->symmetry, k.symmetry);
    EXPECT_EQ(back->n_horizontal, k.stored);
    EXPECT_EQ(back->distribution.c_deg, file.distribution.c_deg);
    EXPECT_EQ(back->distribution.gamma_deg, file.distribution.gamma_deg);
    EXPECT_EQ(back->distribution.candela, file.distribution.candela);
    EXPECT_EQ(back->distribution.opening, file.distribution.opening);
    EXPECT_EQ(back->distribution.name, "Synthetic");
    EXPECT_EQ(back->format, "IES LM-63-2019");
    EXPECT_EQ(back->watts, 12.5);
    EXPECT_TRUE(back->absolute);
    EXPECT_TRUE(back->warnings.empty());
  }
}

TEST(IesWriter, AxialTablesAndRoundOpeningsStayWhatTheyAre) {
  auto file = synthetic([](double, double g) { return 100.0 * std::cos(g); }, 1, 19, 90.0);
  file.distribution.candela.back() = 0.0;  // cos of a rounded π/2
  file.distribution.opening = {-0.2, -0.2, 0.0};
  file.absolute = false;
  file.lamp_lumens = 400.0;
  const auto back = parseIes(toIes(file), "f.ies");
  EXPECT_EQ(back.value().symmetry, "axial");
  EXPECT_EQ(back.value().distribution.opening, file.distribution.opening);
  EXPECT_EQ(back.value().lamp_lumens, 400.0);
  EXPECT_FALSE(back.value().absolute);
}

TEST(IesWriter, LongKeywordsContinueAndLinesStayShort) {
  auto file = synthetic(lobe, 24);
  file.keywords = {{"LUMINAIRE", std::string(300, 'x')}, {"LUMCAT", ""}};
  const std::string text = toIes(file);
  for (LineCursor lines(text); !lines.atEnd();) EXPECT_LE(lines.next().size(), 256u);
  const auto back = parseIes(text, "f.ies").value();
  EXPECT_EQ(back.keyword("LUMCAT"), "");
  std::string name = back.keyword("LUMINAIRE").value();
  std::erase(name, ' ');  // [MORE] joins with a blank
  EXPECT_EQ(name, std::string(300, 'x'));
}

TEST(IesWriter, AFolderThatIsNotThereIsAnError) {
  const auto r =
      writeIes(std::filesystem::path(SOFFIT_BINARY_DIR) / "gone" / "f.ies", synthetic(lobe, 4));
  ASSERT_FALSE(r.ok());
  EXPECT_THAT(r.error().message(), ::testing::HasSubstr("the file cannot be written. Check that"));
}

}  // namespace
}  // namespace soffit::io
