// SPDX-License-Identifier: MIT
#include "core/io/image/read_image.h"

#include "core/color/srgb.h"
#include "core/io/image/radiance_header.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <system_error>

namespace soffit::io {
namespace {

using Input = std::unique_ptr<OIIO::ImageInput>;

Result<Input> open(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return Error{path.string(), "the picture does not exist",
                 "Check the path; it is relative to the project."};
  }
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // colour as stored, not multiplied by alpha
  try {
    Input input = OIIO::ImageInput::open(path.string(), &config);
    if (input != nullptr) return input;
    return Error{path.string(), fmt::format("the picture cannot be read ({})", OIIO::geterror()),
                 "Save it again as PNG, JPEG, TIFF, HDR or EXR."};
  } catch (const std::exception& e) {
    return Error{path.string(), fmt::format("the picture cannot be read ({})", e.what()),
                 "Save it again as PNG, JPEG, TIFF, HDR or EXR."};
  }
}

Result<void> checkSize(const std::filesystem::path& path, const OIIO::ImageSpec& spec,
                       std::size_t max_pixels) {
  if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0) {
    return Error{path.string(), "the picture is empty", "Save it again."};
  }
  const auto pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  if (pixels > max_pixels || spec.depth > 1) {
    return Error{path.string(),
                 fmt::format("the picture has {} x {} pixels, the limit is {} in all", spec.width,
                             spec.height, max_pixels),
                 "Scale it down."};
  }
  return {};
}

bool isInteger(const OIIO::ImageSpec& spec) {
  return !spec.format.is_floating_point();
}

/// Grey to three channels, alpha away, broken numbers to 0, sRGB decoded where asked.
scene::Image toImage(const OIIO::ImageSpec& spec, const std::vector<float>& raw, int read_channels,
                     bool decode) {
  scene::Image image{spec.width, spec.height, 3, {}};
  const auto stride = static_cast<std::size_t>(read_channels);
  const std::size_t pixels = raw.size() / stride;
  image.pixels.resize(pixels * 3);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float v = raw[i * stride + (read_channels >= 3 ? c : 0)];
      const float finite = std::isfinite(v) ? v : 0.0F;
      image.pixels[i * 3 + c] = decode ? color::srgbDecode(finite) : finite;
    }
  }
  return image;
}

std::string trimmed(std::string text) {
  while (!text.empty() && (text.back() == '\r' || text.back() == '\0' || text.back() == ' '))
    text.pop_back();
  return text;
}

}  // namespace

Result<scene::Image> readImage(const std::filesystem::path& path, const ReadOptions& options) {
  auto input = open(path);
  if (!input) return input.error();
  const OIIO::ImageSpec spec = (*input)->spec();
  const auto size = checkSize(path, spec, options.max_pixels);
  if (!size) return size.error();
  try {
    const int channels = std::min(spec.nchannels, 3);
    std::vector<float> raw(static_cast<std::size_t>(spec.width) *
                           static_cast<std::size_t>(spec.height) *
                           static_cast<std::size_t>(channels));
    if (!(*input)->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, raw.data())) {
      return Error{path.string(), fmt::format("the picture is broken ({})", (*input)->geterror()),
                   "Save it again."};
    }
    return toImage(spec, raw, channels, options.decode_srgb && isInteger(spec));
  } catch (const std::exception& e) {
    return Error{path.string(), fmt::format("the picture cannot be read ({})", e.what()),
                 "Save it again."};
  }
}

Result<Metadata> readMetadata(const std::filesystem::path& path) {
  auto input = open(path);
  if (!input) return input.error();
  if (std::string((*input)->format_name()) == "hdr") return readRadianceHeader(path);
  const OIIO::ImageSpec& spec = (*input)->spec();
  Metadata metadata;
  const std::string software = spec.get_string_attribute("Software");
  if (!software.empty()) metadata.emplace_back("Software", software);
  const std::string description = spec.get_string_attribute("ImageDescription");
  for (std::size_t begin = 0; begin < description.size();) {
    const std::size_t end = std::min(description.find('\n', begin), description.size());
    const std::string line = description.substr(begin, end - begin);
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos)
      metadata.emplace_back(line.substr(0, colon), trimmed(line.substr(colon + 2)));
    begin = end + 1;
  }
  return metadata;
}

}  // namespace soffit::io
