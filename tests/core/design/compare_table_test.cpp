// SPDX-License-Identifier: MIT
#include "core/design/compare_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace soffit::design {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<LayoutFigures> twoLayouts() {
  std::vector<LayoutFigures> out(2);
  out[0].name = "As planned";
  out[1].name = "Pendants, \"free\"";
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<double> lux =
        i == 0 ? std::vector<double>{100, 300} : std::vector<double>{150, 200};
    out[i].planes = {{"Desks", photometry::fieldMetrics(lux)}};
    out[i].emitted_lm = 1000.0 * static_cast<double>(i + 1);
    out[i].installed_lm = 3000.0;
    out[i].luminaires_on = i + 1;
    out[i].lm_per_m2 = out[i].emitted_lm / 20.0;
  }
  return out;
}

TEST(CompareCsv, HasARowPerLayoutAndPlane) {
  EXPECT_EQ(compareCsv(twoLayouts()),
            "layout,work_plane,points,mean_lx,min_lx,max_lx,u0,ud,mean_difference_lx,"
            "mean_difference_percent,min_difference_lx,max_difference_lx,luminaires_on,emitted_lm,"
            "installed_lm,lm_per_m2\n"
            "As planned,Desks,2,200,100,300,0.5,0.333333333,0,0,0,0,1,1000,3000,50\n"
            "\"Pendants, \"\"free\"\"\",Desks,2,175,150,200,0.857142857,0.75,-25,-12.5,50,-100,2,"
            "2000,3000,100\n");
}

TEST(CompareCsv, LeavesAPercentageOfNothingEmpty) {
  auto layouts = twoLayouts();
  layouts[0].planes[0].lux = photometry::fieldMetrics(std::vector<double>{0, 0});
  EXPECT_THAT(compareCsv(layouts), HasSubstr("0.75,175,,150,200,2"));
}

TEST(CompareCsv, HasAllColumnsWithoutWorkPlanes) {
  auto layouts = twoLayouts();
  for (auto& l : layouts) l.planes.clear();
  const std::string text = compareCsv(layouts);
  EXPECT_THAT(text, HasSubstr("As planned,,0,,,,,,,,,,1,1000,3000,50\n"));
  const auto first_row = text.substr(text.find('\n') + 1, text.find("\n\"") - text.find('\n') - 1);
  EXPECT_EQ(
      std::count(first_row.begin(), first_row.end(), ','),
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find('\n')), ','));
}

TEST(CompareText, ShowsTheDifferenceToTheFirst) {
  const std::string text = compareText(twoLayouts());
  EXPECT_THAT(text, HasSubstr("Desks (2 points)"));
  EXPECT_THAT(text, HasSubstr("-25.0 lx"));
  EXPECT_THAT(text, HasSubstr("-12.5 %"));
  EXPECT_THAT(text, HasSubstr("100.0"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  EXPECT_EQ(compareText({}), "");
}

}  // namespace
}  // namespace soffit::design
