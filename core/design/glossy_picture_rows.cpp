// SPDX-License-Identifier: MIT
#include "core/design/glossy_picture_rows.h"

#include "core/color/luminance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

namespace soffit::design {
namespace {

/// Which part of the light a row is about.
enum class Part { all, direct, reflected };

using Halves = std::array<double, 2>;

Halves truthOf(const reference::BeamEstimate& beam, Part part) {
  Halves out{};
  for (std::size_t h = 0; h < 2; ++h) {
    const double all = color::luminance(beam.halves[h]);
    const double direct = color::luminance(beam.direct[h]);
    out[h] = part == Part::all ? all : part == Part::direct ? direct : all - direct;
  }
  return out;
}

double valueOf(const PictureByMethod& method, std::size_t i, Part part) {
  if (part == Part::all) return method.luminance[i];
  return part == Part::direct ? method.direct[i] : method.luminance[i] - method.direct[i];
}

/// Figures of a method over the pixels that `in` takes.
GlossyPictureRow rowOf(const PictureByMethod& method, const PictureTruth& truth, double whole_mean,
                       Part part, const std::function<bool(std::size_t)>& in) {
  GlossyPictureRow row;
  row.camera = truth.camera;
  row.method = method.name;
  row.seconds = method.seconds;
  double sum = 0.0;
  double noise = 0.0;
  double squares = 0.0;
  double fourths = 0.0;
  for (std::size_t i = 0; i < truth.beams.size(); ++i) {
    if (!in(i)) continue;
    const auto [a, b] = truthOf(truth.beams[i], part);
    const double found = valueOf(method, i, part);
    const double square = (found - a) * (found - b);
    squares += square;
    fourths += square * square;
    sum += found - 0.5 * (a + b);
    noise += 0.25 * (a - b) * (a - b);
    row.mean += 0.5 * (a + b);
    ++row.pixels;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(row.pixels, 1));
  row.mean /= count;
  const double rms = std::sqrt(std::max(0.0, squares / count));
  row.rms = rms / whole_mean;
  row.bias = sum / count / whole_mean;
  row.noise = std::sqrt(noise / count) / whole_mean;
  // Of the mean square, and from there to its root; where that is near 0, the root of the error.
  const double scatter =
      std::sqrt(std::max(0.0, fourths / count - std::pow(squares / count, 2.0)) / count);
  row.rms_error = std::min(scatter / std::max(2.0 * rms, 1e-30), std::sqrt(scatter)) / whole_mean;
  return row;
}

std::string pixelTable(const PictureTruth& truth, const std::vector<PictureByMethod>& methods) {
  std::string text = "camera,x,y,material,half_1,half_2,direct_1,direct_2";
  for (const PictureByMethod& method : methods) text += fmt::format(",\"{}\"", method.name);
  text += "\n";
  for (std::size_t i = 0; i < truth.beams.size(); ++i) {
    const PixelSamples::Pixel& pixel = truth.pixels.pixels[i];
    const std::uint32_t material =
        pixel.begin < pixel.end ? truth.pixels.samples[pixel.begin].material : 0;
    const Halves all = truthOf(truth.beams[i], Part::all);
    const Halves direct = truthOf(truth.beams[i], Part::direct);
    text += fmt::format(
        "\"{}\",{},{},\"{}\",{:.6g},{:.6g},{:.6g},{:.6g}", truth.camera, pixel.x, pixel.y,
        material < truth.materials.size() ? truth.materials[material].name : std::string(), all[0],
        all[1], direct[0], direct[1]);
    for (const PictureByMethod& method : methods) {
      text += fmt::format(",{:.6g}", method.luminance[i]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

GlossyPictures judgePictures(const PictureTruth& truth,
                             const std::vector<PictureByMethod>& methods) {
  double whole = 0.0;
  for (const auto& beam : truth.beams) whole += color::luminance(beam.mean());
  whole /= static_cast<double>(std::max<std::size_t>(truth.beams.size(), 1));
  const auto& pixels = truth.pixels.pixels;
  std::set<std::uint32_t> materials;
  for (const auto& pixel : pixels) {
    if (pixel.reflects) materials.insert(pixel.material);
  }
  GlossyPictures out;
  for (const PictureByMethod& method : methods) {
    const auto add = [&](const std::string& name, Part part,
                         const std::function<bool(std::size_t)>& in) {
      out.rows.push_back(rowOf(method, truth, whole, part, in));
      out.rows.back().part = name;
    };
    const auto matte = [&](std::size_t i) { return !pixels[i].reflects; };
    add("picture", Part::all, [](std::size_t) { return true; });
    for (const std::uint32_t material : materials) {
      const auto& m = truth.materials[material];
      add(fmt::format("{}, roughness {:.2f}", m.name, m.roughness), Part::all,
          [&](std::size_t i) { return pixels[i].reflects && pixels[i].material == material; });
    }
    add("matte surfaces", Part::all, matte);
    if (method.direct.empty()) continue;
    add("matte, straight light", Part::direct, matte);
    add("matte, reflected light", Part::reflected, matte);
  }
  out.pixels = pixelTable(truth, methods);
  return out;
}

std::string formatGlossyPictureRows(const std::vector<GlossyPictureRow>& rows) {
  std::string text = "camera,method,part,pixels,mean,rms,rms_error,bias,noise,seconds\n";
  for (const GlossyPictureRow& r : rows) {
    text += fmt::format("\"{}\",\"{}\",\"{}\",{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.4g}\n",
                        r.camera, r.method, r.part, r.pixels, r.mean, r.rms, r.rms_error, r.bias,
                        r.noise, r.seconds);
  }
  return text;
}

}  // namespace soffit::design
