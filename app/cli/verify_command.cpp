// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/engine.h"
#include "app/cli/figures_json.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/design/compare_table.h"
#include "core/design/verify.h"
#include "core/io/project/csv.h"
#include "core/io/project/json.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <memory>
#include <string>

namespace soffit::cli {
namespace {

struct VerifyArguments {
  CommonOptions common;
  std::string sensors;
  std::string path;
  design::VerifyOptions verify;
};

std::string row(const std::string& name, const design::ErrorFigures& f) {
  return fmt::format("{:<28} {:>7} {:>10.2f} {:>8.3f} {:>8.3f} {:>9.3f} {:>8.3f} {:>9.3f}\n", name,
                     f.receivers, f.mean_lux, 100.0 * f.rms, 100.0 * f.rms_raw, 100.0 * f.bias,
                     100.0 * f.p95, 100.0 * f.reference_stderr);
}

std::string rows(const std::string& what, const design::LightErrors& errors) {
  std::string text = row(what, errors.receivers);
  for (const auto& zone : errors.zones) text += row("  " + zone.name, zone.figures);
  if (errors.work_planes) {
    text += row("  on work planes", *errors.work_planes);
    for (const auto& plane : errors.planes) text += row("    " + plane.name, plane.figures);
  }
  return text;
}

std::string toText(const design::VerifyReport& report, double seconds) {
  std::string text =
      fmt::format("{:<28} {:>7} {:>10} {:>8} {:>8} {:>9} {:>8} {:>9}\n", "errors in percent",
                  "points", "mean lx", "RMS", "raw RMS", "bias", "P95", "ref. s.e.");
  text += rows("all luminaires", report.total);
  if (report.luminaire) {
    text += rows(report.luminaire->name + " alone", report.luminaire->alone);
    for (const auto& p : report.luminaire->positions) {
      const std::string at =
          fmt::format("  at {:.2f}, {:.2f}, {:.2f}", p.position.x, p.position.y, p.position.z);
      text += row(at, p.alone.receivers) + row("    with the others", p.total.receivers);
    }
  }
  return text + fmt::format("{:.1f} s, {:.0f} million reference rays\n", seconds,
                            static_cast<double>(report.rays) / 1e6);
}

io::Json named(const std::vector<design::NamedFigures>& list, double seconds) {
  io::Json out = io::Json::object({});
  for (const auto& entry : list) out[entry.name] = figuresJson(entry.figures, seconds);
  return out;
}

io::Json toJson(const design::LightErrors& errors, double seconds) {
  io::Json out = figuresJson(errors.receivers, seconds);
  if (!errors.zones.empty()) out["zones"] = named(errors.zones, seconds);
  if (errors.work_planes) {
    io::Json planes = figuresJson(*errors.work_planes, seconds);
    planes["planes"] = named(errors.planes, seconds);
    out["work_planes"] = std::move(planes);
  }
  return out;
}

io::Json toJson(const design::VerifyReport& report, double seconds) {
  io::Json out = toJson(report.total, seconds);
  out["reached"] = report.reached;
  out["reference_rays"] = report.rays;
  if (!report.luminaire) return out;
  io::Json light = toJson(report.luminaire->alone, seconds);
  light["name"] = report.luminaire->name;
  io::JsonArray positions;
  for (const auto& p : report.luminaire->positions) {
    positions.push_back(
        io::Json::object({{"position", io::Json::array({p.position.x, p.position.y, p.position.z})},
                          {"alone", toJson(p.alone, seconds)},
                          {"total", toJson(p.total, seconds)}}));
  }
  if (!positions.empty()) light["positions"] = std::move(positions);
  out["luminaire"] = std::move(light);
  return out;
}

/// A row per point; names with commas are quoted.
std::string toCsv(const std::vector<design::VerifiedPoint>& points) {
  std::string text =
      "x,y,z,nx,ny,nz,set,zone,direct,indirect,total,reference_direct,reference_indirect,"
      "reference_total,stderr\n";
  for (const design::VerifiedPoint& p : points) {
    const dvec3& x = p.sensor.position;
    const dvec3& n = p.sensor.normal;
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{},", x.x, x.y, x.z, n.x, n.y,
                        n.z, design::csvField(p.set), design::csvField(p.zone));
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", p.value.direct,
                        p.value.indirect, p.value.direct + p.value.indirect, p.reference.direct,
                        p.reference.indirect, p.reference.direct + p.reference.indirect,
                        p.standard_error);
  }
  return text;
}

Result<void> runVerify(VerifyArguments arguments, Session& session) {
  const auto start = std::chrono::steady_clock::now();
  if (auto ok = checkResultFile(arguments.common.output); !ok) return ok;
  if (!arguments.path.empty()) {
    if (arguments.verify.luminaire.empty()) {
      return Error{"--path", "a path needs the luminaire that moves along it",
                   "Name it with --luminaire."};
    }
    auto path = io::readPath(arguments.path);
    if (!path) return path.error();
    arguments.verify.path = std::move(*path);
  }
  if (!arguments.sensors.empty()) {
    auto sensors = io::readSensors(arguments.sensors);
    if (!sensors) return sensors.error();
    arguments.verify.sensors = std::move(*sensors);
  }
  ProgressBar progress;
  const auto project = loadForCommand(arguments.common, session, &progress);
  if (!project) return project.error();
  const Job job = session.job(progress);
  const auto engine = makeEngine(*project, arguments.common, false, job, session);
  if (!engine) return engine.error();
  design::VerifyOptions& options = arguments.verify;
  options.sensor_rays = engine->quality.sensor_rays;
  options.effort.seed = arguments.common.seed;
  const auto report = design::verify(engine->solver, project->scene, options, job);
  if (!report) {
    Error error = report.error();
    error.place = fmt::format("{}: {}", project->path.string(), error.place);
    return error;
  }
  progress.clear();
  if (!arguments.common.output.empty()) {
    auto written = writeResult(arguments.common.output, toCsv(report->points));
    if (!written) return written;
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!report->reached) {
    session.warnings.push_back(
        fmt::format("the reference stopped at the time limit of {:g} s before every point had the "
                    "standard error {:g}; see reference_stderr",
                    options.effort.time_limit_s, options.effort.error));
  }
  if (arguments.common.json) {
    return writeResult("", io::formatJsonLine(toJson(*report, seconds)) + "\n");
  }
  return writeResult("", toText(*report, seconds));
}

}  // namespace

void addVerifyCommand(CLI::App& app, Session& session) {
  CLI::App* command =
      app.add_subcommand("verify", "Check the interactive light against the reference");
  auto arguments = std::make_shared<VerifyArguments>();
  arguments->verify.effort.time_limit_s = 600.0;
  addProjectArgument(*command, arguments->common);
  addLayoutOption(*command, arguments->common);
  addSetOption(*command, arguments->common);
  addComputeOptions(*command, arguments->common);
  addJsonOption(*command, arguments->common);
  addOutputOption(*command, arguments->common, "CSV file for every point with both solutions");
  CLI::Option* sensors = command->add_option(
      "--sensors", arguments->sensors, "Compare at these points instead: CSV with x,y,z,nx,ny,nz");
  command
      ->add_option("--receivers", arguments->verify.receivers,
                   "How many points to draw from lit surfaces")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str()
      ->excludes(sensors);
  command->add_option("--luminaire", arguments->verify.luminaire,
                      "Report this luminaire's own light too");
  command->add_option("--path", arguments->path,
                      "At these positions of it: CSV with x,y,z (the moved light alone)");
  command
      ->add_option("--error", arguments->verify.effort.error,
                   "Relative standard error of the reference to reach at every point")
      ->check(CLI::Range(1e-6, 1.0))
      ->capture_default_str();
  command
      ->add_option("--time-limit", arguments->verify.effort.time_limit_s,
                   "Seconds for the reference, after which what there is counts")
      ->check(positiveNumber())
      ->capture_default_str();
  command->callback([&session, arguments] {
    session.run = [arguments, &session] { return runVerify(*arguments, session); };
  });
}

}  // namespace soffit::cli
