// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/luminaire.h"

/// How a luminaire stands: turning, aiming and resizing it as values.
namespace soffit::ui {

/// The fixed-axis angles x, y, z of a rotation, degrees in (-180, 180]: rotationXyz() of them is
/// the matrix, up to rounding. Where the tilt about y is 90 degrees, x is 0.
dvec3 rotationDegOf(const dmat3& rotation);

/// The rotation that makes a luminaire emit (gamma 0) toward a unit direction, with C0 in the
/// vertical plane of it. Straight up and down the azimuth of `before` stays.
dvec3 aimedAlong(const dvec3& direction, const dvec3& before_deg);

/// Turned about a world axis through `pivot`, by degrees.
void turn(light::Luminaire& luminaire, int axis, double angle_deg, const dvec3& pivot);

/// Sizes times a factor per local axis: width and height of rectangles and polygons along x and y,
/// a tube's length along x. What has one size (disk, sphere, a tube's radius) takes the factor that
/// is furthest from 1; meshes take it as their scale; points stay. Whole tenths of a millimetre.
void resize(light::Luminaire& luminaire, const dvec3& factor);

}  // namespace soffit::ui
