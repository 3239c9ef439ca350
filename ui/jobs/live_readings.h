// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/readings_worker.h"
#include "ui/jobs/relighting.h"

#include <QObject>
#include <QTimer>

namespace soffit::ui {

/// Keeps the work planes' readings up to date with a document: they follow each finished light.
class LiveReadings : public QObject {
  Q_OBJECT

 public:
  LiveReadings(Document& document, Relighting& relighting, QObject* parent = nullptr);

  /// The newest readings; null before the first.
  [[nodiscard]] const ReadingsPtr& readings() const { return readings_; }
  /// Reads the base layout too where it is not the one in the view.
  void setBaseWanted(bool wanted);
  /// Whether they are all there for what the document shows now.
  [[nodiscard]] bool isCurrent() const;

 Q_SIGNALS:
  void changed();
  void failed(const QString& message);

 private:
  void onFrame();
  void request();

  Document& document_;
  Relighting& relighting_;
  ReadingsWorker worker_;
  ReadingsPtr readings_;
  bool base_wanted_ = false;
  QTimer pause_;  ///< runs after a reading in a drag
};

}  // namespace soffit::ui
