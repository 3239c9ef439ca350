// SPDX-License-Identifier: MIT
#include "ui/document/pending_files.h"

#include "core/io/project/atomic_file.h"

#include <set>
#include <utility>

namespace soffit::ui {
namespace {

void addFiles(const light::Shape& shape, std::set<std::string>& files) {
  if (const auto* mesh = std::get_if<light::MeshShape>(&shape)) files.insert(mesh->file);
}

std::set<std::string> filesOf(const scene::Scene& scene) {
  std::set<std::string> files;
  for (const light::Luminaire& l : scene.luminaires) {
    addFiles(l.shape, files);
    files.insert(l.distribution.file);
  }
  for (const scene::Layout& layout : scene.layouts) {
    for (const auto& [name, edit] : layout.edits) {
      if (edit.shape) addFiles(*edit.shape, files);
      if (edit.distribution) files.insert(edit.distribution->file);
    }
  }
  if (scene.environment) {
    const auto* probe = std::get_if<scene::Probe>(&scene.environment->light);
    if (probe != nullptr) files.insert(probe->file);
  }
  return files;
}

}  // namespace

std::vector<std::string> filesOf(const light::Luminaire& luminaire) {
  std::vector<std::string> files;
  if (const auto* mesh = std::get_if<light::MeshShape>(&luminaire.shape)) {
    files.push_back(mesh->file);
  }
  if (!luminaire.distribution.file.empty()) files.push_back(luminaire.distribution.file);
  return files;
}

std::string PendingFiles::add(const std::string& wanted, std::string bytes,
                              const std::filesystem::path& folder) {
  const std::filesystem::path name = std::filesystem::path(wanted).filename();
  const std::string stem = name.stem().string();
  const std::string ending = name.extension().string();
  for (int number = 1;; ++number) {
    std::string candidate = stem;
    if (number > 1) candidate.append("_").append(std::to_string(number));
    candidate.append(ending);
    const auto pending = files_.find(candidate);
    if (pending != files_.end()) {
      if (pending->second == bytes) return candidate;
      continue;
    }
    std::error_code code;
    if (std::filesystem::exists(folder / candidate, code)) {
      const auto there = io::readFile(folder / candidate);
      if (there && *there == bytes) return candidate;
      continue;
    }
    files_.emplace(candidate, std::move(bytes));
    return candidate;
  }
}

Result<void> PendingFiles::write(const scene::Scene& scene,
                                 const std::filesystem::path& folder) const {
  for (const std::string& name : filesOf(scene)) {
    const auto pending = files_.find(name);
    std::error_code code;
    if (pending == files_.end() || std::filesystem::exists(folder / name, code)) continue;
    if (auto written = io::writeFileAtomically(folder / name, pending->second); !written) {
      return written.error();
    }
  }
  return {};
}

}  // namespace soffit::ui
