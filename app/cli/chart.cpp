// SPDX-License-Identifier: MIT
#include "app/cli/chart.h"

#include "core/render/pen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace soffit::cli {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr float kText = 8.0F;  // height of capitals, px
constexpr vec3 kInk{0.15F};
constexpr vec3 kGrid{0.87F};
constexpr vec3 kFront{0.35F};

/// Okabe & Ito 2008: apart for every kind of color vision.
constexpr std::array<vec3, 7> kColors{{{0.00F, 0.45F, 0.70F},
                                       {0.84F, 0.37F, 0.00F},
                                       {0.00F, 0.62F, 0.45F},
                                       {0.80F, 0.47F, 0.65F},
                                       {0.90F, 0.62F, 0.00F},
                                       {0.34F, 0.71F, 0.91F},
                                       {0.20F, 0.20F, 0.20F}}};

/// What is drawn on.
class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual void line(const vec2& a, const vec2& b, float width, const vec3& color) = 0;
  virtual void text(const vec2& at, const std::string& text, const vec3& color) = 0;
  void dot(const vec2& at, float size, const vec3& color) { line(at, at, size, color); }
};

class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(int width, int height) {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"{2}\" "
        "stroke-linecap=\"round\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        width, height, kText * 1.4F);
  }
  void line(const vec2& a, const vec2& b, float width, const vec3& color) override {
    // A line without length is a dot; not every viewer draws its round ends.
    const vec2 end = a == b ? b + vec2(0.01F, 0.0F) : b;
    text_ += fmt::format(
        "<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\" stroke=\"{}\" stroke-width=\"{:.1f}\"/>\n", a.x,
        a.y, end.x, end.y, hex(color), width);
  }
  void text(const vec2& at, const std::string& text, const vec3& color) override {
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", at.x, at.y,
                         hex(color), escaped(text));
  }
  [[nodiscard]] std::string finish() const { return text_ + "</svg>\n"; }

 private:
  static std::string hex(const vec3& c) {
    const auto byte = [](float v) { return static_cast<int>(std::lround(255.0F * v)); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(c.x), byte(c.y), byte(c.z));
  }
  static std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
      if (c == '&') {
        out += "&amp;";
      } else if (c == '<') {
        out += "&lt;";
      } else {
        out += c;
      }
    }
    return out;
  }

  std::string text_;
};

class ImageCanvas final : public Canvas {
 public:
  ImageCanvas(int width, int height) : image_{width, height, 3, {}} {
    image_.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3,
                         1.0F);
  }
  void line(const vec2& a, const vec2& b, float width, const vec3& color) override {
    render::drawLine(image_, a, b, width, color);
  }
  void text(const vec2& at, const std::string& text, const vec3& color) override {
    render::drawText(image_, at, kText, text, color);
  }
  [[nodiscard]] scene::Image finish() { return std::move(image_); }

 private:
  scene::Image image_;
};

bool drawable(const dvec2& p) {
  return p.x > 0.0 && p.y > 0.0 && std::isfinite(p.x) && std::isfinite(p.y);
}

/// A logarithmic axis from `lo` to `hi` on pixels `from` to `to`.
struct Axis {
  double lo = 0.1, hi = 10.0;
  float from = 0.0F, to = 1.0F;
  [[nodiscard]] float at(double v) const {
    const double share = std::log(v / lo) / std::log(hi / lo);
    return from + static_cast<float>(share) * (to - from);
  }
};

/// Values 1, 2, 5 x 10^n in the axis.
std::vector<double> ticksOf(const Axis& axis) {
  std::vector<double> ticks;
  const auto first = static_cast<int>(std::floor(std::log10(axis.lo)));
  const auto last = static_cast<int>(std::floor(std::log10(axis.hi)));
  for (int exponent = first; exponent <= last; ++exponent) {
    const double power = std::pow(10.0, exponent);
    for (const double m : {1.0, 2.0, 5.0}) {
      if (m * power >= axis.lo * 0.999 && m * power <= axis.hi * 1.001) ticks.push_back(m * power);
    }
  }
  return ticks;
}

/// An axis that holds all points with some room around them.
Axis fit(const ChartPanel& panel, int coordinate, float from, float to) {
  Axis axis{1e300, 0.0, from, to};
  for (const ChartSeries& s : panel.series) {
    for (const dvec2& p : s.points) {
      if (!drawable(p)) continue;
      axis.lo = std::min(axis.lo, p[coordinate]);
      axis.hi = std::max(axis.hi, p[coordinate]);
    }
  }
  if (axis.hi <= 0.0) return {0.1, 10.0, from, to};
  const double room = std::max(1.15, std::pow(axis.hi / axis.lo, 0.06));
  return {axis.lo / room, axis.hi * room, from, to};
}

void drawAxes(const ChartPanel& panel, const Axis& x, const Axis& y, const vec2& corner,
              Canvas& canvas) {
  for (const double v : ticksOf(x)) {
    const float at = x.at(v);
    canvas.line({at, y.from}, {at, y.to}, 1.0F, kGrid);
    const std::string label = fmt::format("{:g}", v);
    canvas.text({at - 0.5F * render::textWidth(label, kText), y.from + 18.0F}, label, kInk);
  }
  for (const double v : ticksOf(y)) {
    const float at = y.at(v);
    canvas.line({x.from, at}, {x.to, at}, 1.0F, kGrid);
    const std::string label = fmt::format("{:g}", v);
    canvas.text({x.from - 8.0F - render::textWidth(label, kText), at + 4.0F}, label, kInk);
  }
  canvas.line({x.from, y.from}, {x.to, y.from}, 1.2F, kInk);
  canvas.line({x.from, y.from}, {x.from, y.to}, 1.2F, kInk);
  canvas.text(corner + vec2(70.0F, 24.0F), panel.title, kInk);
  canvas.text(corner + vec2(12.0F, 44.0F), panel.y_label, kInk);
  canvas.text({x.to - render::textWidth(panel.x_label, kText), y.from + 38.0F}, panel.x_label,
              kInk);
}

void drawPanel(const ChartPanel& panel, const vec2& corner, Canvas& canvas) {
  const Axis x = fit(panel, 0, corner.x + 60.0F, corner.x + kWidth - 24.0F);
  const Axis y = fit(panel, 1, corner.y + kHeight - 56.0F, corner.y + 56.0F);
  drawAxes(panel, x, y, corner, canvas);
  const auto place = [&](const dvec2& p) { return vec2(x.at(p.x), y.at(p.y)); };
  for (std::size_t i = 0; i < panel.front.size(); ++i) {
    if (!drawable(panel.front[i])) continue;
    if (i + 1 < panel.front.size() && drawable(panel.front[i + 1])) {
      // A stair: between two choices the cheaper one is to be had.
      const vec2 from = place(panel.front[i]);
      const vec2 to = place(panel.front[i + 1]);
      canvas.line(from, {to.x, from.y}, 1.5F, kFront);
      canvas.line({to.x, from.y}, to, 1.5F, kFront);
    }
    canvas.dot(place(panel.front[i]), 13.0F, kFront);
  }
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    const vec3 color = kColors[s % kColors.size()];
    for (const dvec2& p : panel.series[s].points) {
      if (drawable(p)) canvas.dot(place(p), 8.0F, color);
    }
    const float row = y.to + 10.0F + 18.0F * static_cast<float>(s);
    const float left = x.to - 150.0F;
    canvas.dot({left, row - 4.0F}, 8.0F, color);
    canvas.text({left + 12.0F, row}, panel.series[s].name, kInk);
  }
  for (std::size_t i = 0; i < std::min(panel.labels.size(), panel.front.size()); ++i) {
    if (!drawable(panel.front[i])) continue;
    // Beside its dot, on the left of it where the panel ends.
    const vec2 dot = place(panel.front[i]);
    const float width = render::textWidth(panel.labels[i], kText);
    const bool fits = dot.x + 9.0F + width <= corner.x + kWidth;
    canvas.text(dot + vec2(fits ? 9.0F : -9.0F - width, -8.0F), panel.labels[i], kFront);
  }
}

glm::ivec2 sizeOf(std::size_t panels) {
  const int columns = panels > 1 ? 2 : 1;
  const int rows = std::max(1, (static_cast<int>(panels) + columns - 1) / columns);
  return {columns * kWidth, rows * kHeight};
}

void drawAll(const std::vector<ChartPanel>& panels, Canvas& canvas) {
  const std::size_t columns = panels.size() > 1 ? 2 : 1;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    drawPanel(panels[i],
              {static_cast<float>(i % columns * kWidth), static_cast<float>(i / columns * kHeight)},
              canvas);
  }
}

}  // namespace

std::string chartSvg(const std::vector<ChartPanel>& panels) {
  const glm::ivec2 size = sizeOf(panels.size());
  SvgCanvas canvas(size.x, size.y);
  drawAll(panels, canvas);
  return canvas.finish();
}

scene::Image chartImage(const std::vector<ChartPanel>& panels) {
  const glm::ivec2 size = sizeOf(panels.size());
  ImageCanvas canvas(size.x, size.y);
  drawAll(panels, canvas);
  return canvas.finish();
}

}  // namespace soffit::cli
