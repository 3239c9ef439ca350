// SPDX-License-Identifier: MIT
#include "ui/jobs/mesh_import.h"

#include "core/io/model/model_import.h"
#include "ui/document/mesh_text.h"
#include "ui/document/text.h"

#include <QFileInfo>

namespace soffit::ui {
namespace {

/// Positions about the middle of the box' upper side: it hangs from there.
std::shared_ptr<const geometry::Mesh> hanging(const geometry::Mesh& mesh) {
  auto moved = std::make_shared<geometry::Mesh>();
  const Box box = mesh.bounds();
  const vec3 anchor(box.center().x, box.center().y, box.hi.z);
  for (const vec3& p : mesh.positions) moved->positions.push_back(p - anchor);
  moved->triangles = mesh.triangles;
  moved->material_of.assign(mesh.triangles.size(), 0);
  moved->materials = {"light"};
  return moved;
}

}  // namespace

MeshImport::MeshImport(const QString& path, QObject* parent) : QObject(parent) {
  thread_ = std::jthread([this, path](const std::stop_token& stop) {
    const auto model = io::importModel(toPath(path), {}, Job{nullptr, stop});
    if (stop.stop_requested()) return;
    if (!model) {
      Q_EMIT failed(messageOf(model.error()));
      return;
    }
    const auto mesh = hanging(model->mesh);
    const QString name = QFileInfo(path).completeBaseName();
    type_ = typeFromMesh(name, mesh, toStd(name) + ".obj", objText(*mesh));
    type_.prototype.name = toStd(name);
    Q_EMIT finished();
  });
}

MeshImport::~MeshImport() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

}  // namespace soffit::ui
