// SPDX-License-Identifier: MIT
#include "ui/main_window/workspace.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QStatusBar>
#include <QUndoView>

namespace soffit::ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

QDockWidget* dock(QMainWindow& window, Workspace& workspace, Qt::DockWidgetArea area,
                  const QString& title, const char* name, QWidget* panel) {
  auto* dock = new QDockWidget(title, &window);
  dock->setObjectName(QString::fromLatin1(name));
  QString command = QString::fromLatin1(name).replace(QLatin1Char('_'), QLatin1Char(' '));
  command[0] = command[0].toUpper();
  dock->toggleViewAction()->setObjectName(command);
  dock->setWidget(panel);
  window.addDockWidget(area, dock);
  workspace.docks.push_back(dock);
  return dock;
}

QWidget* scrolled(QWidget* panel) {
  auto* scroll = new QScrollArea;
  scroll->setWidget(panel);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(250);
  return scroll;
}

}  // namespace

Workspace makeWorkspace(QMainWindow& window) {
  Workspace w;
  w.area = new ViewArea;
  w.library = new LibraryPanel;
  w.lights = new LightsPanel;
  w.luminaire = new LuminairePanel;
  w.mixer = new MixerPanel;
  w.materials = new MaterialsPanel;
  w.daylight = new DaylightPanel;
  w.layouts = new LayoutsPanel;
  w.view = new ViewPanel;
  w.cameras = new CamerasPanel;
  w.quality = new QualityPanel;
  w.results = new ResultsPanel;
  w.verify = new VerifyPanel;
  w.probes = new ProbesPanel;
  w.log = new LogPanel;
  w.history = new QUndoView;
  w.history->setEmptyLabel(tr("As it was opened"));
  w.history->setToolTip(tr("A click goes back or forward to that step"));
  w.status = new StatusLine(window.statusBar());
  w.evaluation = new EvaluationChoice(&window);
  QObject::connect(w.evaluation, &EvaluationChoice::changed, w.status,
                   [evaluation = w.evaluation, status = w.status] {
                     status->showEvaluation(evaluation->text(), evaluation->reason());
                   });
  QObject::connect(&w.area->view(), &VtkView::contextMade, w.evaluation,
                   &EvaluationChoice::setRenderer);
  window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks |
                        QMainWindow::AllowNestedDocks);
  window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  QDockWidget* properties = dock(window, w, Qt::RightDockWidgetArea, tr("Properties"), "properties",
                                 scrolled(w.luminaire));
  QDockWidget* view =
      dock(window, w, Qt::RightDockWidgetArea, tr("View"), "view", scrolled(w.view));
  QDockWidget* cameras =
      dock(window, w, Qt::RightDockWidgetArea, tr("Cameras"), "cameras", w.cameras);
  QDockWidget* mixer =
      dock(window, w, Qt::RightDockWidgetArea, tr("Light mixer"), "mixer", scrolled(w.mixer));
  mixer->toggleViewAction()->setObjectName(QStringLiteral("Light mixer"));  // as keys were kept
  QDockWidget* quality =
      dock(window, w, Qt::RightDockWidgetArea, tr("Quality"), "quality", scrolled(w.quality));
  QDockWidget* materials =
      dock(window, w, Qt::RightDockWidgetArea, tr("Materials"), "materials", scrolled(w.materials));
  QDockWidget* daylight =
      dock(window, w, Qt::RightDockWidgetArea, tr("Daylight"), "daylight", scrolled(w.daylight));
  QDockWidget* library =
      dock(window, w, Qt::LeftDockWidgetArea, tr("Library"), "library", w.library);
  QDockWidget* layouts =
      dock(window, w, Qt::BottomDockWidgetArea, tr("Layouts"), "layouts", w.layouts);
  QDockWidget* lights =
      dock(window, w, Qt::BottomDockWidgetArea, tr("Light list"), "light_list", w.lights);
  QDockWidget* results =
      dock(window, w, Qt::BottomDockWidgetArea, tr("Results"), "results", w.results);
  QDockWidget* verify = dock(window, w, Qt::BottomDockWidgetArea, tr("Verify"), "verify", w.verify);
  QDockWidget* probes = dock(window, w, Qt::BottomDockWidgetArea, tr("Probes"), "probes", w.probes);
  QDockWidget* log = dock(window, w, Qt::BottomDockWidgetArea, tr("Log"), "log", w.log);
  QDockWidget* history =
      dock(window, w, Qt::BottomDockWidgetArea, tr("History"), "history", w.history);
  window.splitDockWidget(layouts, lights, Qt::Horizontal);
  window.tabifyDockWidget(lights, results);
  window.tabifyDockWidget(results, probes);
  window.tabifyDockWidget(probes, verify);
  window.tabifyDockWidget(verify, log);
  window.tabifyDockWidget(log, history);
  lights->raise();
  window.tabifyDockWidget(properties, materials);
  window.tabifyDockWidget(materials, daylight);
  properties->raise();
  window.tabifyDockWidget(view, cameras);
  window.tabifyDockWidget(cameras, mixer);
  window.tabifyDockWidget(mixer, quality);
  mixer->raise();
  window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  window.resizeDocks({library, view}, {220, 290}, Qt::Horizontal);
  window.resizeDocks({properties, view}, {430, 300}, Qt::Vertical);
  window.resizeDocks({layouts, lights}, {210, 760}, Qt::Horizontal);
  window.resizeDocks({layouts}, {215}, Qt::Vertical);
  return w;
}

}  // namespace soffit::ui
