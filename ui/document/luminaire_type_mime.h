// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/luminaire_types.h"

#include <QMimeData>

#include <utility>

namespace soffit::ui {

inline constexpr const char* kLuminaireTypeFormat = "application/x-soffit-luminaire-type";

/// A kind of luminaire on its way from the library into a view; within this program alone.
class LuminaireTypeMime : public QMimeData {
 public:
  explicit LuminaireTypeMime(LuminaireType dragged) : type(std::move(dragged)) {
    setData(QString::fromLatin1(kLuminaireTypeFormat), type.name.toUtf8());
  }

  LuminaireType type;
};

/// The kind that is dragged; null for anything else.
inline const LuminaireType* typeOf(const QMimeData* data) {
  const auto* mime = dynamic_cast<const LuminaireTypeMime*>(data);
  return mime == nullptr ? nullptr : &mime->type;
}

}  // namespace soffit::ui
