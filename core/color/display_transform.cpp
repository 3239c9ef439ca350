// SPDX-License-Identifier: MIT
#include "core/color/display_transform.h"

#include "core/base/parallel.h"
#include "core/color/exposure.h"
#include "core/color/ocio_config.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>

namespace soffit::color {
namespace {

namespace ocio = OCIO_NAMESPACE;

/// Brighter than any view tells apart, and small enough that no matrix overflows.
constexpr float kBrightest = 1.0e6F;
constexpr std::size_t kPixelsPerTask = 8192;

/// max() with the literal first: a NaN compares false and gives way to 0.
float cleaned(float v) {
  return std::min(std::max(0.0F, v), kBrightest);
}
float clamped(float v) {
  return std::min(std::max(0.0F, v), 1.0F);
}

}  // namespace

struct DisplayTransform::Impl {
  OcioConfig config;  // keeps what the processor may refer to
  ocio::ConstCPUProcessorRcPtr processor;
  std::optional<ToneOperator> tone;

  void run(vec3* pixels, std::size_t count) const {
    if (tone) {
      for (std::size_t i = 0; i < count; ++i) pixels[i] = tone->displayed(pixels[i]);
    }
    ocio::PackedImageDesc image(pixels, static_cast<long>(count), 1, 3);
    processor->apply(image);
    for (std::size_t i = 0; i < count; ++i) {
      vec3& p = pixels[i];
      p = {clamped(p.x), clamped(p.y), clamped(p.z)};
    }
  }
};

Result<DisplayTransform> DisplayTransform::create(const DisplayChoice& choice) {
  const auto kind = toneKindOf(choice.view);
  const std::string view = kind ? kPlainView : choice.view;
  auto config = loadConfigFor(choice.config, choice.display, view, choice.look);
  if (!config) return config.error();
  const std::string path = config->path;
  try {
    auto impl = std::make_shared<Impl>();
    const auto processor = std::static_pointer_cast<const ocio::Processor>(
        viewProcessor(*config, choice.display, view, choice.look, balanceOf(choice)));
    impl->processor = processor->getOptimizedCPUProcessor(ocio::OPTIMIZATION_VERY_GOOD);
    if (kind) {
      impl->tone = choice.tone;
      impl->tone->kind = *kind;
    }
    impl->config = std::move(*config);
    DisplayTransform made;
    made.impl_ = std::move(impl);
    return made;
  } catch (const std::exception& e) {
    return Error{path,
                 fmt::format("the view \"{}\" of display \"{}\" cannot be built ({})", choice.view,
                             choice.display, e.what()),
                 "Check the config and the tables beside it."};
  }
}

void DisplayTransform::apply(std::span<vec3> pixels) const {
  parallelFor(pixels.size(), kPixelsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      pixels[i] = {cleaned(pixels[i].x), cleaned(pixels[i].y), cleaned(pixels[i].z)};
    }
    impl_->run(pixels.data() + begin, end - begin);
  });
}

void DisplayTransform::apply(std::span<const vec3> radiance, double exposure_ev,
                             std::span<vec3> out) const {
  assert(radiance.size() == out.size());
  const float scale = exposureScale(exposure_ev);
  parallelFor(radiance.size(), kPixelsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const vec3 p = radiance[i] * scale;
      out[i] = {cleaned(p.x), cleaned(p.y), cleaned(p.z)};
    }
    impl_->run(out.data() + begin, end - begin);
  });
}

}  // namespace soffit::color
