// SPDX-License-Identifier: MIT
#include "ui/jobs/other_lights.h"

#include "core/scene/edits.h"
#include "core/scene/equality.h"
#include "ui/document/text.h"

#include <algorithm>
#include <utility>

namespace soffit::ui {

OtherLights::OtherLights(Document& document, Relighting& relighting, QObject* parent)
    : QObject(parent), document_(document), relighting_(relighting) {
  connect(&relighting_, &Relighting::frameChanged, this, [this] {
    if (document_.previewing() || !relighting_.isCurrent()) return;
    keepShown();
    requestNext();
  });
  connect(&relighting_.worker(), &RelightWorker::otherReady, this, &OtherLights::take);
}

void OtherLights::setWanted(const QStringList& layouts) {
  wanted_ = layouts;
  requestNext();
}

std::vector<light::Luminaire> OtherLights::luminairesOf(const QString& layout) const {
  if (layout == document_.layout()) return document_.luminaires();
  const scene::Scene& scene = *document_.scene();
  const scene::Layout* found = scene::findLayout(scene, toStd(layout));
  return found == nullptr ? scene.luminaires : scene::resolveLayout(scene, *found);
}

LightFramePtr OtherLights::frame(const QString& layout) const {
  if (layout == document_.layout()) return relighting_.frame();
  const auto known = known_.find(layout);
  return known == known_.end() ? nullptr : known->second.frame;
}

bool OtherLights::isCurrent(const QString& layout) const {
  if (layout == document_.layout()) return relighting_.isCurrent();
  const auto known = known_.find(layout);
  return known != known_.end() && relighting_.frame() != nullptr &&
         known->second.frame->solver == relighting_.frame()->solver &&
         known->second.frame->outside == relighting_.frame()->outside &&
         scene::sameList(known->second.luminaires, luminairesOf(layout));
}

void OtherLights::keepShown() {
  known_[document_.layout()] = {relighting_.frame(), document_.luminaires()};
  std::erase_if(known_, [this](const auto& entry) {
    return !entry.first.isEmpty() &&
           scene::findLayout(*document_.scene(), toStd(entry.first)) == nullptr;
  });
}

void OtherLights::requestNext() {
  if (under_way_ || document_.previewing() || relighting_.frame() == nullptr) return;
  for (const QString& layout : wanted_) {
    const bool exists =
        layout.isEmpty() || scene::findLayout(*document_.scene(), toStd(layout)) != nullptr;
    if (!exists || layout == document_.layout() || isCurrent(layout)) continue;
    asked_ = layout;
    asked_luminaires_ = luminairesOf(layout);
    under_way_ = true;
    LightRequest request;
    request.scene = document_.scene();
    request.layout = toStd(layout);
    request.luminaires = asked_luminaires_;
    relighting_.worker().requestOther(std::move(request));
    return;
  }
}

void OtherLights::take() {
  LightFramePtr frame = relighting_.worker().takeOther();
  under_way_ = false;
  if (frame == nullptr) return;
  known_[asked_] = {std::move(frame), std::move(asked_luminaires_)};
  Q_EMIT ready(asked_);
  requestNext();
}

}  // namespace soffit::ui
