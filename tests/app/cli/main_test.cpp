// SPDX-License-Identifier: MIT
#include "tests/app/cli/run_program.h"
#include "tests/core/io/project/example_project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace soffit {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Program, HelpAndVersionSucceed) {
  const TemporaryFolder folder;
  const auto help = runSoffit(folder, {"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  for (const char* command : {"info", "import", "luminaire"})
    EXPECT_THAT(help.out, HasSubstr(command));
  const auto version = runSoffit(folder, {"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, StartsWith("soffit "));
  const auto sub = runSoffit(folder, {"info", "--help"});
  EXPECT_EQ(sub.status, 0);
  EXPECT_THAT(sub.out, HasSubstr("--layout"));
}

TEST(Program, WrongUsageEndsWithStatusTwoAndOneLine) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"info"},
                                                {"info", "--nonsense"},
                                                {"--nonsense"},
                                                {"info", "P", "--threads", "many"},
                                                {"info", "P", "--threads", "0"},
                                                {"info", "P", "--quality", "best"},
                                                {"import", "model.obj"},
                                                {"luminaire"},
                                                {"info", "P", "luminaire", "F"}}) {
    const auto result = runSoffit(folder, words);
    EXPECT_EQ(result.status, 2) << words.back();
    EXPECT_EQ(result.errorLines(), 1) << result.err;
    EXPECT_THAT(result.err, StartsWith("soffit: "));
    EXPECT_EQ(result.out, "");
  }
}

TEST(Program, WrongInputEndsWithStatusOneAndOneLine) {
  const io::ProjectFolder folder;
  const std::string file = folder.write("p.soffit", R"({"soffit": 1, "luminaires": [
      {"name": "A", "shape": "point", "flux": -1}]})");
  const auto result = runSoffit(folder, {"info", file});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errorLines(), 1) << result.err;
  EXPECT_THAT(result.err, StartsWith("soffit: " + file + ": luminaires.A.flux: "));
  EXPECT_EQ(result.out, "");
}

TEST(Program, AFailureHasItsOneLineInSpiteOfWarnings) {
  const io::ProjectFolder folder;
  const std::string file = folder.write("p.soffit", R"({"soffit": 1, "unknown": 1})");
  const auto result = runSoffit(folder, {"info", file, "--layout", "None"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errorLines(), 1) << result.err;
}

TEST(Program, ResultsThatCannotBeWrittenAreAnError) {
  const io::ProjectFolder folder;
  const std::string file = folder.write("p.soffit", R"({"soffit": 1})");
  const auto result = runSoffit(folder, {"info", file}, "/dev/full");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, StartsWith("soffit: standard output: the result cannot be written"));
}

TEST(Program, ProgressIsOnlyForTerminals) {
  const io::ProjectFolder folder;
  const std::string file =
      folder.write("p.soffit", R"({"soffit": 1, "geometry": [{"file": "quad.obj"}]})");
  const auto result = runSoffit(folder, {"info", file});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
}

TEST(Program, WithoutASubcommandItStartsTheApplicationBesideIt) {
  // A copy of the program with an application of our own beside it.
  const io::ProjectFolder folder;
  const std::string program = (folder.path() / "soffit").string();
  std::filesystem::copy_file(SOFFIT_PROGRAM, program);
  const std::string project = folder.write("p.soffit", R"({"soffit": 1})");

  const auto missing = runProgram(folder, program, {project});
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(missing.errorLines(), 1) << missing.err;
  EXPECT_THAT(missing.err,
              HasSubstr("soffit-gui: the application cannot be started: No such file"));

  const auto gui = folder.write("soffit-gui", "#!/bin/sh\necho \"opened $1\"\nexit 7\n");
  std::filesystem::permissions(gui, std::filesystem::perms::owner_all);
  const auto opened = runProgram(folder, program, {project});
  EXPECT_EQ(opened.status, 7) << "the program became the application";
  EXPECT_EQ(opened.out, "opened " + project + "\n");
  EXPECT_EQ(runProgram(folder, program, {}).out, "opened \n");

  const auto typo = runProgram(folder, program, {"rendre"});
  EXPECT_EQ(typo.status, 1);
  EXPECT_THAT(typo.err, HasSubstr("no such project, and no such subcommand"));
}

}  // namespace
}  // namespace soffit
