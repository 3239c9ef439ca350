// SPDX-License-Identifier: MIT
#include "core/io/project/sync.h"

namespace soffit::io {
namespace {

std::string_view nameOf(const Json& element) {
  const Json* name = element.find("name");
  const std::string* text = name == nullptr ? nullptr : name->asText();
  return text == nullptr ? std::string_view() : std::string_view(*text);
}

}  // namespace

void updateFields(Json& target, const Json& old_fields, const Json& new_fields) {
  for (const JsonMember& field : *old_fields.asObject()) {
    if (new_fields.find(field.key) == nullptr) target.erase(field.key);
  }
  for (const JsonMember& field : *new_fields.asObject()) {
    const Json* old = old_fields.find(field.key);
    if (old == nullptr || !(*old == field.value)) target[field.key] = field.value;
  }
}

const Json* findElement(const Json& list, std::string_view name, std::size_t index,
                        const std::vector<std::string>& names) {
  const JsonArray* elements = list.asArray();
  if (elements == nullptr) return nullptr;
  const auto found = std::ranges::find(*elements, name, nameOf);
  if (found != elements->end()) return &*found;
  if (index >= elements->size()) return nullptr;
  const Json& same_place = (*elements)[index];
  const bool renamed = std::ranges::find(names, nameOf(same_place)) == names.end();
  return renamed && same_place.asObject() != nullptr ? &same_place : nullptr;
}

}  // namespace soffit::io
