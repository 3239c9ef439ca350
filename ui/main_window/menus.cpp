// SPDX-License-Identifier: MIT
// The menus of the main window: what stands in them and what it calls.
#include "ui/actions/actions.h"
#include "ui/actions/file_dialogs.h"
#include "ui/actions/luminaire_actions.h"
#include "ui/document/recent_files.h"
#include "ui/main_window/main_window.h"
#include "ui/widgets/theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QUndoGroup>

namespace soffit::ui {

void MainWindow::forProject(QAction* action) {
  project_actions_.append(action);
}

void MainWindow::makeMenus() {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeLuminaireMenu();
  makeResultsMenu();
  makeLayoutsMenu();
  makeOtherMenus();
}

void MainWindow::makeEditMenu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
  QAction* undo = undo_->createUndoAction(this, tr("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = undo_->createRedoAction(this, tr("Redo"));
  redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
  menu.addActions({undo, redo});
  menu.addSeparator();
  forProject(addEntry(menu, {tr("&Duplicate"), QKeySequence(tr("Ctrl+D")), {}}, this,
                      [this] { duplicateSelection(session_->document()); }));
  forProject(addEntry(menu, {tr("De&lete"), QKeySequence::Delete, {}}, this,
                      [this] { deleteSelection(session_->document()); }));
  forProject(addEntry(menu, {tr("Select &all"), QKeySequence::SelectAll, {}}, this,
                      [this] { selectAll(session_->document()); }));
}

void MainWindow::makeViewMenu() {
  QMenu& menu = *menuBar()->addMenu(tr("&View"));
  forProject(addEntry(menu, {tr("Frame &all"), QKeySequence(Qt::Key_Home), {}}, this,
                      [this] { workspace_.area->view().frameAll(); }));
  forProject(addEntry(menu, {tr("Frame &selection"), QKeySequence(Qt::Key_Period), {}}, this,
                      [this] { workspace_.area->view().frameSelection(); }));
  menu.addSeparator();
  QAction* false_color = addToggle(
      menu,
      {tr("&False colours"), QKeySequence(Qt::Key_F), tr("Illuminance by colour, with a scale")},
      this, [this](bool on) { workspace_.view->setFalseColor(on); });
  forProject(false_color);
  connect(workspace_.view, &ViewPanel::falseColorChanged, false_color, &QAction::setChecked);
  forProject(addEntry(menu, {tr("&Brighter"), QKeySequence(tr("Ctrl+Up")), {}}, this,
                      [this] { workspace_.view->stepExposure(0.25); }));
  forProject(addEntry(menu, {tr("&Darker"), QKeySequence(tr("Ctrl+Down")), {}}, this,
                      [this] { workspace_.view->stepExposure(-0.25); }));
  menu.addSeparator();
  QMenu& theme = *menu.addMenu(tr("&Theme"));
  auto* group = new QActionGroup(this);
  const std::pair<QString, Theme> themes[] = {
      {tr("As the system"), Theme::system}, {tr("Dark"), Theme::dark}, {tr("Light"), Theme::light}};
  for (const auto& [name, choice] : themes) {
    QAction* action = addEntry(theme, {name, {}, {}}, this, [choice = choice] {
      saveTheme(choice);
      applyTheme(choice);
    });
    action->setCheckable(true);
    action->setChecked(choice == savedTheme());
    group->addAction(action);
  }
}

void MainWindow::makeLuminaireMenu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Luminaire"));
  forProject(addEntry(menu, {tr("Switch &on or off"), QKeySequence(Qt::Key_O), {}}, this,
                      [this] { toggleSelection(session_->document()); }));
  for (const int percent : {100, 75, 50, 25, 10}) {
    forProject(addEntry(menu, {tr("Dim to %1 %").arg(percent), {}, {}}, this, [this, percent] {
      Document& document = session_->document();
      document.editLuminaires(tr("Dim"), document.selection(),
                              [percent](light::Luminaire& l) { l.dimming = percent / 100.0; });
    }));
  }
}

void MainWindow::makeOtherMenus() {
  QMenu& window = *menuBar()->addMenu(tr("&Window"));
  for (QDockWidget* dock : workspace_.docks) {
    window.addAction(dock->toggleViewAction());
    forProject(dock->toggleViewAction());
  }
  QMenu& help = *menuBar()->addMenu(tr("&Help"));
  addEntry(help, {tr("&Mouse and keys"), QKeySequence::HelpContents, {}}, this, [this] {
    QMessageBox::information(
        this, tr("Mouse and keys"),
        tr("<table cellspacing=6>"
           "<tr><td>Left</td><td>select; drag a luminaire, an arrow or a plane; elsewhere "
           "orbit</td></tr>"
           "<tr><td>Middle, Shift+Left</td><td>pan</td></tr>"
           "<tr><td>Right</td><td>look round</td></tr>"
           "<tr><td>Wheel</td><td>toward what is under the cursor</td></tr>"
           "<tr><td>Ctrl while dragging</td><td>steps of 0.1 m</td></tr>"
           "<tr><td>Esc</td><td>give up a drag, select nothing</td></tr>"
           "<tr><td>F</td><td>false colours</td></tr>"
           "<tr><td>V</td><td>next layout</td></tr>"
           "<tr><td>O</td><td>switch on or off</td></tr>"
           "<tr><td>Home, period</td><td>frame all, frame the selection</td></tr>"
           "<tr><td>Ctrl+Up, Ctrl+Down</td><td>exposure by a quarter stop</td></tr></table>"));
  });
  addEntry(help, {tr("&About Soffit"), {}, {}}, this, [this] { showAbout(); });
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About Soffit"),
                     tr("<b>Soffit %1</b><p>Interactive, converged light for indoor "
                        "architecture.</p><p>MIT licence. With Qt %2 (LGPL 3), VTK (BSD 3), "
                        "OpenColorIO, Embree, OpenImageIO and others, as the system provides "
                        "them.</p>")
                         .arg(QApplication::applicationVersion(), QString::fromLatin1(qVersion())));
}

}  // namespace soffit::ui
