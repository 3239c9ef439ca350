// SPDX-License-Identifier: MIT
// The texts in resources/translations: all that the sources say is there, finished, and fits.
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

namespace soffit::ui {
namespace {

struct Message {
  QString context;
  QString source;
  QStringList forms;  ///< one, or as many as the language has numbers
  bool plural = false;
  bool finished = true;

  [[nodiscard]] QString id() const { return context + QStringLiteral(": ") + source; }
};

QString textPath(const QString& language) {
  return QStringLiteral(SOFFIT_SOURCE_DIR "/resources/translations/soffit_%1.ts").arg(language);
}

QList<Message> readTexts(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QXmlStreamReader xml(&file);
  QList<Message> all;
  QString context;
  Message now;
  while (!xml.atEnd()) {
    xml.readNext();
    const QStringView name = xml.name();
    if (xml.isEndElement() && name == QLatin1String("message")) all.append(now);
    if (!xml.isStartElement()) continue;
    if (name == QLatin1String("name")) {
      context = xml.readElementText();
    } else if (name == QLatin1String("message")) {
      now = {};
      now.context = context;
      now.plural = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
    } else if (name == QLatin1String("source")) {
      now.source = xml.readElementText();
    } else if (name == QLatin1String("translation")) {
      now.finished = !xml.attributes().hasAttribute(QLatin1String("type"));
      if (!now.plural) now.forms.append(xml.readElementText());
    } else if (name == QLatin1String("numerusform")) {
      now.forms.append(xml.readElementText());
    }
  }
  return all;
}

/// All matches, sorted.
QStringList found(const QString& pattern, const QString& text) {
  QStringList all;
  for (auto it = QRegularExpression(pattern).globalMatch(text); it.hasNext();) {
    all.append(it.next().captured());
  }
  all.sort();
  return all;
}

/// What cuts a text off at its ends: "...", a colon, blanks.
QString endsOf(const QString& text) {
  static const QRegularExpression kEnds(QStringLiteral("^(\\s*).*?((?:\\.\\.\\.|…|:|\\s)*)$"),
                                        QRegularExpression::DotMatchesEverythingOption);
  const auto match = kEnds.match(text);
  return match.captured(1) + QLatin1Char('|') + match.captured(2);
}

QStringList faultsOf(const Message& m) {
  QStringList faults;
  const auto expect = [&](bool fits, const char* what) {
    if (!fits) faults.append(m.id() + QStringLiteral(": ") + QString::fromLatin1(what));
  };
  expect(m.finished, "is unfinished");
  for (const QString& form : m.forms) {
    expect(!form.isEmpty(), "is empty");
    expect(found(QStringLiteral("%L?[1-9]"), m.source) == found(QStringLiteral("%L?[1-9]"), form),
           "has other placeholders");
    expect(found(QStringLiteral("&(?=[^\\s&])"), m.source) ==
               found(QStringLiteral("&(?=[^\\s&])"), form),
           "has another number of accelerators");
    expect(endsOf(m.source) == endsOf(form), "ends otherwise");
    expect(m.source.count(QLatin1Char('\n')) == form.count(QLatin1Char('\n')), "has other lines");
    expect(found(QStringLiteral("<[^>]*>"), m.source) == found(QStringLiteral("<[^>]*>"), form),
           "has other markup");
  }
  // One of them may say its number in words.
  expect(!m.plural || m.forms.last().contains(QStringLiteral("%n")), "lacks its number");
  static const QRegularExpression kKeys(QStringLiteral("^((Ctrl|Shift|Alt)\\+)+\\w+$"));
  if (kKeys.match(m.source).hasMatch()) {
    expect(m.forms.first() == m.source, "are keys, which Qt translates");
  }
  return faults;
}

QString contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

class TranslationsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    // lupdate on a copy: what it would still add is what is missing.
    QVERIFY(folder_.isValid());
    updated_ = folder_.filePath(QStringLiteral("soffit_de.ts"));
    QVERIFY(QFile::copy(textPath(QStringLiteral("de")), updated_));
    QProcess lupdate;
    lupdate.setWorkingDirectory(QStringLiteral(SOFFIT_SOURCE_DIR));
    lupdate.setProcessChannelMode(QProcess::MergedChannels);
    lupdate.start(
        QStringLiteral(SOFFIT_LUPDATE),
        {QStringLiteral("-silent"), QStringLiteral("-locations"), QStringLiteral("none"),
         QStringLiteral("-no-obsolete"), QStringLiteral("-I"), QStringLiteral("."),
         QStringLiteral("app/gui"), QStringLiteral("ui"), QStringLiteral("-ts"), updated_});
    QVERIFY(lupdate.waitForFinished(120000));
    said_ = QString::fromUtf8(lupdate.readAll());
    QCOMPARE(lupdate.exitCode(), 0);
  }

  void everyTextIsTranslated() {
    QStringList missing;
    QSet<QString> wanted;
    for (const Message& m : readTexts(updated_)) {
      wanted.insert(m.id());
      if (!m.finished) missing.append(m.id());
    }
    QVERIFY2(wanted.size() > 500, "lupdate found hardly anything");
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QLatin1Char('\n')) +
                                           QStringLiteral("\nrun: ninja translations, then "
                                                          "translate what is unfinished")));
    QStringList gone;
    for (const Message& m : readTexts(textPath(QStringLiteral("de")))) {
      if (!wanted.contains(m.id())) gone.append(m.id());
    }
    QVERIFY2(gone.isEmpty(), qPrintable(gone.join(QLatin1Char('\n'))));
  }

  void translationsFitTheirSources_data() {
    QTest::addColumn<QString>("language");
    QTest::newRow("de") << QStringLiteral("de");
    QTest::newRow("en") << QStringLiteral("en");
  }
  void translationsFitTheirSources() {
    QFETCH(QString, language);
    const QList<Message> all = readTexts(textPath(language));
    QVERIFY(!all.isEmpty());
    QStringList faults;
    for (const Message& m : all) faults += faultsOf(m);
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
  }

  void everyPluralHasItsEnglishForms() {
    QSet<QString> english;
    for (const Message& m : readTexts(textPath(QStringLiteral("en")))) english.insert(m.id());
    for (const Message& m : readTexts(updated_)) {
      if (m.plural) QVERIFY2(english.contains(m.id()), qPrintable(m.id()));
    }
  }

  /// A tr() that looks texts up where lupdate does not put them finds none.
  void textsAreLookedUpWhereTheyAre() {
    static const QRegularExpression kLacking(QStringLiteral("Class '([^']+)' lacks Q_OBJECT"));
    for (auto it = kLacking.globalMatch(said_); it.hasNext();) {
      // Functions of the namespace, with a tr() of their file.
      QCOMPARE(it.next().captured(1), QStringLiteral("soffit::ui"));
    }
    static const QRegularExpression kOwn(QStringLiteral("translate\\(\"([^\"]+)\", text\\)"));
    QDirIterator files(QStringLiteral(SOFFIT_SOURCE_DIR "/ui"), {QStringLiteral("*.cpp")},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString path = files.next();
      const auto match = kOwn.match(contentOf(path));
      if (!match.hasMatch()) continue;
      QVERIFY2(match.captured(1) == QLatin1String("soffit::ui"), qPrintable(path));
    }
  }

  void theWordsOfCoreAreKnown() {
    QSet<QString> known;
    for (const Message& m : readTexts(updated_)) {
      if (m.context == QLatin1String("Core")) known.insert(m.source);
    }
    static const QRegularExpression kStage(QStringLiteral("\\breport\\(\\s*\"([^\"]+)\""));
    static const QRegularExpression kWord(QStringLiteral("\"([^\"]+)\""));
    QSet<QString> said;
    QDirIterator files(QStringLiteral(SOFFIT_SOURCE_DIR "/core"), {QStringLiteral("*.cpp")},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString text = contentOf(files.next());
      for (auto it = kStage.globalMatch(text); it.hasNext();) said.insert(it.next().captured(1));
    }
    const QString demand = contentOf(QStringLiteral(SOFFIT_SOURCE_DIR "/core/scene/demand.cpp"))
                               .section(QStringLiteral("Demand demandOf("), 1);
    for (auto it = kWord.globalMatch(demand); it.hasNext();) said.insert(it.next().captured(1));
    QVERIFY(said.size() > 20);
    said.subtract(known);
    QVERIFY2(said.isEmpty(), qPrintable(QStringList(said.values()).join(QStringLiteral(", ")) +
                                        QStringLiteral(": not in ui/document/core_words.cpp")));
  }

 private:
  QTemporaryDir folder_;
  QString updated_;
  QString said_;  ///< by lupdate
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::TranslationsTest)
#include "translations_test.moc"
