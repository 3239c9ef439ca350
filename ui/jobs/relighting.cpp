// SPDX-License-Identifier: MIT
#include "ui/jobs/relighting.h"

#include "ui/document/text.h"

namespace soffit::ui {

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
  request();
}

bool Relighting::isCurrent() const {
  return frame_ != nullptr && frame_->revision == revision_;
}

void Relighting::request() {
  LightRequest request;
  request.scene = document_.scene();
  request.layout = toStd(document_.layout());
  request.luminaires = document_.litLuminaires();
  request.probes = document_.probes();
  request.revision = ++revision_;
  request.stops_older = !document_.previewing() || document_.selection().size() <= 1;
  if (document_.previewing()) {
    for (std::size_t i = 0; i < request.luminaires.size(); ++i) {
      if (document_.selection().contains(toQt(request.luminaires[i].name))) {
        request.in_hand.push_back(i);
      }
    }
  }
  worker_.request(std::move(request));
}

}  // namespace soffit::ui
