// SPDX-License-Identifier: MIT
#include "ui/jobs/library_index.h"

#include "core/io/photometry/photometric_file.h"
#include "core/io/project/atomic_file.h"
#include "core/photometry/beam.h"
#include "ui/document/text.h"

#include <QDirIterator>
#include <QFileInfo>

#include <utility>

namespace soffit::ui {
namespace {

/// A folder of a whole disk would go on for ever.
constexpr int kMostFiles = 20000;
constexpr std::size_t kLargestFile = std::size_t{8} << 20U;

}  // namespace

Result<LibraryEntry> readLibraryEntry(const QString& path) {
  auto bytes = io::readFile(toPath(path), kLargestFile);
  if (!bytes) return bytes.error();
  const auto file = io::readPhotometry(toPath(path));
  if (!file) return file.error();
  LibraryEntry entry;
  entry.path = path;
  entry.lumens = file->lumens;
  entry.watts = file->watts;
  entry.beam_deg =
      photometry::beamAngles(file->distribution, photometry::BeamReference::peak).c0_deg;
  entry.type = typeFromPhotometry(*file, toStd(QFileInfo(path).fileName()), std::move(*bytes));
  return entry;
}

LibraryIndex::~LibraryIndex() = default;

void LibraryIndex::start(const QStringList& folders) {
  thread_ = {};  // asks the old one to stop and joins it: it looks after each file
  {
    const std::scoped_lock lock(mutex_);
    entries_.clear();
  }
  thread_ = std::jthread([this, folders](const std::stop_token& stop) { run(folders, stop); });
}

std::vector<LibraryEntry> LibraryIndex::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(entries_, {});
}

void LibraryIndex::run(const QStringList& folders, const std::stop_token& stop) {
  int unreadable = 0;
  int seen = 0;
  for (const QString& folder : folders) {
    QDirIterator files(folder, {QStringLiteral("*.ies"), QStringLiteral("*.ldt")},
                       QDir::Files | QDir::Readable, QDirIterator::Subdirectories);
    while (files.hasNext() && seen < kMostFiles) {
      if (stop.stop_requested()) return;
      ++seen;
      auto entry = readLibraryEntry(files.next());
      if (!entry) {
        ++unreadable;
        continue;
      }
      bool first = false;
      {
        const std::scoped_lock lock(mutex_);
        first = entries_.empty();
        entries_.push_back(std::move(*entry));
      }
      if (first) Q_EMIT found();
    }
  }
  if (!stop.stop_requested()) Q_EMIT finished(unreadable);
}

}  // namespace soffit::ui
