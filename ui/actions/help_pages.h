// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace soffit::ui {

/// A page of the help: a Markdown file of share/soffit/help/LANGUAGE.
struct HelpPage {
  QString file;   ///< its name in the folder: "materials.md"
  QString title;  ///< its first heading
  QString text;   ///< what is read of it, without marks
};

/// The folder of the help in the window's language; the English one where there is none.
QString helpFolder();

/// The pages of a folder: index.md, then those that it links to, in that order.
std::vector<HelpPage> readHelp(const QString& folder);

/// A page that holds all words that were searched for.
struct HelpHit {
  std::size_t page = 0;
  int count = 0;  ///< how often any of them stands there
};

/// The words of a search: what stands between quotes is one.
QStringList searchWords(const QString& text);

/// Pages with all words as parts of theirs, in any case; those whose title holds one first, then by
/// their number. No words: no hits.
std::vector<HelpHit> findInHelp(const std::vector<HelpPage>& pages, const QStringList& words);

/// The files that a Markdown text links to, in order, each once: "materials.md".
QStringList linksOf(const QString& markdown);

}  // namespace soffit::ui
