// SPDX-License-Identifier: MIT
#include "ui/document/luminaire_clipboard.h"

#include "ui/document/text.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

#include <utility>

namespace soffit::ui {
namespace {

/// Luminaires share meshes and photometric tables, which only this program can take over.
class LuminaireMime : public QMimeData {
 public:
  explicit LuminaireMime(std::vector<light::Luminaire> copied) : luminaires(std::move(copied)) {
    QStringList names;
    for (const light::Luminaire& l : luminaires) names.append(toQt(l.name));
    setText(names.join(QLatin1Char('\n')));
  }

  std::vector<light::Luminaire> luminaires;
};

}  // namespace

void copyLuminaires(std::vector<light::Luminaire> luminaires) {
  QGuiApplication::clipboard()->setMimeData(new LuminaireMime(std::move(luminaires)));
}

std::vector<light::Luminaire> copiedLuminaires() {
  const auto* mime = dynamic_cast<const LuminaireMime*>(QGuiApplication::clipboard()->mimeData());
  return mime == nullptr ? std::vector<light::Luminaire>{} : mime->luminaires;
}

}  // namespace soffit::ui
