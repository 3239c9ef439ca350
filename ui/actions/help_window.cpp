// SPDX-License-Identifier: MIT
#include "ui/actions/help_window.h"

#include <QDir>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace soffit::ui {
namespace {

constexpr QSize kSize(900, 640);
constexpr int kContentsWidth = 260;
constexpr QColor kMark(255, 205, 64);
const QString kIndex = QStringLiteral("index.md");

QToolButton* button(Qt::ArrowType arrow, const QString& text, const QKeySequence& keys) {
  auto* made = new QToolButton;
  made->setArrowType(arrow);
  made->setToolTip(keys.isEmpty() ? text
                                  : QStringLiteral("%1 (%2)").arg(
                                        text, keys.toString(QKeySequence::NativeText)));
  made->setAccessibleName(text);
  made->setAutoRaise(true);
  made->setShortcut(keys);
  return made;
}

}  // namespace

HelpWindow::HelpWindow(const QString& folder, QWidget* parent)
    : QDialog(parent),
      folder_(folder),
      pages_(readHelp(folder)),
      search_(new QLineEdit),
      list_(new QListWidget),
      text_(new QTextBrowser),
      state_(new QLabel),
      previous_(button(Qt::UpArrow, tr("Previous hit"), QKeySequence::FindPrevious)),
      next_(button(Qt::DownArrow, tr("Next hit"), QKeySequence::FindNext)) {
  setObjectName(QStringLiteral("help"));
  setWindowTitle(tr("Help for Soffit"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* halves = new QSplitter;
  halves->addWidget(makeContents());
  halves->addWidget(makeReader());
  halves->setStretchFactor(1, 1);
  halves->setSizes({kContentsWidth, kSize.width() - kContentsWidth});
  halves->setChildrenCollapsible(false);
  auto* box = new QVBoxLayout(this);
  box->addWidget(halves);
  auto* find = new QShortcut(QKeySequence::Find, this);
  connect(find, &QShortcut::activated, this, [this] {
    search_->setFocus();
    search_->selectAll();
  });
  resize(kSize);
  fill();
  if (!pages_.empty()) showPage(pages_.front().file);
  search_->setFocus();
}

QWidget* HelpWindow::makeContents() {
  auto* side = new QWidget;
  search_->setPlaceholderText(tr("Search all pages"));
  search_->setClearButtonEnabled(true);
  search_->installEventFilter(this);
  list_->setAccessibleName(tr("Contents"));
  list_->setWordWrap(true);
  list_->setSpacing(2);
  state_->setWordWrap(true);
  state_->setForegroundRole(QPalette::PlaceholderText);
  auto* row = new QHBoxLayout;
  row->addWidget(state_, 1);
  row->addWidget(previous_);
  row->addWidget(next_);
  auto* box = new QVBoxLayout(side);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(search_);
  box->addLayout(row);
  box->addWidget(list_, 1);
  connect(search_, &QLineEdit::textChanged, this, &HelpWindow::fill);
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr) showPage(item->data(Qt::UserRole).toString());
  });
  connect(previous_, &QToolButton::clicked, this, [this] { goToHit(-1); });
  connect(next_, &QToolButton::clicked, this, [this] { goToHit(1); });
  return side;
}

QWidget* HelpWindow::makeReader() {
  auto* side = new QWidget;
  QToolButton* back = button(Qt::LeftArrow, tr("Back"), QKeySequence::Back);
  QToolButton* forward = button(Qt::RightArrow, tr("Forward"), QKeySequence::Forward);
  auto* home = new QToolButton;
  home->setText(tr("Contents"));
  home->setAutoRaise(true);
  back->setEnabled(false);
  forward->setEnabled(false);
  text_->setOpenExternalLinks(true);
  text_->setFrameShape(QFrame::NoFrame);
  text_->setSearchPaths({folder_});
  auto* row = new QHBoxLayout;
  for (QToolButton* b : {back, forward, home}) row->addWidget(b);
  row->addStretch(1);
  auto* box = new QVBoxLayout(side);
  box->setContentsMargins(0, 0, 0, 0);
  box->addLayout(row);
  box->addWidget(text_, 1);
  connect(back, &QToolButton::clicked, text_, &QTextBrowser::backward);
  connect(forward, &QToolButton::clicked, text_, &QTextBrowser::forward);
  connect(home, &QToolButton::clicked, this, [this] { showPage(kIndex); });
  connect(text_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(text_, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
  connect(text_, &QTextBrowser::sourceChanged, this, [this](const QUrl& source) {
    page_ = source.fileName();
    dress();
    mark();
    const QSignalBlocker quiet(list_);
    for (int i = 0; i < list_->count(); ++i) {
      if (list_->item(i)->data(Qt::UserRole).toString() == currentPage()) list_->setCurrentRow(i);
    }
  });
  return side;
}

void HelpWindow::showPage(const QString& file) {
  const bool known = std::any_of(pages_.begin(), pages_.end(),
                                 [&](const HelpPage& page) { return page.file == file; });
  if (pages_.empty()) {
    text_->setPlainText(tr("The pages of the help were not found in %1.").arg(folder_));
    return;
  }
  const QString shown = known ? file : pages_.front().file;
  if (shown == currentPage()) return;
  text_->setSource(QUrl::fromLocalFile(QDir(folder_).filePath(shown)));
}

/// Without a search the contents; else the pages that hold it.
void HelpWindow::fill() {
  const QStringList words = searchWords(search_->text());
  const std::vector<HelpHit> hits = findInHelp(pages_, words);
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    const auto add = [this](const HelpPage& page, const QString& text) {
      auto* item = new QListWidgetItem(text, list_);
      item->setData(Qt::UserRole, page.file);
      if (page.file == currentPage()) list_->setCurrentItem(item);
    };
    if (words.isEmpty()) {
      for (const HelpPage& page : pages_) add(page, page.title);
    }
    for (const HelpHit& hit : hits) {
      const HelpPage& page = pages_[hit.page];
      add(page, QStringLiteral("%1  (%2)").arg(page.title).arg(hit.count));
    }
  }
  state_->setText(words.isEmpty() ? QString()
                  : hits.empty()  ? tr("On no page")
                                  : tr("On %n page(s)", nullptr, static_cast<int>(hits.size())));
  for (QToolButton* b : {previous_, next_}) b->setVisible(!hits.empty());
  // The page at hand stays if it is one of them, but for the contents, which hold a bit of each.
  if (!hits.empty() && (list_->currentItem() == nullptr || currentPage() == kIndex)) {
    showPage(pages_[hits.front().page].file);
  }
  mark();
}

void HelpWindow::search(const QString& text) {
  search_->setText(text);
}

/// Room about headings and lines in tables: Markdown has none of its own.
void HelpWindow::dress() {
  QTextDocument& document = *text_->document();
  document.setDocumentMargin(18);
  document.setIndentWidth(22);
  QTextCursor cursor(&document);
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    cursor.setPosition(block.position());
    QTextBlockFormat format = block.blockFormat();
    const bool heading = format.headingLevel() > 0;
    if (cursor.currentTable() != nullptr) continue;
    format.setTopMargin(heading && block.blockNumber() > 0 ? 16 : 3);
    format.setBottomMargin(heading ? 6 : 5);
    format.setLineHeight(118, QTextBlockFormat::ProportionalHeight);
    cursor.setBlockFormat(format);
  }
  for (QTextFrame* frame : document.rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat format = table->format();
    format.setCellPadding(5);
    format.setCellSpacing(0);
    format.setBorder(1);
    format.setBorderCollapse(true);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(palette().mid());
    format.setTopMargin(6);
    format.setBottomMargin(10);
    table->setFormat(format);
  }
  text_->verticalScrollBar()->setValue(0);
}

void HelpWindow::mark() {
  QList<QTextEdit::ExtraSelection> marks;
  for (const QString& word : searchWords(search_->text())) {
    QTextCursor at(text_->document());
    while (!(at = text_->document()->find(word, at)).isNull()) {
      QTextEdit::ExtraSelection one;
      one.cursor = at;
      one.format.setBackground(kMark);
      one.format.setForeground(Qt::black);
      marks.append(one);
    }
  }
  std::sort(marks.begin(), marks.end(),
            [](const QTextEdit::ExtraSelection& a, const QTextEdit::ExtraSelection& b) {
              return a.cursor.position() < b.cursor.position();
            });
  text_->setExtraSelections(marks);
  if (!marks.isEmpty()) {
    QTextCursor start(text_->document());
    text_->setTextCursor(start);
    goToHit(1);
  }
}

int HelpWindow::markedCount() const {
  return static_cast<int>(text_->extraSelections().size());
}

void HelpWindow::goToHit(int by) {
  const auto marks = text_->extraSelections();
  if (marks.isEmpty()) return;
  const int now = text_->textCursor().position();
  // Round at the ends.
  qsizetype chosen = by > 0 ? 0 : marks.size() - 1;
  for (qsizetype i = 0; i < marks.size(); ++i) {
    const int at = marks[i].cursor.position();
    if (by > 0 && at > now) {
      chosen = i;
      break;
    }
    if (by < 0 && at < now) chosen = i;
  }
  QTextCursor to(text_->document());
  to.setPosition(marks[chosen].cursor.position());
  text_->setTextCursor(to);
  text_->ensureCursorVisible();
}

bool HelpWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == search_ && event->type() == QEvent::KeyPress) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter) {
      goToHit((key.modifiers() & Qt::ShiftModifier) != 0 ? -1 : 1);
      return true;
    }
    if (key.key() == Qt::Key_Down || key.key() == Qt::Key_Up) {
      const int row = list_->currentRow() + (key.key() == Qt::Key_Down ? 1 : -1);
      if (row >= 0 && row < list_->count()) list_->setCurrentRow(row);
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace soffit::ui
