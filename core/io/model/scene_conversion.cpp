// SPDX-License-Identifier: MIT
#include "core/io/model/scene_conversion.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/geometry/polygon.h"

namespace soffit::io {
namespace {

constexpr std::size_t kMaxTriangles = 100'000'000;

glm::dmat4 toMatrix(const aiMatrix4x4& m) {
  glm::dmat4 out(m.a1, m.b1, m.c1, m.d1,  // columns
                 m.a2, m.b2, m.c2, m.d2,  //
                 m.a3, m.b3, m.c3, m.d3,  //
                 m.a4, m.b4, m.c4, m.d4);
  // Quarter turns made of single-precision sines: what should be 0 is 4e-8 of the rest.
  constexpr double kRounding = 2e-7;
  for (int c = 0; c < 3; ++c) {
    const double size = glm::length(dvec3(out[c]));
    for (int r = 0; r < 3; ++r) {
      if (std::abs(out[c][r]) < kRounding * size) out[c][r] = 0.0;
    }
  }
  return out;
}

// A node to visit, with what it takes over from its parents.
struct Visit {
  const aiNode* node;
  glm::dmat4 world_from_parent;
  std::string name;
};

// Names that importers make up for nodes in between say nothing to a user.
bool isMadeUp(std::string_view name) {
  return name.empty() || name.front() == '$' || name.front() == '<' || name == "IfcMappedItem" ||
         name == "defaultobject" || name == "RootNode";
}

class Converter {
 public:
  void startObject(const std::string& name) { out_.raw.objects.push_back(name); }
  // Adds a mesh of the current object under a transform; false when there is too much.
  bool add(const aiMesh& mesh, const glm::dmat4& world_from_mesh);
  ConvertedScene take();

 private:
  void addVertices(const aiMesh& mesh, const glm::dmat4& world_from_mesh);
  // A face of at least three corners, as triangles of raw vertices.
  std::span<const uvec3> trianglesOf(std::span<const unsigned> face, std::uint32_t first);

  std::vector<dvec3> corners_;    // of the face in hand
  std::vector<uvec3> triangles_;  // likewise
  ConvertedScene out_;
  bool any_uv_ = false;
};

void Converter::addVertices(const aiMesh& mesh, const glm::dmat4& world_from_mesh) {
  const dmat3 linear(world_from_mesh);
  const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
  // The cofactor matrix turns normals; it needs no division, so flattened meshes are no trap.
  const dmat3 turn(side * glm::cross(linear[1], linear[2]), side * glm::cross(linear[2], linear[0]),
                   side * glm::cross(linear[0], linear[1]));
  const bool with_uv = mesh.HasTextureCoords(0);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& p = mesh.mVertices[i];
    out_.raw.positions.emplace_back(world_from_mesh * glm::dvec4(p.x, p.y, p.z, 1.0));
    dvec3 normal(0.0);
    if (mesh.HasNormals()) {
      const aiVector3D& n = mesh.mNormals[i];
      normal = turn * dvec3(n.x, n.y, n.z);
      const double length = glm::length(normal);  // scaled here: small models would underflow
      normal = length > 0.0 ? normal / length : dvec3(0.0);
    }
    out_.raw.normals.emplace_back(normal);
    out_.raw.uvs.push_back(with_uv ? vec2(mesh.mTextureCoords[0][i].x, mesh.mTextureCoords[0][i].y)
                                   : vec2(0.0F));
  }
  any_uv_ = any_uv_ || with_uv;
}

std::span<const uvec3> Converter::trianglesOf(std::span<const unsigned> face, std::uint32_t first) {
  triangles_.assign(1, {face[0], face[1], face[2]});
  if (face.size() > 3) {
    corners_.clear();
    for (const unsigned v : face) corners_.push_back(out_.raw.positions[first + v]);
    triangles_ = geometry::triangulatePolygon(corners_);
    for (uvec3& t : triangles_) t = {face[t.x], face[t.y], face[t.z]};
  }
  for (uvec3& t : triangles_) t += first;
  return triangles_;
}

bool Converter::add(const aiMesh& mesh, const glm::dmat4& world_from_mesh) {
  geometry::RawMesh& raw = out_.raw;
  // Three corners each, so 32-bit vertex numbers hold as well.
  if (raw.triangles.size() + mesh.mNumFaces > kMaxTriangles ||
      raw.positions.size() + mesh.mNumVertices > 3 * kMaxTriangles) {
    return false;
  }
  const auto first = static_cast<std::uint32_t>(raw.positions.size());
  addVertices(mesh, world_from_mesh);
  const bool mirrored = glm::determinant(dmat3(world_from_mesh)) < 0.0;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices == 1) ++out_.points;
    if (face.mNumIndices == 2) ++out_.lines;
    if (face.mNumIndices < 3) continue;
    const std::span<const unsigned> corners(face.mIndices, face.mNumIndices);
    for (uvec3 t : trianglesOf(corners, first)) {
      if (mirrored) std::swap(t.y, t.z);
      raw.triangles.push_back(t);
      raw.material_of.push_back(mesh.mMaterialIndex);
      raw.object_of.push_back(static_cast<std::uint32_t>(raw.objects.size() - 1));
    }
  }
  return true;
}

ConvertedScene Converter::take() {
  if (!any_uv_) out_.raw.uvs.clear();
  return std::move(out_);
}

}  // namespace

Result<ConvertedScene> convertScene(const aiScene& scene, const glm::dmat4& world_from_root,
                                    bool skip_root, const std::string& model_name) {
  Converter converter;
  std::vector<Visit> open{{scene.mRootNode, world_from_root, model_name}};
  while (!open.empty()) {
    const Visit visit = std::move(open.back());
    open.pop_back();
    const aiNode& node = *visit.node;
    const bool skip = skip_root && visit.node == scene.mRootNode;
    const glm::dmat4 world_from_node =
        skip ? visit.world_from_parent : visit.world_from_parent * toMatrix(node.mTransformation);
    const std::string name(isMadeUp(node.mName.C_Str()) ? visit.name : node.mName.C_Str());
    if (node.mNumMeshes > 0) converter.startObject(name);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (!converter.add(*scene.mMeshes[node.mMeshes[i]], world_from_node)) {
        return Error{{},
                     fmt::format("holds more than {} million triangles", kMaxTriangles / 1'000'000),
                     "Simplify the model, or split it"};
      }
    }
    // Backwards, so that children are visited in their order.
    for (unsigned i = node.mNumChildren; i-- > 0;) {
      // The root of most formats is called after the file; that is no part's name.
      open.push_back(
          {node.mChildren[i], world_from_node, visit.node == scene.mRootNode ? model_name : name});
    }
  }
  return converter.take();
}

}  // namespace soffit::io
