// SPDX-License-Identifier: MIT
// What scripts may rely on: columns, keys and units, line by line.
#include "core/io/image/read_image.h"
#include "core/io/project/json.h"
#include "tests/app/cli/run_program.h"
#include "tests/app/cli/small_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace soffit {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::StartsWith;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbersOf(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) numbers.push_back(std::stod(field));
  return numbers;
}

std::vector<std::string> keysOf(const io::Json& json) {
  std::vector<std::string> keys;
  if (json.asObject() == nullptr) return keys;
  for (const io::JsonMember& member : *json.asObject()) keys.push_back(member.key);
  return keys;
}

/// What a call prints with --json; a failed expectation when it is no single object.
io::Json jsonOf(const SmallRoom& room, std::vector<std::string> words) {
  words.emplace_back("--json");
  const auto result = runSoffit(room, words);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(linesOf(result.out).size(), 1U) << result.out;
  auto json = io::parseJson(result.out, "stdout");
  EXPECT_TRUE(json) << result.out;
  return json ? *json : io::Json();
}

double number(const io::Json& json, const char* key) {
  const io::Json* found = json.find(key);
  EXPECT_TRUE(found != nullptr && found->asNumber() != nullptr) << key;
  return found != nullptr && found->asNumber() != nullptr ? found->asNumber()->value : NAN;
}

TEST(Interfaces, MeasureWritesItsColumnsInTheOrderOfTheSensors) {
  const SmallRoom room;
  const auto result =
      runSoffit(room, {"measure", room.file(), "--sensors", room.at("sensors.csv")});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto lines = linesOf(result.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "x,y,z,nx,ny,nz,direct,indirect,total");
  const auto first = numbersOf(lines[1]);
  ASSERT_EQ(first.size(), 9U);
  EXPECT_EQ(std::vector<double>(first.begin(), first.begin() + 6),
            (std::vector<double>{2, 1.5, 0.8, 0, 0, 1}));
  // Printed with at least 7 digits each.
  EXPECT_NEAR(first[6] + first[7], first[8], 1e-6 * first[8]);
  EXPECT_EQ(numbersOf(lines[3])[0], 3.0);
  // On the axis of a small Lambertian panel, E = I/d² to a few percent: it reaches the sensor.
  EXPECT_GT(first[6], 300.0);
}

TEST(Interfaces, MeasureToAFilePrintsNothingElse) {
  const SmallRoom room;
  const auto result = runSoffit(room, {"measure", room.file(), "-o", room.at("out.csv")});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(linesOf(room.read("out.csv")).size(), 5U) << "four cells of the work plane";
  const io::Json json = jsonOf(room, {"measure", room.file()});
  EXPECT_THAT(keysOf(json), ElementsAre("seconds", "sensors"));
  ASSERT_EQ(json.find("sensors")->asArray()->size(), 4U);
  EXPECT_THAT(keysOf(json.find("sensors")->asArray()->front()),
              ElementsAre("direct", "indirect", "total"));
}

TEST(Interfaces, MeasureHasFiveQuantities) {
  const SmallRoom room;
  for (const char* name :
       {"planar", "cylindrical", "semicylindrical", "spherical", "hemispherical"}) {
    const auto result = runSoffit(
        room, {"measure", room.file(), "--sensors", room.at("sensors.csv"), "--quantity", name});
    EXPECT_EQ(result.status, 0) << name << result.err;
    for (const std::string& line : linesOf(result.out)) EXPECT_THAT(line, Not(HasSubstr("nan")));
  }
}

TEST(Interfaces, ReferenceAddsAStandardError) {
  const SmallRoom room;
  const auto result = runSoffit(
      room, {"reference", room.file(), "--sensors", room.at("sensors.csv"), "--error", "0.2"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto lines = linesOf(result.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "x,y,z,nx,ny,nz,direct,indirect,total,stderr");
  EXPECT_EQ(numbersOf(lines[1]).size(), 10U);
}

TEST(Interfaces, MoveWritesARowPerPosition) {
  const SmallRoom room;
  const std::vector<std::string> call{
      "move",   room.file(),         "--luminaire", "Panel",
      "--path", room.at("path.csv"), "--sensors",   room.at("sensors.csv")};
  auto words = call;
  words.insert(words.end(), {"-o", room.at("move.csv")});
  const auto result = runSoffit(room, words);
  ASSERT_EQ(result.status, 0) << result.err;
  const auto lines = linesOf(room.read("move.csv"));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_THAT(lines[0], testing::MatchesRegex("x,y,z,ms(,[a-z_]+_ms)+,E0,E1,E2"));
  const io::Json json = jsonOf(room, call);
  EXPECT_THAT(keysOf(json), IsSupersetOf({"receivers", "positions", "median_ms", "p99_ms",
                                          "stages_ms", "rays", "rays_avoided"}));
  EXPECT_EQ(number(json, "positions"), 3.0);
}

TEST(Interfaces, ASecondBakeComesFromTheCache) {
  const SmallRoom room;
  const io::Json first = jsonOf(room, {"bake", room.file()});
  EXPECT_THAT(keysOf(first), IsSupersetOf({"seconds", "first_result_seconds", "bytes", "cached"}));
  EXPECT_FALSE(*first.find("cached")->asBool());
  EXPECT_TRUE(*jsonOf(room, {"bake", room.file()}).find("cached")->asBool());
  // Neither luminaires nor reflectances nor layouts are in the bake.
  EXPECT_TRUE(*jsonOf(room, {"bake", room.file(), "--set", "luminaires.Panel.flux=5", "--set",
                             "materials.paint.diffuse=0.2,0.2,0.2"})
                   .find("cached")
                   ->asBool());
  EXPECT_FALSE(*jsonOf(room, {"bake", room.file(), "--no-cache"}).find("cached")->asBool());
}

TEST(Interfaces, VerifyReportsErrorsAsFractions) {
  const SmallRoom room;
  const io::Json json = jsonOf(
      room, {"verify", room.file(), "--receivers", "50", "--error", "0.2", "--luminaire", "Lamp"});
  const std::vector<std::string> keys{"receivers", "mean_lux",         "rms",    "p95",
                                      "bias",      "reference_stderr", "seconds"};
  EXPECT_THAT(keysOf(json), IsSupersetOf(keys));
  EXPECT_EQ(number(json, "receivers"), 50.0);
  ASSERT_NE(json.find("work_planes"), nullptr);
  EXPECT_THAT(keysOf(*json.find("work_planes")), IsSupersetOf(keys));
  ASSERT_NE(json.find("luminaire"), nullptr);
  EXPECT_THAT(keysOf(*json.find("luminaire")), IsSupersetOf(keys));
}

TEST(Interfaces, CompareWritesATableAndPictures) {
  const SmallRoom room;
  const auto result =
      runSoffit(room, {"compare", room.file(), "-o", room.at("c"), "--size", "32x20"});
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* file :
       {"c/compare.csv", "c/Both.png", "c/Panel alone.png", "c/Panel alone minus Both.png"}) {
    EXPECT_TRUE(room.has(file)) << file;
  }
  const io::Json json = jsonOf(room, {"compare", room.file(), "--layouts", "Panel alone,Both"});
  ASSERT_EQ(json.find("layouts")->asArray()->size(), 2U);
  EXPECT_EQ(*json.find("layouts")->asArray()->front().find("name")->asText(), "Panel alone");
}

TEST(Interfaces, LayoutsAndSettingsActInThisOrder) {
  const SmallRoom room;
  const auto lux = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"measure", room.file(), "--sensors", room.at("sensors.csv")};
    words.insert(words.end(), more.begin(), more.end());
    return numbersOf(linesOf(runSoffit(room, words).out).at(1)).at(6);
  };
  const double both = lux({});
  const double panel = lux({"--layout", "Panel alone"});
  EXPECT_LT(panel, both);
  EXPECT_EQ(lux({"--layout", "Panel alone", "--set", "luminaires.Lamp.on=true"}), both);
  // Direct light is linear in the flux; the rest is rounding of what is printed.
  EXPECT_NEAR(lux({"--layout", "Panel alone", "--set", "luminaires.Panel.flux=6000"}), 2.0 * panel,
              1e-6 * panel);
}

TEST(Interfaces, SceneLinearPicturesHoldLuminanceWithoutExposure) {
  const SmallRoom room;
  const auto picture = [&](const std::string& name, const std::string& stops) {
    const auto result = runSoffit(
        room, {"render", room.file(), "-o", room.at(name), "--size", "24x16", "--exposure", stops});
    EXPECT_EQ(result.status, 0) << result.err;
    const auto image = io::readImage(room.at(name));
    EXPECT_TRUE(image) << name;
    return image ? image->pixels : std::vector<float>();
  };
  EXPECT_EQ(picture("a.exr", "0"), picture("b.exr", "3"));
  EXPECT_NE(picture("a.png", "0"), picture("b.png", "3"));
}

TEST(Interfaces, ResultsDoNotDependOnTheThreads) {
  const SmallRoom room;
  const auto rows = [&](const char* threads) {
    return runSoffit(room, {"measure", room.file(), "-o", "-", "--no-cache", "--threads", threads})
        .out;
  };
  const std::string one = rows("1");
  EXPECT_THAT(one, StartsWith("x,y,z"));
  EXPECT_EQ(one, rows("3"));
}

TEST(Interfaces, AFolderMayBeGivenForTheProject) {
  const SmallRoom room;
  EXPECT_EQ(runSoffit(room, {"info", room.path().string()}).status, 0);
  room.write("other.soffit", R"({"soffit": 1})");
  const auto two = runSoffit(room, {"info", room.path().string()});
  EXPECT_EQ(two.status, 1);
  EXPECT_EQ(two.errorLines(), 1) << two.err;
}

TEST(Interfaces, InfoHasItsKeysAndItsRooms) {
  const SmallRoom room;
  const io::Json json = jsonOf(room, {"info", room.file()});
  EXPECT_THAT(keysOf(json),
              IsSupersetOf({"triangles", "receivers", "luminaires", "needed", "skipped"}));
  EXPECT_EQ(number(json, "receivers"), 600.0);
  ASSERT_EQ(json.find("rooms")->asArray()->size(), 1U);
  // A band of half a cell (0.15 m) along the walls is uncertain.
  EXPECT_NEAR(number(json.find("rooms")->asArray()->front(), "area"), 12.0, 14.0 * 0.15);
  EXPECT_THAT(keysOf(json), Contains("reflectances"));
}

}  // namespace
}  // namespace soffit
