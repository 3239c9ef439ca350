// SPDX-License-Identifier: MIT
#include "core/light/emitter.h"

#include "core/color/cct.h"
#include "core/light/emitter_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soffit::light {
namespace {

Error numberError(const char* field, const char* expected, double found) {
  return {field, fmt::format("expected {}, found {}", expected, found), "Correct the number"};
}

Error vectorError(const char* field) {
  return {field, "expected finite numbers", "Correct the numbers"};
}

Result<void> checkNumbers(const Luminaire& l) {
  if (!isFinite(l.position)) return vectorError("position");
  if (!isFinite(l.rotation_deg)) return vectorError("rotation");
  if (!std::isfinite(l.scale) || l.scale <= 0.0) {
    return numberError("scale", "a finite factor above 0", l.scale);
  }
  if (l.flux && (!std::isfinite(*l.flux) || *l.flux < 0.0)) {
    return numberError("flux", "lumens, finite and not negative", *l.flux);
  }
  if (!std::isfinite(l.dimming) || l.dimming < 0.0) {
    return numberError("dimming", "a finite factor, not negative", l.dimming);
  }
  return {};
}

Result<void> checkColour(const Colour& colour) {
  if (colour.cct_k) {
    if (std::isfinite(*colour.cct_k) && *colour.cct_k >= 500.0 && *colour.cct_k <= 1e6) return {};
    return numberError("colour.cct", "kelvin from 500 to 1000000", *colour.cct_k);
  }
  const dvec3& rgb = colour.rgb;
  if (!isFinite(rgb) || std::min({rgb.x, rgb.y, rgb.z}) < 0.0 || glm::dot(rgb, kLuminance) <= 0.0) {
    return Error{"colour.rgb", "expected three finite numbers, none negative and not all 0",
                 "Set \"on\": false or \"dimming\": 0 for a light that is off"};
  }
  return {};
}

bool isMeasured(const Distribution& distribution) {
  return distribution.kind == DistributionKind::ies || distribution.kind == DistributionKind::ldt;
}

/// The flux that the table has as it stands, and the factor that gives the wanted one.
Result<void> setMeasured(const Luminaire& l, Emitter& e) {
  if (l.distribution.table == nullptr) {
    return Error{"distribution", "the photometric file is not loaded", "Check the file's name"};
  }
  e.table = l.distribution.table;
  e.lambertian = false;
  const double stored = e.table->flux();
  e.flux = l.flux.value_or(stored);
  if (!l.flux) return {};
  if (!(stored > 0.0) && e.flux > 0.0) {
    return Error{"flux", "the photometric file gives no light that could be scaled to this flux",
                 "Use another file or \"flux\": 0"};
  }
  e.table_scale = stored > 0.0 ? e.flux / stored : 0.0;
  return {};
}

Result<void> setEmission(const Luminaire& l, Emitter& e) {
  if (isMeasured(l.distribution)) return setMeasured(l, e);
  if (!l.flux) {
    return Error{"flux", "a luminaire without a photometric file needs its lumens, found none",
                 "Add \"flux\": LUMENS, or a distribution file"};
  }
  e.flux = *l.flux;
  e.lambertian = l.distribution.kind == DistributionKind::lambertian;
  if (e.kind == EmitterKind::point) return {};
  if (!e.lambertian) {
    return Error{"distribution", "\"isotropic\" is for points, found on a shape with a surface",
                 "Use \"lambertian\", or the shape \"point\""};
  }
  e.luminance = e.flux / (kPi * e.area);
  return {};
}

Error named(Error error, const std::string& name) {
  error.place = fmt::format("luminaires.{}.{}", name, error.place);
  return error;
}

}  // namespace

double Emitter::pointIntensity(const dvec3& direction) const {
  if (table != nullptr) {
    return table_scale * table->intensity(glm::transpose(world_from_light) * direction);
  }
  if (!lambertian) return flux / (4.0 * kPi);
  return flux / kPi * std::max(0.0, glm::dot(normal, direction));
}

double Emitter::intensityPerArea(const dvec3& n, const dvec3& direction) const {
  if (table != nullptr) return pointIntensity(direction) / area;
  return luminance * std::max(0.0, glm::dot(n, direction));
}

Result<Emitter> makeEmitter(const Luminaire& luminaire, const dvec3& origin) {
  if (auto ok = checkNumbers(luminaire); !ok) return named(ok.error(), luminaire.name);
  if (auto ok = checkColour(luminaire.colour); !ok) return named(ok.error(), luminaire.name);
  Emitter e;
  e.position = luminaire.position - origin;
  e.world_from_light = rotationXyz(luminaire.rotation_deg);
  if (auto ok = placeShape(luminaire.shape, luminaire.scale, e); !ok) {
    return named(ok.error(), luminaire.name);
  }
  if (auto ok = setEmission(luminaire, e); !ok) return named(ok.error(), luminaire.name);
  e.casts_shadow = luminaire.casts_shadow && e.kind != EmitterKind::point;  // a point has no body
  e.gain = luminaire.on ? luminaire.dimming : 0.0;
  e.color = emissionColor(luminaire.colour);
  return e;
}

dvec3 emissionColor(const Colour& colour) {
  dvec3 rgb = colour.rgb;
  if (colour.cct_k) {
    rgb = glm::max(color::rec709FromXyz(color::planckianXyz(*colour.cct_k)), dvec3(0.0));
  }
  return rgb / glm::dot(rgb, kLuminance);
}

}  // namespace soffit::light
