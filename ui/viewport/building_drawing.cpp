// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/building_drawing.h"

#include <array>
#include <cstddef>
#include <utility>

namespace soffit::ui {
namespace {

constexpr const char* kMeshVertex = R"(#version 150
invariant gl_Position;  // reflections are added where this depth is met again
in vec3 position;
in vec3 albedo;
in vec4 lux;  // RGB, and what is added to the illuminance
in vec2 uv;
uniform mat4 clip_from_scene;
out vec4 light;
out vec2 at;
out vec3 rho;
void main() {
  gl_Position = clip_from_scene * vec4(position, 1.0);
  rho = albedo;
  light = vec4(albedo * lux.rgb * 0.3183098861837907,
               dot(lux.rgb, vec3(0.2126390, 0.7151687, 0.0721923)) + lux.a);
  at = uv;
}
)";

constexpr const char* kMeshFragment = R"(#version 150
in vec4 light;
in vec2 at;
uniform int mapped;
uniform sampler2D map;
out vec4 color;
void main() {
  vec3 rho = mapped == 1 ? texture(map, vec2(at.x, 1.0 - at.y)).rgb : vec3(1.0);
  color = vec4(light.rgb * rho, max(light.a, 0.0));
}
)";

// What SeenSurfaces::see() asks for.
constexpr const char* kNumberFragment = R"(#version 150
in vec3 rho;
in vec2 at;
uniform int mapped;
uniform int first;
uniform sampler2D map;
out uint color;
out vec4 more;
void main() {
  color = uint(first + gl_PrimitiveID + 1);
  more = vec4(mapped == 1 ? rho * texture(map, vec2(at.x, 1.0 - at.y)).rgb : rho, 1.0);
}
)";

constexpr const char* kLuminaireVertex = R"(#version 150
in vec3 position;
in vec3 albedo;
uniform mat4 clip_from_scene;
out vec3 radiance;
void main() {
  gl_Position = clip_from_scene * vec4(position, 1.0);
  radiance = albedo;
}
)";

constexpr const char* kLuminaireFragment = R"(#version 150
in vec3 radiance;
uniform float kind;
out vec4 color;
void main() { color = vec4(radiance, kind); }
)";

void attribute(GLuint location, const GlBuffer& buffer, int size, int stride = 0,
               std::size_t offset = 0) {
  if (buffer.id() == 0) {
    glDisableVertexAttribArray(location);
    return;
  }
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, stride,
                        reinterpret_cast<const void*>(offset));  // NOLINT: GL's way of offsets
  glEnableVertexAttribArray(location);
}

template <class T>
void fill(GlBuffer& buffer, GlBuffer::Kind kind, const std::vector<T>& values, bool often = false) {
  if (values.empty()) {
    buffer.release();
  } else {
    buffer.fill(kind, values.data(), values.size() * sizeof(T), often);
  }
}

}  // namespace

void BuildingDrawing::setMesh(std::shared_ptr<const DisplayMesh> mesh) {
  mesh_ = std::move(mesh);
  reflections_.setMesh(mesh_);
  light_.reset();
  sky_.reset();
  shift_.clear();
  mesh_dirty_ = true;
}

void BuildingDrawing::setSky(std::shared_ptr<const HeldSky> sky) {
  if (sky == sky_) return;
  sky_ = std::move(sky);
  shift_.clear();
  light_dirty_ = true;
}

void BuildingDrawing::setLight(std::shared_ptr<const std::vector<vec3>> lux) {
  light_ = std::move(lux);
  sky_.reset();
  shift_.clear();
  light_dirty_ = true;
}

void BuildingDrawing::setShift(std::vector<float> lux) {
  if (lux.empty() && shift_.empty()) return;
  shift_ = std::move(lux);
  light_dirty_ = true;
}

void BuildingDrawing::setView(const glm::mat4& clip_from_scene, const glm::vec4& eye, bool cuts) {
  cuts_ = cuts;
  if (clip_from_scene == clip_from_scene_ && eye == eye_) return;
  clip_from_scene_ = clip_from_scene;
  eye_ = eye;
  view_dirty_ = true;
}

void BuildingDrawing::setLuminaires(LuminaireMesh luminaires) {
  luminaires_ = std::move(luminaires);
  luminaires_dirty_ = true;
}

void BuildingDrawing::upload() {
  using Kind = GlBuffer::Kind;
  if (!mesh_program_.ready()) {
    mesh_program_.build(kMeshVertex, kMeshFragment);
    number_program_.build(kMeshVertex, kNumberFragment);
    luminaire_program_.build(kLuminaireVertex, kLuminaireFragment);
    glGenVertexArrays(1, &mesh_array_);
    glGenVertexArrays(1, &luminaire_array_);
    mesh_dirty_ = light_dirty_ = luminaires_dirty_ = true;
  }
  if (mesh_dirty_ && mesh_ != nullptr) {
    glBindVertexArray(mesh_array_);
    fill(positions_, Kind::vertices, mesh_->positions);
    fill(albedo_, Kind::vertices, mesh_->albedo);
    fill(uvs_, Kind::vertices, mesh_->uvs);
    view_dirty_ = true;
    attribute(0, positions_, 3);
    attribute(1, albedo_, 3);
    attribute(3, uvs_, 2);
    for (GlTexture& map : maps_) map.release();
    maps_.assign(mesh_->parts.size(), {});
    for (std::size_t i = 0; i < maps_.size(); ++i) {
      if (mesh_->parts[i].map != nullptr) maps_[i].make(*mesh_->parts[i].map);
    }
    light_dirty_ = true;
  }
  if (mesh_dirty_ || view_dirty_) seen_.forget();
  mesh_dirty_ = false;
  if (view_dirty_ && mesh_ != nullptr) {
    glBindVertexArray(mesh_array_);
    fill(indices_, Kind::indices, visibleIndices(*mesh_, clip_from_scene_, eye_, visible_counts_),
         true);
  }
  view_dirty_ = false;
  if (light_dirty_ && light_ != nullptr && !light_->empty()) {
    uploadLight();
    glBindVertexArray(mesh_array_);
    attribute(2, lux_, 4, sizeof(glm::vec4));
  }
  light_dirty_ = false;
  if (luminaires_dirty_) {
    glBindVertexArray(luminaire_array_);
    fill(corners_, Kind::vertices, luminaires_.triangles, true);
    constexpr int kStride = sizeof(LuminaireMesh::Vertex);
    attribute(0, corners_, 3, kStride);
    attribute(1, corners_, 3, kStride, offsetof(LuminaireMesh::Vertex, radiance));
    luminaire_corners_ = static_cast<int>(luminaires_.triangles.size());
  }
  luminaires_dirty_ = false;
  glBindVertexArray(0);
}

void BuildingDrawing::uploadLight() {
  if (sky_ == nullptr) {
    sky_evaluation_.letGo();
  } else if (sky_evaluation_.evaluate(*sky_, mesh_, lux_)) {
    return;
  }
  const std::vector<vec3> sum = sky_ == nullptr ? std::vector<vec3>{} : evaluated(*sky_, *mesh_);
  const std::vector<vec3>& lux = sky_ == nullptr ? *light_ : sum;
  // Four each: what pixels are shaded from is fetched in one piece.
  std::vector<glm::vec4> padded(lux.size());
  for (std::size_t i = 0; i < padded.size(); ++i) padded[i] = glm::vec4(lux[i], 0.0F);
  for (std::size_t i = 0; i < shift_.size(); ++i) padded[i].w = shift_[i];
  fill(lux_, GlBuffer::Kind::vertices, padded, true);
}

void BuildingDrawing::drawMesh(const glm::mat4& clip_from_scene, const GlProgram& program) {
  if (mesh_ == nullptr || light_ == nullptr || light_->empty()) return;
  program.use();
  program.set("clip_from_scene", clip_from_scene);
  program.set("map", 0);
  glBindVertexArray(mesh_array_);
  std::size_t first = 0;
  for (std::size_t i = 0; i < mesh_->parts.size(); ++i) {
    const bool mapped = mesh_->parts[i].map != nullptr;
    const std::uint32_t count = visible_counts_[i];
    program.set("mapped", mapped ? 1 : 0);
    program.set("first", static_cast<int>(first / 3));
    if (mapped) maps_[i].bind(0);
    if (count > 0) {
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                     reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));  // NOLINT
    }
    first += count;
  }
}

void BuildingDrawing::drawLuminaires(const glm::mat4& clip_from_scene) {
  if (luminaire_corners_ == 0) return;
  luminaire_program_.use();
  luminaire_program_.set("clip_from_scene", clip_from_scene);
  luminaire_program_.set("kind", kLamp);
  // A panel may lie in the ceiling's very plane.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1.0F, -4.0F);
  // What hangs above the cut of a plan lies on top of it.
  if (cuts_) glEnable(GL_DEPTH_CLAMP);
  glBindVertexArray(luminaire_array_);
  glDrawArrays(GL_TRIANGLES, 0, luminaire_corners_);
  glDisable(GL_DEPTH_CLAMP);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

bool BuildingDrawing::drawSeen(const SeenSurfaces::View& view, const vec3& background) {
  if (mesh_ == nullptr || light_ == nullptr || light_->size() != mesh_->vertexCount()) return false;
  std::size_t shown = 0;
  for (const std::uint32_t count : visible_counts_) shown += count;
  const SeenSurfaces::Mesh buffers{positions_.id(), lux_.id(), indices_.id(), mesh_->vertexCount(),
                                   shown};
  if (!SeenSurfaces::fits(buffers)) return false;
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  if (!seen_.holds(view)) {
    seen_.see(view, buffers, [&] { drawMesh(view.clip_from_scene, number_program_); });
  }
  seen_.shade(static_cast<unsigned>(target), buffers, background, kBeyond);
  glEnable(GL_DEPTH_TEST);
  return true;
}

void BuildingDrawing::draw(const vec2& shift, const vec3& background) {
  upload();
  glm::mat4 shifted(1.0F);
  shifted[3] = glm::vec4(shift, 0.0F, 1.0F);
  const glm::mat4 clip_from_scene = shifted * clip_from_scene_;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_BLEND);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  std::array<GLint, 4> viewport{};
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  const SeenSurfaces::View view{clip_from_scene, viewport[2], viewport[3]};
  const bool still = view == last_view_ && !in_pieces_;
  last_view_ = view;
  if (!still || !drawSeen(view, background)) {
    glClearColor(background.x, background.y, background.z, kBeyond);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawMesh(clip_from_scene, mesh_program_);
  }
  reflections_.draw(clip_from_scene, eye_);
  drawLuminaires(clip_from_scene);
  if (eye_.w != 0.0F) outside_.drawOutside(clip_from_scene, kBeyond);
  outside_.drawPanes(clip_from_scene, eye_);
  glBindVertexArray(0);
  glDisable(GL_CULL_FACE);
}

void BuildingDrawing::release() {
  for (GlBuffer* buffer : {&positions_, &albedo_, &uvs_, &lux_, &indices_, &corners_}) {
    buffer->release();
  }
  for (GlTexture& map : maps_) map.release();
  seen_.release();
  sky_evaluation_.release();
  outside_.release();
  reflections_.release();
  mesh_program_.release();
  number_program_.release();
  luminaire_program_.release();
  if (mesh_array_ != 0) glDeleteVertexArrays(1, &mesh_array_);
  if (luminaire_array_ != 0) glDeleteVertexArrays(1, &luminaire_array_);
  mesh_array_ = luminaire_array_ = 0;
}

}  // namespace soffit::ui
