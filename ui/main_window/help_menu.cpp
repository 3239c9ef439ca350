// SPDX-License-Identifier: MIT
// The menu Help.
#include "ui/actions/about_dialog.h"
#include "ui/actions/actions.h"
#include "ui/actions/command_palette.h"
#include "ui/actions/help_window.h"
#include "ui/actions/keys_dialog.h"
#include "ui/main_window/main_window.h"

#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>

namespace soffit::ui {
namespace {

/// The page on the dock that has the focus; none: that of the contents.
QString pageOnFocus() {
  static const std::pair<const char*, const char*> kPages[] = {
      {"properties", "luminaires.md"}, {"light_list", "luminaires.md"},
      {"library", "luminaires.md"},    {"view", "view.md"},
      {"cameras", "view.md"},          {"mixer", "scenes.md"},
      {"quality", "accuracy.md"},      {"materials", "materials.md"},
      {"layouts", "layouts.md"},       {"results", "results.md"},
      {"history", "files.md"}};
  for (const QWidget* w = QApplication::focusWidget(); w != nullptr; w = w->parentWidget()) {
    for (const auto& [dock, page] : kPages) {
      if (qobject_cast<const QDockWidget*>(w) != nullptr &&
          w->objectName() == QLatin1String(dock)) {
        return QString::fromLatin1(page);
      }
    }
  }
  return QStringLiteral("index.md");
}

/// The one window of a kind, made when there is none.
template <typename Window, typename Make>
Window* raised(QWidget* parent, const Make& make) {
  auto* window = parent->findChild<Window*>();
  if (window == nullptr) window = make();
  window->show();
  window->raise();
  window->activateWindow();
  return window;
}

}  // namespace

void MainWindow::makeHelpMenu() {
  QMenu& help = named(menuBar()->addMenu(tr("&Help")), "Help");
  addEntry(help,
           {tr("&Contents"), QKeySequence::HelpContents,
            tr("How Soffit is used, with a search; from a panel: the page on it"), "Contents"},
           this, [this] {
             const QString page = pageOnFocus();
             raised<HelpWindow>(this, [this] {
               return new HelpWindow(helpFolder(), this);
             })->showPage(page);
           });
  addEntry(help,
           {tr("Co&mmands\u2026"), QKeySequence(tr("Ctrl+Shift+P")),
            tr("Run any command by a few letters of its name"), "Commands"},
           this, [this] {
             if (findChild<CommandPalette*>() == nullptr) {
               (new CommandPalette(commandsOf(*menuBar()), this))->show();
             }
           });
  addEntry(help,
           {tr("Mouse and &keys"), QKeySequence(tr("?")),
            tr("What the mouse does, and the keys of all commands, to change"), "Mouse and keys"},
           this,
           [this] { raised<KeysDialog>(this, [this] { return new KeysDialog(*keys_, this); }); });
  help.addSeparator();
  addEntry(help, {tr("&About Soffit"), {}, {}, "About Soffit"}, this,
           [this] { raised<AboutDialog>(this, [this] { return new AboutDialog(this); }); });
}

}  // namespace soffit::ui
