// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/common_options.h"
#include "app/cli/output.h"
#include "core/io/photometry/photometric_file.h"
#include "core/io/photometry/summary.h"
#include "core/io/project/json.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace soffit::cli {
namespace {

struct LuminaireOptions {
  std::string file;
  CommonOptions common;
};

io::Json anglesJson(const photometry::PrincipalAngles& angles) {
  return io::Json::array({angles.c0_deg, angles.c90_deg});
}

io::Json summaryJson(const io::PhotometrySummary& summary) {
  io::JsonArray warnings;
  for (const std::string& warning : summary.warnings) warnings.emplace_back(warning);
  return io::Json::object({{"format", summary.format},
                           {"lumens", summary.lumens},
                           {"n_vertical", summary.n_vertical},
                           {"n_horizontal", summary.n_horizontal},
                           {"symmetry", summary.symmetry},
                           {"name", summary.name},
                           {"peak_cd", summary.peak_cd},
                           {"beam_deg", anglesJson(summary.beam_deg)},
                           {"field_deg", anglesJson(summary.field_deg)},
                           {"absolute", summary.absolute},
                           {"watts", summary.watts},
                           {"warnings", warnings}});
}

Result<void> runLuminaire(const LuminaireOptions& options) {
  const auto file = io::readPhotometry(options.file);
  if (!file) return file.error();
  const io::PhotometrySummary summary = io::summarize(*file);
  if (options.common.json) return writeResult("", io::formatJsonLine(summaryJson(summary)) + "\n");
  return writeResult("", io::toText(summary));
}

}  // namespace

void addLuminaireCommand(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand(
      "luminaire", "Describe an IES or LDT file: lumens, angles, symmetry, beam, warnings");
  auto options = std::make_shared<LuminaireOptions>();
  command->add_option("FILE", options->file, "Photometric file")->required();
  addJsonOption(*command, options->common);
  command->callback(
      [&session, options] { session.run = [options] { return runLuminaire(*options); }; });
}

}  // namespace soffit::cli
