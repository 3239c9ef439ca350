// SPDX-License-Identifier: MIT
#include "core/daylight/picture_light.h"

#include "core/base/parallel.h"
#include "core/daylight/sky_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::daylight {
namespace {

constexpr int kLightWidth = 1024;  // of the reduced picture that light is taken from
constexpr double kSpotOfMean = 100.0;
constexpr double kSpotReach = 1.5 * kPi / 180.0;
constexpr std::size_t kMostSpots = 64;

sh::EnvironmentLayout layoutOf(scene::ProbeLayout layout, const scene::Image& image) {
  if (layout == scene::ProbeLayout::angular) return sh::EnvironmentLayout::angular_map;
  if (layout == scene::ProbeLayout::lat_long) return sh::EnvironmentLayout::lat_long;
  return image.width > image.height ? sh::EnvironmentLayout::horizontal_cross
                                    : sh::EnvironmentLayout::vertical_cross;
}

/// Means of blocks of n x n pixels, n whole.
scene::Image reduced(const scene::Image& image, int n) {
  scene::Image out;
  out.width = image.width / n;
  out.height = image.height / n;
  out.pixels.assign(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height),
                    0.0F);
  const auto at = [](const scene::Image& i, int x, int y) {
    return static_cast<std::size_t>(i.channels) *
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(i.width) +
            static_cast<std::size_t>(x));
  };
  for (int y = 0; y < out.height * n; ++y) {
    for (int x = 0; x < out.width * n; ++x) {
      const float* from = &image.pixels[at(image, x, y)];
      float* to = &out.pixels[at(out, x / n, y / n)];
      for (int c = 0; c < 3; ++c) to[c] += std::max(0.0F, from[c]) / static_cast<float>(n * n);
    }
  }
  return out;
}

/// The smallest block that divides both sides, so that squares of a cross keep whole pixels.
int blockFor(const scene::Image& image) {
  int n = 1;
  while (image.width / n > kLightWidth) {
    do {
      ++n;
    } while (n < image.width && (image.width % n != 0 || image.height % n != 0));
  }
  return std::min(n, std::max(1, std::min(image.width, image.height)));
}

/// Azimuth over 2 pi, 0..1, from +x towards +y; wrong by less than 2e-6, a thousandth of a cell.
/// The odd polynomial for the arc tangent on 0..1 errs by 1.2e-5 (Abramowitz & Stegun 4.4.49's
/// kind).
double quickTurn(double x, double y) {
  const double a = std::abs(x);
  const double b = std::abs(y);
  const double most = std::max(a, b);
  if (!(most > 0.0)) return 0.0;
  const double t = std::min(a, b) / most;
  const double s = t * t;
  double turn = t *
                (0.99997726 +
                 s * (-0.33262347 +
                      s * (0.19354346 + s * (-0.11643287 + s * (0.05265332 - s * 0.01172120))))) /
                (2.0 * kPi);
  if (b > a) turn = 0.25 - turn;
  if (x < 0.0) turn = 0.5 - turn;
  return y < 0.0 ? 1.0 - turn : turn;
}

double lum(const dvec3& rgb) {
  return 0.2126390058715104 * rgb.x + 0.7151686787677560 * rgb.y + 0.0721923153607336 * rgb.z;
}

}  // namespace

PictureLight::PictureLight(std::shared_ptr<const scene::Image> image, scene::ProbeLayout layout,
                           double scale)
    : image_(std::move(image)), named_(layout), layout_(layoutOf(layout, *image_)), scale_(scale) {
  const int n = blockFor(*image_);
  scene::Image light = reduced(*image_, n);
  findSpots(light);
  // What the spots carry is not counted twice.
  const sh::SphereSamples samples = sh::environmentSamples(layout_, light.width, light.height);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (const Spot& spot : spots_) {
      if (lum(scale_ * dvec3(light.pixels[3 * i], light.pixels[3 * i + 1],
                             light.pixels[3 * i + 2])) <= spot_threshold_) {
        break;
      }
      if (glm::dot(samples.directions[i], spot.direction) < std::cos(2.0 * kSpotReach)) continue;
      for (std::size_t c = 0; c < 3; ++c) light.pixels[3 * i + c] = 0.0F;
    }
  }
  cells_.assign(SkyTable::kCells, dvec3(0.0));
  const int side = std::clamp(light.width / SkyTable::kColumns * 2, 2, 8);
  parallelFor(cells_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (int k = 0; k < side * side; ++k) {
        const int row = k / side;
        const dvec2 at((k % side + 0.5) / side, (row + 0.5) / side);
        cells_[i] += lookUp(light, SkyTable::direction(i, at)) / double(side * side);
      }
    }
  });
}

PictureLight PictureLight::scaled(double scale) const {
  if (scale == scale_) return *this;
  if (!(scale_ > 0.0)) return {image_, named_, scale};
  PictureLight out = *this;
  const double factor = scale / scale_;
  out.scale_ = scale;
  out.spot_threshold_ *= factor;
  for (dvec3& cell : out.cells_) cell *= factor;
  for (Spot& spot : out.spots_) spot.normal_illuminance *= factor;
  if (!(scale > 0.0)) out.spots_.clear();
  return out;
}

void PictureLight::findSpots(const scene::Image& image) {
  const sh::SphereSamples samples = sh::environmentSamples(layout_, image.width, image.height);
  double mean = 0.0;
  const auto value = [&](std::size_t i) {
    return scale_ * dvec3(image.pixels[3 * i], image.pixels[3 * i + 1], image.pixels[3 * i + 2]);
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    mean += lum(value(i)) * samples.weights[i] / (4.0 * kPi);
  }
  spot_threshold_ = kSpotOfMean * mean;
  struct Sum {
    dvec3 moment{0.0};
    dvec3 light{0.0};
    double angle = 0.0;
  };
  std::vector<Sum> sums;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const dvec3 l = value(i);
    const double y = lum(l);
    const double w = samples.weights[i];
    if (!(w > 0.0) || !(y > spot_threshold_)) continue;
    auto at = std::ranges::find_if(sums, [&](const Sum& s) {
      return glm::dot(glm::normalize(s.moment), samples.directions[i]) > std::cos(kSpotReach);
    });
    if (at == sums.end()) {
      if (sums.size() == kMostSpots) {
        spot_threshold_ = std::numeric_limits<double>::infinity();
        return;  // a picture full of sparks: none is treated apart
      }
      at = sums.insert(sums.end(), Sum{});
    }
    at->moment += y * w * samples.directions[i];
    at->light += w * l;
    at->angle += w;
  }
  for (const Sum& s : sums) {
    spots_.push_back({glm::normalize(s.moment), std::acos(1.0 - s.angle / (2.0 * kPi)), s.light});
  }
}

dvec3 PictureLight::pixel(const scene::Image& image, int x, int y) const {
  const float* p =
      &image.pixels[static_cast<std::size_t>(image.channels) *
                    (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x))];
  return glm::max(dvec3(p[0], p[1], p[2]), dvec3(0.0));
}

dvec3 PictureLight::lookUp(const scene::Image& image, const dvec3& d) const {
  const int w = image.width;
  const int h = image.height;
  dvec2 st = sh::environmentPoint(layout_, d);
  if (layout_ == sh::EnvironmentLayout::angular_map) {
    // The corners beyond the rim show nothing: stay a pixel inside.
    const dvec2 from(st.x - 0.5, st.y - 0.5);
    const double r = glm::length(from);
    const double most = 0.5 - 1.5 / std::min(w, h);
    if (r > most && most > 0.0) st = dvec2(0.5) + from * (most / r);
  }
  int x_lo = 0;
  int x_hi = w - 1;
  int y_lo = 0;
  int y_hi = h - 1;
  const bool cross = layout_ == sh::EnvironmentLayout::horizontal_cross ||
                     layout_ == sh::EnvironmentLayout::vertical_cross;
  if (cross) {
    const int columns = layout_ == sh::EnvironmentLayout::horizontal_cross ? 4 : 3;
    const int rows = 7 - columns;
    const int column = std::clamp(static_cast<int>(st.x * columns), 0, columns - 1);
    const int row = std::clamp(static_cast<int>(st.y * rows), 0, rows - 1);
    x_lo = column * w / columns;
    x_hi = (column + 1) * w / columns - 1;
    y_lo = row * h / rows;
    y_hi = (row + 1) * h / rows - 1;
  }
  const double x = st.x * w - 0.5;
  const double y = st.y * h - 0.5;
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const auto column = [&](int i) {
    if (layout_ == sh::EnvironmentLayout::lat_long) return (i % w + w) % w;
    return std::clamp(i, x_lo, x_hi);
  };
  const auto row = [&](int j) { return std::clamp(j, y_lo, y_hi); };
  const double fx = x - x0;
  const double fy = y - y0;
  const dvec3 upper =
      (1.0 - fx) * pixel(image, column(x0), row(y0)) + fx * pixel(image, column(x0 + 1), row(y0));
  const dvec3 lower = (1.0 - fx) * pixel(image, column(x0), row(y0 + 1)) +
                      fx * pixel(image, column(x0 + 1), row(y0 + 1));
  return scale_ * ((1.0 - fy) * upper + fy * lower);
}

dvec3 PictureLight::radiance(const dvec3& d) const {
  return lookUp(*image_, d);
}

const dvec3& PictureLight::smooth(const dvec3& d) const {
  // As SkyTable::cellOf(): every direction of every receiver asks.
  const int row =
      std::clamp(static_cast<int>((0.5 + 0.5 * d.z) * SkyTable::kRows), 0, SkyTable::kRows - 1);
  const int column = std::clamp(static_cast<int>(quickTurn(d.x, d.y) * SkyTable::kColumns), 0,
                                SkyTable::kColumns - 1);
  return cells_[static_cast<std::size_t>(row * SkyTable::kColumns + column)];
}

bool PictureLight::dark() const {
  return spots_.empty() &&
         std::ranges::all_of(cells_, [](const dvec3& cell) { return !(lum(cell) > 0.0); });
}

std::vector<double> PictureLight::weights() const {
  std::vector<double> out;
  out.reserve(cells_.size());
  for (const dvec3& c : cells_) out.push_back(lum(c));
  // A spot's light, spread over the cells that its disc may reach.
  const double cell = 4.0 * kPi / static_cast<double>(SkyTable::kCells);
  for (const Spot& spot : spots_) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const dvec3 d = SkyTable::direction(i, {0.5, 0.5});
      const double reach = std::max(spot.radius, 0.5 * kPi / 180.0) + 1.0 * kPi / 180.0;
      if (glm::dot(d, spot.direction) > std::cos(reach) || SkyTable::cellOf(spot.direction) == i) {
        out[i] += 0.25 * lum(spot.normal_illuminance) / cell;
      }
    }
  }
  return out;
}

}  // namespace soffit::daylight
