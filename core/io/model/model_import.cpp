// SPDX-License-Identifier: MIT
#include "core/io/model/model_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/io/model/child_process.h"
#include "core/io/model/model_format.h"
#include "core/io/model/model_reader.h"
#include "core/io/model/ply_header.h"
#include "core/io/model/reading_error.h"

namespace soffit::io {
namespace fs = std::filesystem;
namespace {

Result<ModelFormat> check(const fs::path& file, const ImportOptions& options) {
  const auto wrong = [&](const char* what, const char* hint) {
    return Error{file.string(), what, hint};
  };
  if (!(options.unit > 0.0) || !std::isfinite(options.unit)) {
    return wrong("the unit must be a positive number of metres", "Use 0.001 for millimetres");
  }
  if (options.scale == 0.0 || !std::isfinite(options.scale)) {
    return wrong("the scale must be a number other than 0", "Use 1 for the model's own size");
  }
  if (!isFinite(options.translate) || !isFinite(options.rotate_deg)) {
    return wrong("translation and rotation must be finite numbers", "Use 0 for none");
  }
  if (options.up && *options.up != 'y' && *options.up != 'z') {
    return wrong("the up axis must be y or z", "Look at the model in a viewer to see which it is");
  }
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return wrong("the file does not exist", "Check the name");
  if (!fs::is_regular_file(file, ignored)) return wrong("is not a file", "Name the model file");
  const auto format = modelFormat(file);
  if (!format) {
    return wrong("is no model format that can be read",
                 "Readable are OBJ, glTF, GLB, PLY, STL, 3DS, FBX, DAE and IFC");
  }
  if (!std::ifstream(file)) return wrong("cannot be opened", "Check the access rights");
  if (*format == ModelFormat::kPly) {
    const std::string problem = plyHeaderProblem(file);
    if (!problem.empty()) return wrong(problem.c_str(), "Export the model again");
  }
  return *format;
}

void warnOfLosses(ImportedModel& out) {
  const auto say = [&](std::size_t count, const char* what) {
    if (count > 0) out.warnings.push_back(fmt::format("{} {}", count, what));
  };
  say(out.cleaning.non_finite, "triangles dropped: corners that are not finite numbers");
  say(out.cleaning.degenerate, "triangles dropped: no area");
  say(out.cleaning.duplicate, "triangles dropped: duplicates of others");
  say(out.points, "points left out");
  say(out.lines, "lines left out");
  say(out.lights, "lights of the file ignored: place luminaires in the project");
  say(out.cameras, "cameras of the file ignored");
}

Error noTriangles(const fs::path& file, const ImportedModel& model) {
  if (model.cleaning.triangles_in > 0) {
    return {file.string(),
            fmt::format("all of its {} triangles are degenerate or not finite",
                        model.cleaning.triangles_in),
            "Check the unit and the export settings"};
  }
  return {file.string(), "holds no triangles",
          "Export the model with its meshes; curves and bodies must be tessellated"};
}

// Reads in a process of its own: the format libraries crash on some damaged files.
Result<ModelPayload> readApart(const fs::path& file, ModelFormat format,
                               const ImportOptions& options, const Job& job) {
  std::error_code ignored;
  const double megabytes = static_cast<double>(fs::file_size(file, ignored)) / 1e6;
  const ChildLimits limits{.cpu_seconds = static_cast<int>(std::min(60.0 + 2.0 * megabytes, 1e6))};
  ChildOutcome outcome =
      runInChild([&](const Job& inner) { return toBytes(readModel(file, format, options, inner)); },
                 limits, job, "reading the model");
  if (outcome.end == ChildEnd::kDone) {
    if (auto payload = payloadFromBytes(outcome.bytes)) return *std::move(payload);
    outcome.end = ChildEnd::kCrashed;
  }
  return readingError(outcome.end, file);
}

}  // namespace

Result<ImportedModel> importModel(const fs::path& file, const ImportOptions& options,
                                  const Job& job) {
  const Result<ModelFormat> format = check(file, options);
  if (!format) return format.error();
  ImportOptions inside = options;
  if (inside.folder.empty()) inside.folder = file.parent_path();
  if (inside.folder.empty()) inside.folder = ".";
  Result<ModelPayload> read = readApart(file, *format, inside, job);
  if (!read) return read.error();
  job.report("cleaning the model", 0.0);
  geometry::CleanedMesh cleaned = geometry::cleanMesh(read->raw);
  if (job.cancelled()) return readingError(ChildEnd::kCancelled, file);
  ImportedModel out = std::move(read->model);
  out.mesh = std::move(cleaned.mesh);
  out.cleaning = cleaned.report;
  if (out.mesh.triangles.empty()) return noTriangles(file, out);
  warnOfLosses(out);
  job.report("cleaning the model", 1.0);
  return out;
}

}  // namespace soffit::io
