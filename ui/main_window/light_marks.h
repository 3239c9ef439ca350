// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/jobs/live_readings.h"
#include "ui/main_window/workspace.h"
#include "ui/viewport/probe_drag.h"
#include "ui/viewport/profile_cut.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace soffit::ui {

/// A project's light in numbers over its view: the values and isolux lines of its work planes, its
/// probes, which are pinned, moved and read here, and a profile cut. Live in a drag.
class LightMarks : public QObject {
  Q_OBJECT

 public:
  LightMarks(Document& document, Relighting& relighting, LiveReadings& readings,
             Workspace& workspace);
  ~LightMarks() override;

  /// The marks of a layout; probes are those of the layout in the view.
  [[nodiscard]] LuxMarks marksOf(const QString& layout) const;
  /// Pins a probe where the cursor pointed last; nothing happens off all surfaces.
  void pinProbe();
  /// Lets the user draw a line, whose light is shown in a chart until that is closed.
  void drawProfile();

 private:
  void refresh();
  /// Over the views that are new.
  void addViews();
  [[nodiscard]] bool isUsed(std::size_t view) const;
  void showMarks(std::size_t view);
  void addPlanes(const LayoutReading& reading, LuxMarks& marks) const;
  void addProbes(LuxMarks& marks) const;
  void moveProbe(std::size_t probe, const SurfaceReading& to);
  void endMove(bool keep);
  void setCut(const std::optional<ProfileCut>& cut);
  void readCut();

  Document& document_;
  Relighting& relighting_;
  LiveReadings& readings_;
  Workspace& workspace_;
  std::vector<std::unique_ptr<ProbeDrag>> drags_;  ///< per view
  std::vector<io::Probe> probes_;                  ///< where they are now, one of them in hand
  std::optional<SurfaceReading> pointed_;
  std::optional<ProfileCut> cut_;
};

}  // namespace soffit::ui
