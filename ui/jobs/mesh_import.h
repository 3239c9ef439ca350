// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/luminaire_types.h"

#include <QObject>

#include <thread>

namespace soffit::ui {

/// Reads a model file as the body of a luminaire, on a thread of its own: all its parts as one mesh
/// about the middle of its upper side, saved as OBJ in metres.
class MeshImport : public QObject {
  Q_OBJECT

 public:
  explicit MeshImport(const QString& path, QObject* parent = nullptr);
  ~MeshImport() override;
  /// Once it is there.
  [[nodiscard]] const LuminaireType& type() const { return type_; }

 Q_SIGNALS:
  void finished();
  void failed(const QString& message);

 private:
  LuminaireType type_;
  std::jthread thread_;
};

}  // namespace soffit::ui
