// SPDX-License-Identifier: MIT
#include "core/scene/layout_edits.h"

#include "core/scene/edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace soffit::scene {
namespace {

Error noLayout(std::string_view name) {
  return {"layouts", fmt::format("there is no layout named '{}'", name),
          "Check the spelling, or add it first."};
}

auto find(Scene& scene, std::string_view name) {
  return std::ranges::find(scene.layouts, name, &Layout::name);
}

}  // namespace

Result<Scene> withLayoutRenamed(const Scene& scene, std::string_view from, std::string_view to) {
  Scene edited = scene;
  const auto layout = find(edited, from);
  if (layout == edited.layouts.end()) return noLayout(from);
  if (from == to) return edited;
  if (to.empty()) return Error{"layouts", "the name is empty", "Give the layout a name."};
  if (findLayout(scene, to) != nullptr) {
    return Error{"layouts", fmt::format("the name '{}' is taken", to), "Choose another name."};
  }
  layout->name = to;
  return edited;
}

Result<Scene> withoutLayout(const Scene& scene, std::string_view name) {
  Scene edited = scene;
  const auto layout = find(edited, name);
  if (layout == edited.layouts.end()) return noLayout(name);
  edited.layouts.erase(layout);
  return edited;
}

Result<Scene> withLayoutAt(const Scene& scene, std::string_view name, std::size_t place) {
  Scene edited = scene;
  const auto layout = find(edited, name);
  if (layout == edited.layouts.end()) return noLayout(name);
  Layout moved = std::move(*layout);
  edited.layouts.erase(layout);
  const auto at = std::min(place, edited.layouts.size());
  edited.layouts.insert(edited.layouts.begin() + static_cast<std::ptrdiff_t>(at), std::move(moved));
  return edited;
}

std::string freeLayoutName(const Scene& scene, std::string_view stem) {
  const auto last = stem.find_last_not_of("0123456789");
  if (last != std::string_view::npos && last + 1 < stem.size() && stem[last] == ' ') {
    stem = stem.substr(0, last);
  }
  std::string name;
  for (int number = 2; name.empty() || findLayout(scene, name) != nullptr; ++number) {
    name = fmt::format("{} {}", stem, number);
  }
  return name;
}

}  // namespace soffit::scene
