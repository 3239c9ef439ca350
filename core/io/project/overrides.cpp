// SPDX-License-Identifier: MIT
#include "core/io/project/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

namespace soffit::io {
namespace {

const std::string* nameOf(const Json& element) {
  const Json* name = element.find("name");
  return name == nullptr ? nullptr : name->asText();
}

Json* findNamed(JsonArray& array, std::string_view name) {
  const auto found = std::ranges::find_if(array, [&](const Json& element) {
    const std::string* text = nameOf(element);
    return text != nullptr && *text == name;
  });
  return found == array.end() ? nullptr : &*found;
}

std::string listNames(const JsonArray& array) {
  std::string list;
  for (const Json& element : array) {
    const std::string* name = nameOf(element);
    if (name == nullptr) continue;
    if (list.size() > 200) return list + ", ...";
    list += (list.empty() ? "" : ", ") + *name;
  }
  return list;
}

/// Where a path has led so far.
struct Step {
  Json* value = nullptr;
  std::string_view rest;  ///< of the path, without the dot
};

/// If `path` starts with `name`, followed by a dot or nothing: what comes after.
std::optional<std::string_view> restAfter(std::string_view path, std::string_view name) {
  if (name.empty() || !path.starts_with(name)) return std::nullopt;
  path.remove_prefix(name.size());
  if (path.empty()) return path;
  if (path.front() != '.') return std::nullopt;
  path.remove_prefix(1);
  return path;
}

/// The element of a list that the path names, longest name first, or by "[index]" before it.
std::optional<Step> stepIntoArray(JsonArray& array, std::string_view path) {
  std::optional<Step> best;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string* name = nameOf(array[i]);
    const std::string index = fmt::format("[{}]", i);
    for (const std::string_view key :
         {name == nullptr ? std::string_view() : *name, std::string_view(index)}) {
      const auto rest = restAfter(path, key);
      if (!rest || key.size() <= longest) continue;
      longest = key.size();
      best = Step{&array[i], *rest};
    }
  }
  return best;
}

/// The member that the path names, longest key first; a new one when none does.
Step stepIntoObject(Json& object, std::string_view path) {
  std::optional<Step> best;
  std::size_t longest = 0;
  for (JsonMember& member : *object.asObject()) {
    const auto rest = restAfter(path, member.key);
    if (!rest || member.key.size() <= longest) continue;
    longest = member.key.size();
    best = Step{&member.value, *rest};
  }
  if (best) return *best;
  const auto end = path.find('.');
  const std::string_view rest =
      end == std::string_view::npos ? std::string_view() : path.substr(end + 1);
  return {&object[path.substr(0, end)], rest};
}

/// In these, one key excludes the others: setting shape.disk replaces shape.rectangle.
bool isOneOf(std::string_view key) {
  return key == "shape" || key == "colour" || key == "distribution";
}

bool isCompanion(std::string_view key) {
  return key == "unit" || key == "up";
}

Error deadEnd(const Report& report, std::string_view key, std::string what, std::string hint) {
  return {fmt::format("{}: --set {}", report.file(), key), std::move(what), std::move(hint)};
}

/// Sets the value at `path` below an object that holds no lists.
void setBelow(Json& object, std::string_view path, Json value) {
  Json* at = &object;
  std::string_view parent;
  while (!path.empty()) {
    if (at->asObject() == nullptr) *at = Json::object();
    if (isOneOf(parent) && at->find(path) == nullptr && !isCompanion(path)) *at = Json::object();
    const Step step = stepIntoObject(*at, path);
    parent = path.substr(0, path.find('.'));
    at = step.value;
    path = step.rest;
  }
  *at = std::move(value);
}

/// The fields of a material, deepest first: what a path under "materials" may end in.
constexpr std::array<std::string_view, 9> kMaterialFields{
    ".glass.index", ".glass.transmittance", ".diffuse_map",
    ".normal_map",  ".roughness_map",       ".diffuse",
    ".specular",    ".roughness",           ".glass"};

Result<std::string> setMaterial(Json& root, std::string_view path, Json value, Report& report) {
  for (const std::string_view field : kMaterialFields) {
    if (!path.ends_with(field) || path.size() == field.size()) continue;
    const std::string name(path.substr(0, path.size() - field.size()));
    Json& materials = root["materials"];
    const bool is_new = materials.find(name) == nullptr;
    setBelow(materials[name], field.substr(1), std::move(value));
    return is_new ? name : std::string();
  }
  return deadEnd(report, fmt::format("materials.{}", path), "this is no field of a material",
                 "Name one: materials.wall.diffuse, .specular, .roughness, .glass.index.");
}

Result<std::string> setInList(Json& root, std::string_view list, std::string_view path, Json value,
                              Report& report) {
  const std::string key = fmt::format("{}.{}", list, path);
  Json* array_value = root.find(list);
  JsonArray* array = array_value == nullptr ? nullptr : array_value->asArray();
  const auto step = array == nullptr ? std::nullopt : stepIntoArray(*array, path);
  if (!step) {
    const std::string names = array == nullptr ? std::string() : listNames(*array);
    return deadEnd(report, key, fmt::format("nothing in {} has this name", list),
                   names.empty() ? fmt::format("The project has no {}.", list)
                                 : fmt::format("There is: {}.", names));
  }
  if (step->rest.empty() || step->value->asObject() == nullptr) {
    return deadEnd(report, key, "this names the whole, not one of its fields",
                   "Add the field: luminaires.Panel 1.flux.");
  }
  setBelow(*step->value, step->rest, std::move(value));
  const auto index = static_cast<std::size_t>(step->value - array->data());
  report.markSet(joinPath(elementPath(list, index, *step->value), step->rest));
  return std::string();
}

Result<std::string> setSection(Json& root, std::string_view key, Json value, Report& report) {
  const std::string_view section = key.substr(0, key.find('.'));
  if (section == "quality" && key.size() > section.size() && root.find("quality") != nullptr) {
    Json& quality = root["quality"];
    if (quality.asText() != nullptr) quality = Json::object({{"preset", quality}});
  }
  if (section == "soffit" || section == "layouts" || section == "geometry" || section.empty()) {
    return deadEnd(report, key, "this part of a project cannot be set from outside",
                   "Set fields of luminaires, materials, environment, cameras, work_planes, view "
                   "or quality.");
  }
  setBelow(root, key, std::move(value));
  return std::string();
}

std::optional<double> wholeNumber(std::string_view text) {
  double value = 0.0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::string_view withoutBlanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Numbers with commas between them, at least two.
std::optional<Json> numberList(std::string_view text) {
  JsonArray numbers;
  for (;;) {
    const auto comma = text.find(',');
    const auto number = wholeNumber(withoutBlanks(text.substr(0, comma)));
    if (!number) return std::nullopt;
    numbers.emplace_back(*number);
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  return Json(std::move(numbers));
}

Error notAnObject(const Json& value, std::string_view layout, std::string_view luminaire,
                  const std::string& file) {
  const std::string place = fmt::format("layouts.{}.luminaires", layout);
  return {fmt::format("{}: {}", file, luminaire.empty() ? place : joinPath(place, luminaire)),
          fmt::format("expected an object, found {}", value.describe()),
          "Write it as { \"key\": value, ... }."};
}

}  // namespace

Result<Json> parseSetValue(std::string_view text) {
  const std::string_view bare = withoutBlanks(text);
  if (bare == "true") return Json(true);
  if (bare == "false") return Json(false);
  if (bare == "null") return Json();
  if (const auto number = wholeNumber(bare)) return Json(JsonNumber{*number, std::string(bare)});
  if (bare.find(',') != std::string_view::npos) {
    if (auto numbers = numberList(bare)) return *numbers;
  }
  if (bare.starts_with('{') || bare.starts_with('[') || bare.starts_with('"')) {
    return parseJson(bare, "--set");
  }
  return Json(std::string(text));
}

Result<std::string> applySet(Json& root, std::string_view set, Report& report) {
  const auto equals = set.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    return deadEnd(report, set, "expected KEY=VALUE",
                   "Write --set \"luminaires.Panel 1.flux=3000\".");
  }
  const std::string_view key = withoutBlanks(set.substr(0, equals));
  if (key.ends_with('.')) {
    return deadEnd(report, key, "the path ends in a dot", "Name the field after it.");
  }
  auto value = parseSetValue(set.substr(equals + 1));
  if (!value) return value.error();
  report.markSet(std::string(key));
  for (const std::string_view list : {"luminaires", "cameras", "work_planes"}) {
    if (const auto rest = restAfter(key, list)) {
      return setInList(root, list, *rest, std::move(*value), report);
    }
    if (key.starts_with(list) && key.substr(list.size()).starts_with('[')) {
      return setInList(root, list, key.substr(list.size()), std::move(*value), report);
    }
  }
  if (const auto rest = restAfter(key, "materials")) {
    return setMaterial(root, *rest, std::move(*value), report);
  }
  return setSection(root, key, std::move(*value), report);
}

Result<void> applyLayout(Json& root, std::string_view layout, const std::string& file) {
  Json* list = root.find("layouts");
  JsonArray* layouts = list == nullptr ? nullptr : list->asArray();
  Json* found = layouts == nullptr ? nullptr : findNamed(*layouts, layout);
  if (found == nullptr) {
    const std::string names = layouts == nullptr ? std::string() : listNames(*layouts);
    return Error{
        fmt::format("{}: layouts", file), fmt::format("there is no layout \"{}\"", layout),
        names.empty() ? "The project has no layouts." : fmt::format("Choose one of: {}.", names)};
  }
  const Json chosen = *found;
  *list = Json::array({Json::object({{"name", layout}})});
  const Json* edits = chosen.find("luminaires");
  if (edits == nullptr) return {};
  if (edits->asObject() == nullptr) return notAnObject(*edits, layout, "", file);
  Json& base = root["luminaires"];
  if (base.isNull()) base = Json::array();
  JsonArray* luminaires = base.asArray();
  if (luminaires == nullptr) return {};  // reading it reports the fault
  JsonArray own;
  for (const JsonMember& edit : *edits->asObject()) {
    Json* target = findNamed(*luminaires, edit.key);
    if (target == nullptr) target = &own.emplace_back(Json::object({{"name", edit.key}}));
    if (edit.value.asObject() == nullptr) return notAnObject(edit.value, layout, edit.key, file);
    for (const JsonMember& field : *edit.value.asObject()) {
      if (field.key != "name") (*target)[field.key] = field.value;
    }
  }
  std::ranges::sort(own, {}, [](const Json& element) { return *nameOf(element); });
  luminaires->insert(luminaires->end(), own.begin(), own.end());
  return {};
}

}  // namespace soffit::io
