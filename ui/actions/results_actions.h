// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "ui/jobs/background.h"
#include "ui/jobs/readings.h"

#include <QString>

#include <functional>

class QWidget;

namespace soffit::ui {

class Document;

/// Writes the figures of all layouts as `soffit compare` does (design::compareCsv).
/// Errors: the disk's. Waits for it: not for the GUI thread.
Result<void> writeReadings(const QString& path, const Readings& readings);

/// Asks for a file and writes it in the background. done: what is told when it is written.
void exportReadings(QWidget* parent, const Document& document, const ReadingsPtr& readings,
                    Background& background, const std::function<void(const QString& path)>& done);

}  // namespace soffit::ui
