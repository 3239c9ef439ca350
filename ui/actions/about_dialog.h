// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/library.h"

#include <QDialog>

#include <vector>

namespace soffit::ui {

/// What Soffit runs on, the ones that matter most to a picture first: Qt and VTK, then core's.
std::vector<Library> usedLibraries();

/// Version, compiler, libraries and licences, as text that can be copied into a report of a fault.
class AboutDialog : public QDialog {
  Q_OBJECT

 public:
  explicit AboutDialog(QWidget* parent);
};

}  // namespace soffit::ui
