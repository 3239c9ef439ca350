// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/luminaire_types.h"

#include <QObject>
#include <QStringList>

#include <mutex>
#include <thread>
#include <vector>

namespace soffit::ui {

/// A photometric file of the user's, read.
struct LibraryEntry {
  QString path;
  LuminaireType type;
  double lumens = 0.0;
  double beam_deg = 0.0;  ///< CIE beam angle in the plane C0-C180
  double watts = 0.0;     ///< 0: not stated
};

/// The facts of one file. Errors: io::readPhotometry()'s.
Result<LibraryEntry> readLibraryEntry(const QString& path);

/// Reads the IES and LDT files of folders, with the folders in them, on a thread of its own. A new
/// start() gives up the old one.
class LibraryIndex : public QObject {
  Q_OBJECT

 public:
  explicit LibraryIndex(QObject* parent = nullptr) : QObject(parent) {}
  ~LibraryIndex() override;

  void start(const QStringList& folders);
  /// What was read since the last call.
  std::vector<LibraryEntry> take();

 Q_SIGNALS:
  void found();
  /// All files were looked at; those that could not be read.
  void finished(int unreadable);

 private:
  void run(const QStringList& folders, const std::stop_token& stop);

  std::mutex mutex_;
  std::vector<LibraryEntry> entries_;  // guarded by mutex_
  std::jthread thread_;
};

}  // namespace soffit::ui
