// SPDX-License-Identifier: MIT
#include "ui/actions/about_dialog.h"
#include "ui/actions/help_pages.h"
#include "ui/actions/help_window.h"

#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QTextBrowser>

#include <algorithm>

namespace soffit::ui {
namespace {

QString folderOf(const QString& language) {
  return QStringLiteral(SOFFIT_SOURCE_DIR "/resources/help/") + language;
}

QStringList filesIn(const QString& folder) {
  return QDir(folder).entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name);
}

QString contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

class HelpTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bothLanguagesHaveTheSamePages() {
    QCOMPARE(filesIn(folderOf(QStringLiteral("de"))), filesIn(folderOf(QStringLiteral("en"))));
    QVERIFY(filesIn(folderOf(QStringLiteral("en"))).size() > 10);
    QStringList orders[2];
    int i = 0;
    for (const char* language : {"en", "de"}) {
      for (const HelpPage& page : readHelp(folderOf(QString::fromLatin1(language)))) {
        orders[i].append(page.file);
      }
      ++i;
    }
    QCOMPARE(orders[1], orders[0]);
  }

  void pagesAreListedTitledAndLinkedTo_data() { languages(); }
  void pagesAreListedTitledAndLinkedTo() {
    QFETCH(QString, language);
    const QString folder = folderOf(language);
    const QStringList files = filesIn(folder);
    const std::vector<HelpPage> pages = readHelp(folder);
    QCOMPARE(static_cast<qsizetype>(pages.size()), files.size());
    for (const HelpPage& page : pages) {
      const QString markdown = contentOf(QDir(folder).filePath(page.file));
      QVERIFY2(markdown.startsWith(QStringLiteral("# ")), qPrintable(page.file));
      QVERIFY2(!page.title.isEmpty() && page.text.size() > 300, qPrintable(page.file));
      for (const QString& link : linksOf(markdown)) {
        QVERIFY2(files.contains(link), qPrintable(page.file + QStringLiteral(" → ") + link));
      }
    }
  }

  void linksAreFoundOnce() {
    QCOMPARE(linksOf(QStringLiteral("[a](x.md), [b](http://y.md) [c](z.md#d) [e](x.md)")),
             QStringList{QStringLiteral("x.md")});
  }

  void wordsAreSearchedAllAtOnce() {
    const std::vector<HelpPage> pages{
        {QStringLiteral("a"), QStringLiteral("Colour"), QStringLiteral("light light scene")},
        {QStringLiteral("b"), QStringLiteral("Light"), QStringLiteral("Light and a scene")},
        {QStringLiteral("c"), QStringLiteral("Other"), QStringLiteral("light alone")}};
    const auto hits = findInHelp(pages, {QStringLiteral("light"), QStringLiteral("scene")});
    QCOMPARE(hits.size(), std::size_t{2});
    QCOMPARE(hits[0].page, std::size_t{1});  // in its title
    QCOMPARE(hits[1].count, 3);
    QVERIFY(findInHelp(pages, {}).empty());
    QCOMPARE(
        searchWords(QStringLiteral(" work \"light scene\"  x")),
        (QStringList{QStringLiteral("work"), QStringLiteral("light scene"), QStringLiteral("x")}));
  }

  void theWindowSearchesMarksAndGoesBack_data() { languages(); }
  void theWindowSearchesMarksAndGoesBack() {
    QFETCH(QString, language);
    HelpWindow window(folderOf(language), nullptr);
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.show();
    auto* list = window.findChild<QListWidget*>();
    auto* text = window.findChild<QTextBrowser*>();
    QCOMPARE(window.currentPage(), QStringLiteral("index.md"));
    const int all = list->count();
    window.showPage(QStringLiteral("materials.md"));
    QCOMPARE(list->currentItem()->data(Qt::UserRole).toString(), QStringLiteral("materials.md"));
    window.search(QStringLiteral("IES LDT"));
    QVERIFY(list->count() > 0 && list->count() < all);
    QVERIFY(window.markedCount() > 0);
    QVERIFY(text->textCursor().position() > 0);
    window.search({});
    QCOMPARE(list->count(), all);
    QCOMPARE(window.markedCount(), 0);
    QVERIFY(text->isBackwardAvailable());
    text->backward();
    text->backward();
    QCOMPARE(window.currentPage(), QStringLiteral("index.md"));
  }

  void whereThereIsNoHelpTheWindowSaysSo() {
    HelpWindow window(QStringLiteral("/nowhere"), nullptr);
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.showPage(QStringLiteral("materials.md"));
    QVERIFY(window.findChild<QTextBrowser*>()->toPlainText().contains(QStringLiteral("/nowhere")));
  }

  void theAboutBoxKnowsTheLibraries() {
    const std::vector<Library> libraries = usedLibraries();
    for (const char* name : {"Qt", "VTK", "Embree", "OpenColorIO", "OpenImageIO", "Assimp",
                             "oneTBB", "Eigen", "GLM"}) {
      const auto found = std::ranges::find(libraries, std::string(name), &Library::name);
      QVERIFY2(found != libraries.end(), name);
      QVERIFY2(!found->version.empty() && found->version[0] >= '0' && found->version[0] <= '9',
               found->version.c_str());
      QVERIFY2(!found->licence.empty(), name);
    }
    AboutDialog dialog(nullptr);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    for (QPushButton* b : dialog.findChildren<QPushButton*>()) {
      if (b->text().contains(QStringLiteral("versions"))) b->click();
    }
    QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("Embree")));
  }

 private:
  static void languages() {
    QTest::addColumn<QString>("language");
    QTest::newRow("en") << QStringLiteral("en");
    QTest::newRow("de") << QStringLiteral("de");
  }
};

}  // namespace soffit::ui

QTEST_MAIN(soffit::ui::HelpTest)
#include "help_test.moc"
