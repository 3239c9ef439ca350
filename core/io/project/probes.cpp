// SPDX-License-Identifier: MIT
#include "core/io/project/probes.h"

#include "core/io/project/content.h"
#include "core/io/project/report.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace soffit::io {
namespace {

constexpr std::string_view kKey = "probes";
/// Slack of a unit vector in single precision.
constexpr double kUnit = 1e-6;

Probe readProbe(const Json& value, const std::string& path, Report& report) {
  Probe probe;
  ObjectReader reader(value, path, report);
  reader.read("name", probe.name);
  reader.require("position", "[1, 2, 0.75]");
  reader.read("position", probe.position);
  reader.read("normal", probe.normal);
  const double length = glm::length(probe.normal);
  if (!isFinite(probe.position) || !(length > 0.0) || !isFinite(probe.normal)) {
    report.fail(path, "expected finite numbers and a normal that is not 0",
                "Write the side of the surface that is read: [0, 0, 1] is its upper one.");
    return probe;
  }
  // What was written as a unit stays bit for bit.
  if (std::abs(length - 1.0) > kUnit) probe.normal /= length;
  return probe;
}

}  // namespace

std::vector<Probe> readProbes(const Json& value, const std::string& path, Report& report) {
  std::vector<Probe> probes;
  const JsonArray* list = value.asArray();
  if (list == nullptr) {
    report.fail(path, fmt::format("expected a list of probes, found {}", value.describe()),
                "Write it as [ { \"name\": \"Desk\", \"position\": [1, 2, 0.75] } ].");
    return probes;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    probes.push_back(readProbe((*list)[i], elementPath(path, i, (*list)[i]), report));
  }
  return probes;
}

std::vector<Probe> probesOf(const Json& root) {
  const Json* probes = root.find(kKey);
  Report ignored("");
  return probes == nullptr ? std::vector<Probe>{} : readProbes(*probes, "", ignored);
}

void syncProbes(const std::vector<Probe>& probes, Json& root) {
  if (probesOf(root) == probes) return;
  if (probes.empty()) {
    root.erase(kKey);
    return;
  }
  JsonArray list;
  for (const Probe& probe : probes) {
    list.push_back(Json::object({{"name", probe.name},
                                 {"position", toJson(probe.position)},
                                 {"normal", toJson(probe.normal)}}));
  }
  root[kKey] = std::move(list);
}

}  // namespace soffit::io
