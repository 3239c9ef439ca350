// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <QString>

#include <filesystem>
#include <string>

/// Between core's UTF-8 and Qt's strings.
namespace soffit::ui {

inline QString toQt(const std::string& text) {
  return QString::fromStdString(text);
}
inline std::string toStd(const QString& text) {
  return text.toStdString();
}

QString toQt(const std::filesystem::path& path);
std::filesystem::path toPath(const QString& path);

/// What the user is told of an error: its one line.
QString messageOf(const Error& error);

}  // namespace soffit::ui
