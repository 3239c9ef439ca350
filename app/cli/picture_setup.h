// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/geometry/ray_caster.h"
#include "core/render/picture.h"
#include "core/render/view_scene.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

/// What the subcommands that make pictures need before they render.
namespace soffit::cli {

/// WIDTHxHEIGHT in pixels. Errors: anything else.
Result<std::pair<int, int>> parseSize(const std::string& text);

/// The camera of that name; the first, or one that sees the model, when `name` is empty.
/// Errors: the project has no such camera.
Result<scene::Camera> chooseCamera(const scene::Scene& scene, const std::string& name);

/// The exposure in EV: the project's when `text` is empty; nothing stands for "auto".
/// Errors: neither a finite number nor "auto".
Result<std::optional<double>> parseExposure(const std::string& text, double from_project);

/// Kelvin that are shown as white, 0 for daylight: the project's when `text` is empty, that of its
/// luminaires for "auto". Errors: neither "auto" nor a number in range.
Result<double> parseWhiteBalance(const std::string& text, const scene::Scene& scene);

/// The project's white balance, tone settings and bloom.
void finishAsProject(const scene::View& view, render::PictureOptions& picture);

/// The scene with its luminaires placed. caster: over its mesh; made here when null.
/// Errors: makeEmitter's.
Result<std::unique_ptr<render::ViewScene>> makeViewScene(
    const scene::Scene& scene, std::shared_ptr<const geometry::RayCaster> caster);

}  // namespace soffit::cli
