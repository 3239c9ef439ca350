// SPDX-License-Identifier: MIT
#include "core/color/display_shader.h"

#include "core/color/ocio_config.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>

namespace soffit::color {
namespace {

namespace ocio = OCIO_NAMESPACE;
using Texture = ocio::GpuShaderDesc;

std::vector<float> copyOf(const float* values, std::size_t count) {
  return values == nullptr ? std::vector<float>{} : std::vector<float>(values, values + count);
}

ShaderTable flatTable(const Texture& shader, unsigned i) {
  const char* texture = nullptr;
  const char* sampler = nullptr;
  unsigned width = 1;
  unsigned height = 1;
  auto channel = Texture::TEXTURE_RGB_CHANNEL;
  auto interpolation = ocio::INTERP_LINEAR;
  shader.getTexture(i, texture, sampler, width, height, channel, interpolation);
  ShaderTable table;
  table.sampler = sampler;
  table.dimensions = height > 1 ? 2 : 1;
  table.width = static_cast<int>(width);
  table.height = static_cast<int>(height);
  table.channels = channel == Texture::TEXTURE_RED_CHANNEL ? 1 : 3;
  table.interpolated = interpolation != ocio::INTERP_NEAREST;
  const float* values = nullptr;
  shader.getTextureValues(i, values);
  const std::size_t entries = static_cast<std::size_t>(width) * height;
  table.values = copyOf(values, entries * static_cast<std::size_t>(table.channels));
  return table;
}

ShaderTable cubeTable(const Texture& shader, unsigned i) {
  const char* texture = nullptr;
  const char* sampler = nullptr;
  unsigned edge = 1;
  auto interpolation = ocio::INTERP_LINEAR;
  shader.get3DTexture(i, texture, sampler, edge, interpolation);
  ShaderTable table;
  table.sampler = sampler;
  table.dimensions = 3;
  table.width = table.height = table.depth = static_cast<int>(edge);
  table.interpolated = interpolation != ocio::INTERP_NEAREST;
  const float* values = nullptr;
  shader.get3DTextureValues(i, values);
  table.values = copyOf(values, std::size_t{3} * edge * edge * edge);
  return table;
}

}  // namespace

Result<DisplayShader> makeDisplayShader(const DisplayChoice& choice) {
  const auto kind = toneKindOf(choice.view);
  const std::string view = kind ? kPlainView : choice.view;
  const auto config = loadConfigFor(choice.config, choice.display, view, choice.look);
  if (!config) return config.error();
  try {
    const auto processor = std::static_pointer_cast<const ocio::Processor>(
        viewProcessor(*config, choice.display, view, choice.look, balanceOf(choice)));
    ocio::GpuShaderDescRcPtr shader = ocio::GpuShaderDesc::CreateShaderDesc();
    shader->setLanguage(ocio::GPU_LANGUAGE_GLSL_1_3);
    shader->setFunctionName(kind ? "soffitPlainView" : "soffitView");
    shader->setResourcePrefix("view_");
    processor->getOptimizedGPUProcessor(ocio::OPTIMIZATION_VERY_GOOD)->extractGpuShaderInfo(shader);
    DisplayShader made;
    made.text = shader->getShaderText();
    made.adapts = kind.has_value();
    if (kind) {
      made.text += toneShader(*kind);
      made.text +=
          "vec4 soffitView(vec4 c) { return soffitPlainView(vec4(soffitTone(c.rgb), c.a)); }\n";
    }
    for (unsigned i = 0; i < shader->getNumTextures(); ++i) {
      made.tables.push_back(flatTable(*shader, i));
    }
    for (unsigned i = 0; i < shader->getNum3DTextures(); ++i) {
      made.tables.push_back(cubeTable(*shader, i));
    }
    return made;
  } catch (const std::exception& e) {
    return Error{config->path,
                 fmt::format("the view \"{}\" of display \"{}\" has no shader ({})", choice.view,
                             choice.display, e.what()),
                 "Check the config and the tables beside it."};
  }
}

}  // namespace soffit::color
