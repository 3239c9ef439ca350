// SPDX-License-Identifier: MIT
#include "core/io/project/probes.h"

#include "core/io/project/report.h"
#include "core/math/vec.h"

#include <gtest/gtest.h>

namespace soffit::io {
namespace {

Json parsed(const char* text) {
  auto json = parseJson(text, "test");
  EXPECT_TRUE(json.ok());
  return json.ok() ? *json : Json();
}

TEST(Probes, AreReadAndWrittenBackBitForBit) {
  const Json root = parsed(
      R"({"soffit": 1, "probes": [{"name": "Desk", "position": [1.1, 2, 0.75], "normal": [0, 0, 2]},
          {"name": "Wall", "position": [0, 0.3, 1], "normal": [1, 0, 0]}]})");
  const auto probes = probesOf(root);
  ASSERT_EQ(probes.size(), 2U);
  EXPECT_EQ(probes[0].name, "Desk");
  EXPECT_EQ(probes[0].position, dvec3(1.1, 2.0, 0.75));
  EXPECT_EQ(probes[0].normal, dvec3(0.0, 0.0, 1.0));  // made a unit
  Json written = parsed(R"({"soffit": 1, "mine": true})");
  syncProbes(probes, written);
  EXPECT_EQ(probesOf(*parseJson(formatJson(written), "again")), probes);
  EXPECT_NE(written.find("mine"), nullptr);
}

TEST(Probes, WhatIsTheSameIsNotTouched) {
  Json root = parsed(R"({"probes": [{"name": "A", "position": [1.50, 0, 0], "note": "kept"}]})");
  const std::string before = formatJson(root);
  syncProbes(probesOf(root), root);
  EXPECT_EQ(formatJson(root), before);
  syncProbes({}, root);
  EXPECT_EQ(root.find("probes"), nullptr);
}

TEST(Probes, FaultsNameTheirPlace) {
  const auto fault = [](const char* text) {
    Report report("room.soffit");
    const Json json = parsed(text);
    (void)readProbes(*json.find("probes"), "probes", report);
    return report.failed() ? report.error().message() : std::string();
  };
  EXPECT_NE(fault(R"({"probes": 3})").find("expected a list of probes"), std::string::npos);
  EXPECT_NE(fault(R"({"probes": [{"name": "A"}]})").find("probes.A.position"), std::string::npos);
  EXPECT_NE(fault(R"({"probes": [{"name": "A", "position": [0,0,0], "normal": [0,0,0]}]})")
                .find("probes.A"),
            std::string::npos);
}

}  // namespace
}  // namespace soffit::io
