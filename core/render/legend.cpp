// SPDX-License-Identifier: MIT
#include "core/render/legend.h"

#include "core/render/pen.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr int kSmallest = 120;
constexpr vec3 kPanel{0.07F, 0.07F, 0.08F};
constexpr vec3 kInk{0.96F, 0.96F, 0.96F};
constexpr float kPanelOpacity = 0.78F;

/// Height of capitals: a fortieth of the picture, but readable.
float textHeight(const scene::Image& image) {
  return std::max(7.0F,
                  std::round(static_cast<float>(std::min(image.width, image.height)) / 60.0F));
}

float panelHeight(const scene::Image& image) {
  return std::round(std::min(0.72F * static_cast<float>(image.height), 34.0F * textHeight(image)));
}

void drawBar(scene::Image& image, const Area& bar, const LegendScale& scale) {
  const int top = static_cast<int>(bar.top);
  const int bottom = static_cast<int>(bar.bottom);
  for (int y = top; y < bottom; ++y) {
    const float place =
        1.0F - (static_cast<float>(y - top) + 0.5F) / static_cast<float>(bottom - top);
    const vec3 color = scale.color(place);
    for (int x = static_cast<int>(bar.left); x < static_cast<int>(bar.right); ++x) {
      const auto at = static_cast<std::size_t>((y * image.width + x) * 3);
      for (std::size_t c = 0; c < 3; ++c) image.pixels[at + c] = color[static_cast<int>(c)];
    }
  }
}

}  // namespace

int legendRoom(const scene::Image& image) {
  const float h = textHeight(image);
  return std::clamp(static_cast<int>((panelHeight(image) - 6.4F * h) / (2.6F * h)), 2, 12);
}

void drawLegend(scene::Image& image, const color::FalseColorRange& range) {
  drawLegend(image, color::LuxScale{.range = range});
}

void drawLegend(scene::Image& image, const color::LuxScale& scale) {
  drawLegend(image,
             LegendScale{[&scale](float place) { return scale.colorAt(place); },
                         color::legendTicks(scale, legendRoom(image)), color::nameOf(scale.unit)});
}

void drawLegend(scene::Image& image, const LegendScale& scale) {
  if (image.width < kSmallest || image.height < kSmallest) return;
  const float h = textHeight(image);
  const auto width = static_cast<float>(image.width);
  const auto height = static_cast<float>(image.height);
  const float panel_height = panelHeight(image);
  const float bar_height = panel_height - 6.4F * h;
  float labels = textWidth(scale.unit, h);
  for (const auto& tick : scale.ticks) labels = std::max(labels, textWidth(tick.label, h));

  const float bar_width = std::round(1.6F * h);
  const float panel_width = std::round(1.2F * h + bar_width + 1.3F * h + labels + 1.3F * h);
  const float right = width - std::round(1.2F * h);
  const float top = std::round(0.5F * (height - panel_height));
  const Area panel{right - panel_width, top, right, top + panel_height};
  fillRounded(image, panel, 0.8F * h, kPanel, kPanelOpacity);

  const Area bar{std::round(panel.left + 1.2F * h), std::round(panel.top + 4.6F * h),
                 std::round(panel.left + 1.2F * h) + bar_width,
                 std::round(panel.top + 4.6F * h + bar_height)};
  drawText(image, {bar.left, panel.top + 2.7F * h}, h, scale.unit, kInk);
  drawBar(image, bar, scale);
  for (const auto& tick : scale.ticks) {
    const float y = bar.bottom - tick.place * (bar.bottom - bar.top);
    drawLine(image, {bar.right + 0.25F * h, y}, {bar.right + 0.7F * h, y}, strokeWidth(h), kInk);
    drawText(image, {bar.right + 1.3F * h, y + 0.5F * h}, h, tick.label, kInk);
  }
}

void drawTitle(scene::Image& image, const std::string& title) {
  if (title.empty() || image.width < kSmallest || image.height < kSmallest) return;
  const float h = textHeight(image);
  const float margin = std::round(1.2F * h);
  const float bottom = static_cast<float>(image.height) - margin;
  const float width =
      std::min(textWidth(title, h) + 2.0F * h, static_cast<float>(image.width) - 2.0F * margin);
  fillRounded(image, {margin, bottom - 2.6F * h, margin + width, bottom}, 0.6F * h, kPanel,
              kPanelOpacity);
  drawText(image, {margin + h, bottom - 0.8F * h}, h, title, kInk);
}

}  // namespace soffit::render
