// SPDX-License-Identifier: MIT
#pragma once

#include "ui/main_window/view_area.h"
#include "ui/panels/cameras_panel.h"
#include "ui/panels/daylight_panel.h"
#include "ui/panels/layouts_panel.h"
#include "ui/panels/library_panel.h"
#include "ui/panels/lights_panel.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/luminaire_panel.h"
#include "ui/panels/materials_panel.h"
#include "ui/panels/mixer_panel.h"
#include "ui/panels/probes_panel.h"
#include "ui/panels/quality_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/panels/status_line.h"
#include "ui/panels/verify_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/viewport/evaluation.h"

class QDockWidget;
class QMainWindow;
class QUndoView;

namespace soffit::ui {

/// The parts that a project is worked on with, laid out in docks. The window owns them.
struct Workspace {
  ViewArea* area = nullptr;
  LibraryPanel* library = nullptr;
  LightsPanel* lights = nullptr;
  LuminairePanel* luminaire = nullptr;
  MixerPanel* mixer = nullptr;
  MaterialsPanel* materials = nullptr;
  DaylightPanel* daylight = nullptr;
  LayoutsPanel* layouts = nullptr;
  ViewPanel* view = nullptr;
  CamerasPanel* cameras = nullptr;
  QualityPanel* quality = nullptr;
  ResultsPanel* results = nullptr;
  VerifyPanel* verify = nullptr;
  ProbesPanel* probes = nullptr;
  LogPanel* log = nullptr;
  QUndoView* history = nullptr;  ///< the steps that can be undone; the window says whose
  StatusLine* status = nullptr;
  EvaluationChoice* evaluation = nullptr;
  std::vector<QDockWidget*> docks;
};

/// Makes the parts and docks them into a window; `area` becomes nobody's child yet.
Workspace makeWorkspace(QMainWindow& window);

}  // namespace soffit::ui
