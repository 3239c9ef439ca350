// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/common_options.h"
#include "app/cli/output.h"
#include "app/cli/progress_bar.h"
#include "core/io/project/json.h"
#include "core/scene/edits.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace soffit::cli {
namespace {

/// What a project needs to be computed, and what it does not and why.
struct Demand {
  std::vector<std::string> needed;
  struct Skip {
    std::string what;
    std::string why;
  };
  std::vector<Skip> skipped;

  void decide(bool wanted, const char* what, const char* why_not) {
    if (wanted) {
      needed.emplace_back(what);
    } else {
      skipped.push_back({what, why_not});
    }
  }
};

bool isGrey(const dvec3& color) {
  return color.x == color.y && color.y == color.z;
}

Demand demandOf(const scene::Scene& scene, const std::vector<light::Luminaire>& luminaires) {
  Demand demand;
  const auto lit = [](const light::Luminaire& l) { return l.on && l.dimming > 0.0; };
  const bool any_surface = scene.mesh->triangleCount() > 0;
  const bool reflecting = std::ranges::any_of(scene.materials, [](const scene::Material& m) {
    return m.diffuse != dvec3(0.0) || m.specular > 0.0;
  });
  const bool glossy =
      std::ranges::any_of(scene.materials, [](const auto& m) { return m.specular > 0.0; });
  const bool colored = std::ranges::any_of(scene.materials, [](const auto& m) {
    return !isGrey(m.diffuse) || m.diffuse_image != nullptr;
  });
  const bool measured = std::ranges::any_of(
      luminaires, [](const auto& l) { return l.distribution.table != nullptr; });
  const bool bodies = std::ranges::any_of(luminaires, [](const auto& l) { return l.casts_shadow; });
  const bool glass =
      std::ranges::any_of(scene.materials, [](const auto& m) { return m.glass.has_value(); });
  demand.decide(std::ranges::any_of(luminaires, lit), "direct light", "no luminaire is on");
  demand.decide(any_surface && reflecting, "interreflection", "no surface reflects");
  demand.decide(any_surface, "visibility", "there is no geometry");
  demand.decide(colored, "three color channels", "all reflectances are grey");
  demand.decide(glossy, "highlights and reflections", "no material has a specular share");
  demand.decide(measured, "measured photometry", "no luminaire names a file");
  demand.decide(bodies, "luminaires as obstacles", "no luminaire casts a shadow");
  demand.decide(false, "light from outside",
                scene.environment ? "not yet computed" : "the project has no environment");
  demand.decide(false, "light through glass",
                glass ? "not yet computed: panes block light" : "no material is glass");
  return demand;
}

std::size_t pointCount(const scene::Scene& scene) {
  std::size_t count = 0;
  for (const scene::WorkPlane& plane : scene.work_planes) {
    count += static_cast<std::size_t>(plane.nu) * static_cast<std::size_t>(plane.nv);
  }
  return count;
}

template <class Items>
std::string names(const Items& items) {
  std::string list;
  for (const auto& item : items) list += (list.empty() ? "" : ", ") + item.name;
  return list.empty() ? "none" : list;
}

io::Json textArray(const std::vector<std::string>& lines) {
  io::JsonArray array;
  for (const std::string& line : lines) array.emplace_back(line);
  return array;
}

template <class Items>
io::Json nameArray(const Items& items) {
  io::JsonArray array;
  for (const auto& item : items) array.emplace_back(item.name);
  return array;
}

io::Json toJson(const io::Project& project, const Demand& demand) {
  const scene::Scene& scene = project.scene;
  io::JsonArray skipped;
  for (const Demand::Skip& skip : demand.skipped) {
    skipped.push_back(io::Json::object({{"what", skip.what}, {"why", skip.why}}));
  }
  return io::Json::object({{"name", scene.name},
                           {"triangles", scene.mesh->triangleCount()},
                           {"receivers", pointCount(scene)},
                           {"luminaires", scene.luminaires.size()},
                           {"needed", textArray(demand.needed)},
                           {"skipped", skipped},
                           {"materials", nameArray(scene.materials)},
                           {"layouts", nameArray(scene.layouts)},
                           {"cameras", nameArray(scene.cameras)},
                           {"work_planes", nameArray(scene.work_planes)},
                           {"warnings", textArray(project.warnings)}});
}

std::string toText(const io::Project& project, const Demand& demand) {
  const scene::Scene& scene = project.scene;
  std::string text = fmt::format("{}\n", scene.name.empty() ? project.path.string() : scene.name);
  const auto row = [&](const char* what, const std::string& value) {
    text += fmt::format("  {:<12} {}\n", what, value);
  };
  const vec3 size = scene.mesh->triangleCount() > 0 ? scene.mesh->bounds().size() : vec3(0.0F);
  row("triangles", fmt::format("{} in {:.2f} x {:.2f} x {:.2f} m", scene.mesh->triangleCount(),
                               size.x, size.y, size.z));
  row("materials", fmt::format("{}: {}", scene.materials.size(), names(scene.materials)));
  row("luminaires", fmt::format("{}", scene.luminaires.size()));
  row("layouts", names(scene.layouts));
  row("cameras", names(scene.cameras));
  row("work planes", fmt::format("{} ({} points)", names(scene.work_planes), pointCount(scene)));
  for (const std::string& needed : demand.needed) row("needed", needed);
  for (const Demand::Skip& skip : demand.skipped) {
    row("skipped", fmt::format("{}: {}", skip.what, skip.why));
  }
  for (const std::string& warning : project.warnings) row("warning", warning);
  return text;
}

Result<void> runInfo(const CommonOptions& options) {
  ProgressBar progress;
  Session quiet;  // the warnings are part of the answer here
  const auto project = loadForCommand(options, quiet, &progress);
  progress.clear();
  if (!project) return project.error();
  const Demand demand = demandOf(project->scene, project->scene.luminaires);
  if (!options.json) return writeResult("", toText(*project, demand));
  return writeResult("", io::formatJsonLine(toJson(*project, demand)) + "\n");
}

}  // namespace

void addInfoCommand(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand(
      "info", "Say what is in a project, what it needs, what is skipped and why");
  auto options = std::make_shared<CommonOptions>();
  addProjectArgument(*command, *options);
  addLayoutOption(*command, *options);
  addSetOption(*command, *options);
  addComputeOptions(*command, *options);
  addJsonOption(*command, *options);
  command->callback([&session, options] { session.run = [options] { return runInfo(*options); }; });
}

}  // namespace soffit::cli
