// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/math/vec.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <string_view>
#include <vector>

/// Points in CSV files: sensors and paths of `soffit measure`, `reference`, `verify` and `move`.
///
/// The first line is the header, its names in the stated order, blanks and case ignored. Then a
/// row of finite decimal numbers per point. Line ends of any system, a byte order mark, blanks,
/// empty lines and quotes round a field are tolerated; more columns are not.
namespace soffit::io {

/// Header `x,y,z,nx,ny,nz`; metres, world. Normals are scaled to unit length.
/// Errors name the file and the line: a wrong header or count of fields, what is no number, a
/// normal of zero length, no row at all.
Result<std::vector<scene::Sensor>> readSensors(const std::filesystem::path& path);

/// Header `x,y,z`; metres, world.
Result<std::vector<dvec3>> readPath(const std::filesystem::path& path);

/// The same from text; `name` stands for the file in errors.
Result<std::vector<scene::Sensor>> parseSensors(std::string_view text, std::string_view name);
Result<std::vector<dvec3>> parsePath(std::string_view text, std::string_view name);

}  // namespace soffit::io
