// SPDX-License-Identifier: MIT
#include "ui/actions/command_palette.h"
#include "ui/actions/key_bindings.h"
#include "ui/actions/keys_dialog.h"

#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

namespace soffit::ui {

class KeysTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
    QCoreApplication::setOrganizationName(QStringLiteral("soffit"));
    QCoreApplication::setApplicationName(QStringLiteral("keys-test"));
  }

  void init() {
    QSettings().clear();
    bar_ = std::make_unique<QMenuBar>();
    QMenu* edit = bar_->addMenu(QStringLiteral("&Edit"));
    move_ = edit->addAction(QStringLiteral("&Move"));
    move_->setShortcut(QKeySequence(Qt::Key_W));
    rotate_ = edit->addAction(QStringLiteral("&Rotate"));
    rotate_->setShortcut(QKeySequence(Qt::Key_E));
    edit->addSeparator();
    QMenu* snap = edit->addMenu(QStringLiteral("&Snap to"));
    grid_ = snap->addAction(QString::fromUtf8("&Grid…"));
    size_ = edit->addAction(QStringLiteral("Resi&ze"));
    size_->setShortcut(QKeySequence(Qt::Key_R));
  }

  void commandsHaveTheirPlaces() {
    const std::vector<Command> all = commandsOf(*bar_);
    QCOMPARE(all.size(), std::size_t{4});
    QCOMPARE(all[0].id, QStringLiteral("Edit/Move"));
    QCOMPARE(all[2].id, QStringLiteral("Edit/Snap to/Grid"));
    QCOMPARE(all[2].place, QString::fromUtf8("Edit › Snap to"));
  }

  void commandsAreFoundByWordsOfTheirNames() {
    const std::vector<Command> all = commandsOf(*bar_);
    QCOMPARE(commandsMatching(all, QStringLiteral("grid snap")).size(), std::size_t{1});
    QCOMPARE(commandsMatching(all, QStringLiteral("r")).front().id, QStringLiteral("Edit/Rotate"));
    QVERIFY(commandsMatching(all, QStringLiteral("nothing")).empty());
    rotate_->setEnabled(false);
    QCOMPARE(commandsMatching(all, QStringLiteral("rotate")).size(), std::size_t{0});
  }

  void changedKeysAreKeptAndTakenFromTheirOwner() {
    {
      KeyBindings keys(*bar_, nullptr);
      const QKeySequence e(Qt::Key_E);
      QVERIFY(keys.takenBy(e, QStringLiteral("Edit/Move")) != nullptr);
      keys.assign(QStringLiteral("Edit/Move"), e);
      QCOMPARE(move_->shortcut(), e);
      QVERIFY(rotate_->shortcut().isEmpty());
    }
    giveBuiltInKeys();
    KeyBindings again(*bar_, nullptr);
    QCOMPARE(move_->shortcut(), QKeySequence(Qt::Key_E));
    QVERIFY(rotate_->shortcut().isEmpty());
    again.resetAll();
    QCOMPARE(move_->shortcut(), QKeySequence(Qt::Key_W));
    QCOMPARE(rotate_->shortcut(), QKeySequence(Qt::Key_E));
  }

  void aPresetMovesKeysWithoutDoubles() {
    KeyBindings keys(*bar_, nullptr);
    keys.setPreset(QStringLiteral("Blender"));
    QCOMPARE(move_->shortcut(), QKeySequence(Qt::Key_G));
    QCOMPARE(rotate_->shortcut(), QKeySequence(Qt::Key_R));
    QCOMPARE(size_->shortcut(), QKeySequence(Qt::Key_S));
    keys.assign(QStringLiteral("Edit/Resize"), QKeySequence(Qt::Key_G));
    QVERIFY(move_->shortcut().isEmpty());
    keys.setPreset(QStringLiteral("Soffit"));
    QCOMPARE(rotate_->shortcut(), QKeySequence(Qt::Key_E));
    QCOMPARE(size_->shortcut(), QKeySequence(Qt::Key_G));
  }

  void entriesThatAreGoneAreLeftOut() {
    KeyBindings keys(*bar_, nullptr);
    delete move_;
    keys.assign(QStringLiteral("Edit/Rotate"), QKeySequence(Qt::Key_M));
    QCOMPARE(rotate_->shortcut(), QKeySequence(Qt::Key_M));
    QVERIFY(keys.keys(QStringLiteral("Edit/Move")).isEmpty());
    QCOMPARE(commandsMatching(keys.commands(), QString()).size(), std::size_t{3});
    KeysDialog dialog(keys, nullptr);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    QCOMPARE(dialog.findChild<QTreeWidget*>()->topLevelItem(0)->childCount(), 2);
  }

  void keptNonsenseIsNoPreset() {
    QSettings().setValue(QStringLiteral("keys/preset"), QStringLiteral("Emacs"));
    const KeyBindings keys(*bar_, nullptr);
    QCOMPARE(keys.preset(), QStringLiteral("Soffit"));
    QCOMPARE(move_->shortcut(), QKeySequence(Qt::Key_W));
  }

  void thePaletteRunsWhatIsTyped() {
    QSignalSpy ran(rotate_, &QAction::triggered);
    auto* palette = new CommandPalette(commandsOf(*bar_), nullptr);
    palette->show();
    auto* line = palette->findChild<QLineEdit*>();
    QTest::keyClicks(line, QStringLiteral("rot"));
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_COMPARE(ran.size(), 1);
    // What was run last stands first.
    auto* next = new CommandPalette(commandsOf(*bar_), nullptr);
    QCOMPARE(next->findChild<QTreeWidget*>()->topLevelItem(0)->text(0), QStringLiteral("Rotate"));
    QTest::keyClick(next->findChild<QLineEdit*>(), Qt::Key_Down);
    QCOMPARE(next->findChild<QTreeWidget*>()->currentItem()->text(0), QStringLiteral("Move"));
    next->close();
  }

  void theDialogAssigns() {
    KeyBindings keys(*bar_, nullptr);
    auto* dialog = new KeysDialog(keys, nullptr);
    dialog->show();
    auto* list = dialog->findChild<QTreeWidget*>();
    list->setCurrentItem(list->topLevelItem(0)->child(0));
    dialog->findChild<QKeySequenceEdit*>()->setKeySequence(QKeySequence(Qt::Key_M));
    for (QPushButton* b : dialog->findChildren<QPushButton*>()) {
      if (b->text() == QStringLiteral("&Assign")) b->click();
    }
    QCOMPARE(move_->shortcut(), QKeySequence(Qt::Key_M));
    QCOMPARE(list->currentItem()->text(1), QStringLiteral("M"));
    dialog->findChild<QLineEdit*>()->setText(QStringLiteral("grid"));
    QVERIFY(list->topLevelItem(0)->isHidden());
    dialog->close();
  }

 private:
  void giveBuiltInKeys() {
    move_->setShortcut(QKeySequence(Qt::Key_W));
    rotate_->setShortcut(QKeySequence(Qt::Key_E));
  }

  QTemporaryDir folder_;
  std::unique_ptr<QMenuBar> bar_;
  QAction* move_ = nullptr;
  QAction* rotate_ = nullptr;
  QAction* grid_ = nullptr;
  QAction* size_ = nullptr;
};

}  // namespace soffit::ui

QTEST_MAIN(soffit::ui::KeysTest)
#include "keys_test.moc"
