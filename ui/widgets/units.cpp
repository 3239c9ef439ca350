// SPDX-License-Identifier: MIT
#include "ui/widgets/units.h"

#include <QApplication>
#include <QEvent>
#include <QSettings>
#include <QWidget>

namespace soffit::ui {
namespace {

const QString kKey = QStringLiteral("units");
const QString kImperial = QStringLiteral("imperial");
/// The application carries what is shown, as it does its palette.
constexpr const char* kProperty = "soffit_imperial";

}  // namespace

Units savedUnits() {
  return QSettings().value(kKey).toString() == kImperial ? Units::imperial : Units::metric;
}

void saveUnits(Units units) {
  QSettings().setValue(kKey, units == Units::imperial ? kImperial : QStringLiteral("metric"));
}

Units shownUnits() {
  const QCoreApplication* application = QCoreApplication::instance();
  return application != nullptr && application->property(kProperty).toBool() ? Units::imperial
                                                                             : Units::metric;
}

void applyUnits(Units units) {
  if (units == shownUnits()) return;
  QCoreApplication::instance()->setProperty(kProperty, units == Units::imperial);
  for (QWidget* widget : QApplication::allWidgets()) {
    QEvent change(QEvent::LocaleChange);
    QApplication::sendEvent(widget, &change);
    widget->update();
  }
}

}  // namespace soffit::ui
