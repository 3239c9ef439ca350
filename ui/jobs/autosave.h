// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/jobs/background.h"

#include <QImage>
#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

namespace soffit::ui {

/// Keeps unsaved changes of a document where a crash leaves them (recovery.h): within ten seconds
/// of a change, off the GUI thread. What is saved or closed is kept no longer.
class Autosave : public QObject {
  Q_OBJECT

 public:
  explicit Autosave(Document& document, QObject* parent = nullptr);
  ~Autosave() override;

  /// Gives the picture that is kept with the version, when there is one.
  void setThumbnails(std::function<QImage()> picture) { thumbnail_ = std::move(picture); }
  /// Milliseconds from a change to its version.
  void setDelay(int milliseconds) { timer_.setInterval(milliseconds); }
  /// Keeps a version now, if there is anything to save.
  void keep();
  [[nodiscard]] const QString& id() const { return id_; }

 Q_SIGNALS:
  void kept();
  void failed(const QString& message);

 private:
  void onChange();
  void forget();

  Document& document_;
  QString id_;
  QTimer timer_;
  std::function<QImage()> thumbnail_;
  std::unique_ptr<QLockFile> lock_;
  Background background_;
};

}  // namespace soffit::ui
