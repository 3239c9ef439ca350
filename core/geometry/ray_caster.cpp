// SPDX-License-Identifier: MIT
#include "core/geometry/ray_caster.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <new>
#include <utility>
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace soffit::geometry {
namespace {

constexpr std::size_t kWidth = 16;

// Embree 3 takes a context where Embree 4 takes arguments.
#if RTC_VERSION_MAJOR >= 4
void intersect1(RTCScene scene, RTCRayHit& query) {
  rtcIntersect1(scene, &query);
}
void occluded1(RTCScene scene, RTCRay& query) {
  rtcOccluded1(scene, &query);
}
void intersect16(const int* valid, RTCScene scene, RTCRayHit16& query, bool coherent) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &query, &arguments);
}
void occluded16(const int* valid, RTCScene scene, RTCRay16& query) {
  rtcOccluded16(valid, scene, &query);
}
#else
RTCIntersectContext incoherent() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  return context;
}
void intersect1(RTCScene scene, RTCRayHit& query) {
  RTCIntersectContext context = incoherent();
  rtcIntersect1(scene, &context, &query);
}
void occluded1(RTCScene scene, RTCRay& query) {
  RTCIntersectContext context = incoherent();
  rtcOccluded1(scene, &context, &query);
}
void intersect16(const int* valid, RTCScene scene, RTCRayHit16& query, bool coherent) {
  RTCIntersectContext context = incoherent();
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &context, &query);
}
void occluded16(const int* valid, RTCScene scene, RTCRay16& query) {
  RTCIntersectContext context = incoherent();
  rtcOccluded16(valid, scene, &context, &query);
}
#endif

bool finite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// What Embree's preconditions ask; anything else (NaN, empty interval) meets nothing.
bool traceable(const Ray& ray) {
  return finite(ray.origin) && finite(ray.direction) && ray.t_max >= std::max(ray.t_min, 0.0F);
}

RTCRay toEmbree(const Ray& ray) {
  RTCRay out{};
  out.org_x = ray.origin.x;
  out.org_y = ray.origin.y;
  out.org_z = ray.origin.z;
  out.dir_x = ray.direction.x;
  out.dir_y = ray.direction.y;
  out.dir_z = ray.direction.z;
  out.tnear = std::max(ray.t_min, 0.0F);
  out.tfar = ray.t_max;
  out.mask = ~0U;
  return out;
}

// Fills lane by lane; lanes beyond the batch are switched off and hold a harmless ray.
void fillPacket(std::span<const Ray> rays, RTCRay16& out, std::array<int, kWidth>& valid) {
  for (std::size_t i = 0; i < kWidth; ++i) {
    const bool live = i < rays.size() && traceable(rays[i]);
    const Ray ray = live ? rays[i] : Ray{};
    valid[i] = live ? -1 : 0;
    out.org_x[i] = ray.origin.x;
    out.org_y[i] = ray.origin.y;
    out.org_z[i] = ray.origin.z;
    out.dir_x[i] = ray.direction.x;
    out.dir_y[i] = ray.direction.y;
    out.dir_z[i] = ray.direction.z;
    out.tnear[i] = std::max(ray.t_min, 0.0F);
    out.tfar[i] = ray.t_max;
    out.time[i] = 0.0F;
    out.mask[i] = ~0U;
    out.id[i] = 0;
    out.flags[i] = 0;
  }
}

// Fills a geometry's buffers. Embree may read 16 bytes per vertex, so it owns (and pads) the copy.
template <class T>
bool copyToBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                  std::span<const T> items) {
  void* memory = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), items.size());
  if (memory == nullptr) return false;
  std::copy(items.begin(), items.end(), static_cast<T*>(memory));
  return true;
}

}  // namespace

struct RayCaster::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;  // stays null without triangles

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  void build(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    device = rtcNewDevice(nullptr);
    if (device == nullptr) throw std::bad_alloc();
    scene = rtcNewScene(device);
    // Robust: no ray slips through the edge that two triangles share.
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    // Spatial splits pay for themselves over the millions of rays of a bake, but not in memory
    // on very large models.
    constexpr std::size_t kSplitLimit = 1'000'000;
    rtcSetSceneBuildQuality(
        scene, triangles.size() <= kSplitLimit ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const bool copied =
        copyToBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions) &&
        copyToBuffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles);
    if (copied) {
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene, geometry);
    }
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    if (!copied || rtcGetDeviceError(device) == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  }
};

RayCaster::RayCaster(std::span<const vec3> positions, std::span<const uvec3> triangles)
    : impl_(std::make_unique<Impl>()) {
  assert(std::all_of(triangles.begin(), triangles.end(), [&](const uvec3& t) {
    return std::max({t.x, t.y, t.z}) < positions.size();
  }));
  if (!triangles.empty()) impl_->build(positions, triangles);
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

Hit RayCaster::closest(const Ray& ray) const {
  if (impl_->scene == nullptr || !traceable(ray)) return {};
  RTCRayHit query{};
  query.ray = toEmbree(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersect1(impl_->scene, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v};
}

bool RayCaster::occluded(const Ray& ray) const {
  if (impl_->scene == nullptr || !traceable(ray)) return false;
  RTCRay query = toEmbree(ray);
  occluded1(impl_->scene, query);
  return query.tfar < 0.0F;  // Embree's mark for "something is in the way"
}

void RayCaster::closest(std::span<const Ray> rays, std::span<Hit> hits, bool coherent) const {
  assert(rays.size() == hits.size());
  std::fill(hits.begin(), hits.end(), Hit{});
  if (impl_->scene == nullptr) return;
  alignas(64) RTCRayHit16 query;
  alignas(64) std::array<int, kWidth> valid{};
  for (std::size_t first = 0; first < rays.size(); first += kWidth) {
    const std::size_t count = std::min(kWidth, rays.size() - first);
    fillPacket(rays.subspan(first, count), query.ray, valid);
    std::fill(std::begin(query.hit.geomID), std::end(query.hit.geomID), RTC_INVALID_GEOMETRY_ID);
    std::fill(std::begin(query.hit.instID[0]), std::end(query.hit.instID[0]),
              RTC_INVALID_GEOMETRY_ID);
    intersect16(valid.data(), impl_->scene, query, coherent);
    for (std::size_t i = 0; i < count; ++i) {
      if (query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
      hits[first + i] = {query.hit.primID[i], query.ray.tfar[i], query.hit.u[i], query.hit.v[i]};
    }
  }
}

void RayCaster::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
  assert(rays.size() == blocked.size());
  std::fill(blocked.begin(), blocked.end(), std::uint8_t{0});
  if (impl_->scene == nullptr) return;
  alignas(64) RTCRay16 query;
  alignas(64) std::array<int, kWidth> valid{};
  for (std::size_t first = 0; first < rays.size(); first += kWidth) {
    const std::size_t count = std::min(kWidth, rays.size() - first);
    fillPacket(rays.subspan(first, count), query, valid);
    occluded16(valid.data(), impl_->scene, query);
    for (std::size_t i = 0; i < count; ++i) {
      if (valid[i] != 0 && query.tfar[i] < 0.0F) blocked[first + i] = 1;
    }
  }
}

}  // namespace soffit::geometry
