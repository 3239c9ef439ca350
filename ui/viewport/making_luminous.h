// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/document/luminaire_types.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/view_tool.h"

namespace soffit::ui {

/// Makes a luminaire of the part of the building that is clicked: what hangs together there and has
/// one material. It emits from the side that was clicked; the building keeps its own part, and the
/// luminaire's lies a hair before it.
class MakingLuminous : public ViewTool {
  Q_OBJECT

 public:
  MakingLuminous(Document& document, SceneView& view) : document_(document), view_(view) {}
  void hover(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  void click(const PointedAt& at, const QPointF& mouse, Qt::KeyboardModifiers keys) override;
  [[nodiscard]] QString hint() const override;

 private:
  Document& document_;
  SceneView& view_;
  std::vector<std::uint32_t> part_;  ///< the last one shown
};

/// The kind of luminaire that a part of the building becomes; `place` receives where it stands.
/// Nothing for parts of more than kMostTriangles.
std::optional<LuminaireType> luminousPart(const scene::Scene& scene, const SurfaceReading& surface,
                                          const vec3& geometric_normal,
                                          std::span<const std::uint32_t> part, dvec3& place);

inline constexpr std::size_t kMostTriangles = 4000;

}  // namespace soffit::ui
