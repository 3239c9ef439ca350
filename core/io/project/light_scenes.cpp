// SPDX-License-Identifier: MIT
#include "core/io/project/light_scenes.h"

#include "core/io/project/content.h"
#include "core/io/project/report.h"
#include "core/scene/equality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soffit::io {
namespace {

constexpr std::string_view kKey = "scenes";

Mix readMix(const Json& value, const std::string& path, Report& report) {
  Mix mix;
  ObjectReader reader(value, path, report);
  reader.read("dimming", mix.dimming);
  if (mix.dimming && !(std::isfinite(*mix.dimming) && *mix.dimming >= 0.0)) {
    report.fail(reader.pathOf("dimming"),
                fmt::format("expected a number from 0, found {}", *mix.dimming),
                "Write the share of the full flux: 0.5 is one half.");
  }
  reader.read("on", mix.on);
  if (const Json* colour = reader.get("colour")) {
    mix.colour = readColour(*colour, reader.pathOf("colour"), report);
  }
  return mix;
}

void readMixes(ObjectReader& reader, std::string_view key, Report& report,
               std::map<std::string, Mix>& mixes) {
  const Json* members = reader.get(key);
  if (members == nullptr) return;
  const std::string path = reader.pathOf(key);
  const JsonObject* object = members->asObject();
  if (object == nullptr) {
    report.fail(path, fmt::format("expected an object by name, found {}", members->describe()),
                "Write it as { \"General\": { \"dimming\": 0.5 } }.");
    return;
  }
  for (const JsonMember& member : *object) {
    mixes[member.key] = readMix(member.value, joinPath(path, member.key), report);
  }
}

Json toJson(const Mix& mix) {
  Json json = Json::object();
  if (mix.dimming) json["dimming"] = *mix.dimming;
  if (mix.on) json["on"] = *mix.on;
  if (mix.colour) json["colour"] = io::toJson(*mix.colour);
  return json;
}

Json toJson(const std::map<std::string, Mix>& mixes) {
  Json json = Json::object();
  for (const auto& [name, mix] : mixes) json[name] = toJson(mix);
  return json;
}

Json toJson(const std::vector<LightScene>& scenes) {
  JsonArray list;
  for (const LightScene& scene : scenes) {
    Json json = Json::object({{"name", scene.name}});
    if (!scene.groups.empty()) json["groups"] = toJson(scene.groups);
    if (!scene.luminaires.empty()) json["luminaires"] = toJson(scene.luminaires);
    list.push_back(std::move(json));
  }
  return list;
}

std::vector<LightScene> scenesOf(const Json& owner) {
  const Json* scenes = owner.find(kKey);
  Report ignored("");
  return scenes == nullptr ? std::vector<LightScene>{} : readLightScenes(*scenes, "", ignored);
}

void syncOwner(const LightScenes& scenes, const std::string& name, Json& owner) {
  const auto wanted = scenes.find(name);
  if (wanted == scenes.end()) return;
  const auto old = scenesOf(owner);
  if (std::ranges::equal(old, wanted->second,
                         [](const LightScene& a, const LightScene& b) { return same(a, b); })) {
    return;
  }
  if (wanted->second.empty()) {
    owner.erase(kKey);
  } else {
    owner[kKey] = toJson(wanted->second);
  }
}

template <class Owner>
void forLayouts(Owner& root, const auto& visit) {
  auto* layouts = root.find("layouts");
  auto* list = layouts == nullptr ? nullptr : layouts->asArray();
  if (list == nullptr) return;
  for (auto& layout : *list) {
    const Json* name = layout.find("name");
    const std::string* text = name == nullptr ? nullptr : name->asText();
    if (text != nullptr) visit(*text, layout);
  }
}

}  // namespace

bool same(const Mix& a, const Mix& b) {
  if (a.dimming != b.dimming || a.on != b.on) return false;
  if (a.colour.has_value() != b.colour.has_value()) return false;
  return !a.colour || scene::same(*a.colour, *b.colour);
}

bool same(const LightScene& a, const LightScene& b) {
  const auto sameMixes = [](const auto& x, const auto& y) {
    return std::ranges::equal(x, y, [](const auto& p, const auto& q) {
      return p.first == q.first && same(p.second, q.second);
    });
  };
  return a.name == b.name && sameMixes(a.groups, b.groups) && sameMixes(a.luminaires, b.luminaires);
}

bool same(const LightScenes& a, const LightScenes& b) {
  return std::ranges::equal(a, b, [](const auto& p, const auto& q) {
    return p.first == q.first &&
           std::ranges::equal(p.second, q.second,
                              [](const LightScene& x, const LightScene& y) { return same(x, y); });
  });
}

std::vector<LightScene> readLightScenes(const Json& value, const std::string& path,
                                        Report& report) {
  std::vector<LightScene> scenes;
  const JsonArray* list = value.asArray();
  if (list == nullptr) {
    report.fail(path, fmt::format("expected a list of scenes, found {}", value.describe()),
                "Write it as [ { \"name\": \"Meeting\", \"groups\": { ... } } ].");
    return scenes;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    LightScene scene;
    ObjectReader reader((*list)[i], elementPath(path, i, (*list)[i]), report);
    reader.read("name", scene.name);
    readMixes(reader, "groups", report, scene.groups);
    readMixes(reader, "luminaires", report, scene.luminaires);
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

LightScenes readAllLightScenes(const Json& root) {
  LightScenes all;
  if (auto base = scenesOf(root); !base.empty()) all[""] = std::move(base);
  forLayouts(root, [&](const std::string& name, const Json& layout) {
    if (auto scenes = scenesOf(layout); !scenes.empty()) all[name] = std::move(scenes);
  });
  return all;
}

void syncLightScenes(const LightScenes& scenes, Json& root) {
  syncOwner(scenes, "", root);
  forLayouts(root, [&](const std::string& name, Json& layout) { syncOwner(scenes, name, layout); });
}

}  // namespace soffit::io
