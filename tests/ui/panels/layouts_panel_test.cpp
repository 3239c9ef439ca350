// SPDX-License-Identifier: MIT
#include "ui/panels/layouts_panel.h"

#include "ui/document/text.h"

#include <QListWidget>
#include <QTest>

namespace soffit::ui {

class LayoutsPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<Document>(*io::loadProject(SOFFIT_SOURCE_DIR "/projects/cornell"));
    panel_ = std::make_unique<LayoutsPanel>();
    panel_->setDocument(document_.get());
    list_ = panel_->findChild<QListWidget*>();
  }
  void cleanup() {
    panel_.reset();
    document_.reset();
  }

  void aCopyIsShownAndUndoneInOneStep() {
    panel_->duplicateShown();
    QCOMPARE(names().last(), QStringLiteral("Classic 2"));
    QCOMPARE(document_->layout(), QStringLiteral("Classic 2"));
    document_->undoStack()->undo();
    QCOMPARE(document_->layout(), QStringLiteral("Classic"));
    QCOMPARE(list_->count(), 4);
    document_->undoStack()->redo();
    QCOMPARE(document_->layout(), QStringLiteral("Classic 2"));
  }

  void aNameIsTypedInTheList() {
    list_->item(1)->setText(QStringLiteral("Morning"));
    QCOMPARE(document_->layout(), QStringLiteral("Morning"));
    QCOMPARE(names().front(), QStringLiteral("Morning"));
    document_->undoStack()->undo();
    QCOMPARE(document_->layout(), QStringLiteral("Classic"));
    QCOMPARE(list_->item(1)->text(), QStringLiteral("Classic"));
  }

  void aNameThatIsTakenComesBack() {
    list_->item(1)->setText(QStringLiteral("Coloured"));
    QCOMPARE(list_->item(1)->text(), QStringLiteral("Classic"));
    list_->item(1)->setText(QString());
    QCOMPARE(list_->item(1)->text(), QStringLiteral("Classic"));
    QVERIFY(!document_->undoStack()->canUndo());
  }

  void deletingShowsTheNeighbour() {
    document_->setLayout(QStringLiteral("Light moved"));
    panel_->deleteShown();
    QCOMPARE(names(), (QStringList{QStringLiteral("Classic"), QStringLiteral("Coloured")}));
    QCOMPARE(document_->layout(), QStringLiteral("Coloured"));
    document_->undoStack()->undo();
    QCOMPARE(document_->layout(), QStringLiteral("Light moved"));
    document_->setLayout({});
    panel_->deleteShown();
    QCOMPARE(names().size(), 3);
  }

  void theOrderIsChangedByKeysAndByDragging() {
    panel_->moveShown(1);
    QCOMPARE(names().at(1), QStringLiteral("Classic"));
    panel_->moveShown(-1);
    panel_->moveShown(-1);  // the base stays first
    QCOMPARE(names().front(), QStringLiteral("Classic"));
    // What a drag in the list does in the end.
    QVERIFY(list_->model()->moveRow({}, 3, {}, 1));
    QCOMPARE(names().front(), QStringLiteral("Coloured"));
    QCOMPARE(list_->item(1)->text(), QStringLiteral("Coloured"));
    QCOMPARE(document_->layout(), QStringLiteral("Classic"));
    document_->undoStack()->undo();
    QCOMPARE(list_->item(3)->text(), QStringLiteral("Coloured"));
  }

 private:
  [[nodiscard]] QStringList names() const {
    QStringList names;
    for (const scene::Layout& layout : document_->scene()->layouts) names.append(toQt(layout.name));
    return names;
  }

  std::unique_ptr<Document> document_;
  std::unique_ptr<LayoutsPanel> panel_;
  QListWidget* list_ = nullptr;
};

}  // namespace soffit::ui

QTEST_MAIN(soffit::ui::LayoutsPanelTest)
#include "layouts_panel_test.moc"
