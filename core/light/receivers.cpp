// SPDX-License-Identifier: MIT
#include "core/light/receivers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace soffit::light {
namespace {

/// 26 directions of the cube's faces, edges and corners plus exact axis directions first: points
/// of one plane always share a class.
std::uint32_t normalClass(const vec3& n) {
  const auto digit = [](float c) { return c < -0.4142F ? 0U : (c > 0.4142F ? 2U : 1U); };
  return digit(n.x) + 3U * digit(n.y) + 9U * digit(n.z);
}

struct Splitter {
  std::span<const vec3> positions;
  std::span<const vec3> normals;
  std::uint32_t limit;
  std::vector<std::uint32_t>* order;
  std::vector<std::uint32_t>* offsets;

  // Distances along the normal count more: a desk top and the floor below it do not mix.
  static constexpr float kNormalWeight = 4.0F;

  void split(std::uint32_t begin, std::uint32_t end, const vec3& n) const {
    Box box;
    float lo = 1e30F;
    float hi = -1e30F;
    for (std::uint32_t i = begin; i < end; ++i) {
      const vec3& p = positions[(*order)[i]];
      box.add(p);
      const float d = glm::dot(n, p);
      lo = std::min(lo, d);
      hi = std::max(hi, d);
    }
    if (end - begin <= limit && (hi - lo) * kNormalWeight <= box.diagonal() + 1e-6F) {
      offsets->push_back(end);
      return;
    }
    if (end - begin <= Receivers::kGroup) {
      offsets->push_back(end);
      return;
    }
    const vec3 size = box.size();
    int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    const bool along_normal = (hi - lo) * kNormalWeight > size[axis];
    const auto key = [&](std::uint32_t i) {
      return along_normal ? glm::dot(n, positions[i]) : positions[i][axis];
    };
    // Split at a multiple of the limit, so that clusters are full; along the normal at the widest gap.
    const std::uint32_t count = end - begin;
    std::uint32_t middle = begin + count / 2;
    const auto first = order->begin() + begin;
    const auto last = order->begin() + end;
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
      const float ka = key(a);
      const float kb = key(b);
      return ka < kb || (ka == kb && a < b);
    };
    if (along_normal) {
      std::sort(first, last, less);
      float widest = -1.0F;
      for (std::uint32_t i = begin + 1; i < end; ++i) {
        const float gap = key((*order)[i]) - key((*order)[i - 1]);
        if (gap > widest) {
          widest = gap;
          middle = i;
        }
      }
    } else {
      if (count > limit) {
        const std::uint32_t parts = (count + limit - 1) / limit;
        middle = begin + static_cast<std::uint32_t>((static_cast<std::uint64_t>(count) * (parts / 2)) / parts);
      }
      std::nth_element(first, order->begin() + middle, last, less);
    }
    if (middle == begin || middle == end) middle = begin + count / 2;
    split(begin, middle, n);
    split(middle, end, n);
  }
};

Receivers::Bounds boundsOf(const Receivers& r, std::uint32_t begin, std::uint32_t end) {
  Receivers::Bounds b;
  const vec3 n = r.normal(begin);
  bool common = true;
  float plane = 1e30F;
  for (std::uint32_t i = begin; i < end; ++i) {
    b.box.add(r.position(i));
    common = common && glm::dot(n, r.normal(i)) > 1.0F - 1e-6F;
    plane = std::min(plane, glm::dot(n, r.position(i)));
  }
  if (common) {
    b.normal = n;
    b.plane_min = plane;
  }
  return b;
}

}  // namespace

void clusterPoints(std::span<const vec3> positions, std::span<const vec3> normals, std::uint32_t cluster_size,
                   std::span<const std::uint32_t> regions, std::vector<std::uint32_t>& order,
                   std::vector<std::uint32_t>& offsets) {
  const auto count = static_cast<std::uint32_t>(positions.size());
  order.resize(count);
  std::iota(order.begin(), order.end(), 0U);
  offsets.assign(1, 0U);
  const auto regionOf = [&](std::uint32_t i) { return regions.empty() ? 0U : regions[i]; };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (regionOf(a) != regionOf(b)) return regionOf(a) < regionOf(b);
    return normalClass(normals[a]) < normalClass(normals[b]);
  });
  const Splitter splitter{positions, normals, cluster_size, &order, &offsets};
  for (std::uint32_t begin = 0; begin < count;) {
    const std::uint32_t cls = normalClass(normals[order[begin]]);
    const std::uint32_t region = regionOf(order[begin]);
    std::uint32_t end = begin;
    vec3 mean(0.0F);
    while (end < count && normalClass(normals[order[end]]) == cls && regionOf(order[end]) == region) {
      mean += normals[order[end++]];
    }
    const float length = glm::length(mean);
    splitter.split(begin, end, length > 0.0F ? mean / length : vec3(0, 0, 1));
    begin = end;
  }
}

Receivers makeReceivers(std::span<const vec3> positions, std::span<const vec3> normals,
                        std::span<const std::uint32_t> order, std::span<const std::uint32_t> offsets) {
  Receivers r;
  r.slot_of.assign(positions.size(), 0);
  const auto push = [&](std::uint32_t point) {
    const vec3& p = positions[point];
    const vec3& n = normals[point];
    r.x.push_back(p.x);
    r.y.push_back(p.y);
    r.z.push_back(p.z);
    r.nx.push_back(n.x);
    r.ny.push_back(n.y);
    r.nz.push_back(n.z);
    r.point_of.push_back(point);
  };
  for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
    if (offsets[k] == offsets[k + 1]) continue;
    Receivers::Cluster c;
    c.begin = static_cast<std::uint32_t>(r.x.size());
    c.used = offsets[k + 1] - offsets[k];
    for (std::uint32_t i = offsets[k]; i < offsets[k + 1]; ++i) {
      r.slot_of[order[i]] = static_cast<std::uint32_t>(r.x.size());
      push(order[i]);
    }
    while (r.x.size() % Receivers::kGroup != 0) push(order[offsets[k + 1] - 1]);
    c.end = static_cast<std::uint32_t>(r.x.size());
    c.bounds = boundsOf(r, c.begin, c.end);
    for (std::uint32_t g = c.begin; g < c.end; g += Receivers::kGroup) {
      r.groups.push_back(boundsOf(r, g, g + Receivers::kGroup));
    }
    r.clusters.push_back(c);
  }
  return r;
}

namespace {

/// Orders up to 16 points so that runs of 4 lie close together.
void orderFours(std::span<const vec3> positions, std::span<std::uint32_t> order) {
  if (order.size() <= 4) return;
  Box box;
  for (const std::uint32_t i : order) box.add(positions[i]);
  const vec3 size = box.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float ka = positions[a][axis];
    const float kb = positions[b][axis];
    return ka < kb || (ka == kb && a < b);
  });
  const std::size_t middle = order.size() > 8 ? 8 : 4;
  orderFours(positions, order.first(middle));
  orderFours(positions, order.subspan(middle));
}

/// Orders the points of each cluster along a space-filling path so that groups of 16, and fours
/// within them, are compact.
void orderWithin(std::span<const vec3> positions, std::span<const vec3> normals, std::vector<std::uint32_t>& order,
                 std::span<const std::uint32_t> offsets) {
  for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
    const std::vector<std::uint32_t> members(order.begin() + offsets[k], order.begin() + offsets[k + 1]);
    if (members.size() <= Receivers::kGroup) continue;
    std::vector<vec3> p;
    std::vector<vec3> n;
    for (const std::uint32_t m : members) {
      p.push_back(positions[m]);
      n.push_back(normals[m]);
    }
    std::vector<std::uint32_t> inner;
    std::vector<std::uint32_t> inner_offsets;
    clusterPoints(p, n, Receivers::kGroup, {}, inner, inner_offsets);
    for (std::size_t i = 0; i < members.size(); ++i) order[offsets[k] + i] = members[inner[i]];
    for (std::size_t i = offsets[k]; i < offsets[k + 1]; i += Receivers::kGroup) {
      const std::size_t count = std::min<std::size_t>(Receivers::kGroup, offsets[k + 1] - i);
      orderFours(positions, std::span(order).subspan(i, count));
    }
  }
}

}  // namespace

Receivers makeReceivers(std::span<const vec3> positions, std::span<const vec3> normals, std::uint32_t cluster_size,
                        std::span<const std::uint32_t> regions) {
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> offsets;
  clusterPoints(positions, normals, cluster_size, regions, order, offsets);
  orderWithin(positions, normals, order, offsets);
  return makeReceivers(positions, normals, order, offsets);
}

}  // namespace soffit::light
