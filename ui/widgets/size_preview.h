// SPDX-License-Identifier: MIT
#pragma once

#include "core/math/vec.h"

#include <QString>
#include <QWidget>

#include <optional>

namespace soffit::ui {

/// How large something is: a box in elevation beside a person of 1.75 m, with its measures.
class SizePreview : public QWidget {
  Q_OBJECT

 public:
  explicit SizePreview(QWidget* parent = nullptr);
  /// Metres along x, y and z; nothing: `text` stands in its place.
  void setSize(const std::optional<dvec3>& size, const QString& text = {});
  [[nodiscard]] QSize sizeHint() const override { return {420, 200}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<dvec3> size_;
  QString text_;
};

}  // namespace soffit::ui
