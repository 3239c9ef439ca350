// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/live_readings.h"
#include "ui/jobs/other_lights.h"
#include "ui/main_window/workspace.h"

#include <QObject>
#include <QTimer>

namespace soffit::ui {

/// Layouts beside the one in the view: the comparison of two, and the thumbnails of all.
class ComparisonSession : public QObject {
  Q_OBJECT

 public:
  ComparisonSession(Document& document, Relighting& relighting, LiveReadings& readings,
                    Workspace& workspace);
  ~ComparisonSession() override;

  /// Compares the layout in the view with another, the one compared with last or its neighbour;
  /// nothing happens in a project without a second one. off ends it.
  void setMode(ComparisonMode mode);
  [[nodiscard]] ComparisonMode mode() const;
  /// The layout compared with; empty: the base.
  [[nodiscard]] const QString& other() const { return other_; }
  void setOther(const QString& layout);
  /// The other layout comes into the view, and the other way round.
  void swap();
  [[nodiscard]] OtherLights& lights() { return lights_; }
  /// Whether the second picture is the light of what the document says now.
  [[nodiscard]] bool isCurrent() const;

 private:
  [[nodiscard]] QStringList others() const;
  void chooseOther();
  void onScene();
  void show();
  void showDifference();
  void takeLook();
  void want();
  void takeThumbnail();

  Document& document_;
  Relighting& relighting_;
  LiveReadings& readings_;
  Workspace& workspace_;
  OtherLights lights_;
  QString other_;
  QString before_;  ///< the layout that was in the view before
  std::optional<double> chosen_range_;
  double range_ = 0.0;
  QStringList without_thumbnail_;
  QTimer thumbnails_;
};

}  // namespace soffit::ui
