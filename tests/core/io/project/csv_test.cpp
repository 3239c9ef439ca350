// SPDX-License-Identifier: MIT
#include "core/io/project/csv.h"

#include "tests/core/io/project/temporary_folder.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace soffit::io {
namespace {

std::string errorOf(std::string_view text) {
  const auto sensors = parseSensors(text, "s.csv");
  return sensors ? std::string() : sensors.error().message();
}

TEST(ParseSensors, ReadsPositionsAndUnitNormals) {
  const auto sensors = parseSensors("x,y,z,nx,ny,nz\n1,2,0.8,0,0,2\n-1.5e0,+2,3,3,0,4\n", "s.csv");
  ASSERT_TRUE(sensors);
  ASSERT_EQ(sensors->size(), 2U);
  EXPECT_EQ((*sensors)[0].position, dvec3(1, 2, 0.8));
  EXPECT_EQ((*sensors)[0].normal, dvec3(0, 0, 1));
  EXPECT_EQ((*sensors)[1].position, dvec3(-1.5, 2, 3));
  constexpr double kRoundoff = 4 * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR((*sensors)[1].normal.x, 0.6, kRoundoff);
  EXPECT_NEAR((*sensors)[1].normal.z, 0.8, kRoundoff);
}

TEST(ParseSensors, ToleratesWhatSpreadsheetsWrite) {
  const std::string unix_text = "x,y,z,nx,ny,nz\n1,2,3,0,0,1\n4,5,6,0,0,1\n";
  const auto plain = parseSensors(unix_text, "s.csv");
  ASSERT_TRUE(plain);
  for (const std::string text : {"\xEF\xBB\xBFx,y,z,nx,ny,nz\r\n1,2,3,0,0,1\r\n4,5,6,0,0,1\r\n",
                                 "X, Y ,Z,\tNX,nY,nz\n 1 , 2 ,3,0, 0,1 \n\n4,5,6,0,0,1",
                                 "x,y,z,nx,ny,nz\r1,2,3,0,0,1\r4,5,6,0,0,1\r",
                                 "\"x\",\"y\",\"z\",\"nx\",\"ny\",\"nz\"\n\"1\",\"2\",\"3\",\"0\","
                                 "\"0\",\"1\"\n4,5,6,0,0,1\n"}) {
    const auto sensors = parseSensors(text, "s.csv");
    ASSERT_TRUE(sensors) << text;
    ASSERT_EQ(sensors->size(), 2U) << text;
    EXPECT_EQ((*sensors)[1].position, (*plain)[1].position) << text;
  }
}

TEST(ParseSensors, NormalsOfAnySizeAreScaled) {
  const auto sensors =
      parseSensors("x,y,z,nx,ny,nz\n0,0,0,1e-300,0,0\n0,0,0,0,-1e300,0\n0,0,0,5e-324,0,0\n", "s");
  ASSERT_TRUE(sensors);
  EXPECT_EQ((*sensors)[0].normal, dvec3(1, 0, 0));
  EXPECT_EQ((*sensors)[1].normal, dvec3(0, -1, 0));
  EXPECT_EQ((*sensors)[2].normal, dvec3(1, 0, 0));
}

TEST(ParseSensors, ErrorsNameTheLine) {
  EXPECT_EQ(errorOf("1,2,3,0,0,1\n"),
            "s.csv:1: expected the header \"x,y,z,nx,ny,nz\". Put it in the first line.");
  EXPECT_EQ(errorOf("x,y,z,nx,ny,nz\n1,2,3,0,0\n"),
            "s.csv:2: expected 6 numbers, found 5 fields. Separate the numbers by commas, with "
            "decimal points.");
  EXPECT_EQ(errorOf("x,y,z,nx,ny,nz\n\n1,2,3,0,0,1\n1,2,nan,0,0,1\n"),
            "s.csv:4: expected a finite number, found \"nan\". Write it with a decimal point, in "
            "metres.");
  EXPECT_EQ(errorOf("x,y,z,nx,ny,nz\n1,2,1e999,0,0,1\n").substr(0, 36),
            "s.csv:2: expected a finite number, f");
  EXPECT_EQ(
      errorOf("x,y,z,nx,ny,nz\n1,2,,0,0,1\n"),
      "s.csv:2: expected a finite number, found \"\". Write it with a decimal point, in metres.");
  EXPECT_EQ(errorOf("x,y,z,nx,ny,nz\n1,2,1e30,0,0,1\n"),
            "s.csv:2: expected numbers up to 1e+07, found \"1e30\". Write coordinates in metres.");
  EXPECT_EQ(errorOf("x,y,z,nx,ny,nz\n1,2,3,0,0,0\n"),
            "s.csv:2: the normal nx,ny,nz has no length. Give the direction that the sensor faces, "
            "0,0,1 for upward.");
  EXPECT_EQ(errorOf("x,y,z,nx,ny,nz\n"),
            "s.csv: there are no points in the file. It needs the header \"x,y,z,nx,ny,nz\" and a "
            "row for each point.");
  EXPECT_EQ(errorOf(""), errorOf("\n\n"));
}

TEST(ParsePath, ReadsThreeColumns) {
  const auto path = parsePath("x,y,z\n1,2,3\n4,5,6\n", "p.csv");
  ASSERT_TRUE(path);
  EXPECT_EQ((*path)[1], dvec3(4, 5, 6));
  EXPECT_FALSE(parsePath("x,y,z,nx,ny,nz\n1,2,3,0,0,1\n", "p.csv"));
}

TEST(ReadSensors, NamesTheFile) {
  const TemporaryFolder folder;
  const auto file = folder.write("s.csv", "x,y,z,nx,ny,nz\n1,2,3,0,0,1\n");
  ASSERT_TRUE(readSensors(file));
  EXPECT_EQ(readSensors(file)->size(), 1U);
  const auto missing = readPath(folder.path() / "none.csv");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().message(),
            (folder.path() / "none.csv").string() + ": there is no such file. Check the name.");
}

}  // namespace
}  // namespace soffit::io
