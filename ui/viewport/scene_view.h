// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/light_frame.h"
#include "ui/viewport/display_mesh_job.h"
#include "ui/viewport/emitter_set.h"
#include "ui/viewport/gizmo_actor.h"
#include "ui/viewport/look.h"
#include "ui/viewport/pointing.h"
#include "ui/viewport/shot.h"
#include "ui/viewport/sky_evaluation.h"
#include "ui/viewport/still.h"
#include "ui/viewport/traced_view.h"
#include "ui/viewport/view_camera.h"
#include "ui/viewport/vtk_view.h"

#include <QStringList>
#include <QTimer>

#include <optional>

namespace soffit::ui {

/// A view of the scene in its light: camera, picture, selection and gizmo. Shows what it is given;
/// what mouse and keys do lies in Navigation and LuminaireDrag.
class SceneView : public VtkView {
  Q_OBJECT

 public:
  /// Of the lines that a flat view draws: the cut and the hatching of what it cuts, and luminaires
  /// seen on their dark side.
  static constexpr vec3 kCutColor{0.62F, 0.66F, 0.72F};
  static constexpr float kCutWidth = 1.6F;
  static constexpr vec3 kHatchColor{0.40F, 0.43F, 0.48F};
  static constexpr float kHatchWidth = 1.0F;
  static constexpr vec3 kPlanColor{0.95F, 0.86F, 0.62F};
  static constexpr float kPlanWidth = 1.2F;

  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// A building; what was shown is gone.
  void setScene(std::shared_ptr<const scene::Scene> scene);
  /// Finished light. The mesh of a new solver is cut in the background; until then the old light
  /// stays.
  void setFrame(LightFramePtr frame);
  /// The light that another view of the building shows; with its mesh, at no further cost.
  void setFrameOf(SceneView& other);
  void setLuminaires(std::shared_ptr<const EmitterSet> luminaires);
  void setSelection(const QStringList& names);
  /// The luminaire under the mouse, empty for none.
  void setHovered(const std::string& name);
  /// Errors: the view is unknown; the look stays as it was.
  Result<void> setLook(const Look& look);
  /// What a view transform that adapts was adapted to in the last picture.
  [[nodiscard]] color::PictureLuminance adaptation();

  [[nodiscard]] const Look& look() const { return look_; }
  [[nodiscard]] const LightFramePtr& frame() const { return frame_; }
  [[nodiscard]] const std::shared_ptr<const EmitterSet>& luminaires() const { return luminaires_; }
  [[nodiscard]] const ViewCamera& viewCamera() const { return view_; }
  void setViewCamera(const ViewCamera& camera);
  void frameAll();
  void frameSelection();

  /// While the camera or a luminaire moves, slow machines compute fewer pixels; the whole picture
  /// follows within 0.1 s of the rest.
  void setMoving(bool moving);

  /// Logical pixels.
  [[nodiscard]] PointedAt pointAt(const QPointF& mouse) const;
  [[nodiscard]] QStringList luminairesIn(const QRectF& band) const;
  /// The lit surface that a ray from a place meets, world, unit direction.
  [[nodiscard]] std::optional<SurfaceReading> surfaceAlong(const dvec3& from,
                                                           const dvec3& direction) const;
  [[nodiscard]] Surroundings surroundings(const QStringList& moving) const;
  [[nodiscard]] GizmoTool gizmoTool() const { return tool_; }
  void setGizmoTool(GizmoTool tool);
  /// Without one nothing of it can be grabbed either: a tool is at work.
  void setGizmoShown(bool shown);
  [[nodiscard]] GizmoPart gizmoPartAt(const QPointF& mouse) const;
  /// Where the gizmo is, world; nothing without a selection.
  [[nodiscard]] std::optional<dvec3> gizmoPlace() const;
  /// The axes of the gizmo, columns: the luminaire's own for scaling one, else the world's.
  [[nodiscard]] dmat3 gizmoFrame() const;
  /// Half of what is selected, about the gizmo, along the world's axes, m.
  [[nodiscard]] dvec3 selectionHalfSize() const;
  void setGizmoHighlight(GizmoPart part);
  /// The last picture without view transform, cd/m^2; empty before there is light.
  [[nodiscard]] std::vector<vec3> readLinear();
  /// The illuminance of the surfaces in the last picture; empty before there is light.
  [[nodiscard]] render::LuxPicture readLux();
  /// Whether nothing that is drawn lies between the eye and a place (world); luminaires do not
  /// hide anything.
  [[nodiscard]] bool isSeen(const ViewCamera& camera, const dvec3& place) const;
  /// Another picture of the building than the one on the screen; that stays as it is. Without an
  /// image before there is light, and for light of another solver.
  Picture take(const Shot& shot);
  /// The same for another thread to make (StillRenderer), without marks; nothing where take() has
  /// no image.
  [[nodiscard]] std::optional<Still> still(const Shot& shot);
  /// Shows a traced picture for as long as it fits what is to be seen; null: none.
  void showTraced(std::shared_ptr<const TracedView> picture);
  /// Whether that is on the screen, or will be with the next frame.
  [[nodiscard]] bool showsTraced() const;
  /// Shows the building with the mesh that another view of it has cut already.
  void shareMesh(const SceneView& other);
  /// The solver whose mesh is shown; null before there is one.
  [[nodiscard]] const std::shared_ptr<const relight::Solver>& meshSolver() const {
    return mesh_solver_;
  }
  /// How the light of surroundings in hand was added up last.
  [[nodiscard]] SkyEvaluation::Figures skyFigures();
  [[nodiscard]] bool isMoving() const { return moving_; }
  [[nodiscard]] dvec2 viewSize() const { return {width(), height()}; }
  [[nodiscard]] dvec3 origin() const;
  /// Bounds of building and luminaires, scene-local.
  [[nodiscard]] Box bounds() const;

 Q_SIGNALS:
  /// Once the light of a frame with this revision is on the screen.
  void lightShown(quint64 revision, double frame_ms);
  void cameraMoved();
  /// The mesh of a new solver is there.
  void meshChanged();
  void movingChanged(bool moving);

 protected:
  void paintGL() override;
  void resizeGL(int width, int height) override;

 private:
  void onMeshFinished();
  bool showOutside(const scene::Scene* before);
  void showLight();
  void lightBuilding(const LightFrame& frame);
  void smoothLines();
  void placeCamera();
  void drawLuminaires();
  void updateOverlay();
  void updateCut();
  /// The overlay as a picture has it: the lines of a plan or a section, nothing to work with.
  void showDrawingLines();
  void restart();
  /// A parallel view whose widget changes its shape goes on showing what it showed.
  void keepExtent(const dvec2& size);
  void refine();
  [[nodiscard]] double movingScale() const;
  [[nodiscard]] Pointable pointable() const;
  [[nodiscard]] std::vector<const light::Emitter*> selectedEmitters() const;
  [[nodiscard]] std::vector<vec3> planOutlines() const;
  [[nodiscard]] std::vector<vec3> cutLines() const;
  [[nodiscard]] std::vector<vec3> cutHatch() const;
  /// Per luminaire; empty: the view cuts none away.
  [[nodiscard]] std::vector<bool> cutAwayLuminaires() const;
  [[nodiscard]] std::vector<vec3> outlines(const QStringList& names) const;

  std::shared_ptr<const scene::Scene> scene_;
  LightFramePtr frame_;
  std::shared_ptr<const EmitterSet> luminaires_;
  QStringList selection_;
  std::string hovered_;
  Look look_;
  bool look_given_ = false;
  ViewCamera view_;
  dvec2 size_{0.0};           ///< of the widget, logical pixels
  dvec2 extent_{0.0};         ///< m: what a parallel view shows at least
  double kept_height_ = 0.0;  ///< m: the picture's height that follows from it; another: a new one
  std::shared_ptr<const DisplayMesh> mesh_;
  std::shared_ptr<const relight::Solver> mesh_solver_;
  DisplayMeshJob mesh_job_;
  std::unique_ptr<GizmoActor> gizmo_;
  std::unique_ptr<OutlineActor> selected_outline_;
  std::unique_ptr<OutlineActor> hovered_outline_;
  /// What the lines of the cut were drawn for.
  struct CutDrawn {
    const geometry::Mesh* mesh = nullptr;
    const void* solid = nullptr;
    int axis = 0;
    double place = 0.0;
    bool cuts = false;
    bool operator==(const CutDrawn&) const = default;
  };
  CutDrawn cut_drawn_;
  std::unique_ptr<OutlineActor> cut_hatch_;
  std::unique_ptr<OutlineActor> cut_outline_;
  std::unique_ptr<OutlineActor> plan_outline_;  ///< luminaires seen on their dark side from above
  GizmoTool tool_ = GizmoTool::move;
  bool gizmo_shown_ = true;
  GizmoPart highlight_ = GizmoPart::none;
  std::shared_ptr<const TracedView> traced_;
  bool lit_from_frame_ = false;  ///< what is drawn is frame_, not what came before it
  bool light_pending_ = false;
  bool moving_ = false;
  bool drew_scaled_ = false;
  bool picture_stale_ = true;
  int sample_ = 0;
  double full_frame_ms_ = 60.0;
  QTimer rest_;
  QTimer late_;  ///< runs while luminaires that moved wait for their light
};

}  // namespace soffit::ui
