// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/jobs/relight_worker.h"

#include <QObject>

namespace soffit::ui {

/// Keeps light up to date with a document: each change becomes a request, each answer a frame.
class Relighting : public QObject {
  Q_OBJECT

 public:
  explicit Relighting(Document& document, bool use_cache = true, QObject* parent = nullptr);

  [[nodiscard]] RelightWorker& worker() { return worker_; }
  /// The newest finished light; null before the first.
  [[nodiscard]] const LightFramePtr& frame() const { return frame_; }
  /// Whether the newest frame is the light of what the document shows now.
  [[nodiscard]] bool isCurrent() const;
  [[nodiscard]] quint64 revision() const { return revision_; }
  /// The user's setting: whether light comes with what specular surfaces reflect of it.
  [[nodiscard]] static bool reflectionsWanted();
  void setReflections(bool wanted);
  /// From the next step on (LightRequest::in_parts).
  void setHeldInParts(bool in_parts) { in_parts_ = in_parts; }

 Q_SIGNALS:
  void frameChanged();

 private:
  void request();

  Document& document_;
  RelightWorker worker_;
  LightFramePtr frame_;
  quint64 revision_ = 0;
  bool in_parts_ = false;
  ScenePtr settled_;  ///< the scene before a preview
};

}  // namespace soffit::ui
