// SPDX-License-Identifier: MIT
#include "core/color/display_shader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace soffit::color {
namespace {

using testing::HasSubstr;

// That the shader computes what the processor computes is tested on a graphics card, in
// tests/ui/viewport/scene_view_test.cpp.

TEST(DisplayShader, EveryViewOfTheOwnConfigHasOne) {
  for (const char* view : {"Filmic", "ACES", "sRGB", "Reinhard", kFalseColorView}) {
    DisplayChoice choice;
    choice.view = view;
    const auto shader = makeDisplayShader(choice);
    ASSERT_TRUE(shader) << view << ": " << shader.error().message();
    EXPECT_THAT(shader->text, HasSubstr("vec4 soffitView(")) << view;
  }
}

TEST(DisplayShader, TablesAreCompleteAndNamedInTheText) {
  DisplayChoice choice;
  choice.view = "Filmic";
  const auto shader = makeDisplayShader(choice);
  ASSERT_TRUE(shader);
  ASSERT_FALSE(shader->tables.empty()) << "the tone curve is a table";
  for (const ShaderTable& table : shader->tables) {
    EXPECT_THAT(shader->text, HasSubstr(table.sampler));
    EXPECT_EQ(table.values.size(), static_cast<std::size_t>(table.width) *
                                       static_cast<std::size_t>(table.height) *
                                       static_cast<std::size_t>(table.depth) *
                                       static_cast<std::size_t>(table.channels));
  }
}

TEST(DisplayShader, AnUnknownViewNamesThoseThatAreThere) {
  DisplayChoice choice;
  choice.view = "Sepia";
  const auto shader = makeDisplayShader(choice);
  ASSERT_FALSE(shader);
  EXPECT_THAT(shader.error().message(), HasSubstr("no view \"Sepia\""));
  EXPECT_THAT(shader.error().message(), HasSubstr("Filmic"));
}

}  // namespace
}  // namespace soffit::color
