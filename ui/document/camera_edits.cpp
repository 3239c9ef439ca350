// SPDX-License-Identifier: MIT
#include "ui/document/camera_edits.h"

#include "ui/document/text.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace soffit::ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

std::vector<scene::Camera>::iterator find(scene::Scene& scene, const std::string& name) {
  return std::ranges::find(scene.cameras, name, &scene::Camera::name);
}

}  // namespace

QString freeCameraName(const scene::Scene& scene) {
  for (std::size_t i = 1;; ++i) {
    QString name = tr("View %1").arg(i);
    if (std::ranges::find(scene.cameras, toStd(name), &scene::Camera::name) == scene.cameras.end())
      return name;
  }
}

void addCamera(Document& document, const scene::Camera& camera) {
  scene::Scene next = *document.scene();
  next.cameras.push_back(camera);
  document.edit(tr("Save camera %1").arg(toQt(camera.name)), std::move(next));
}

void updateCamera(Document& document, const scene::Camera& camera) {
  scene::Scene next = *document.scene();
  const auto at = find(next, camera.name);
  if (at == next.cameras.end()) return;
  *at = camera;
  document.edit(tr("Update camera %1").arg(toQt(camera.name)), std::move(next));
}

bool renameCamera(Document& document, const QString& from, const QString& to) {
  const QString name = to.trimmed();
  if (name == from) return true;
  scene::Scene next = *document.scene();
  const auto at = find(next, toStd(from));
  if (name.isEmpty() || at == next.cameras.end() || find(next, toStd(name)) != next.cameras.end())
    return false;
  at->name = toStd(name);
  document.edit(tr("Rename camera %1").arg(from), std::move(next));
  return true;
}

void removeCamera(Document& document, const QString& name) {
  scene::Scene next = *document.scene();
  const auto at = find(next, toStd(name));
  if (at == next.cameras.end()) return;
  next.cameras.erase(at);
  document.edit(tr("Delete camera %1").arg(name), std::move(next));
}

void moveCamera(Document& document, const QString& name, int row) {
  scene::Scene next = *document.scene();
  const auto at = find(next, toStd(name));
  if (at == next.cameras.end()) return;
  const int before = static_cast<int>(at - next.cameras.begin());
  const int last = static_cast<int>(next.cameras.size()) - 1;
  row = std::clamp(row, 0, last);
  if (row == before) return;
  const auto from = next.cameras.begin() + before;
  const auto to = next.cameras.begin() + row;
  if (row > before) {
    std::rotate(from, from + 1, to + 1);
  } else {
    std::rotate(to, from, from + 1);
  }
  document.edit(tr("Reorder cameras"), std::move(next));
}

}  // namespace soffit::ui
