// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/luminaire.h"
#include "ui/document/luminaire_types.h"

#include <QColor>
#include <QString>

namespace soffit::ui {

/// "Rectangle 0.6 × 1.2 m", "Disk ⌀ 0.3 m", "Mesh neon.obj".
QString describeShape(const light::Shape& shape);

/// What a kind says about itself, with its lengths as they are shown now: "3600 lm · 0.6 × 0.6 m".
QString describeType(const LuminaireType& type);

/// "Lambertian", "spot_wide.ies".
QString describeDistribution(const light::Distribution& distribution);

/// Lumens at dimming 1: the luminaire's own, or those of its photometric file.
double fluxOf(const light::Luminaire& luminaire);

/// "4000 K", or "RGB".
QString describeColour(const light::Colour& colour);

/// How the light's colour looks, for a swatch.
QColor swatchOf(const light::Colour& colour);

}  // namespace soffit::ui
