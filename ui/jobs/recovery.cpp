// SPDX-License-Identifier: MIT
#include "ui/jobs/recovery.h"

#include "ui/document/state_folder.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>

#include <algorithm>

namespace soffit::ui {
namespace {

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Whether no running program holds the version.
bool isOrphan(const QString& id) {
  QLockFile lock(recoveryFile(id, QStringLiteral("lock")));
  lock.setStaleLockTime(0);  // no lock is too old; that of a dead process is free
  return lock.tryLock(0);
}

}  // namespace

QString recoveryFolder() {
  return stateFolder(QStringLiteral("recovery"));
}

QString recoveryFile(const QString& id, const QString& ending) {
  return QDir(recoveryFolder()).filePath(id + QLatin1Char('.') + ending);
}

QList<Recovery> findRecoveries() {
  QList<Recovery> found;
  const QStringList names =
      QDir(recoveryFolder()).entryList({QStringLiteral("*.json")}, QDir::Files);
  for (const QString& name : names) {
    Recovery recovery;
    recovery.id = name.chopped(5);
    const QJsonObject facts =
        QJsonDocument::fromJson(read(recoveryFile(recovery.id, QStringLiteral("json")))).object();
    recovery.path = facts.value(QStringLiteral("path")).toString();
    recovery.name = facts.value(QStringLiteral("name")).toString();
    recovery.saved =
        QDateTime::fromString(facts.value(QStringLiteral("saved")).toString(), Qt::ISODate);
    recovery.thumbnail = QImage(recoveryFile(recovery.id, QStringLiteral("png")));
    const bool whole = QFile::exists(recoveryFile(recovery.id, QStringLiteral("soffit")));
    if (recovery.path.isEmpty() || !whole || !isOrphan(recovery.id)) continue;
    found.append(recovery);
  }
  std::ranges::sort(found, std::ranges::greater(), &Recovery::saved);
  return found;
}

QByteArray recoveredText(const QString& id) {
  return read(recoveryFile(id, QStringLiteral("soffit")));
}

void discardRecovery(const QString& id) {
  for (const char* ending : {"json", "soffit", "soffit~", "png", "lock"}) {
    QFile::remove(recoveryFile(id, QString::fromLatin1(ending)));
  }
}

}  // namespace soffit::ui
