// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/jobs/background.h"
#include "ui/jobs/live_readings.h"
#include "ui/jobs/relighting.h"
#include "ui/jobs/verification.h"
#include "ui/main_window/comparison_session.h"
#include "ui/main_window/light_marks.h"
#include "ui/main_window/picture_export.h"
#include "ui/main_window/rest_tracer.h"
#include "ui/main_window/view_area.h"
#include "ui/main_window/workspace.h"

#include <QObject>

#include <memory>

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
  [[nodiscard]] LiveReadings& readings() { return readings_; }
  [[nodiscard]] Verification& verification() { return verification_; }
  [[nodiscard]] ComparisonSession& comparison() { return *comparison_; }
  [[nodiscard]] LightMarks& marks() { return *marks_; }
  [[nodiscard]] PictureExport& pictures() { return *pictures_; }
  [[nodiscard]] RestTracer& tracer() { return *tracer_; }
  /// In the active view.
  void showCamera(const QString& name);
  /// The project's first camera, or somewhere in the building.
  void showFirstCamera();
  /// Asks for a file and writes the readings to it.
  void exportResults();

 private:
  void connectView();
  void connectPanels();
  void connectProgress();
  void connectResults();
  void connectVerification();
  void showErrorMap();
  void onFrame();
  void placeLuminaires();
  void saveCamera();
  void updateCamera(const QString& name);
  [[nodiscard]] const ViewCamera* cameraToSave() const;
  void offerViews();
  void exposeAutomatically();

  Document document_;
  Workspace& workspace_;
  Relighting relighting_;
  LiveReadings readings_;
  Verification verification_;
  Background background_;
  std::unique_ptr<ComparisonSession> comparison_;
  std::unique_ptr<LightMarks> marks_;
  std::unique_ptr<PictureExport> pictures_;
  std::unique_ptr<RestTracer> tracer_;
};

}  // namespace soffit::ui
