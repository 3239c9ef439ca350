// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/core/io/project/temporary_folder.h"

extern char** environ;

namespace soffit {

struct ProgramResult {
  int status = -1;  ///< exit status; -1 when the program did not exit by itself
  std::string out;
  std::string err;

  [[nodiscard]] long errorLines() const { return std::count(err.begin(), err.end(), '\n'); }
};

/// Runs a program with its output in files, stdin empty; `folder` holds the output.
inline ProgramResult runProgram(const TemporaryFolder& folder, const std::string& program,
                                const std::vector<std::string>& arguments,
                                const std::string& out_file = "") {
  const std::string out = out_file.empty() ? (folder.path() / "stdout.txt").string() : out_file;
  const std::string err = (folder.path() / "stderr.txt").string();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ProgramResult result;
  pid_t child = 0;
  int state = 0;
  if (posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ) == 0 &&
      waitpid(child, &state, 0) == child && WIFEXITED(state)) {
    result.status = WEXITSTATUS(state);
  }
  posix_spawn_file_actions_destroy(&actions);
  if (out_file.empty()) result.out = folder.read("stdout.txt");
  result.err = folder.read("stderr.txt");
  return result;
}

/// Runs the built `soffit`.
inline ProgramResult runSoffit(const TemporaryFolder& folder,
                               const std::vector<std::string>& arguments,
                               const std::string& out_file = "") {
  return runProgram(folder, SOFFIT_PROGRAM, arguments, out_file);
}

}  // namespace soffit
