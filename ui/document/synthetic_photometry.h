// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/photometric_file.h"

#include <string>

/// Photometry of our own for kinds of luminaires that come with the program: smooth lobes with the
/// beam angle and the lumens that are asked for, and nothing of any maker's.
namespace soffit::ui {

/// An axial lobe I0 cos^n(gamma) that falls to half its peak at half the beam angle (1..150
/// degrees).
io::PhotometricFile syntheticSpot(const std::string& name, double beam_deg, double lumens);

/// A lobe about a direction 35 degrees off the axis toward C0: turned by its z, it lights a wall on
/// that side.
io::PhotometricFile syntheticWallWasher(const std::string& name, double lumens);

}  // namespace soffit::ui
