// SPDX-License-Identifier: MIT
#pragma once

#include "ui/main_window/view_pane.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

class QPainter;
class QSettings;

namespace soffit::ui {

/// One to four views of one building in the centre. They show the same document, selection and
/// look, each from its own camera; the light is computed once, and the mesh is cut once, by the
/// first.
///
/// The active view is the one that was used last: commands are for it, and while something is
/// dragged in it the others follow as often as the machine has time. Views that are not shown are
/// told nothing; they catch up when they come.
class ViewGrid : public QObject {
  Q_OBJECT

 public:
  enum class Arrangement { one, beside, over, four };

  /// The views become parts of `area`, which must outlive this.
  explicit ViewGrid(QWidget& area);

  [[nodiscard]] ViewPane& first() { return *panes_.front(); }
  [[nodiscard]] ViewPane& active() { return *panes_[active_]; }
  /// Those that are shown.
  [[nodiscard]] std::size_t count() const { return shown_; }
  [[nodiscard]] ViewPane& pane(std::size_t i) { return *panes_[i]; }
  [[nodiscard]] Arrangement arrangement() const { return arrangement_; }
  void setArrangement(Arrangement arrangement);
  /// Lays the views out. alone: the first has all of it, whatever the arrangement; its bar leaves
  /// `above` px free at the upper edge.
  void layOut(const QRect& area, bool alone, int above = 0);
  /// How many views there are when a comparison does not take their place.
  [[nodiscard]] std::size_t arranged() const;
  /// What is seen between the views: the frame of the active one.
  void paint(QPainter& painter) const;

  void setDocument(Document* document);
  void setScene(const std::shared_ptr<const scene::Scene>& scene);
  void setLuminaires(const std::shared_ptr<const EmitterSet>& luminaires);
  void setFrame(const LightFramePtr& frame);
  void setSelection(const QStringList& names);
  /// Errors: SceneView::setLook()'s.
  Result<void> setLook(const Look& look);
  /// What other layouts look like; null functions: there are none.
  struct OtherLayouts {
    std::function<LightFramePtr(const QString&)> frame;
    std::function<std::shared_ptr<const EmitterSet>(const QString&)> luminaires;
  };
  void setOtherLayouts(OtherLayouts layouts) { others_ = std::move(layouts); }
  /// All layouts and the one that is edited. Every view but the first may show another one; in it
  /// nothing is edited.
  void setLayouts(const QStringList& names, const QString& edited);
  /// The light of another layout has come.
  void catchUp() { follow(); }
  /// The active view, or the first when what is shown in that one cannot be edited.
  [[nodiscard]] ViewPane& working() { return showsOther(active()) ? first() : active(); }
  /// The saved cameras that the views' bars offer.
  void setCameras(const QStringList& names);
  /// No tool is at work any more, in any view.
  void endTools();

  void save(QSettings& settings) const;
  void restore(const QSettings& settings);

 Q_SIGNALS:
  void arrangementChanged();
  /// Other views are shown, or a view shows another layout.
  void shownChanged();
  void activeChanged();
  /// A saved camera was chosen for the active view.
  void cameraChosen(const QString& name);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addPane();
  void activate(std::size_t i);
  void showPanes(std::size_t count);
  /// Gives a view what the grid shows.
  void bringUpToDate(ViewPane& pane);
  void showLight(ViewPane& pane);
  void showFrame(SceneView& view, const LightFramePtr& frame);
  [[nodiscard]] bool showsOther(const ViewPane& pane) const {
    return pane.layout() && *pane.layout() != edited_ && others_.frame != nullptr;
  }
  void follow();
  void followSoon();
  bool dragDivider(QEvent* event);
  [[nodiscard]] bool isDragged() const;

  QWidget& area_;
  std::vector<ViewPane*> panes_;
  std::vector<StandardView> wanted_;  ///< what a view shows when it comes for the first time
  std::size_t active_ = 0;
  std::size_t shown_ = 1;
  Arrangement arrangement_ = Arrangement::one;
  double across_ = 0.5;  ///< share of the left views, and of the upper ones
  double down_ = 0.5;
  bool alone_ = false;
  QRect laid_;  ///< the part of the area that they have
  QTimer follow_;
  Document* document_ = nullptr;
  std::shared_ptr<const scene::Scene> scene_;
  std::shared_ptr<const EmitterSet> luminaires_;
  LightFramePtr frame_;
  QStringList selection_;
  QStringList cameras_;
  QStringList layouts_;
  QString edited_;
  OtherLayouts others_;
  Look look_;
};

}  // namespace soffit::ui
