// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace soffit::io {

/// The materials of a Wavefront material library (text of an MTL file) that state a diffuse color
/// (Kd). The importer fills in a grey of its own for the others and does not say so.
std::set<std::string> materialsWithColor(std::string_view mtl_text);

}  // namespace soffit::io
