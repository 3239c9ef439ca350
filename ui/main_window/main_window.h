// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/luminaire_array.h"
#include "ui/main_window/project_files.h"
#include "ui/main_window/project_session.h"
#include "ui/main_window/workspace.h"
#include "ui/panels/start_page.h"

#include <QMainWindow>

#include <memory>

class QStackedWidget;
class QUndoGroup;

namespace soffit::ui {

class KeyBindings;
class LoadJob;

/// The window: start page or workspace, and the menus. Assembles; what happens lies in the parts.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow();
  ~MainWindow() override;

  /// Opens a project; reading goes on in the background.
  void open(const QString& path) { openVersion(path, std::nullopt); }
  /// The same with a text in place of the file's: changes that are not saved yet.
  void openVersion(const QString& path, const std::optional<std::string>& text);
  [[nodiscard]] ProjectFiles& files() { return files_; }
  [[nodiscard]] ProjectSession* session() { return session_.get(); }
  [[nodiscard]] Workspace& workspace() { return workspace_; }
  [[nodiscard]] KeyBindings& keys() { return *keys_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeMenus();
  void makeFileMenu();
  void makeEditMenu();
  void addGizmoTools(QMenu& menu);
  void addSnapping(QMenu& menu);
  void makeViewMenu();
  void addCameraEntries(QMenu& menu);
  void addStandardViews(QMenu& menu);
  void addArrangements(QMenu& menu);
  void addThemes(QMenu& menu);
  void addLanguages(QMenu& menu);
  void addUnits(QMenu& menu);
  void addEvaluations(QMenu& menu);
  void makeInsertMenu();
  void place(const LuminaireType& type);
  void placeFromPhotometry();
  void placeFromMesh();
  void makeLuminaireMenu();
  void makeCalculateMenu();
  void makeResultsMenu();
  void makeLayoutsMenu();
  void startArray(ArrayKind kind);
  void addArrayEntries(QMenu& menu);
  void makeOtherMenus();
  void makeHelpMenu();
  void finishOpening();
  void showWorkspace(bool shown);
  void updateTitle();
  bool closeProject();
  /// A menu entry that is there only while a project is open.
  void forProject(QAction* action);

  Workspace workspace_;
  ProjectFiles files_;
  QStackedWidget* pages_;
  StartPage* start_;
  QUndoGroup* undo_;
  KeyBindings* keys_ = nullptr;
  QList<QAction*> project_actions_;
  QByteArray docks_;  ///< their places while the start page is shown
  std::unique_ptr<LoadJob> load_;
  std::unique_ptr<ProjectSession> session_;
};

}  // namespace soffit::ui
