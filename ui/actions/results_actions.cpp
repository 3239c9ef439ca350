// SPDX-License-Identifier: MIT
#include "ui/actions/results_actions.h"

#include "core/design/compare_table.h"
#include "core/io/project/atomic_file.h"
#include "ui/actions/file_dialogs.h"
#include "ui/document/text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>

namespace soffit::ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

}  // namespace

Result<void> writeReadings(const QString& path, const Readings& readings) {
  std::vector<design::LayoutFigures> figures;
  for (const LayoutReading& reading : readings.layouts) figures.push_back(reading.figures);
  return io::writeFileAtomically(toPath(path), design::compareCsv(figures));
}

void exportReadings(QWidget* parent, const Document& document, const ReadingsPtr& readings,
                    Background& background, const std::function<void(const QString& path)>& done) {
  if (readings == nullptr) return;
  const QFileInfo project(document.path());
  const QString suggestion =
      project.dir().filePath(project.completeBaseName() + QStringLiteral(".csv"));
  QString path = QFileDialog::getSaveFileName(parent, tr("Export the readings"), suggestion,
                                              tr("Comma-separated values (*.csv)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".csv");
  background.run([path, readings, done, parent = QPointer<QWidget>(parent)]() -> Background::End {
    const auto written = writeReadings(path, *readings);
    const QString message = written ? QString() : messageOf(written.error());
    return [path, message, done, parent] {
      if (message.isEmpty()) {
        done(path);
      } else {
        showError(parent, tr("The readings were not written"), message);
      }
    };
  });
}

}  // namespace soffit::ui
