// SPDX-License-Identifier: MIT
#include "ui/jobs/relighting.h"

#include "core/scene/equality.h"
#include "ui/document/text.h"

#include <QSettings>

namespace soffit::ui {
namespace {

const QString kReflections = QStringLiteral("view/reflections");

bool sameOutside(const scene::Scene& a, const scene::Scene& b) {
  return a.environment.has_value() == b.environment.has_value() &&
         (!a.environment || scene::same(*a.environment, *b.environment));
}

}  // namespace

Relighting::Relighting(Document& document, bool use_cache, QObject* parent)
    : QObject(parent), document_(document), worker_(use_cache) {
  connect(&document_, &Document::sceneChanged, this, &Relighting::request);
  connect(&document_, &Document::probesChanged, this, &Relighting::request);
  connect(&worker_, &RelightWorker::frameReady, this, [this] {
    LightFramePtr frame = worker_.takeFrame();
    if (frame == nullptr) return;
    frame_ = std::move(frame);
    Q_EMIT frameChanged();
  });
  worker_.setReflections(reflectionsWanted());
  request();
}

bool Relighting::reflectionsWanted() {
  return QSettings().value(kReflections, true).toBool();
}

void Relighting::setReflections(bool wanted) {
  QSettings().setValue(kReflections, wanted);
  worker_.setReflections(wanted);
  request();
}

bool Relighting::isCurrent() const {
  return frame_ != nullptr && frame_->revision == revision_ && frame_->complete;
}

void Relighting::request() {
  LightRequest request;
  request.scene = document_.scene();
  request.layout = toStd(document_.layout());
  request.luminaires = document_.litLuminaires();
  request.probes = document_.probes();
  request.in_parts = in_parts_;
  request.revision = ++revision_;
  if (!document_.previewing()) settled_ = document_.scene();
  request.outside_in_hand = document_.previewing() && !sameOutside(*settled_, *document_.scene());
  request.stops_older =
      !document_.previewing() || (document_.selection().size() <= 1 && !request.outside_in_hand);
  if (document_.previewing() && !request.outside_in_hand) {
    for (std::size_t i = 0; i < request.luminaires.size(); ++i) {
      if (document_.selection().contains(toQt(request.luminaires[i].name))) {
        request.in_hand.push_back(i);
      }
    }
  }
  worker_.request(std::move(request));
}

}  // namespace soffit::ui
