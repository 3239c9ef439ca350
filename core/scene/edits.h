// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/light/luminaire.h"
#include "core/scene/scene.h"

#include <string>
#include <string_view>

/// Changes to a scene as values: each takes a scene and gives a new one, so that the old stays
/// what an undo step or a running computation holds. Copies are cheap (geometry is shared).
namespace soffit::scene {

/// `luminaire` with the fields that `edit` names; the others stay.
light::Luminaire applyEdit(const light::Luminaire& luminaire, const LuminaireEdit& edit);

/// The fewest fields that lead from one luminaire to another: applyEdit(from, result) has every
/// field of `to` but the name. A flux that `to` lacks cannot be told by an edit and is left out.
LuminaireEdit editBetween(const light::Luminaire& from, const light::Luminaire& to);

/// Whether no field is named.
bool isEmpty(const LuminaireEdit& edit);

/// The layout of that name, or null.
const Layout* findLayout(const Scene& scene, std::string_view name);

/// The luminaire of the base layout of that name, or null.
const light::Luminaire* findLuminaire(const Scene& scene, std::string_view name);

/// Edits one luminaire: in the base when `layout` is empty, else in that layout alone, where
/// fields add to those that the layout names already.
/// Errors: no layout of that name; no luminaire of that name in the base or the layout.
Result<Scene> withEdit(const Scene& scene, std::string_view layout, std::string_view luminaire,
                       const LuminaireEdit& edit);

/// Adds a luminaire to the base when `layout` is empty, else to that layout alone.
/// Errors: the name is empty or taken, in the base or the layout; no layout of that name.
Result<Scene> withLuminaire(const Scene& scene, std::string_view layout,
                            const light::Luminaire& luminaire);

/// Removes a luminaire from the base and from every layout.
/// Errors: nothing bears that name.
Result<Scene> withoutLuminaire(const Scene& scene, std::string_view luminaire);

/// Renames a luminaire in the base and in every layout.
/// Errors: nothing bears the old name; the new one is empty or taken.
Result<Scene> withLuminaireRenamed(const Scene& scene, std::string_view from, std::string_view to);

/// Adds a layout that copies the edits of `source` (empty: none, the base as it stands).
/// Errors: the name is empty or taken; no layout named `source`.
Result<Scene> withLayout(const Scene& scene, std::string_view name, std::string_view source);

/// A name not yet borne by any luminaire of the base or a layout: `stem`, else "stem 2", "stem
/// 3"...
std::string freeLuminaireName(const Scene& scene, std::string_view stem);

}  // namespace soffit::scene
