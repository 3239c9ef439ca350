// SPDX-License-Identifier: MIT
#include "ui/document/state_folder.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUuid>

namespace soffit::ui {
namespace {

const QString kUntitled = QStringLiteral("untitled");

}  // namespace

QString stateFolder(const QString& name) {
  QString home = qEnvironmentVariable("XDG_STATE_HOME");
  // The XDG specification: relative paths there are to be ignored.
  if (home.isEmpty() || QDir::isRelativePath(home)) {
    home = QDir::home().filePath(QStringLiteral(".local/state"));
  }
  const QDir folder(QDir(home).filePath(QStringLiteral("soffit/") + name));
  folder.mkpath(QStringLiteral("."));
  return folder.path();
}

QString makeUntitledProject(const QString& name) {
  QDir folder(stateFolder(kUntitled));
  const QString own = QUuid::createUuid().toString(QUuid::WithoutBraces);
  if (!folder.mkpath(own) || !folder.cd(own)) return {};
  const QString path = folder.filePath(name + QStringLiteral(".soffit"));
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return {};
  const QJsonObject project{{QStringLiteral("soffit"), 1},
                            {QStringLiteral("name"), name},
                            {QStringLiteral("geometry"), QJsonArray()}};
  return file.write(QJsonDocument(project).toJson()) > 0 ? path : QString();
}

bool isUntitledProject(const QString& path) {
  QDir folder = QFileInfo(path).dir();
  return folder.cdUp() && folder.canonicalPath() == QDir(stateFolder(kUntitled)).canonicalPath();
}

void removeUntitledProject(const QString& path) {
  if (isUntitledProject(path)) QFileInfo(path).dir().removeRecursively();
}

}  // namespace soffit::ui
