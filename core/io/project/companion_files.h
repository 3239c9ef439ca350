// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/project/importers.h"

#include <filesystem>
#include <map>
#include <string>

/// The files that lie beside a project: taken along when it is made or moves (internal to
/// io_project).
namespace soffit::io {

/// Files to write beside a project: relative path and content. Nothing is written before all are
/// known to fit.
using CompanionFiles = std::map<std::string, std::string>;

/// Takes a file over at the same place relative to `from_folder`. What lies outside of it is left
/// (its reader refused it). Errors: it cannot be read.
Result<void> takeFile(const std::filesystem::path& file, const std::filesystem::path& from_folder,
                      CompanionFiles& files);

/// The same where the file is there; a missing one is no error.
Result<void> takeFileIfThere(const std::filesystem::path& file,
                             const std::filesystem::path& from_folder, CompanionFiles& files);

/// A model with its side files, its textures and the pictures stored inside it, at their places
/// relative to `from_folder`.
Result<void> takeModel(const std::filesystem::path& model_file, const LoadedModel& model,
                       const std::filesystem::path& from_folder, CompanionFiles& files);

/// Drops what is in the folder already with the same content.
/// Errors: a file of the same name and other content.
Result<void> dropPresent(const std::filesystem::path& folder, CompanionFiles& files);

/// Writes all, making folders as need be.
Result<void> writeFiles(const std::filesystem::path& folder, const CompanionFiles& files);

}  // namespace soffit::io
