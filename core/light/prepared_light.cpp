// SPDX-License-Identifier: MIT
#include "core/light/prepared_light.h"

#include "core/light/emitter_illuminance.h"
#include "core/light/box_tree.h"
#include "core/light/emitter_sampling.h"
#include "core/light/polygon_irradiance.h"
#include "core/light/receivers.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace soffit::light {
namespace {

/// Lambertian meshes of at most this many triangles are summed in closed form.
constexpr std::size_t kExactTriangles = 48;

/// A triangle of at most this share of its distance is as good as a point: the whole mesh then errs
/// by less than 3e-4 (prepared_light_test).
constexpr float kFacetShare = 0.12F;

/// Even-odd test of a point in the plane coordinates of an outline.
bool insideOutline(std::span<const dvec2> outline, const dvec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const dvec2& a = outline[i];
    const dvec2& b = outline[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

/// The parallelogram that bounds a planar emitter, along its longest edge.
struct Frame {
  dvec3 origin, u, v;
};

Frame boundingFrame(const Emitter& e) {
  if (e.disk) {
    dvec3 t;
    dvec3 b;
    orthonormalBasis(e.normal, t, b);
    return {e.position - e.radius * (t + b), 2.0 * e.radius * t, 2.0 * e.radius * b};
  }
  dvec3 along(0.0);
  for (std::size_t i = 0; i < e.outline.size(); ++i) {
    const dvec3 edge = e.outline[(i + 1) % e.outline.size()] - e.outline[i];
    if (glm::dot(edge, edge) > glm::dot(along, along)) along = edge;
  }
  const dvec3 t = glm::normalize(along);
  const dvec3 b = glm::cross(e.normal, t);
  dvec2 lo(1e300);
  dvec2 hi(-1e300);
  for (const dvec3& c : e.outline) {
    const dvec2 q(glm::dot(c - e.outline[0], t), glm::dot(c - e.outline[0], b));
    lo = glm::min(lo, q);
    hi = glm::max(hi, q);
  }
  return {e.outline[0] + lo.x * t + lo.y * b, (hi.x - lo.x) * t, (hi.y - lo.y) * b};
}

void setOutlineBits(const Emitter& e, MaskLight& mask) {
  dvec3 t;
  dvec3 b;
  orthonormalBasis(e.normal, t, b);
  std::vector<dvec2> flat;
  const auto inPlane = [&](const dvec3& v) { return dvec2(glm::dot(v, t), glm::dot(v, b)); };
  for (const dvec3& c : e.outline) flat.push_back(inPlane(c - e.position));
  const dvec2 origin = inPlane(dvec3(mask.origin) - e.position);
  const dvec2 u = inPlane(dvec3(mask.u)) / double{MaskLight::kColumns};
  const dvec2 v = inPlane(dvec3(mask.v)) / double{MaskLight::kRows};
  for (int j = 0; j < MaskLight::kRows; ++j) {
    std::uint32_t bits = 0;
    for (int i = 0; i < MaskLight::kColumns; ++i) {
      const double a = i + static_cast<double>(MaskLight::rowOffset(j));
      const dvec2 q = origin + a * u + (j + a / MaskLight::kColumns) * v;
      const bool in = e.disk ? glm::dot(q, q) <= e.radius * e.radius : insideOutline(flat, q);
      if (in) bits |= 1U << static_cast<unsigned>(i);
    }
    mask.outline[static_cast<std::size_t>(j)] = bits;
  }
}

MaskLight unitSquare() {
  return makeMaskLight(vec3(0.0F), vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), true);
}

/// The disk that touches the sides of the unit square.
MaskLight unitDisk() {
  MaskLight mask = unitSquare();
  for (int j = 0; j < MaskLight::kRows; ++j) {
    std::uint32_t bits = 0;
    for (int i = 0; i < MaskLight::kColumns; ++i) {
      const vec3 d = mask.sample(j, i) - vec3(0.5F, 0.5F, 0.0F);
      if (glm::dot(d, d) <= 0.25F) bits |= 1U << static_cast<unsigned>(i);
    }
    mask.outline[static_cast<std::size_t>(j)] = bits;
  }
  mask.finish();
  return mask;
}

bool isParallelogram(const Emitter& e, const Frame& f) {
  if (e.disk || e.outline.size() != 4) return false;
  return std::abs(e.area - glm::length(glm::cross(f.u, f.v))) <= 1e-9 * e.area;
}

/// Moves points so that their mean is the shape's middle: what varies linearly over the light, as a
/// narrow beam's edge does, is then exact however few they are. (One point of a disk by its area
/// lies 0.7 radii off: a spot of 4 cm erred by 10 % at the edge of its beam.)
void centre(const Emitter& e, std::vector<vec3>& places) {
  const bool symmetric = e.kind == EmitterKind::sphere || e.kind == EmitterKind::tube ||
                         (e.kind == EmitterKind::planar && e.disk);
  if (!symmetric || e.lambertian) return;
  dvec3 mean(0.0);
  for (const vec3& place : places) mean += dvec3(place) / static_cast<double>(places.size());
  const vec3 shift(e.position - mean);
  for (vec3& place : places) place += shift;
}

/// N points by area, low-discrepancy, neighbours together; `weight` shares the area evenly.
PointLightSamples samplesByArea(const Emitter& e, int count) {
  std::vector<EmitterSample> found;
  std::vector<vec3> places;
  for (int i = 0; i < count; ++i) {
    const dvec2 u = count == 1 ? dvec2(0.5) : r2Sequence(static_cast<std::uint32_t>(i));
    found.push_back(sampleByArea(e, u));
    places.emplace_back(found.back().point);
  }
  centre(e, places);
  PointLightSamples s;
  for (const std::uint32_t i : orderByPlace(places)) {
    s.x.push_back(places[i].x);
    s.y.push_back(places[i].y);
    s.z.push_back(places[i].z);
    // Without a cosine at the light (measured photometry, point sources) the normal is zero.
    const bool cosine = e.lambertian && e.kind != EmitterKind::point;
    const vec3 n = cosine ? vec3(found[i].normal) : vec3(0.0F);
    s.nx.push_back(n.x);
    s.ny.push_back(n.y);
    s.nz.push_back(n.z);
    s.weight.push_back(static_cast<float>((e.kind == EmitterKind::point ? 1.0 : e.area) / count));
  }
  return s;
}

}  // namespace

PreparedLight::PreparedLight(const Emitter& emitter) : emitter_(emitter) {
  const Emitter& e = emitter_;
  switch (e.kind) {
    case EmitterKind::planar:
      // Light to both sides has no single front to clip blockers at: points handle it.
      form_ = e.twoSided() ? Form::points : Form::planar;
      break;
    case EmitterKind::sphere:
    case EmitterKind::tube: form_ = e.lambertian ? Form::facing : Form::points; break;
    case EmitterKind::point:
    case EmitterKind::mesh: form_ = Form::points; break;
  }
  exact_ = e.lambertian && (e.kind == EmitterKind::planar || e.kind == EmitterKind::sphere ||
                            e.kind == EmitterKind::tube ||
                            (e.kind == EmitterKind::mesh && e.triangle_areas.size() <= kExactTriangles));
  if (form_ == Form::planar) {
    const Frame f = boundingFrame(e);
    cell_diagonal_ = static_cast<float>(0.25 * std::sqrt(glm::dot(f.u, f.u) + glm::dot(f.v, f.v)));
  }
  if (e.kind == EmitterKind::mesh && e.lambertian && !exact_) prepareFacets();
  if (form_ == Form::points || e.kind == EmitterKind::tube) prepareSamples();
}

std::span<const MaskLight> PreparedLight::masks(int level) const {
  const auto l = static_cast<std::size_t>(level);
  std::call_once(masks_->once[l], [&] { makeMasks(level); });
  return masks_->levels[l];
}

void PreparedLight::makeMasks(int level) const {
  const Frame f = boundingFrame(emitter_);
  const bool whole = isParallelogram(emitter_, f);
  const double lu = glm::length(f.u);
  const double lv = glm::length(f.v);
  const double cell = std::max(lu, lv) / (1 << level);
  const int nu = std::max(1, static_cast<int>(std::ceil(lu / cell - 1e-6)));
  const int nv = std::max(1, static_cast<int>(std::ceil(lv / cell - 1e-6)));
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) {
      MaskLight mask = makeMaskLight(vec3(f.origin + f.u * (1.0 * i / nu) + f.v * (1.0 * j / nv)),
                                     vec3(f.u / (1.0 * nu)), vec3(f.v / (1.0 * nv)), vec3(emitter_.normal), true);
      if (!whole) {
        setOutlineBits(emitter_, mask);
        mask.finish();
      }
      masks_->levels[static_cast<std::size_t>(level)].push_back(mask);
    }
  }
}

void PreparedLight::prepareSamples() {
  for (int level = 0; level < kSampleLevels; ++level) {
    const int count = emitter_.kind == EmitterKind::point ? 1 : 1 << (2 * level);
    samples_[static_cast<std::size_t>(level)] = samplesByArea(emitter_, count);
  }
}

void PreparedLight::prepareFacets() {
  const Emitter& e = emitter_;
  const auto corner = [&](std::uint32_t t, std::size_t k) { return e.corners[std::size_t{3} * t + k]; };
  std::vector<float> extents;
  for (std::uint32_t t = 0; t < e.triangle_areas.size(); ++t) {
    Box box;
    for (std::size_t k = 0; k < 3; ++k) box.add(vec3(corner(t, k)));
    extents.push_back(box.diagonal());
    facets_.order.push_back(t);
  }
  std::sort(facets_.order.begin(), facets_.order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return extents[a] > extents[b] || (extents[a] == extents[b] && a < b);
  });
  PointLightSamples& s = facets_.points;
  for (const std::uint32_t t : facets_.order) {
    facets_.extent.push_back(extents[t]);
    const vec3 center((corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0);
    const vec3 n(e.triangle_normals[t]);
    s.x.push_back(center.x);
    s.y.push_back(center.y);
    s.z.push_back(center.z);
    s.nx.push_back(n.x);
    s.ny.push_back(n.y);
    s.nz.push_back(n.z);
    s.weight.push_back(static_cast<float>(e.triangle_areas[t]));
  }
}

double PreparedLight::nearFacets(std::size_t count, const dvec3& p, const dvec3& n) const {
  const Emitter& e = emitter_;
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t t = facets_.order[i];
    const std::span<const dvec3> corners(e.corners.data() + std::size_t{3} * t, 3);
    const dvec3 to = (corners[0] + corners[1] + corners[2]) / 3.0 - p;
    const double cos_l = -glm::dot(to, e.triangle_normals[t]);
    if (cos_l <= 0.0) continue;
    const double r2 = glm::dot(to, to);
    const auto reach = static_cast<double>(facets_.extent[i] / kFacetShare);
    if (r2 < reach * reach) {
      sum += polygonIrradiance(corners, p, n);
    } else {
      sum += e.triangle_areas[t] * std::max(0.0, glm::dot(to, n)) * cos_l / (r2 * r2);
    }
  }
  return sum;
}

int PreparedLight::maskLevel(float distance) const {
  float cell = cell_diagonal_;
  int level = 0;
  while (level + 1 < kLevels && cell > 0.5F * distance) {
    cell *= 0.5F;
    ++level;
  }
  return level;
}

int PreparedLight::sampleLevel(float distance) const {
  if (emitter_.kind == EmitterKind::point) return 0;
  // One point errs by about (size/distance)^2/8; every level halves the size of a cell. Curved and
  // Lambertian shapes turn away from the receiver: they want more points to begin with.
  const float size = emitter_.bounds.diagonal();
  int level = emitter_.lambertian ? 3 : 0;
  float reach = 8.0F * size;
  if (emitter_.lambertian) reach = 3.0F * size;
  while (level + 1 < kSampleLevels && distance < reach) {
    reach *= 0.5F;
    ++level;
  }
  return level;
}

MaskLight PreparedLight::facing(const vec3& eye) const {
  const vec3 center(emitter_.position);
  const auto radius = static_cast<float>(emitter_.radius);
  if (emitter_.kind == EmitterKind::sphere) {
    // The circle where the tangent cone from `eye` touches the sphere.
    const vec3 to = eye - center;
    const float distance = std::max(glm::length(to), radius * 1.001F);
    const vec3 n = to / std::max(glm::length(to), 1e-12F);
    const float share = radius / distance;
    const float rim = radius * std::sqrt(1.0F - share * share);
    const vec3 middle = center + n * (radius * share);
    vec3 t;
    vec3 b;
    orthonormalBasis(n, t, b);
    static const MaskLight unit = unitDisk();
    return placed(unit, middle - rim * (t + b), 2.0F * rim * t, 2.0F * rim * b, n);
  }
  // Tube: the rectangle between its two tangent lines.
  const vec3 axis(emitter_.axis);
  const vec3 d = eye - center;
  vec3 radial = d - glm::dot(d, axis) * axis;
  const float rho = std::max(glm::length(radial), radius * 1.001F);
  radial /= std::max(glm::length(radial), 1e-12F);
  const float share = radius / rho;
  const float rim = radius * std::sqrt(1.0F - share * share);
  const vec3 side = glm::cross(axis, radial);
  const auto half = static_cast<float>(emitter_.half_length);
  const vec3 middle = center + radial * (radius * share);
  static const MaskLight unit = unitSquare();
  return placed(unit, middle - half * axis - rim * side, 2.0F * half * axis, 2.0F * rim * side,
                radial);
}

void PreparedLight::unoccluded(const MaskReceivers& r, float distance, double* lux) const {
  const Emitter& e = emitter_;
  if (exact_ && e.kind == EmitterKind::planar && !e.disk) {
    std::uint32_t clipped = 0;
    contourIrradiance16(e.outline, r, lux, clipped);
    for (std::uint32_t i = 0; i < 16; ++i) {
      const dvec3 p(r.x[i], r.y[i], r.z[i]);
      if (glm::dot(p - e.outline[0], e.normal) <= 0.0) {
        lux[i] = 0.0;
      } else if ((clipped >> i & 1U) != 0U) {
        lux[i] = e.luminance * polygonIrradiance(e.outline, p, dvec3(r.nx[i], r.ny[i], r.nz[i]));
      } else {
        lux[i] *= e.luminance;
      }
    }
    return;
  }
  if (exact_ && e.disk) {
    std::uint32_t clipped = 0;
    diskIrradiance16(e.position, e.normal, e.radius, r, lux, clipped);
    for (std::uint32_t i = 0; i < 16; ++i) {
      if ((clipped >> i & 1U) != 0U) {
        lux[i] = diskIrradiance(e.position, e.normal, e.radius, dvec3(r.x[i], r.y[i], r.z[i]),
                                dvec3(r.nx[i], r.ny[i], r.nz[i]));
      }
      lux[i] *= e.luminance;
    }
    return;
  }
  if (!facets_.order.empty()) {
    // The largest come first: those that may be too large for where the group is.
    const auto large = std::partition_point(
        facets_.extent.begin(), facets_.extent.end(),
        [&](float extent) { return extent > kFacetShare * distance; });
    const auto count = static_cast<std::size_t>(large - facets_.extent.begin());
    std::array<float, 16> far{};
    facetIrradiance16(facets_.points, count, r, far.data());
    for (std::uint32_t i = 0; i < 16; ++i) {
      const dvec3 p(r.x[i], r.y[i], r.z[i]);
      const dvec3 n(r.nx[i], r.ny[i], r.nz[i]);
      lux[i] = e.luminance * (static_cast<double>(far[i]) + nearFacets(count, p, n));
    }
    return;
  }
  const PointLightSamples& s = samples_[static_cast<std::size_t>(sampleLevel(distance))];
  for (std::uint32_t i = 0; i < 16; ++i) {
    const dvec3 p(r.x[i], r.y[i], r.z[i]);
    const dvec3 n(r.nx[i], r.ny[i], r.nz[i]);
    lux[i] = exact_ ? closedForm(e, p, n) : sampledIlluminance(e, s, p, n);
  }
}

double unoccludedIlluminance(const Emitter& e, const dvec3& p, const dvec3& n) {
  if (e.lambertian && e.kind != EmitterKind::point) return closedForm(e, p, n);
  if (e.kind == EmitterKind::point) return sampledIlluminance(e, samplesByArea(e, 1), p, n);
  double last = sampledIlluminance(e, samplesByArea(e, 64), p, n);
  for (int count = 256; count <= 65536; count *= 4) {
    const double now = sampledIlluminance(e, samplesByArea(e, count), p, n);
    if (std::abs(now - last) <= 1e-6 * std::abs(now)) return now;
    last = now;
  }
  return last;
}

}  // namespace soffit::light
