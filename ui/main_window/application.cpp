// SPDX-License-Identifier: MIT
#include "ui/main_window/application.h"

#include "ui/main_window/main_window.h"
#include "ui/widgets/language.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/units.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <QTimer>

namespace soffit::ui {

int runApplication(int argc, char** argv, const char* version) {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);  // VTK draws into its own
  format.setSamples(0);
  format.setSwapInterval(0);  // a frame is shown when it is ready
  QSurfaceFormat::setDefaultFormat(format);
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("soffit"));
  QApplication::setApplicationName(QStringLiteral("soffit"));
  QApplication::setApplicationDisplayName(QString());
  QApplication::setApplicationVersion(QString::fromLatin1(version));
  applyLanguage(savedLanguage());
  QCommandLineParser parser;
  parser.setApplicationDescription(QApplication::translate(
      "Application", "Interactive, converged light for indoor architecture"));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("project"),
                               QApplication::translate("Application", "Project or model to open"),
                               QStringLiteral("[project]"));
  parser.process(application);
  systemIsDark();  // before the palette is ours
  applyTheme(savedTheme());
  applyUnits(savedUnits());
  MainWindow window;
  window.show();
  if (!parser.positionalArguments().isEmpty())
    window.files().openFile(parser.positionalArguments().front());
  QTimer::singleShot(0, &window, [&window] { window.files().offerRecovery(); });
  return QApplication::exec();
}

}  // namespace soffit::ui
