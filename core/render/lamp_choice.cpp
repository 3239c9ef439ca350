// SPDX-License-Identifier: MIT
#include "core/render/lamp_choice.h"

#include "core/base/parallel.h"
#include "core/color/luminance.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

/// Of all draws, those that any source may get.
constexpr double kEven = 0.1;
/// What the other texels of a cluster have counts so much beside a texel's own: shadows' edges and
/// facets of a curved surface lie between them.
constexpr float kNeighbours = 0.4F;
/// Sources below this share of a slot's light are left to those.
constexpr float kLeastShare = 0.003F;

/// What a slot receives from one source is scale * lux[slot].
struct Source {
  std::uint32_t number = 0;
  std::vector<float> own;  ///< where no column holds it
  const std::vector<float>* lux = nullptr;
  float scale = 1.0F;
  std::vector<float> mean;  ///< of scale * lux, per cluster
};

float lightAt(const Source& source, std::size_t slot) {
  return slot < source.lux->size() ? std::max(source.scale * (*source.lux)[slot], 0.0F) : 0.0F;
}

/// What the environment's spots bring: direct light from outside without the sky's.
std::vector<float> spotLight(const relight::Lighting& lighting) {
  const relight::Planes& sky = lighting.skyDirect();
  std::vector<float> lux(sky[0].size(), 0.0F);
  for (const relight::WeightedColumn& light : lighting.outdoorLights()) {
    const auto scale = static_cast<float>(color::luminance(light.weight));
    for (std::size_t s = 0; s < lux.size(); ++s) lux[s] += scale * light.column->direct[s];
  }
  for (std::size_t s = 0; s < lux.size(); ++s) {
    const float smooth = color::luminance(vec3(sky[0][s], sky[1][s], sky[2][s]));
    lux[s] = std::max(lux[s] - smooth, 0.0F);
  }
  return lux;
}

std::vector<Source> sourcesOf(const relight::Lighting& lighting) {
  std::vector<Source> sources;
  const auto emitters = lighting.emitters();
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    if (emitters[i].gain <= 0.0) continue;
    Source source;
    source.number = static_cast<std::uint32_t>(i);
    source.lux = &lighting.column(i).direct;
    source.scale = static_cast<float>(color::luminance(lighting.weight(i)));
    sources.push_back(std::move(source));
  }
  if (lighting.environment() == nullptr) return sources;
  const auto spots = lighting.environment()->spots();
  const std::vector<float> lux = spots.empty() ? std::vector<float>{} : spotLight(lighting);
  double all = 0.0;
  for (const daylight::Spot& spot : spots) all += color::luminance(spot.normal_illuminance);
  for (std::size_t k = 0; k < spots.size(); ++k) {
    Source source;
    source.number = static_cast<std::uint32_t>(emitters.size() + k);
    source.own = lux;
    if (all > 0.0) {
      source.scale = static_cast<float>(color::luminance(spots[k].normal_illuminance) / all);
    }
    sources.push_back(std::move(source));
  }
  return sources;
}

}  // namespace

LampChoice::LampChoice(const relight::Lighting& lighting) {
  std::vector<Source> sources = sourcesOf(lighting);
  for (Source& source : sources) {
    if (source.lux == nullptr) source.lux = &source.own;
    on_.push_back(source.number);
  }
  const std::size_t slots = lighting.solver().operators().texels.slotCount();
  const auto& clusters = lighting.solver().operators().texels.receivers.clusters;
  for (Source& source : sources) {
    for (const light::Receivers::Cluster& c : clusters) {
      float sum = 0.0F;
      for (std::uint32_t s = c.begin; s < c.end; ++s) sum += lightAt(source, s);
      source.mean.push_back(sum / static_cast<float>(std::max(c.end - c.begin, 1U)));
    }
  }
  // Weights of all sources at a slot, small ones 0.
  const auto weigh = [&](std::size_t cluster, std::size_t slot, std::vector<float>& weights) {
    weights.clear();
    float sum = 0.0F;
    for (const Source& source : sources) {
      weights.push_back(lightAt(source, slot) + kNeighbours * source.mean[cluster]);
      sum += weights.back();
    }
    for (float& w : weights) w = w > kLeastShare * sum ? w : 0.0F;
  };
  first_.assign(slots + 1, 0);
  parallelFor(clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<float> weights;
    for (std::size_t c = begin; c < end; ++c) {
      for (std::uint32_t s = clusters[c].begin; s < clusters[c].end; ++s) {
        weigh(c, s, weights);
        for (const float w : weights) first_[s + 1] += w > 0.0F ? 1U : 0U;
      }
    }
  });
  for (std::size_t s = 0; s < slots; ++s) first_[s + 1] += first_[s];
  shares_.resize(first_.back());
  parallelFor(clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<float> weights;
    for (std::size_t c = begin; c < end; ++c) {
      for (std::uint32_t s = clusters[c].begin; s < clusters[c].end; ++s) {
        weigh(c, s, weights);
        std::uint32_t at = first_[s];
        float sum = 0.0F;
        for (std::size_t k = 0; k < sources.size(); ++k) {
          if (weights[k] > 0.0F) shares_[at++] = {sources[k].number, sum += weights[k]};
        }
        for (std::uint32_t k = first_[s]; k < at; ++k) shares_[k].up_to /= sum;
      }
    }
  });
}

LampChoice::Pick LampChoice::pick(std::uint32_t slot, double u) const {
  if (on_.empty()) return {};
  const auto begin = shares_.begin() + first_[slot];
  const auto end = shares_.begin() + first_[slot + 1];
  const double even = begin == end ? 1.0 : kEven;
  const auto byOrder = [](const Share& share, std::uint32_t source) {
    return share.source < source;
  };
  const auto byShare = [](const Share& share, double v) {
    return static_cast<double>(share.up_to) < v;
  };
  std::uint32_t source = 0;
  if (u < even) {
    const double place = u / even * static_cast<double>(on_.size());
    source = on_[std::min(static_cast<std::size_t>(place), on_.size() - 1)];
  } else {
    const auto found = std::lower_bound(begin, end, (u - even) / (1.0 - even), byShare);
    source = (found == end ? end - 1 : found)->source;
  }
  double probability = even / static_cast<double>(on_.size());
  const auto own = std::lower_bound(begin, end, source, byOrder);
  if (own != end && own->source == source) {
    const float before = own == begin ? 0.0F : (own - 1)->up_to;
    probability += (1.0 - even) * static_cast<double>(own->up_to - before);
  }
  return {source, probability};
}

}  // namespace soffit::render
