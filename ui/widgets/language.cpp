// SPDX-License-Identifier: MIT
#include "ui/widgets/language.h"

#include "ui/widgets/shared_files.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

#include <clocale>

namespace soffit::ui {
namespace {

const QString kKey = QStringLiteral("language");

QString codeOf(Language language) {
  switch (language) {
    case Language::system:
      return QStringLiteral("system");
    case Language::english:
      return QStringLiteral("en");
    case Language::german:
      return QStringLiteral("de");
  }
  return {};
}

void add(const QString& file, const QString& folder) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  if (translator->load(file, folder)) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

}  // namespace

Language savedLanguage() {
  const QString code = QSettings().value(kKey).toString();
  for (const Language language : {Language::english, Language::german}) {
    if (code == codeOf(language)) return language;
  }
  return Language::system;
}

void saveLanguage(Language language) {
  QSettings().setValue(kKey, codeOf(language));
}

Language systemLanguage() {
  for (const QString& tag : QLocale::system().uiLanguages()) {
    const QString code = tag.section(QLatin1Char('-'), 0, 0);
    if (code == QLatin1String("de")) return Language::german;
    if (code == QLatin1String("en")) return Language::english;
  }
  return Language::english;
}

void applyLanguage(Language language) {
  if (language == Language::system) language = systemLanguage();
  for (QTranslator* old : QCoreApplication::instance()->findChildren<QTranslator*>()) delete old;
  const QString code = codeOf(language);
  add(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  add(QStringLiteral("soffit_") + code, sharedFolder(QStringLiteral("translations")));
  QLocale::setDefault(QLocale(language == Language::german ? QLocale::German : QLocale::English));
  // Qt takes the desktop's locale over into C, where libraries that read "0.5" out of a file with
  // strtod() would stop at the point.
  std::setlocale(LC_NUMERIC, "C");
}

}  // namespace soffit::ui
