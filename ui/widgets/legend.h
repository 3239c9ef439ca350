// SPDX-License-Identifier: MIT
#pragma once

#include "core/color/false_color.h"

#include <QWidget>

namespace soffit::ui {

/// The scale of a false-colour picture, to lay over a view: a bar with round values in lux.
class Legend : public QWidget {
  Q_OBJECT

 public:
  explicit Legend(QWidget* parent = nullptr);
  void setRange(const color::FalseColorRange& range);
  [[nodiscard]] QSize sizeHint() const override { return {92, 300}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  color::FalseColorRange range_;
};

}  // namespace soffit::ui
