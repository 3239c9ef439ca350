// SPDX-License-Identifier: MIT
#include "ui/viewport/making_luminous.h"

#include "ui/document/mesh_text.h"
#include "ui/document/text.h"
#include "ui/viewport/placing.h"

#include <algorithm>

namespace soffit::ui {
namespace {

constexpr float kLift = 0.002F;          // m: beyond what counts as lying on the surface
constexpr std::size_t kMostShown = 600;  // triangles outlined while pointing

/// "pendant_01.glass" as a file's name.
std::string fileName(const std::string& name) {
  std::string file;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    file += plain ? c : '_';
  }
  return (file.empty() ? "part" : file) + "_light.obj";
}

}  // namespace

std::optional<LuminaireType> luminousPart(const scene::Scene& scene, const SurfaceReading& surface,
                                          const vec3& geometric_normal,
                                          std::span<const std::uint32_t> part, dvec3& place) {
  if (part.empty() || part.size() > kMostTriangles) return std::nullopt;
  const bool flip = glm::dot(geometric_normal, surface.normal) < 0.0F;
  auto mesh =
      std::make_shared<const geometry::Mesh>(liftedPart(*scene.mesh, part, flip, kLift, place));
  const geometry::Mesh& building = *scene.mesh;
  std::string name = surface.material;
  if (!building.object_of.empty()) {
    const std::size_t object = building.object_of[surface.triangle];
    if (object < building.objects.size() && !building.objects[object].empty()) {
      name = building.objects[object];
    }
  }
  if (name.empty()) name = "Part";
  return typeFromMesh(toQt(name), mesh, fileName(name), objText(*mesh));
}

void MakingLuminous::hover(const PointedAt& at, const QPointF&, Qt::KeyboardModifiers) {
  ViewOverlay::Content content;
  const geometry::Mesh& building = *document_.scene()->mesh;
  if (at.surface) {
    const std::uint32_t triangle = at.surface->triangle;
    if (std::ranges::find(part_, triangle) == part_.end()) part_ = partAround(building, triangle);
    if (part_.size() > kMostTriangles) {
      content.labels.push_back({at.place, tr("too large a part")});
    }
    for (std::size_t i = 0; i < std::min(part_.size(), kMostShown); ++i) {
      const uvec3& t = building.triangles[part_[i]];
      for (int k = 0; k < 3; ++k) {
        content.lines.push_back({building.origin + dvec3(building.positions[t[k]]),
                                 building.origin + dvec3(building.positions[t[(k + 1) % 3]]),
                                 ViewOverlay::Stroke::outline,
                                 {}});
      }
    }
  }
  Q_EMIT contentChanged(content);
}

void MakingLuminous::click(const PointedAt& at, const QPointF&, Qt::KeyboardModifiers keys) {
  if (!at.surface || view_.frame() == nullptr) return;
  const auto part = partAround(*document_.scene()->mesh, at.surface->triangle);
  dvec3 place(0.0);
  const vec3 normal = view_.frame()->solver->scene().normals[at.surface->triangle];
  auto type = luminousPart(*document_.scene(), *at.surface, normal, part, place);
  if (!type) return;
  light::Luminaire luminaire = type->prototype;
  luminaire.position = place;
  addLuminaire(document_, *type, luminaire);
  if ((keys & Qt::ShiftModifier) == 0) Q_EMIT finished();
}

QString MakingLuminous::hint() const {
  return tr("Click the part of the building that is to give light. Shift: several. Esc: done.");
}

}  // namespace soffit::ui
