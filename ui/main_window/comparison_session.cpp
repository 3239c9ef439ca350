// SPDX-License-Identifier: MIT
#include "ui/main_window/comparison_session.h"

#include "ui/document/text.h"
#include "ui/viewport/difference_light.h"

#include <algorithm>

namespace soffit::ui {
namespace {

/// Thumbnails are taken one by one, in pauses.
constexpr int kThumbnailMs = 600;
constexpr int kThumbnailSamples = 4;

}  // namespace

ComparisonSession::ComparisonSession(Document& document, Relighting& relighting,
                                     LiveReadings& readings, Workspace& workspace)
    : document_(document),
      relighting_(relighting),
      readings_(readings),
      workspace_(workspace),
      lights_(document, relighting),
      before_(document.layout()) {
  thumbnails_.setSingleShot(true);
  thumbnails_.setInterval(kThumbnailMs);
  connect(&thumbnails_, &QTimer::timeout, this, &ComparisonSession::takeThumbnail);
  ComparisonBar& bar = workspace_.area->comparison().bar();
  connect(&bar, &ComparisonBar::modeChosen, this, &ComparisonSession::setMode);
  connect(&bar, &ComparisonBar::otherChosen, this, &ComparisonSession::setOther);
  connect(&bar, &ComparisonBar::swapRequested, this, &ComparisonSession::swap);
  connect(&bar, &ComparisonBar::closeRequested, this, [this] { setMode(ComparisonMode::off); });
  connect(&bar, &ComparisonBar::rangeChosen, this, [this](double lux) {
    chosen_range_ = lux;
    show();
  });
  connect(workspace_.layouts, &LayoutsPanel::comparisonRequested, this,
          &ComparisonSession::setMode);
  connect(&document_, &Document::sceneChanged, this, &ComparisonSession::onScene);
  connect(&lights_, &OtherLights::ready, this, [this](const QString& layout) {
    if (layout == other_) show();
    if (!without_thumbnail_.contains(layout)) without_thumbnail_.append(layout);
    if (!thumbnails_.isActive()) thumbnails_.start();
  });
  connect(&relighting_, &Relighting::frameChanged, this, [this] {
    if (mode() == ComparisonMode::difference) showDifference();
    if (document_.previewing()) return;
    if (!without_thumbnail_.contains(document_.layout())) {
      without_thumbnail_.append(document_.layout());
    }
    if (!thumbnails_.isActive()) thumbnails_.start();
  });
  connect(&workspace_.area->view(), &SceneView::meshChanged, this, [this] {
    show();
    // Lights that came before their mesh.
    without_thumbnail_ = others();
    without_thumbnail_.prepend(document_.layout());
    thumbnails_.start();
  });
  connect(workspace_.view, &ViewPanel::lookChanged, this, &ComparisonSession::takeLook);
  const auto adapt = [this] {
    if (color::toneKindOf(workspace_.view->look().display.view)) takeLook();
  };
  connect(&workspace_.area->view(), &SceneView::lightShown, this, adapt);
  connect(&workspace_.area->view(), &SceneView::cameraMoved, this, adapt, Qt::QueuedConnection);
  want();
}

ComparisonSession::~ComparisonSession() {
  if (mode() == ComparisonMode::off) return;
  SceneView& second = workspace_.area->comparison().second();
  second.setLuminaires(nullptr);
  second.setScene(nullptr);
  workspace_.area->comparison().setMode(ComparisonMode::off);
  workspace_.area->setDifferenceScale(0.0);
}

ComparisonMode ComparisonSession::mode() const {
  return workspace_.area->comparison().mode();
}

QStringList ComparisonSession::others() const {
  QStringList names{QString()};
  for (const scene::Layout& layout : document_.scene()->layouts) names.append(toQt(layout.name));
  names.removeAll(document_.layout());
  return names;
}

void ComparisonSession::chooseOther() {
  const QStringList all = others();
  if (all.contains(other_) && other_ != document_.layout()) return;
  if (all.contains(before_)) {
    other_ = before_;
    return;
  }
  // The next in the list rather than the base, which few want to see.
  QStringList names{QString()};
  for (const scene::Layout& layout : document_.scene()->layouts) names.append(toQt(layout.name));
  const auto at = names.indexOf(document_.layout());
  other_ = at + 1 < names.size() ? names[at + 1] : names[std::max<qsizetype>(at - 1, 0)];
}

void ComparisonSession::setMode(ComparisonMode mode) {
  if (mode != ComparisonMode::off && others().isEmpty()) return;
  const bool begins = this->mode() == ComparisonMode::off;
  if (begins && mode != ComparisonMode::off) {
    if (other_.isEmpty()) other_ = document_.layout();  // not chosen yet
    chooseOther();
  }
  workspace_.area->comparison().setMode(mode);
  if (mode == ComparisonMode::off) {
    workspace_.area->setDifferenceScale(0.0);
    workspace_.results->setComparison(std::nullopt);
    readings_.setBaseWanted(false);
    return;
  }
  show();
  want();
}

void ComparisonSession::setOther(const QString& layout) {
  if (layout == document_.layout()) return;
  other_ = layout;
  chosen_range_.reset();
  show();
  want();
}

void ComparisonSession::swap() {
  const QString shown = document_.layout();
  const QString other = other_;
  other_ = shown;
  document_.setLayout(other);
}

void ComparisonSession::onScene() {
  if (document_.previewing()) return;
  if (others().isEmpty()) {
    setMode(ComparisonMode::off);
  } else if (mode() != ComparisonMode::off) {
    if (other_ == document_.layout()) other_ = before_;
    chooseOther();
    show();
  }
  before_ = document_.layout();
  want();
}

void ComparisonSession::want() {
  QStringList wanted = others();
  if (mode() != ComparisonMode::off) {
    wanted.removeAll(other_);
    wanted.prepend(other_);
  }
  lights_.setWanted(wanted);
}

bool ComparisonSession::isCurrent() const {
  return mode() != ComparisonMode::off && lights_.isCurrent(other_);
}

void ComparisonSession::takeLook() {
  if (mode() == ComparisonMode::off) return;
  ComparisonView& comparison = workspace_.area->comparison();
  Look look = workspace_.view->look();
  if (mode() == ComparisonMode::difference) {
    look.false_color = true;
    look.difference = true;
    look.scale = {.range = {0.0, 2.0 * range_, false}};
    look.levels.clear();
  }
  // One eye looks at both.
  if (color::toneKindOf(look.display.view)) {
    look.adapted_to = workspace_.area->view().adaptation();
  }
  (void)comparison.second().setLook(look);
}

void ComparisonSession::show() {
  if (mode() == ComparisonMode::off) return;
  ComparisonView& comparison = workspace_.area->comparison();
  SceneView& first = workspace_.area->view();
  SceneView& second = comparison.second();
  const auto name = [](const QString& layout) { return layout.isEmpty() ? tr("Base") : layout; };
  comparison.bar().setLayouts(document_.layout(), others(), other_);
  comparison.setNames(name(document_.layout()), name(other_));
  workspace_.results->setComparison(std::pair(document_.layout(), other_));
  readings_.setBaseWanted(other_.isEmpty());
  second.setScene(document_.scene());
  auto luminaires = lights_.luminairesOf(other_);
  if (mode() == ComparisonMode::difference) {
    // Those of either, in grey.
    luminaires.insert(luminaires.end(), document_.luminaires().begin(),
                      document_.luminaires().end());
  }
  second.setLuminaires(
      std::make_shared<const EmitterSet>(luminaires, document_.scene()->mesh->origin));
  const LightFramePtr frame = lights_.frame(other_);
  const bool ready = frame != nullptr && first.meshSolver() == frame->solver;
  if (ready) second.shareMesh(first);
  if (mode() == ComparisonMode::difference) {
    showDifference();
  } else {
    workspace_.area->setDifferenceScale(0.0);
    if (ready) second.setFrame(frame);
    takeLook();
  }
}

void ComparisonSession::showDifference() {
  const LightFramePtr first = relighting_.frame();
  const LightFramePtr second = lights_.frame(other_);
  if (first == nullptr || second == nullptr || first->solver != second->solver) return;
  if (workspace_.area->view().meshSolver() != second->solver) return;
  if (range_ <= 0.0 || !document_.previewing()) {
    range_ = chosen_range_.value_or(fittingDifference(*first, *second));
  }
  workspace_.area->comparison().bar().setRange(range_);
  workspace_.area->comparison().second().setFrame(differenceLight(*first, *second, range_));
  workspace_.area->setDifferenceScale(range_);
  takeLook();
}

void ComparisonSession::takeThumbnail() {
  SceneView& view = workspace_.area->view();
  if (document_.previewing() || view.isMoving()) {
    thumbnails_.start();
    return;
  }
  while (!without_thumbnail_.isEmpty()) {
    const QString layout = without_thumbnail_.takeFirst();
    const LightFramePtr frame = lights_.frame(layout);
    if (frame == nullptr || frame->solver != view.meshSolver()) continue;
    Shot shot;
    shot.pixels = workspace_.layouts->thumbnailSize();
    shot.frame = frame;
    shot.luminaires = std::make_shared<const EmitterSet>(lights_.luminairesOf(layout),
                                                         document_.scene()->mesh->origin);
    shot.samples = kThumbnailSamples;
    shot.look = plain(view.look());
    workspace_.layouts->setThumbnail(layout, view.take(shot).image);
    break;
  }
  if (!without_thumbnail_.isEmpty()) thumbnails_.start();
}

}  // namespace soffit::ui
