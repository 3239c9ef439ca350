// SPDX-License-Identifier: MIT
#include "ui/widgets/language.h"

#include "ui/actions/commands.h"
#include "ui/main_window/main_window.h"
#include "ui/widgets/quantity_box.h"

#include <QApplication>
#include <QLineEdit>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTest>

#include <clocale>
#include <cstdlib>

namespace soffit::ui {
namespace {

QStringList idsOf(const std::vector<Command>& commands) {
  QStringList ids;
  for (const Command& c : commands) ids.append(c.id);
  return ids;
}

/// Letters that two entries of a menu share.
QStringList sharedLetters(const QList<QAction*>& actions, const QString& place) {
  QStringList faults;
  QHash<QString, QString> taken;
  for (const QAction* action : actions) {
    if (action->menu() != nullptr) {
      faults += sharedLetters(action->menu()->actions(), place + action->text() + QLatin1Char('/'));
    }
    const QObject* named =
        action->menu() != nullptr ? static_cast<const QObject*>(action->menu()) : action;
    const auto at = action->text().indexOf(QLatin1Char('&'));
    if (at < 0 || named->objectName().isEmpty()) continue;
    const QString letter = action->text().mid(at + 1, 1).toLower();
    if (taken.contains(letter)) {
      faults.append(place + taken[letter] + QStringLiteral(" = ") + action->text());
    }
    taken[letter] = action->text();
  }
  return faults;
}

}  // namespace

class LanguageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { applyLanguage(Language::english); }

  void commandsAreNamedAlikeInEveryLanguage() {
    applyLanguage(Language::english);
    const MainWindow english;
    const std::vector<Command> named = commandsOf(*english.menuBar());
    QVERIFY(named.size() > 60);
    for (const Command& c : named) {
      // The names under which keys have always been kept.
      QString place = c.place;
      place.replace(QStringLiteral(" › "), QStringLiteral("/"));
      QCOMPARE(c.id, place + QLatin1Char('/') + c.name);
    }
    applyLanguage(Language::german);
    const MainWindow german;
    QCOMPARE(idsOf(commandsOf(*german.menuBar())), idsOf(named));
    QCOMPARE(german.menuBar()->actions().front()->text(), QStringLiteral("&Datei"));
  }

  void lettersOfAMenuDiffer() {
    for (const Language language : {Language::english, Language::german}) {
      applyLanguage(language);
      const MainWindow window;
      const QStringList faults = sharedLetters(window.menuBar()->actions(), {});
      QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }
  }

  void qtSpeaksItToo() {
    applyLanguage(Language::german);
    QCOMPARE(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("Abbrechen"));
    // Keys are shown in the language, and read in both.
    const QKeySequence keys(QStringLiteral("Ctrl+Shift+S"));
    QCOMPARE(keys.toString(QKeySequence::NativeText), QStringLiteral("Strg+Umschalt+S"));
    QCOMPARE(keys.toString(QKeySequence::PortableText), QStringLiteral("Ctrl+Shift+S"));
    QCOMPARE(keys[0].keyboardModifiers(), Qt::ControlModifier | Qt::ShiftModifier);
  }

  void numbersHaveTheMarkOfTheLanguage() {
    applyLanguage(Language::german);
    QCOMPARE(formatQuantity(1.25, Dimension::length, 3), QStringLiteral("1,25\u00a0m"));
    QCOMPARE(formatQuantity(1200.0, Dimension::flux, 1), QStringLiteral("1200\u00a0lm"));
    for (const char* text : {"1,25", "1.25 m", "125 cm"}) {
      QCOMPARE(parseQuantity(QString::fromLatin1(text), Dimension::length), std::optional(1.25));
    }
    QuantityBox box(Dimension::length);
    box.setValue(2.5);
    auto* line = box.findChild<QLineEdit*>();
    QCOMPARE(line->text(), QStringLiteral("2,5\u00a0m"));
    box.stepBy(1);
    QCOMPARE(line->text(), QStringLiteral("2,6\u00a0m"));
    applyLanguage(Language::english);
    QCOMPARE(formatQuantity(1.25, Dimension::length, 3), QStringLiteral("1.25\u00a0m"));
  }

  void filesAreReadWithAPoint() {
    applyLanguage(Language::german);
    QCOMPARE(std::localeconv()->decimal_point, ".");
    QCOMPARE(std::strtod("0.5", nullptr), 0.5);
    QCOMPARE(QString::number(0.5), QStringLiteral("0.5"));
  }

  void theChoiceIsKept() {
    QCOMPARE(savedLanguage(), Language::system);
    saveLanguage(Language::german);
    QCOMPARE(savedLanguage(), Language::german);
    saveLanguage(Language::system);
    QCOMPARE(savedLanguage(), Language::system);
  }
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);
  QSurfaceFormat::setDefaultFormat(format);
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("soffit-test"));
  QApplication::setApplicationName(QStringLiteral("soffit-language-test"));
  QSettings().clear();
  soffit::ui::LanguageTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "language_test.moc"
