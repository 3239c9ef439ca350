// SPDX-License-Identifier: MIT
#include "ui/main_window/view_pane.h"

#include <algorithm>

namespace soffit::ui {
namespace {

constexpr int kMargin = 8;
/// A perspective so high above a floor stands in no room.
constexpr double kRoomHeight = 6.0;

}  // namespace

ViewPane::ViewPane(QWidget& area)
    : QObject(&area),
      view_(new SceneView(&area)),
      input_(new ViewInput(*view_, this)),
      bar_(new ViewBar(&area)) {
  connect(view_, &SceneView::cameraMoved, this, &ViewPane::onCamera);
  connect(bar_, &ViewBar::viewChosen, this, &ViewPane::show);
  connect(bar_, &ViewBar::cutChosen, this, [this](double metres) {
    ViewCamera camera = view_->viewCamera();
    if (!camera.isParallel()) return;
    camera.setCutPlace(metres);
    view_->setViewCamera(camera);
  });
  connect(bar_, &ViewBar::layoutChosen, this, &ViewPane::setLayout);
  onCamera();
}

void ViewPane::setLayout(const std::optional<QString>& layout) {
  if (layout == layout_) return;
  layout_ = layout;
  bar_->setLayout(layout);
  Q_EMIT layoutChanged();
}

StandardView ViewPane::standardView() const {
  if (!view_->viewCamera().isParallel()) return StandardView::perspective;
  return standardViewOf(view_->viewCamera(), view_->bounds(), view_->origin());
}

double ViewPane::floor() const {
  const double lowest = view_->origin().z + static_cast<double>(view_->bounds().lo.z);
  const auto below = view_->surroundings({}).distance(perspective_.position, {0.0, 0.0, -1.0});
  return below && *below < kRoomHeight ? perspective_.position.z - *below : lowest;
}

void ViewPane::show(StandardView standard) {
  if (standard == StandardView::perspective) {
    view_->setViewCamera(perspective_);
    return;
  }
  // All of the building under the bar.
  const dvec2 size = glm::max(view_->viewSize(), dvec2(1.0));
  const double bar = std::min(double{1.0} * bar_->sizeHint().height() + kMargin, 0.5 * size.y);
  ViewCamera camera =
      standardCamera(standard, view_->bounds(), view_->origin(), floor(), size.x / (size.y - bar));
  camera.parallel_height *= size.y / (size.y - bar);
  camera.position += 0.5 * bar * camera.pixelSize(0.0, size) * camera.up();
  view_->setViewCamera(camera);
}

void ViewPane::onCamera() {
  const ViewCamera& camera = view_->viewCamera();
  if (!camera.isParallel()) perspective_ = camera;
  std::optional<double> cut;
  if (camera.isParallel()) cut = camera.cutPlace();
  bar_->setView(standardView(), cut);
}

void ViewPane::setGeometry(const QRect& rect, int above) {
  view_->setGeometry(rect);
  bar_->adjustSize();
  bar_->move(rect.left() + kMargin, rect.top() + above + kMargin);
  bar_->raise();
}

void ViewPane::setVisible(bool visible) {
  view_->setVisible(visible);
  bar_->setVisible(visible);
}

}  // namespace soffit::ui
