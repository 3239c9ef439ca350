// SPDX-License-Identifier: MIT
#include "core/io/image/write_image.h"

#include "core/io/image/memory_file.h"
#include "core/io/image/radiance_header.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <system_error>

namespace soffit::io {
namespace {

namespace fs = std::filesystem;

std::string extensionOf(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

Metadata cleaned(const Metadata& metadata) {
  Metadata lines;
  for (const auto& [key, value] : metadata) {
    if (key != "Software") lines.emplace_back(oneLine(key), oneLine(value));
  }
  return lines;
}

constexpr const char* kSoftware = "Soffit " SOFFIT_VERSION;

/// Interleaved gradient noise, Jimenez 2014, "Next Generation Post Processing in Call of Duty",
/// kept off 0 and 1 so that a representable value is not moved by rounding.
float noiseAt(int x, int y) {
  const double inner = 0.06711056 * x + 0.00583715 * y;
  const double value = 52.9829189 * (inner - std::floor(inner));
  return static_cast<float>(0.001 + 0.998 * (value - std::floor(value)));
}

/// Code values as unsigned integers of the full range.
template <class T>
std::vector<T> quantized(const scene::Image& image, bool dither) {
  constexpr float kTop = static_cast<float>(static_cast<T>(~T{0}));
  std::vector<T> codes(image.pixels.size());
  const auto row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const int x = static_cast<int>(i % row) / image.channels;
    const int y = static_cast<int>(i / row);
    const float code = std::min(std::max(0.0F, image.pixels[i]), 1.0F) * kTop;  // NaN becomes 0
    codes[i] = static_cast<T>(std::min(std::floor(code + (dither ? noiseAt(x, y) : 0.5F)), kTop));
  }
  return codes;
}

OIIO::ImageSpec makeSpec(const fs::path& path, const scene::Image& image,
                         const WriteOptions& options) {
  const std::string extension = extensionOf(path);
  const bool linear = isSceneLinear(path);
  const bool sixteen =
      options.bits == 16 && (extension == ".tif" || extension == ".tiff" || extension == ".png");
  OIIO::ImageSpec spec(
      image.width, image.height, image.channels,
      linear ? OIIO::TypeDesc::FLOAT : (sixteen ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8));
  std::string description;
  for (const auto& [key, value] : cleaned(options.metadata))
    description += fmt::format("{}: {}\n", key, value);
  spec.attribute("Software", kSoftware);
  if (!description.empty()) spec.attribute("ImageDescription", description);
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  if (extension.starts_with(".jp")) {
    spec.attribute("compression", fmt::format("jpeg:{}", std::clamp(options.quality, 1, 100)));
    spec.attribute("jpeg:subsampling", "4:4:4");
  } else if (extension != ".hdr") {
    spec.attribute("compression", "zip");
    spec.attribute("png:compressionLevel", 4);  // a third of the time of 6 for a tenth more bytes
  }
  return spec;
}

bool writePixels(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec, const scene::Image& image,
                 bool dither) {
  if (spec.format == OIIO::TypeDesc::UINT8) {
    return output.write_image(spec.format, quantized<std::uint8_t>(image, dither).data());
  }
  if (spec.format == OIIO::TypeDesc::UINT16) {
    return output.write_image(spec.format, quantized<std::uint16_t>(image, false).data());
  }
  return output.write_image(OIIO::TypeDesc::FLOAT, image.pixels.data());
}

/// libpng and libjpeg go on when nothing can be written any more, but then their last bytes lack.
bool isWhole(const MemoryFile& memory, const fs::path& path) {
  const std::string extension = extensionOf(path);
  if (extension == ".png") return memory.endsWith("IEND\xAE\x42\x60\x82");
  if (extension.starts_with(".jp")) return memory.endsWith("\xFF\xD9");
  return true;
}

/// Into `temporary`, by way of memory; its extension is that of the wanted format.
Result<void> writeTo(const fs::path& temporary, const fs::path& path, const scene::Image& image,
                     const WriteOptions& options) {
  const MemoryFile memory;
  const std::string encoded = memory.path().string();
  const auto failed = [&](const std::string& why) {
    return Error{path.string(), fmt::format("the picture cannot be written ({})", why),
                 "Check that the folder exists, may be written to, and that the disk is not full."};
  };
  try {
    auto output = OIIO::ImageOutput::create(temporary.string());
    if (output == nullptr) return failed(OIIO::geterror());
    const OIIO::ImageSpec spec = makeSpec(path, image, options);
    if (!output->open(encoded, spec)) return failed(output->geterror());
    const bool written = writePixels(*output, spec, image, options.dither);
    if (!output->close() || !written) return failed(output->geterror());
  } catch (const std::exception& e) {
    return failed(e.what());
  }
  if (extensionOf(path) == ".hdr") {
    Metadata header{{"SOFTWARE", kSoftware}};
    for (const auto& line : cleaned(options.metadata)) header.push_back(line);
    if (auto added = addRadianceHeader(encoded, header); !added) return added;
  }
  if (!isWhole(memory, path)) return failed("there is no room for it");
  std::error_code ignored;
  fs::remove(temporary, ignored);  // of an earlier program with our number that was killed
  const int trouble = memory.copyTo(temporary);
  if (trouble != 0) return failed(std::generic_category().message(trouble));
  return {};
}

}  // namespace

bool isSceneLinear(const fs::path& path) {
  const std::string extension = extensionOf(path);
  return extension == ".exr" || extension == ".hdr";
}

Result<void> checkImagePath(const fs::path& path) {
  static constexpr const char* kKnown[] = {".png",  ".jpg", ".jpeg", ".tif",
                                           ".tiff", ".exr", ".hdr"};
  const std::string extension = extensionOf(path);
  if (std::find(std::begin(kKnown), std::end(kKnown), extension) != std::end(kKnown)) return {};
  return Error{path.string(),
               fmt::format("expected a picture format, found the extension \"{}\"", extension),
               "Use .png, .jpg or .tif for tone-mapped pictures, .exr or .hdr for luminances."};
}

Result<void> writeImage(const fs::path& path, const scene::Image& image,
                        const WriteOptions& options) {
  auto known = checkImagePath(path);
  if (!known) return known;
  const auto count = static_cast<std::size_t>(std::max(image.width, 0)) *
                     static_cast<std::size_t>(std::max(image.height, 0)) *
                     static_cast<std::size_t>(std::max(image.channels, 0));
  if (count == 0 || image.pixels.size() != count || (image.channels != 1 && image.channels != 3)) {
    return Error{path.string(), "the picture has no pixels", "Ask for at least 1 x 1 pixel."};
  }
  // Beside the target, so that the rename stays on one file system and is atomic.
  fs::path temporary = path;
  temporary.replace_filename(
      fmt::format(".{}.{}{}", path.stem().string(), getpid(), path.extension().string()));
  auto written = writeTo(temporary, path, image, options);
  std::error_code failed;
  if (written) {
    fs::rename(temporary, path, failed);
    if (!failed) return {};
    written = Error{path.string(),
                    fmt::format("the picture cannot be put in place ({})", failed.message()),
                    "Check that no folder has this name and that the folder may be written to."};
  }
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return written;
}

}  // namespace soffit::io
