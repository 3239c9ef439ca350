// SPDX-License-Identifier: MIT
#include "ui/actions/help_pages.h"

#include "ui/widgets/shared_files.h"

#include <QDir>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QTextDocument>

#include <algorithm>

namespace soffit::ui {
namespace {

const QString kIndex = QStringLiteral("index.md");

QString contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

HelpPage toPage(const QString& file, const QString& markdown) {
  QTextDocument document;
  document.setMarkdown(markdown);
  HelpPage page{file, {}, document.toPlainText()};
  page.title = page.text.section(QLatin1Char('\n'), 0, 0);
  return page;
}

bool titleHolds(const HelpPage& page, const QStringList& words) {
  return std::any_of(words.begin(), words.end(), [&](const QString& word) {
    return page.title.contains(word, Qt::CaseInsensitive);
  });
}

}  // namespace

QString helpFolder() {
  const QString help = sharedFolder(QStringLiteral("help"));
  const QString own = QLocale().name().section(QLatin1Char('_'), 0, 0);
  return QDir(help).filePath(QDir(help).exists(own) ? own : QStringLiteral("en"));
}

std::vector<HelpPage> readHelp(const QString& folder) {
  const QDir dir(folder);
  const QString index = contentOf(dir.filePath(kIndex));
  if (index.isEmpty()) return {};
  std::vector<HelpPage> pages{toPage(kIndex, index)};
  for (const QString& file : linksOf(index)) {
    const QString markdown = contentOf(dir.filePath(file));
    if (!markdown.isEmpty()) pages.push_back(toPage(file, markdown));
  }
  return pages;
}

QStringList searchWords(const QString& text) {
  static const QRegularExpression kWord(QStringLiteral("\"([^\"]+)\"|([^\\s\"]+)"));
  QStringList words;
  for (auto it = kWord.globalMatch(text); it.hasNext();) {
    const QRegularExpressionMatch match = it.next();
    words.append(match.captured(1) + match.captured(2));
  }
  return words;
}

std::vector<HelpHit> findInHelp(const std::vector<HelpPage>& pages, const QStringList& words) {
  std::vector<HelpHit> hits;
  if (words.isEmpty()) return hits;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    HelpHit hit{i, 0};
    const bool all = std::all_of(words.begin(), words.end(), [&](const QString& word) {
      const auto n = pages[i].text.count(word, Qt::CaseInsensitive);
      hit.count += static_cast<int>(n);
      return n > 0;
    });
    if (all) hits.push_back(hit);
  }
  std::stable_sort(hits.begin(), hits.end(), [&](const HelpHit& a, const HelpHit& b) {
    const bool title_a = titleHolds(pages[a.page], words);
    const bool title_b = titleHolds(pages[b.page], words);
    return title_a != title_b ? title_a : a.count > b.count;
  });
  return hits;
}

QStringList linksOf(const QString& markdown) {
  static const QRegularExpression kLink(QStringLiteral("\\]\\(([^)#:]+\\.md)\\)"));
  QStringList files;
  for (auto it = kLink.globalMatch(markdown); it.hasNext();) {
    const QString file = it.next().captured(1);
    if (!files.contains(file)) files.append(file);
  }
  return files;
}

}  // namespace soffit::ui
