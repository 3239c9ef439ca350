// SPDX-License-Identifier: MIT
// The menus of the main window: what stands in them and what it calls.
#include "ui/actions/actions.h"
#include "ui/actions/file_dialogs.h"
#include "ui/actions/key_bindings.h"
#include "ui/document/recent_files.h"
#include "ui/main_window/main_window.h"
#include "ui/widgets/language.h"
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
  makeCalculateMenu();
  makeResultsMenu();
  makeLayoutsMenu();
  makeOtherMenus();
  keys_ = new KeyBindings(*menuBar(), this);
}

void MainWindow::makeViewMenu() {
  QMenu& menu = named(menuBar()->addMenu(tr("&View")), "View");
  addCameraEntries(menu);
  menu.addSeparator();
  QAction* false_color = addToggle(menu,
                                   {tr("&False colours"), QKeySequence(Qt::Key_F),
                                    tr("Illuminance by colour, with a scale"), "False colours"},
                                   this, [this](bool on) { workspace_.view->setFalseColor(on); });
  forProject(false_color);
  connect(workspace_.view, &ViewPanel::falseColorChanged, false_color, &QAction::setChecked);
  QAction* isolines =
      addToggle(menu,
                {tr("&Isolux lines"), QKeySequence(Qt::Key_I),
                 tr("Lines of equal illuminance, on surfaces or work planes"), "Isolux lines"},
                this, [this](bool on) { workspace_.view->setIsolines(on); });
  forProject(isolines);
  connect(workspace_.view, &ViewPanel::isolinesChanged, isolines, &QAction::setChecked);
  QAction* values = addToggle(
      menu,
      {tr("Wor&k plane values"), QKeySequence(Qt::Key_N),
       tr("Illuminance in numbers at the points of the work planes"), "Work plane values"},
      this, [this](bool on) { workspace_.view->setValues(on); });
  forProject(values);
  connect(workspace_.view, &ViewPanel::valuesChanged, values, &QAction::setChecked);
  QAction* reflections = addToggle(
      menu,
      {tr("Reflections"),
       {},
       tr("What shiny surfaces reflect, following every move; without them the view is a little "
          "quicker"),
       "Reflections"},
      this, [this](bool on) {
        if (session() != nullptr) session()->relighting().setReflections(on);
      });
  reflections->setChecked(Relighting::reflectionsWanted());
  forProject(reflections);
  QAction* traced =
      addToggle(menu,
                {tr("Ray traced at rest"), QKeySequence(Qt::Key_T),
                 tr("Reflections and exact shadows, some seconds after nothing moves any more"),
                 "Ray traced at rest"},
                this, [this](bool on) {
                  if (session() != nullptr) session()->tracer().setWanted(on);
                });
  traced->setChecked(RestTracer::isWanted());
  forProject(traced);
  forProject(addEntry(menu, {tr("&Brighter"), QKeySequence(tr("Ctrl+Up")), {}, "Brighter"}, this,
                      [this] { workspace_.view->stepExposure(0.25); }));
  forProject(addEntry(menu, {tr("&Darker"), QKeySequence(tr("Ctrl+Down")), {}, "Darker"}, this,
                      [this] { workspace_.view->stepExposure(-0.25); }));
  menu.addSeparator();
  addEvaluations(named(menu.addMenu(tr("&Evaluation")), "Evaluation"));
  addUnits(named(menu.addMenu(tr("&Units")), "Units"));
  addThemes(named(menu.addMenu(tr("&Theme")), "Theme"));
  addLanguages(named(menu.addMenu(tr("Lan&guage")), "Language"));
}

void MainWindow::addThemes(QMenu& menu) {
  auto* group = new QActionGroup(this);
  const std::pair<ActionText, Theme> themes[] = {
      {{tr("As the system"), {}, {}, "As the system"}, Theme::system},
      {{tr("Dark"), {}, {}, "Dark"}, Theme::dark},
      {{tr("Light"), {}, {}, "Light"}, Theme::light}};
  for (const auto& [text, choice] : themes) {
    QAction* action = addEntry(menu, text, this, [choice = choice] {
      saveTheme(choice);
      applyTheme(choice);
    });
    action->setCheckable(true);
    action->setChecked(choice == savedTheme());
    group->addAction(action);
  }
}

void MainWindow::addLanguages(QMenu& menu) {
  auto* group = new QActionGroup(this);
  // Languages by their own names: who does not read the present one finds theirs.
  const std::pair<ActionText, Language> languages[] = {
      {{tr("As the system"), {}, {}, "As the system"}, Language::system},
      {{QStringLiteral("English"), {}, {}, "English"}, Language::english},
      {{QStringLiteral("Deutsch"), {}, {}, "Deutsch"}, Language::german}};
  for (const auto& [text, choice] : languages) {
    QAction* action = addEntry(menu, text, this, [this, choice = choice] {
      saveLanguage(choice);
      QMessageBox::information(this, tr("Language"),
                               tr("The language changes when Soffit is started again."));
    });
    action->setCheckable(true);
    action->setChecked(choice == savedLanguage());
    group->addAction(action);
  }
}

void MainWindow::makeOtherMenus() {
  QMenu& window = named(menuBar()->addMenu(tr("&Window")), "Window");
  for (QDockWidget* dock : workspace_.docks) {
    window.addAction(dock->toggleViewAction());
    forProject(dock->toggleViewAction());
  }
  makeHelpMenu();
}

}  // namespace soffit::ui
