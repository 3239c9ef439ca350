// SPDX-License-Identifier: MIT
// The menu File.
#include "ui/actions/actions.h"
#include "ui/actions/file_dialogs.h"
#include "ui/document/recent_files.h"
#include "ui/main_window/main_window.h"

#include <QMenuBar>

namespace soffit::ui {

void MainWindow::makeFileMenu() {
  QMenu& menu = named(menuBar()->addMenu(tr("&File")), "File");
  addEntry(menu, {tr("&New"), QKeySequence::New, tr("An empty project"), "New"}, this,
           [this] { files_.newProject(); });
  addEntry(menu, {tr("&Open\u2026"), QKeySequence::Open, {}, "Open"}, this, [this] {
    const QString path = askProjectToOpen(this);
    if (!path.isEmpty()) files_.openFile(path);
  });
  addEntry(menu,
           {tr("&Import a model\u2026"), QKeySequence(tr("Ctrl+I")),
            tr("Architecture or furniture, into a new project or this one"), "Import a model"},
           this, [this] {
             const QString path = askModelToImport(this);
             if (!path.isEmpty()) files_.importModel(path);
           });
  QMenu* recent = &named(menu.addMenu(tr("Open &recent")), "Open recent");
  connect(recent, &QMenu::aboutToShow, this, [this, recent] {
    recent->clear();
    for (const QString& path : recentFiles()) {
      addEntry(*recent, {path, {}, {}}, this, [this, path] { open(path); });
    }
    if (recent->isEmpty()) recent->addAction(tr("None yet"))->setEnabled(false);
  });
  QMenu* samples = &named(menu.addMenu(tr("Sa&mple projects")), "Sample projects");
  for (const QString& path : sampleProjects()) {
    QString name = path.section(QLatin1Char('/'), -1).section(QLatin1Char('.'), 0, 0);
    name[0] = name[0].toUpper();
    addEntry(*samples, {name, {}, path}, this, [this, path] { open(path); });
  }
  forProject(addEntry(menu, {tr("&Close project"), QKeySequence::Close, {}, "Close project"}, this,
                      [this] {
                        if (closeProject()) showWorkspace(false);
                      }));
  menu.addSeparator();
  forProject(addEntry(menu, {tr("&Save"), QKeySequence::Save, {}, "Save"}, this,
                      [this] { save(this, session_->document()); }));
  forProject(addEntry(menu, {tr("Save &as\u2026"), QKeySequence(tr("Ctrl+Shift+S")), {}, "Save as"},
                      this, [this] { saveAs(this, session_->document()); }));
  menu.addSeparator();
  forProject(addEntry(
      menu,
      {tr("&Export the view\u2026"), QKeySequence(tr("Ctrl+E")),
       tr("A picture of the view at any size, without gizmo and outlines"), "Export the view"},
      this, [this] { session_->pictures().exportView(); }));
  forProject(
      addEntry(menu,
               {tr("Export a se&t of pictures\u2026"), QKeySequence(tr("Ctrl+Shift+E")),
                tr("From cameras and of layouts, into a folder"), "Export a set of pictures"},
               this, [this] { session_->pictures().exportSet(); }));
  forProject(addEntry(
      menu, {tr("Cop&y the picture"), QKeySequence(tr("Ctrl+Shift+C")), {}, "Copy the picture"},
      this, [this] { session_->pictures().copyView(); }));
  menu.addSeparator();
  addEntry(menu, {tr("&Quit"), QKeySequence(tr("Ctrl+Q")), {}, "Quit"}, this, [this] { close(); });
}

}  // namespace soffit::ui
