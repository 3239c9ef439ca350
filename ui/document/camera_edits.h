// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

namespace soffit::ui {

/// Changes of the project's saved cameras, each one step that can be undone. Names are unique.

/// The first of "View 1", "View 2" .. that is free.
QString freeCameraName(const scene::Scene& scene);
/// At the end of the list.
void addCamera(Document& document, const scene::Camera& camera);
/// The camera of that name looks from elsewhere.
void updateCamera(Document& document, const scene::Camera& camera);
/// False, and no step, when the name is empty or another camera's.
bool renameCamera(Document& document, const QString& from, const QString& to);
void removeCamera(Document& document, const QString& name);
/// To another row of the list, 0 for the first.
void moveCamera(Document& document, const QString& name, int row);

}  // namespace soffit::ui
