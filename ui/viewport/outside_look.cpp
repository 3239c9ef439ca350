// SPDX-License-Identifier: MIT
#include "ui/viewport/outside_look.h"

#include "core/base/parallel.h"
#include "core/daylight/cie_sky.h"
#include "core/daylight/environment.h"
#include "core/daylight/slab.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

constexpr int kOvercast = 16;
/// Wider pictures are drawn at so many columns: 0.09 degrees each.
constexpr int kMostColumns = 4096;
constexpr int kResampledColumns = 2048;
constexpr int kFormulaColumns = 1024;

SkyLook lookOf(const scene::Sky& sky) {
  SkyLook look;
  const dvec3 to_sun =
      daylight::skyDirection(radians(sky.sun_azimuth_deg), radians(sky.sun_altitude_deg));
  const daylight::CieSky cie(sky.cie, to_sun, sky.horizontal_illuminance);
  const double zenith = cie.luminance({0.0, 0.0, 1.0});
  look.to_sun = vec3(to_sun);
  look.overcast = sky.cie == kOvercast;
  look.ground = static_cast<float>(sky.ground_reflectance * sky.horizontal_illuminance / kPi);
  if (look.overcast) {
    look.gradation.z = static_cast<float>(zenith);
  } else {
    const daylight::CieParameters p = daylight::cieParameters(sky.cie);
    const double chi = std::acos(std::clamp(to_sun.z, -1.0, 1.0));
    const double toward =
        1.0 + p.c * (std::exp(p.d * chi) - std::exp(p.d * 0.5 * kPi)) + p.e * to_sun.z * to_sun.z;
    const double at_zenith = (1.0 + p.a * std::exp(p.b)) * toward;
    look.gradation = vec3(dvec3(p.a, p.b, zenith / at_zenith));
    look.indicatrix = vec3(dvec3(p.c, p.d, p.e));
  }
  if (sky.direct_normal_illuminance > 0.0 && sky.sun_altitude_deg > 0.0) {
    look.sun = static_cast<float>(daylight::Sun{to_sun, sky.direct_normal_illuminance}.radiance());
  }
  return look;
}

dvec3 directionAt(int column, int row, const scene::Image& image) {
  const double phi = 2.0 * kPi * ((column + 0.5) / image.width - 0.5);
  const double theta = kPi * (row + 0.5) / image.height;
  return {std::sin(theta) * std::sin(phi), std::sin(theta) * std::cos(phi), std::cos(theta)};
}

/// Surroundings all round, as they are before they are turned and scaled.
scene::Image allRound(scene::Environment environment, int columns) {
  if (auto* probe = std::get_if<scene::Probe>(&environment.light)) {
    probe->rotation_deg = 0.0;
    probe->scale = 1.0;
  } else if (auto* patches = std::get_if<scene::PatchLight>(&environment.light)) {
    patches->rotation_deg = 0.0;
    patches->scale = 1.0;
  }
  const daylight::Environment light(environment);
  scene::Image image;
  image.width = columns;
  image.height = columns / 2;
  image.channels = 3;
  image.pixels.resize(3 * static_cast<std::size_t>(image.width) *
                      static_cast<std::size_t>(image.height));
  parallelFor(static_cast<std::size_t>(image.height), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      for (int column = 0; column < columns; ++column) {
        const dvec3 l = light.radiance(directionAt(column, static_cast<int>(row), image));
        float* to = &image.pixels[3 * (row * static_cast<std::size_t>(columns) +
                                       static_cast<std::size_t>(column))];
        for (int c = 0; c < 3; ++c) to[c] = static_cast<float>(l[c]);
      }
    }
  });
  return image;
}

std::shared_ptr<const RoundPicture> normalized(scene::Image image) {
  auto picture = std::make_shared<RoundPicture>();
  float most = 0.0F;
  for (float& v : image.pixels) {
    if (!(v > 0.0F)) v = 0.0F;
    most = std::max(most, v);
  }
  // Half floats, which the graphics card keeps, end at 65504: the brightest pixel is 1e4.
  picture->unit = most > 0.0F ? most / 1.0e4F : 1.0F;
  for (float& v : image.pixels) v /= picture->unit;
  picture->pixels = std::move(image);
  return picture;
}

std::shared_ptr<const RoundPicture> pictureOf(const scene::Environment& environment) {
  const auto* probe = std::get_if<scene::Probe>(&environment.light);
  if (probe == nullptr) return normalized(allRound(environment, kFormulaColumns));
  if (probe->image == nullptr || probe->image->width < 1) return nullptr;
  if (probe->layout != scene::ProbeLayout::lat_long) {
    return normalized(allRound(environment, kResampledColumns));
  }
  if (probe->image->width <= kMostColumns && probe->image->channels == 3) {
    return normalized(*probe->image);
  }
  return normalized(allRound(environment, kMostColumns));
}

/// Whether two show the same picture, turned and scaled as they may be.
bool samePicture(const scene::Environment& a, const scene::Environment& b) {
  const auto* probe = std::get_if<scene::Probe>(&a.light);
  const auto* other = std::get_if<scene::Probe>(&b.light);
  if (probe != nullptr && other != nullptr) {
    return probe->image == other->image && probe->layout == other->layout;
  }
  const auto* patches = std::get_if<scene::PatchLight>(&a.light);
  const auto* others = std::get_if<scene::PatchLight>(&b.light);
  return patches != nullptr && others != nullptr &&
         patches->overhead_gain == others->overhead_gain &&
         patches->overhead_threshold == others->overhead_threshold &&
         patches->side_gain == others->side_gain &&
         patches->side_threshold == others->side_threshold &&
         patches->side_azimuth_rad == others->side_azimuth_rad;
}

}  // namespace

OutsideLook OutsideLook::of(const scene::Environment& environment, const OutsideLook* before,
                            const scene::Environment* before_environment) {
  OutsideLook look;
  if (const auto* sky = std::get_if<scene::Sky>(&environment.light)) {
    look.sky = lookOf(*sky);
    return look;
  }
  const bool known = before != nullptr && before_environment != nullptr &&
                     before->picture != nullptr && samePicture(environment, *before_environment);
  look.picture = known ? before->picture : pictureOf(environment);
  if (const auto* probe = std::get_if<scene::Probe>(&environment.light)) {
    look.turn = static_cast<float>(radians(probe->rotation_deg));
    look.scale = static_cast<float>(probe->scale);
  } else {
    const auto& patches = std::get<scene::PatchLight>(environment.light);
    look.turn = static_cast<float>(radians(patches.rotation_deg));
    look.scale = static_cast<float>(patches.scale);
  }
  return look;
}

std::vector<PaneCorner> paneCorners(const geometry::Mesh& mesh,
                                    std::span<const scene::Material> materials) {
  std::vector<PaneCorner> corners;
  if (mesh.material_of.empty()) return corners;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t m = mesh.material_of[i];
    if (m >= materials.size() || !materials[m].glass) continue;
    const uvec3& t = mesh.triangles[i];
    const vec3 cross = glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                  mesh.positions[t.z] - mesh.positions[t.x]);
    if (!(glm::length(cross) > 0.0F)) continue;
    const daylight::Slab slab(*materials[m].glass);
    // Black glass lets nothing through: exp(-1e3) is 0.
    const vec2 numbers(dvec2(slab.index(), std::max(slab.logPass(), -1e3)));
    for (int k = 0; k < 3; ++k) {
      corners.push_back({mesh.positions[t[k]], glm::normalize(cross), numbers});
    }
  }
  return corners;
}

}  // namespace soffit::ui
