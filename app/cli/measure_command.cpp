// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/engine.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/io/project/json.h"
#include "core/photometry/metrics.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace soffit::cli {
namespace {

struct MeasureArguments {
  CommonOptions common;
  std::string sensors;
  std::string quantity = "planar";
};

Result<relight::Quantity> parseQuantity(const std::string& text) {
  if (text == "planar") return relight::Quantity::planar;
  if (text == "cylindrical") return relight::Quantity::cylindrical;
  if (text == "semicylindrical") return relight::Quantity::semicylindrical;
  if (text == "spherical") return relight::Quantity::spherical;
  if (text == "hemispherical") return relight::Quantity::hemispherical;
  return Error{"--quantity", fmt::format("there is no quantity \"{}\"", text),
               "Choose planar, cylindrical, semicylindrical, spherical or hemispherical."};
}

struct Row {
  scene::Sensor sensor;
  double direct, indirect;
};

std::string toCsv(const std::vector<Row>& rows) {
  std::string text = "x,y,z,nx,ny,nz,direct,indirect,total\n";
  for (const Row& r : rows) {
    const dvec3& p = r.sensor.position;
    const dvec3& n = r.sensor.normal;
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", p.x,
                        p.y, p.z, n.x, n.y, n.z, r.direct, r.indirect, r.direct + r.indirect);
  }
  return text;
}

io::Json toJson(const std::vector<Row>& rows, double seconds) {
  io::JsonArray sensors;
  for (const Row& r : rows) {
    sensors.push_back(io::Json::object(
        {{"direct", r.direct}, {"indirect", r.indirect}, {"total", r.direct + r.indirect}}));
  }
  return io::Json::object({{"seconds", seconds}, {"sensors", sensors}});
}

/// One line per work plane: mean, least and greatest lux and uniformity.
std::string summary(const scene::Scene& scene, const std::vector<Row>& rows) {
  std::string text = fmt::format("{:<24} {:>7} {:>9} {:>9} {:>9} {:>6}\n", "work plane", "points",
                                 "mean lx", "min lx", "max lx", "U0");
  std::size_t at = 0;
  for (const scene::WorkPlane& plane : scene.work_planes) {
    std::vector<double> values;
    for (std::size_t k = 0;
         k < static_cast<std::size_t>(plane.nu) * static_cast<std::size_t>(plane.nv); ++k) {
      values.push_back(rows[at].direct + rows[at].indirect);
      ++at;
    }
    double sum = 0.0;
    double low = 1e300;
    double high = 0.0;
    for (const double v : values) {
      sum += v;
      low = std::min(low, v);
      high = std::max(high, v);
    }
    const double mean = sum / static_cast<double>(values.size());
    text += fmt::format("{:<24} {:>7} {:>9.1f} {:>9.1f} {:>9.1f} {:>6.2f}\n", plane.name,
                        values.size(), mean, low, high, mean > 0.0 ? low / mean : 0.0);
  }
  return text;
}

Result<void> runMeasure(const MeasureArguments& arguments, Session& session) {
  const auto start = std::chrono::steady_clock::now();
  const CommonOptions& common = arguments.common;
  if (auto writable = checkResultFile(common.output); !writable) return writable;
  const auto quantity = parseQuantity(arguments.quantity);
  if (!quantity) return quantity.error();
  ProgressBar progress;
  const auto project = loadForCommand(common, session, &progress);
  if (!project) return project.error();
  const auto sensors = sensorsFor(*project, arguments.sensors);
  if (!sensors) return sensors.error();
  const Job job = session.job(progress);
  const auto engine = makeEngine(*project, common, true, job, session);
  if (!engine) return engine.error();
  const relight::Sensors prepared(*engine->solver, *sensors, *quantity, engine->quality.sensor_rays,
                                  common.seed);
  const std::vector<relight::SensorLight> light = engine->lighting->read(prepared);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < sensors->size(); ++i) {
    rows.push_back({(*sensors)[i], lux(light[i].direct), lux(light[i].indirect)});
  }
  progress.clear();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (common.json) {
    // With -o the rows go to the file as CSV and the object to stdout.
    if (!common.output.empty()) {
      if (auto written = writeResult(common.output, toCsv(rows)); !written) return written;
    }
    return writeResult("", io::formatJsonLine(toJson(rows, seconds)) + "\n");
  }
  if (common.output.empty() && arguments.sensors.empty())
    return writeResult("", summary(project->scene, rows));
  return writeResult(common.output, toCsv(rows));
}

}  // namespace

void addMeasureCommand(CLI::App& app, Session& session) {
  CLI::App* command =
      app.add_subcommand("measure", "Illuminance in lux at sensors, or on the work planes");
  auto arguments = std::make_shared<MeasureArguments>();
  addProjectArgument(*command, arguments->common);
  addLayoutOption(*command, arguments->common);
  addSetOption(*command, arguments->common);
  addComputeOptions(*command, arguments->common);
  addJsonOption(*command, arguments->common);
  addOutputOption(*command, arguments->common, "CSV file to write");
  command->add_option("--sensors", arguments->sensors, "Sensors: CSV with x,y,z,nx,ny,nz");
  command
      ->add_option("--quantity", arguments->quantity,
                   "planar, cylindrical, semicylindrical, spherical or hemispherical")
      ->capture_default_str();
  command->callback([&session, arguments] {
    session.run = [arguments, &session] { return runMeasure(*arguments, session); };
  });
}

}  // namespace soffit::cli
