// SPDX-License-Identifier: MIT
#include "ui/widgets/shared_files.h"

#include <QCoreApplication>
#include <QDir>

namespace soffit::ui {

QString sharedFolder(const QString& name) {
  return QDir::cleanPath(QDir(QCoreApplication::applicationDirPath())
                             .filePath(QStringLiteral("../share/soffit/") + name));
}

}  // namespace soffit::ui
