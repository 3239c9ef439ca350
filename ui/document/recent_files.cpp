// SPDX-License-Identifier: MIT
#include "ui/document/recent_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace soffit::ui {
namespace {

constexpr int kMost = 10;
const QString kKey = QStringLiteral("recent_files");

}  // namespace

QStringList recentFiles() {
  QStringList known;
  for (const QString& path : QSettings().value(kKey).toStringList()) {
    if (QFileInfo::exists(path)) known.append(path);
  }
  return known;
}

void rememberFile(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList files = QSettings().value(kKey).toStringList();
  files.removeAll(absolute);
  files.prepend(absolute);
  QSettings().setValue(kKey, files.mid(0, kMost));
}

QStringList sampleProjects() {
  QDir folder(QCoreApplication::applicationDirPath());
  QStringList places{folder.filePath(QStringLiteral("../share/soffit/projects"))};
  // build/release/bin lies three levels below the source tree.
  for (int level = 0; level < 4; ++level) {
    places.append(folder.filePath(QStringLiteral("projects")));
    if (!folder.cdUp()) break;
  }
  if (qEnvironmentVariableIsSet("SOFFIT_PROJECTS")) {
    places.prepend(qEnvironmentVariable("SOFFIT_PROJECTS"));
  }
  for (const QString& place : places) {
    QStringList found;
    for (const char* name : {"office", "gallery", "flat", "cornell"}) {
      const QString stem = QString::fromLatin1(name);
      const QFileInfo file(QDir(place), stem + QLatin1Char('/') + stem + QStringLiteral(".soffit"));
      if (file.exists()) found.append(file.canonicalFilePath());
    }
    if (!found.isEmpty()) return found;
  }
  return {};
}

}  // namespace soffit::ui
