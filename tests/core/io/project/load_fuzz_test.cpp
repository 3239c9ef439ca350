// SPDX-License-Identifier: MIT
#include "core/io/project/csv.h"
#include "core/io/project/project.h"
#include "tests/core/io/project/example_project.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace soffit::io {
namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t n) {
  return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
}

/// Values that a wrong project is likely to hold, and some that none should.
const std::vector<std::string_view> kValues{"null",
                                            "true",
                                            "-1",
                                            "0",
                                            "1e308",
                                            "-1e-320",
                                            "1e999",
                                            "\"\"",
                                            "\"point\"",
                                            "[]",
                                            "{}",
                                            "[[]]",
                                            "[1,2,3]",
                                            "[1,2]",
                                            "{\"name\":\"\"}",
                                            "\"../../etc/passwd\"",
                                            "\"quad.obj\"",
                                            "\"\\u0000\"",
                                            "99999999999999999999",
                                            "\"Panel 1\"",
                                            "[{\"name\":\"Panel 1\"}]"};

/// Changes the text at a few random places, by bytes and by values.
std::string mutated(std::string text, Random& random) {
  const std::size_t changes = 1 + below(random, 4);
  for (std::size_t k = 0; k < changes && !text.empty(); ++k) {
    const std::size_t at = below(random, text.size());
    switch (below(random, 5)) {
      case 0:
        text[at] = static_cast<char>(below(random, 256));
        break;
      case 1:
        text.erase(at, 1 + below(random, 20));
        break;
      case 2:
        text.insert(at,
                    std::string(text.substr(below(random, text.size()), 1 + below(random, 30))));
        break;
      default: {
        // A whole value, so that what follows the parser is reached.
        const std::size_t colon = text.find(": ", at);
        if (colon == std::string::npos) break;
        const std::size_t end = text.find_first_of(",}\n", colon);
        text.replace(colon + 2, end == std::string::npos ? 0 : end - colon - 2,
                     kValues[below(random, kValues.size())]);
      }
    }
  }
  return text;
}

TEST(LoadFuzz, AMutatedProjectLoadsOrSaysWhy) {
  const ProjectFolder folder;
  Random random(20240501);
  int loaded = 0;
  constexpr int kRounds = 1500;
  // Reading a model takes longer than all the rest; one round in 16 does.
  std::string no_geometry = kFullProject;
  const std::size_t list = no_geometry.find("[{ \"file\"");
  no_geometry.replace(list, no_geometry.find("}]", list) + 2 - list, "[]");
  for (int round = 0; round < kRounds; ++round) {
    const std::string text = mutated(round % 16 == 0 ? kFullProject : no_geometry, random);
    const auto project = folder.load(text);
    if (project) {
      ++loaded;
      ASSERT_TRUE(formatProject(*project)) << text;
    } else {
      const std::string message = project.error().message();
      ASSERT_FALSE(message.empty());
      ASSERT_EQ(message.find('\n'), std::string::npos);
      ASSERT_TRUE(folder.local(message).starts_with("p.soffit")) << message << "\n" << text;
    }
  }
  // Both ways are taken, or the test would say nothing.
  EXPECT_GT(loaded, kRounds / 50);
  EXPECT_LT(loaded, kRounds - kRounds / 5);
}

TEST(LoadFuzz, MutatedSettingsApplyOrSayWhy) {
  const ProjectFolder folder;
  const auto project = folder.load(kFullProject);
  ASSERT_TRUE(project);
  Random random(7);
  const std::vector<std::string> seeds{"luminaires.Panel 1.position=2,1,2.7",
                                       "materials.wall.diffuse=0.8,0.8,0.8",
                                       "quality=final",
                                       "luminaires.Spot 1.2.shape={\"disk\":0.1}",
                                       "environment.sky.cie=3",
                                       "luminaires[1].flux=3"};
  for (int round = 0; round < 1500; ++round) {
    LoadOptions options;
    options.sets = {mutated(seeds[below(random, seeds.size())], random)};
    const auto variant = variantOf(*project, options);
    if (!variant) {
      ASSERT_EQ(variant.error().message().find('\n'), std::string::npos);
    }
  }
}

TEST(LoadFuzz, MutatedTablesParseOrSayWhy) {
  Random random(11);
  const std::string seed = "x,y,z,nx,ny,nz\n1,2,3,0,0,1\n4.5,-5e-3,6,0.1,0.2,1\n";
  for (int round = 0; round < 5000; ++round) {
    const auto sensors = parseSensors(mutated(seed, random), "s.csv");
    if (!sensors) continue;
    for (const scene::Sensor& sensor : *sensors) {
      ASSERT_TRUE(isFinite(sensor.position));
      ASSERT_TRUE(isFinite(sensor.normal));
    }
  }
}

}  // namespace
}  // namespace soffit::io
