// SPDX-License-Identifier: MIT
// Writes the stored pictures anew: golden/README.md.
#include "tests/app/cli/run_program.h"
#include "tests/projects/golden_pictures.h"

#include <cstdio>

int main() {
  const soffit::TemporaryFolder folder;
  for (const soffit::GoldenPicture& picture : soffit::kGoldenPictures) {
    const std::string file = soffit::goldenFolder() + "/" + picture.file;
    auto command = soffit::renderCommand(picture, file);
    // Well baked and with little noise: what the coarse pictures of the test should look like.
    for (const char* word : {"--quality", "interactive", "--samples", "64"})
      command.push_back(word);
    const soffit::ProgramResult result = soffit::runSoffit(folder, command);
    if (result.status != 0) {
      std::fprintf(stderr, "%s: %s", picture.file, result.err.c_str());
      return 1;
    }
    std::printf("%s\n", file.c_str());
  }
  return 0;
}
