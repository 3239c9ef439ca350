// SPDX-License-Identifier: MIT
#include "ui/document/text.h"

namespace soffit::ui {

QString toQt(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

std::filesystem::path toPath(const QString& path) {
  return path.toStdString();
}

QString messageOf(const Error& error) {
  return toQt(error.message());
}

}  // namespace soffit::ui
