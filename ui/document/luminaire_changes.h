// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/edits.h"

#include <QStringList>

#include <functional>
#include <span>
#include <string>
#include <vector>

/// Changes to many luminaires at once: one copy of the scene however many there are.
namespace soffit::ui {

/// The luminaires of a layout, in order; an empty name, or one that is not there: the base's.
std::vector<light::Luminaire> luminairesOf(const scene::Scene& scene, const std::string& layout);

/// The scene with each luminaire named changed in place, in that layout alone (empty: in the base).
scene::Scene withChanged(const scene::Scene& scene, const std::string& layout,
                         const QStringList& names,
                         const std::function<void(light::Luminaire&)>& change);

/// The scene with more luminaires, in that layout alone (empty: in the base). Names that are empty
/// or taken are numbered on: "Panel 3", "Panel 4". `names` receives those that were given.
scene::Scene withAdded(const scene::Scene& scene, const std::string& layout,
                       std::span<const light::Luminaire> added, QStringList& names);

/// "Panel 3" without its number, so that copies are numbered on.
std::string stemOf(const std::string& name);

}  // namespace soffit::ui
