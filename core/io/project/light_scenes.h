// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/json.h"
#include "core/light/luminaire.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// Light scenes of the mixer as the project keeps them: presets to recall, by layout. They change
/// no light by themselves; recalling one sets luminaires, whose state is what everything computes.
namespace soffit::io {

class Report;

/// What a scene says of a group, or of one luminaire that differs from its group; what is absent
/// stays as it is.
struct Mix {
  std::optional<double> dimming;
  std::optional<bool> on;
  std::optional<light::Colour> colour;
};

struct LightScene {
  std::string name;
  std::map<std::string, Mix> groups;
  std::map<std::string, Mix> luminaires;
};

/// By layout; the empty name is the base.
using LightScenes = std::map<std::string, std::vector<LightScene>>;

bool same(const Mix& a, const Mix& b);
bool same(const LightScene& a, const LightScene& b);
bool same(const LightScenes& a, const LightScenes& b);

/// The member "scenes" of the project or of a layout (internal to io_project):
/// [ { "name": "Meeting", "groups": { "General": { "dimming": 0.8, "on": true,
/// "colour": { "cct": 3500 } } }, "luminaires": { ... } } ].
std::vector<LightScene> readLightScenes(const Json& value, const std::string& path, Report& report);
/// All of a document's.
LightScenes readAllLightScenes(const Json& root);
/// Brings a document up to date, touching only what differs. Layouts that `scenes` does not know
/// keep theirs.
void syncLightScenes(const LightScenes& scenes, Json& root);

}  // namespace soffit::io
