// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/json.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Brings a document up to date with a scene, touching only what differs (internal to io_project).
namespace soffit::io {

/// Changes the members of `target` in which `old_fields` and `new_fields` differ: set, or removed
/// when the new fields lack them. Members that neither has stay.
void updateFields(Json& target, const Json& old_fields, const Json& new_fields);

/// The element of `list` that describes the item of that name: the one with the name, else the
/// one at the same place when its own name is gone from `names` (it was renamed); null if none.
const Json* findElement(const Json& list, std::string_view name, std::size_t index,
                        const std::vector<std::string>& names);

/// Rewrites the list root[key] in the order of `items` (which have a `name`): known elements are
/// changed by update(item, element), new ones made by create(item). A list that is absent and
/// would be empty is not added.
template <class Item, class Create, class Update>
void syncList(Json& root, std::string_view key, const std::vector<Item>& items,
              const Create& create, const Update& update) {
  const Json* list = root.find(key);
  if (list == nullptr && items.empty()) return;
  const Json old = list == nullptr ? Json::array() : *list;
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const Item& item : items) names.push_back(item.name);
  JsonArray written;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Json* known = findElement(old, names[i], i, names);
    Json element = known == nullptr ? create(items[i]) : *known;
    if (known != nullptr) update(items[i], element);
    if (const Json* name = element.find("name"); name == nullptr || !(*name == Json(names[i]))) {
      element["name"] = names[i];
    }
    written.push_back(std::move(element));
  }
  root[key] = std::move(written);
}

}  // namespace soffit::io
