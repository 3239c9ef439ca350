// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/reflection_drawing.h"

#include "core/base/parallel.h"
#include "core/glossy/lobe_shape.h"
#include "core/render/live_probes.h"
#include "ui/viewport/reflection_shader.h"

#include <algorithm>
#include <map>
#include <string>

namespace soffit::ui {
namespace {

constexpr int kRoughnessUnit = 4;
constexpr int kPosition = 0, kUv = 3, kNormal = 4, kGloss = 6;  // as GlProgram binds them
static_assert(render::LiveProbes::kMostProbes <= kMostShaderProbes);
static_assert(render::LampMaker::kMostLamps <= kMostShaderLamps);
static_assert(render::LampMaker::kFewLuminaires * 4 <= kMostShaderLamps);  // pieces in a row

void attribute(int location, GlBuffer& buffer, const void* data, std::size_t count, int size) {
  buffer.fill(GlBuffer::Kind::vertices, data,
              count * static_cast<std::size_t>(size) * sizeof(float));
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  const auto at = static_cast<GLuint>(location);
  glVertexAttribPointer(at, size, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(at);
}

std::string element(const char* name, std::size_t i) {
  return std::string(name) + "[" + std::to_string(i) + "]";
}

}  // namespace

void ReflectionDrawing::setMesh(std::shared_ptr<const DisplayMesh> mesh) {
  mesh_ = std::move(mesh);
  light_.reset();
  mesh_dirty_ = true;
}

void ReflectionDrawing::setLight(std::shared_ptr<const render::LitProbes> probes) {
  if (probes == light_) return;
  light_ = std::move(probes);
  light_dirty_ = true;
}

void ReflectionDrawing::releaseRuns() {
  for (Run& run : runs_) run.map.release();
  runs_.clear();
}

void ReflectionDrawing::uploadMesh() {
  releaseRuns();
  // What shines, map by map (null sorts first), and the vertices of that alone.
  std::map<std::shared_ptr<const scene::Image>, std::vector<std::uint32_t>> by_map;
  std::vector<std::uint32_t> number(mesh_->vertexCount(), 0xffffffffU);
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  std::vector<vec2> gloss;
  std::vector<vec2> uvs;
  const bool mapped = !mesh_->roughness_maps.empty();
  for (std::size_t k = 0; k + 2 < mesh_->indices.size() && !mesh_->gloss.empty(); k += 3) {
    const std::uint32_t corner = mesh_->indices[k];
    if (mesh_->gloss[corner].x <= 0.0F) continue;
    auto& indices = by_map[mapped ? mesh_->roughness_maps[mesh_->material_of[corner]] : nullptr];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh_->indices[k + c];
      if (number[v] == 0xffffffffU) {
        number[v] = static_cast<std::uint32_t>(positions.size());
        positions.push_back(mesh_->positions[v]);
        normals.push_back(mesh_->normals[v]);
        gloss.push_back(mesh_->gloss[v]);
        if (mapped) uvs.push_back(mesh_->uvs[v]);
      }
      indices.push_back(number[v]);
    }
  }
  if (by_map.empty()) return;
  std::vector<std::uint32_t> indices;
  for (const auto& [map, run] : by_map) {
    runs_.push_back({static_cast<int>(indices.size()), static_cast<int>(run.size()), {}});
    if (map != nullptr) runs_.back().map.make(*map);
    indices.insert(indices.end(), run.begin(), run.end());
  }
  glBindVertexArray(array_);
  attribute(kPosition, positions_, positions.data(), positions.size(), 3);
  attribute(kNormal, normals_, normals.data(), normals.size(), 3);
  attribute(kGloss, gloss_, gloss.data(), gloss.size(), 2);
  if (mapped) {
    attribute(kUv, uvs_, uvs.data(), uvs.size(), 2);
  } else {
    glDisableVertexAttribArray(kUv);
  }
  indices_.fill(GlBuffer::Kind::indices, indices.data(), indices.size() * sizeof(std::uint32_t));
  glBindVertexArray(0);
}

void ReflectionDrawing::drawRuns() const {
  glBindVertexArray(array_);
  for (const Run& run : runs_) {
    const bool mapped = run.map.id() != 0;
    program_.set("mapped", mapped ? 1 : 0);
    if (mapped) run.map.bind(kRoughnessUnit);
    const auto first = static_cast<std::size_t>(run.first) * sizeof(std::uint32_t);
    glDrawElements(GL_TRIANGLES, run.count, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first));  // NOLINT
  }
  glBindVertexArray(0);
}

void ReflectionDrawing::uploadLobes() {
  const glossy::LobeTable table = glossy::lobeTable();
  const std::size_t n = table.shapes.size();
  std::vector<float> values(8 * n);
  const auto put = [&](std::size_t at, double weight, const glossy::RoundLobe& lobe) {
    values[at] = static_cast<float>(weight);
    values[at + 1] = static_cast<float>(lobe.axis_sine);
    values[at + 2] = static_cast<float>(lobe.alpha);
    values[at + 3] = static_cast<float>(lobe.above);
  };
  for (std::size_t k = 0; k < n; ++k) {
    put(4 * k, table.shapes[k].scale, table.shapes[k].base);
    put(4 * (n + k), table.shapes[k].bias, table.shapes[k].rise);
  }
  const auto side = static_cast<int>(table.nodes);
  lobes_.fill(GlLayers::Format::four, side, side, 2, true, values.data());
}

void ReflectionDrawing::uploadMaps() {
  const auto probes = light_->probes();
  if (probes.empty()) return;
  const auto cubes = probes.front().map.cubes();
  atlas_width_ = cubes.front().side() + 2;
  atlas_height_ = 0;
  for (const glossy::SmoothCube& cube : cubes) atlas_height_ += cube.side() + 2;
  const auto layer =
      static_cast<std::size_t>(atlas_width_) * static_cast<std::size_t>(atlas_height_);
  atlas_.resize(3 * layer * 6 * probes.size());
  parallelFor(6 * probes.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t l = begin; l < end; ++l) {
      std::size_t row_at = 0;
      for (const glossy::SmoothCube& cube : probes[l / 6].map.cubes()) {
        const auto wide = static_cast<std::size_t>(cube.side()) + 2;
        for (std::size_t row = 0; row < wide; ++row) {
          const vec3* from = cube.rimmed().data() + (l % 6 * wide + row) * wide;
          float* to = atlas_.data() +
                      3 * (l * layer + (row_at + row) * static_cast<std::size_t>(atlas_width_));
          std::copy_n(&from->x, 3 * wide, to);
        }
        row_at += wide;
      }
    }
  });
  const auto layers = static_cast<int>(6 * probes.size());
  maps_.fill(GlLayers::Format::three, atlas_width_, atlas_height_, layers, true, atlas_.data());
  std::vector<std::shared_ptr<const glossy::ProbeDepth>> wanted;
  for (const render::LitProbe& probe : probes) wanted.push_back(probe.depth);
  if (wanted == uploaded_) return;
  uploaded_ = std::move(wanted);
  std::vector<float> depths;
  for (const auto& depth : uploaded_) {
    depths.insert(depths.end(), depth->rimmed().begin(), depth->rimmed().end());
  }
  const int wide = uploaded_.front()->side() + 2;
  depths_.fill(GlLayers::Format::one, wide, wide, layers, true, depths.data());
  std::vector<vec2> sights;
  for (const render::LitProbe& probe : probes) {
    sights.insert(sights.end(), probe.sight->rimmed().begin(), probe.sight->rimmed().end());
  }
  constexpr int kSightWide = glossy::ProbeSight::kSide + 2;
  sights_.fill(GlLayers::Format::two, kSightWide, kSightWide, layers, true, &sights.front().x);
}

void ReflectionDrawing::uploadLamps() {
  constexpr int kWide = render::LampMap::kSide + 2;
  const auto lamps =
      light_->lamps().first(std::min<std::size_t>(light_->lamps().size(), kMostShaderLamps));
  if (lamps.empty()) return;
  const auto layers = static_cast<int>(6 * lamps.size());
  if (lamps_.layers() < layers) {
    // Room for all that come and go.
    lamps_.fill(GlLayers::Format::two, kWide, kWide, 6 * kMostShaderLamps, true, nullptr);
    lamp_maps_.clear();
  }
  lamp_maps_.resize(std::max(lamp_maps_.size(), lamps.size()));
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    if (lamp_maps_[i] == lamps[i].map) continue;
    lamp_maps_[i] = lamps[i].map;
    lamps_.replace(GlLayers::Format::two, static_cast<int>(6 * i), 6,
                   &lamps[i].map->rimmed().front().x);
  }
}

void ReflectionDrawing::upload() {
  if (array_ == 0) {
    glGenVertexArrays(1, &array_);
    program_.build(reflectionVertexShader(), reflectionFragmentShader());
    uploadLobes();
    mesh_dirty_ = light_dirty_ = true;
  }
  if (std::exchange(mesh_dirty_, false)) uploadMesh();
  if (std::exchange(light_dirty_, false)) {
    uploadMaps();
    uploadLamps();
  }
}

void ReflectionDrawing::draw(const glm::mat4& clip_from_scene, const glm::vec4& eye) {
  if (mesh_ == nullptr || mesh_->gloss.empty() || light_ == nullptr || light_->probes().empty()) {
    return;
  }
  upload();
  if (runs_.empty() || !program_.ready()) return;
  setUniforms(clip_from_scene, eye);
  maps_.bind(0);
  depths_.bind(1);
  lobes_.bind(2);
  lamps_.bind(3);
  sights_.bind(5);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  glDepthMask(GL_FALSE);
  drawRuns();
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_BLEND);
  glActiveTexture(GL_TEXTURE0);
}

void ReflectionDrawing::setUniforms(const glm::mat4& clip_from_scene, const glm::vec4& eye) const {
  program_.use();
  program_.set("clip_from_scene", clip_from_scene);
  program_.set("eye", eye);
  const auto probes = light_->probes();
  const auto count = std::min<std::size_t>(probes.size(), kMostShaderProbes);
  program_.set("probe_count", static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i) {
    program_.set(element("probe", i).c_str(), probes[i].position);
  }
  program_.set("room_lo", light_->room().lo);
  program_.set("room_hi", light_->room().hi);
  program_.set("side", probes.front().depth->side());
  const auto cubes = probes.front().map.cubes();
  program_.set("level_count",
               static_cast<int>(std::min<std::size_t>(cubes.size(), kMostShaderLevels)));
  int row = 0;
  for (std::size_t k = 0; k < cubes.size() && k < kMostShaderLevels; ++k) {
    program_.set(element("level_side", k).c_str(), cubes[k].side());
    program_.set(element("level_row", k).c_str(), row);
    row += cubes[k].side() + 2;
  }
  program_.set("atlas", vec2(atlas_width_, atlas_height_));
  program_.set("maps", 0);
  program_.set("depths", 1);
  program_.set("lobes", 2);
  program_.set("lamps", 3);
  program_.set("sights", 5);
  program_.set("roughness_map", kRoughnessUnit);
  const auto lamps = light_->lamps();
  const auto lamp_count = std::min<std::size_t>(lamps.size(), kMostShaderLamps);
  program_.set("lamp_count", static_cast<int>(lamp_count));
  for (std::size_t i = 0; i < lamp_count; ++i) {
    program_.set(element("lamp", i).c_str(), glm::vec4(lamps[i].position, lamps[i].radius));
    program_.set(element("lamp_color", i).c_str(), lamps[i].color);
  }
}

void ReflectionDrawing::release() {
  for (GlBuffer* buffer : {&positions_, &normals_, &gloss_, &uvs_, &indices_}) buffer->release();
  for (GlLayers* layers : {&maps_, &depths_, &sights_, &lobes_, &lamps_}) layers->release();
  program_.release();
  releaseRuns();
  if (array_ != 0) glDeleteVertexArrays(1, &array_);
  array_ = 0;
  uploaded_.clear();
  lamp_maps_.clear();
}

}  // namespace soffit::ui
