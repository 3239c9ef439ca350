// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/jobs/relighting.h"
#include "ui/main_window/view_area.h"
#include "ui/main_window/workspace.h"

#include <QObject>

namespace soffit::ui {

/// One open project: its document, its light, and the wires to view and panels. When it goes, all
/// wires go with it.
class ProjectSession : public QObject {
  Q_OBJECT

 public:
  ProjectSession(io::Project project, Workspace& workspace, QObject* parent = nullptr);
  ~ProjectSession() override;

  [[nodiscard]] Document& document() { return document_; }
  [[nodiscard]] Relighting& relighting() { return relighting_; }
  void showCamera(const QString& name);

 private:
  void connectView();
  void connectPanels();
  void connectProgress();
  void onFrame();
  void placeLuminaires();
  void saveCamera();
  void exposeAutomatically();

  Document document_;
  Workspace& workspace_;
  Relighting relighting_;
};

}  // namespace soffit::ui
