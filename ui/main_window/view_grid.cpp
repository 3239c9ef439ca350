// SPDX-License-Identifier: MIT
#include "ui/main_window/view_grid.h"

#include <QMouseEvent>
#include <QPainter>
#include <QSettings>

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::ui {
namespace {

constexpr int kGap = 4;    ///< px between views, to take hold of
constexpr int kFrame = 1;  ///< px about each, for the frame of the active one
constexpr double kLeastShare = 0.15;
/// While something is dragged, a view that is only looked at is drawn again after so many times
/// what a picture takes it, within these bounds, ms.
constexpr double kPatience = 4.0;
constexpr double kOftenest = 60.0;
constexpr double kRarest = 500.0;

constexpr std::array kFirstShown{StandardView::perspective, StandardView::plan,
                                 StandardView::section_front, StandardView::section_right};

std::size_t countOf(ViewGrid::Arrangement arrangement) {
  switch (arrangement) {
    case ViewGrid::Arrangement::one:
      return 1;
    case ViewGrid::Arrangement::four:
      return 4;
    default:
      return 2;
  }
}

}  // namespace

ViewGrid::ViewGrid(QWidget& area)
    : QObject(&area), area_(area), wanted_(kFirstShown.begin(), kFirstShown.end()) {
  follow_.setSingleShot(true);
  connect(&follow_, &QTimer::timeout, this, &ViewGrid::follow);
  area_.setMouseTracking(true);
  area_.installEventFilter(this);
  addPane();
  connect(&first().view(), &SceneView::meshChanged, this, &ViewGrid::follow);
}

void ViewGrid::addPane() {
  auto* pane = new ViewPane(area_);
  panes_.push_back(pane);
  pane->view().installEventFilter(this);
  connect(&pane->view(), &SceneView::movingChanged, this, [this, pane](bool moving) {
    if (pane != &active() || moving) return;
    for (ViewPane* other : panes_) {
      if (other != pane) other->view().setMoving(false);
    }
    follow();
  });
  connect(&pane->bar(), &ViewBar::cameraChosen, this, [this, pane](const QString& name) {
    activate(static_cast<std::size_t>(std::ranges::find(panes_, pane) - panes_.begin()));
    Q_EMIT cameraChosen(name);
  });
  pane->bar().setCameras(cameras_);
  if (panes_.size() == 1) return;
  // What the others say, the first says for all.
  ViewInput* input = &pane->input();
  ViewInput* main = &first().input();
  connect(input, &ViewInput::pointed, main, &ViewInput::pointed);
  connect(input, &ViewInput::left, main, &ViewInput::left);
  connect(input, &ViewInput::editRequested, main, &ViewInput::editRequested);
  connect(input, &ViewInput::surfaceClicked, main, &ViewInput::surfaceClicked);
  connect(input, &ViewInput::surfaceDoubleClicked, main, &ViewInput::surfaceDoubleClicked);
  connect(input, &ViewInput::hintChanged, main, &ViewInput::hintChanged);
  connect(main, &ViewInput::gizmoToolChanged, input, &ViewInput::setGizmoTool);
  input->setGizmoTool(first().view().gizmoTool());
  input->setDocument(document_);
  pane->bar().setLayouts(layouts_);
  connect(pane, &ViewPane::layoutChanged, this, &ViewGrid::follow);
  connect(pane, &ViewPane::layoutChanged, this, &ViewGrid::shownChanged);
}

bool ViewGrid::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &area_) return dragDivider(event);
  const bool used = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::Wheel ||
                    event->type() == QEvent::FocusIn || event->type() == QEvent::DragEnter;
  if (used) {
    for (std::size_t i = 0; i < panes_.size(); ++i) {
      if (watched == &panes_[i]->view()) activate(i);
    }
  }
  return false;
}

void ViewGrid::activate(std::size_t i) {
  // The menu changes the rules of the first.
  if (i != 0) panes_[i]->input().snapRules() = first().input().snapRules();
  if (i == active_ || i >= shown_) return;
  active_ = i;
  area_.update();
  Q_EMIT activeChanged();
}

void ViewGrid::setArrangement(Arrangement arrangement) {
  if (arrangement == arrangement_) return;
  arrangement_ = arrangement;
  Q_EMIT arrangementChanged();
}

void ViewGrid::showPanes(std::size_t count) {
  while (panes_.size() < count) addPane();
  shown_ = count;
  if (active_ >= shown_) activate(0);
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    const bool shown = i < shown_;
    if (!shown) panes_[i]->input().setTool(nullptr);
    panes_[i]->setVisible(shown);
  }
  Q_EMIT shownChanged();
}

std::size_t ViewGrid::arranged() const {
  return countOf(arrangement_);
}

void ViewGrid::layOut(const QRect& area, bool alone, int above) {
  const std::size_t count = alone ? 1 : countOf(arrangement_);
  const std::size_t before = shown_;
  alone_ = alone;
  laid_ = area;
  if (panes_.size() < count || shown_ != count) showPanes(count);
  if (count == 1) {
    first().setGeometry(area, above);
    return;
  }
  const bool columns = arrangement_ != Arrangement::over;
  const bool rows = arrangement_ != Arrangement::beside;
  const int x = static_cast<int>(std::lround(across_ * area.width()));
  const int y = static_cast<int>(std::lround(down_ * area.height()));
  for (std::size_t i = 0; i < count; ++i) {
    const bool right = columns && i % 2 == 1;
    const bool low = rows && (count == 4 ? i >= 2 : i == 1);
    QRect rect = area;
    if (columns && right) rect.setLeft(area.left() + x + kGap / 2);
    if (columns && !right) rect.setRight(area.left() + x - kGap / 2 - 1);
    if (rows && low) rect.setTop(area.top() + y + kGap / 2);
    if (rows && !low) rect.setBottom(area.top() + y - kGap / 2 - 1);
    panes_[i]->setGeometry(rect.adjusted(kFrame, kFrame, -kFrame, -kFrame));
  }
  for (std::size_t i = before; i < count; ++i) bringUpToDate(*panes_[i]);
  area_.update();
}

void ViewGrid::paint(QPainter& painter) const {
  if (shown_ == 1) return;
  painter.fillRect(area_.rect(), area_.palette().color(QPalette::Window));
  const QRect active = panes_[active_]->view().geometry();
  painter.fillRect(active.adjusted(-kFrame, -kFrame, kFrame, kFrame),
                   area_.palette().color(QPalette::Highlight));
}

bool ViewGrid::dragDivider(QEvent* event) {
  const auto* mouse = dynamic_cast<QMouseEvent*>(event);
  if (mouse == nullptr || shown_ == 1) return false;
  // To be taken hold of; what follows comes here, too.
  if (event->type() == QEvent::MouseButtonPress) return area_.cursor().shape() != Qt::ArrowCursor;
  if (event->type() != QEvent::MouseMove) return false;
  const QPointF at = mouse->position();
  const double x = (at.x() - laid_.left()) / std::max(laid_.width(), 1);
  const double y = (at.y() - laid_.top()) / std::max(laid_.height(), 1);
  if ((mouse->buttons() & Qt::LeftButton) == 0) {
    const bool across =
        arrangement_ != Arrangement::over && std::abs(x - across_) * laid_.width() <= kGap;
    const bool down =
        arrangement_ != Arrangement::beside && std::abs(y - down_) * laid_.height() <= kGap;
    area_.setCursor(across && down ? Qt::SizeAllCursor
                    : across       ? Qt::SplitHCursor
                    : down         ? Qt::SplitVCursor
                                   : Qt::ArrowCursor);
    return false;
  }
  const Qt::CursorShape held = area_.cursor().shape();
  if (held == Qt::SplitHCursor || held == Qt::SizeAllCursor) {
    across_ = std::clamp(x, kLeastShare, 1.0 - kLeastShare);
  }
  if (held == Qt::SplitVCursor || held == Qt::SizeAllCursor) {
    down_ = std::clamp(y, kLeastShare, 1.0 - kLeastShare);
  }
  layOut(laid_, alone_);
  return true;
}

bool ViewGrid::isDragged() const {
  return document_ != nullptr && document_->previewing() && panes_[active_]->view().isMoving();
}

void ViewGrid::bringUpToDate(ViewPane& pane) {
  SceneView& view = pane.view();
  SceneView& main = first().view();
  const auto i = static_cast<std::size_t>(std::ranges::find(panes_, &pane) - panes_.begin());
  if (scene_ == nullptr) {
    if (!view.bounds().empty()) wanted_[i] = pane.standardView();
    pane.setLayout(std::nullopt);
    view.setLuminaires(nullptr);
    view.setScene(nullptr);
    return;
  }
  const bool fresh = view.origin() != main.origin() || view.bounds().empty();
  (void)view.setLook(look_);
  view.setScene(scene_);
  view.setSelection(selection_);
  showLight(pane);
  if (!fresh || view.bounds().empty()) return;
  pane.setPerspective(main.viewCamera().isParallel() ? first().perspective() : main.viewCamera());
  pane.show(wanted_[i]);
}

void ViewGrid::showLight(ViewPane& pane) {
  SceneView& view = pane.view();
  SceneView& main = first().view();
  const bool other = showsOther(pane);
  pane.input().setOnlyLooking(other);
  const LightFramePtr frame = other ? others_.frame(*pane.layout()) : frame_;
  const bool lit = frame != nullptr && main.meshSolver() == frame->solver;
  const bool changed = lit && view.frame() != frame;
  if (!other && view.luminaires() != luminaires_) view.setLuminaires(luminaires_);
  if (other && (changed || view.luminaires() == nullptr || view.luminaires() == luminaires_)) {
    view.setLuminaires(others_.luminaires(*pane.layout()));
  }
  if (lit) view.shareMesh(main);
  if (changed) showFrame(view, frame);
}

/// One view computes the light of the mesh's corners, the others take it over.
void ViewGrid::showFrame(SceneView& view, const LightFramePtr& frame) {
  for (std::size_t i = 0; i < shown_; ++i) {
    SceneView& other = panes_[i]->view();
    if (&other == &view || other.frame() != frame) continue;
    view.setFrameOf(other);
    return;
  }
  view.setFrame(frame);
}

void ViewGrid::setLayouts(const QStringList& names, const QString& edited) {
  layouts_ = names;
  edited_ = edited;
  for (std::size_t i = 1; i < panes_.size(); ++i) {
    panes_[i]->bar().setLayouts(names);
    const auto& layout = panes_[i]->layout();
    if (layout && !names.contains(*layout)) panes_[i]->setLayout(std::nullopt);
  }
}

void ViewGrid::follow() {
  follow_.stop();
  if (scene_ == nullptr) return;
  for (std::size_t i = 0; i < shown_; ++i) {
    if (i != 0) {
      bringUpToDate(*panes_[i]);
      continue;
    }
    SceneView& view = first().view();
    if (view.luminaires() != luminaires_) view.setLuminaires(luminaires_);
    if (frame_ != nullptr && view.frame() != frame_) showFrame(view, frame_);
  }
}

/// The active view is up to date already.
void ViewGrid::followSoon() {
  if (!isDragged()) {
    follow();
    return;
  }
  if (follow_.isActive()) return;
  double longest = 0.0;
  for (std::size_t i = 0; i < shown_; ++i) {
    if (i == active_) continue;
    longest += panes_[i]->view().frameMilliseconds();
    panes_[i]->view().setMoving(true);
  }
  follow_.start(static_cast<int>(std::clamp(kPatience * longest, kOftenest, kRarest)));
}

void ViewGrid::setDocument(Document* document) {
  document_ = document;
  for (ViewPane* pane : panes_) pane->input().setDocument(document);
}

void ViewGrid::setScene(const std::shared_ptr<const scene::Scene>& scene) {
  scene_ = scene;
  first().view().setScene(scene);
  if (scene == nullptr) frame_ = nullptr;
  if (scene != nullptr) return;  // luminaires come next, and with them the others' turn
  for (std::size_t i = 1; i < panes_.size(); ++i) bringUpToDate(*panes_[i]);
}

void ViewGrid::setLuminaires(const std::shared_ptr<const EmitterSet>& luminaires) {
  luminaires_ = luminaires;
  (isDragged() ? active() : first()).view().setLuminaires(luminaires);
  if (shown_ > 1) followSoon();
}

void ViewGrid::setFrame(const LightFramePtr& frame) {
  frame_ = frame;
  SceneView& main = first().view();
  SceneView& used = active().view();
  // A new mesh is the first's to cut.
  const bool same_mesh = frame != nullptr && main.meshSolver() == frame->solver;
  if (&used != &main && same_mesh && isDragged()) {
    used.setFrame(frame);
  } else {
    main.setFrame(frame);
  }
  if (shown_ > 1) followSoon();
}

void ViewGrid::setSelection(const QStringList& names) {
  selection_ = names;
  for (std::size_t i = 0; i < shown_; ++i) panes_[i]->view().setSelection(names);
}

Result<void> ViewGrid::setLook(const Look& look) {
  auto set = first().view().setLook(look);
  if (!set) return set;
  look_ = look;
  for (std::size_t i = 1; i < shown_; ++i) (void)panes_[i]->view().setLook(look);
  return {};
}

void ViewGrid::setCameras(const QStringList& names) {
  cameras_ = names;
  for (ViewPane* pane : panes_) pane->bar().setCameras(names);
}

void ViewGrid::endTools() {
  for (ViewPane* pane : panes_) pane->input().setTool(nullptr);
}

void ViewGrid::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("views/arrangement"), static_cast<int>(arrangement_));
  settings.setValue(QStringLiteral("views/across"), across_);
  settings.setValue(QStringLiteral("views/down"), down_);
  QVariantList shown;
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const bool known = i < panes_.size() && !panes_[i]->view().bounds().empty();
    shown.append(static_cast<int>(known ? panes_[i]->standardView() : wanted_[i]));
  }
  settings.setValue(QStringLiteral("views/shown"), shown);
}

void ViewGrid::restore(const QSettings& settings) {
  const auto share = [&](const QString& key) {
    return std::clamp(settings.value(key, 0.5).toDouble(), kLeastShare, 1.0 - kLeastShare);
  };
  across_ = share(QStringLiteral("views/across"));
  down_ = share(QStringLiteral("views/down"));
  const QVariantList shown = settings.value(QStringLiteral("views/shown")).toList();
  for (std::size_t i = 1; i < wanted_.size() && i < static_cast<std::size_t>(shown.size()); ++i) {
    const int view = shown[static_cast<qsizetype>(i)].toInt();
    if (view < 0 || view >= static_cast<int>(kStandardViews.size())) continue;
    wanted_[i] = static_cast<StandardView>(view);
  }
  const int arrangement = settings.value(QStringLiteral("views/arrangement"), 0).toInt();
  if (arrangement < 0 || arrangement > static_cast<int>(Arrangement::four)) return;
  setArrangement(static_cast<Arrangement>(arrangement));
}

}  // namespace soffit::ui
