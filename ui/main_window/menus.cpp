// SPDX-License-Identifier: MIT
// The menus of the main window: what stands in them and what it calls.
#include "ui/actions/actions.h"
#include "ui/actions/command_palette.h"
#include "ui/actions/file_dialogs.h"
#include "ui/actions/keys_dialog.h"
#include "ui/document/recent_files.h"
#include "ui/main_window/main_window.h"
#include "ui/widgets/theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>

namespace soffit::ui {
void MainWindow::forProject(QAction* action) {
  project_actions_.append(action);
}

void MainWindow::makeMenus() {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeInsertMenu();
  makeLuminaireMenu();
  makeResultsMenu();
  makeLayoutsMenu();
  makeOtherMenus();
  keys_ = new KeyBindings(*menuBar(), this);
}

void MainWindow::makeViewMenu() {
  QMenu& menu = *menuBar()->addMenu(tr("&View"));
  addCameraEntries(menu);
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

void MainWindow::makeOtherMenus() {
  QMenu& window = *menuBar()->addMenu(tr("&Window"));
  for (QDockWidget* dock : workspace_.docks) {
    window.addAction(dock->toggleViewAction());
    forProject(dock->toggleViewAction());
  }
  QMenu& help = *menuBar()->addMenu(tr("&Help"));
  addEntry(help,
           {tr("&Commands..."), QKeySequence(tr("Ctrl+Shift+P")),
            tr("Run any command by a few letters of its name")},
           this, [this] {
             if (findChild<CommandPalette*>() == nullptr) {
               (new CommandPalette(commandsOf(*menuBar()), this))->show();
             }
           });
  QAction* keys = addEntry(help,
                           {tr("&Mouse and keys"), QKeySequence::HelpContents,
                            tr("What the mouse does, and the keys of all commands, to change")},
                           this, [this] {
                             auto* open = findChild<KeysDialog*>();
                             if (open == nullptr) open = new KeysDialog(*keys_, this);
                             open->show();
                             open->activateWindow();
                           });
  keys->setShortcuts({QKeySequence(QKeySequence::HelpContents), QKeySequence(tr("?"))});
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
