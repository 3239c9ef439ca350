// SPDX-License-Identifier: MIT
#include "core/render/pen.h"

#include "core/render/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soffit::render {
namespace {

/// The pixels that a rectangle touches.
struct Pixels {
  int x0, y0, x1, y1;
};

Pixels touched(const scene::Image& image, const Area& a) {
  const auto cut = [](float v, int most) {
    return static_cast<int>(std::clamp(v, 0.0F, static_cast<float>(most)));
  };
  return {cut(std::floor(a.left), image.width), cut(std::floor(a.top), image.height),
          cut(std::ceil(a.right), image.width), cut(std::ceil(a.bottom), image.height)};
}

void blend(scene::Image& image, int x, int y, const vec3& color, float opacity) {
  const auto at = static_cast<std::size_t>((y * image.width + x) * 3);
  for (std::size_t c = 0; c < 3; ++c) {
    float& v = image.pixels[at + c];
    v += opacity * (color[static_cast<int>(c)] - v);
  }
}

float distanceToSegment(const vec2& p, const vec2& a, const vec2& b) {
  const vec2 d = b - a;
  const float length2 = glm::dot(d, d);
  const float t = length2 > 0.0F ? std::clamp(glm::dot(p - a, d) / length2, 0.0F, 1.0F) : 0.0F;
  return glm::length(p - a - t * d);
}

/// How much of a pixel a shape covers, from the signed distance of its centre to the shape's edge.
float coverage(float distance) {
  return std::clamp(0.5F - distance, 0.0F, 1.0F);
}

/// Blends segments as one shape: where they overlap the colour is not laid on twice.
void drawSegments(scene::Image& image, const std::vector<Stroke>& segments, float width,
                  const vec3& color, float opacity) {
  const float reach = 0.5F * width + 1.0F;
  Area bounds{1e9F, 1e9F, -1e9F, -1e9F};
  for (const Stroke& s : segments) {
    bounds = {std::min({bounds.left, s.a.x - reach, s.b.x - reach}),
              std::min({bounds.top, s.a.y - reach, s.b.y - reach}),
              std::max({bounds.right, s.a.x + reach, s.b.x + reach}),
              std::max({bounds.bottom, s.a.y + reach, s.b.y + reach})};
  }
  const Pixels box = touched(image, bounds);
  const int columns = box.x1 - box.x0;
  if (columns <= 0 || box.y1 <= box.y0) return;
  std::vector<float> mask(static_cast<std::size_t>(columns * (box.y1 - box.y0)), 0.0F);
  for (const Stroke& s : segments) {
    const Pixels p =
        touched(image, {std::min(s.a.x, s.b.x) - reach, std::min(s.a.y, s.b.y) - reach,
                        std::max(s.a.x, s.b.x) + reach, std::max(s.a.y, s.b.y) + reach});
    for (int y = p.y0; y < p.y1; ++y) {
      for (int x = p.x0; x < p.x1; ++x) {
        const vec2 center(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
        float& m = mask[static_cast<std::size_t>((y - box.y0) * columns + x - box.x0)];
        m = std::max(m, coverage(distanceToSegment(center, s.a, s.b) - 0.5F * width));
      }
    }
  }
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const float m = mask[static_cast<std::size_t>((y - box.y0) * columns + x - box.x0)];
      if (m > 0.0F) blend(image, x, y, color, opacity * m);
    }
  }
}

}  // namespace

void fillRounded(scene::Image& image, const Area& area, float radius, const vec3& color,
                 float opacity) {
  const vec2 center(0.5F * (area.left + area.right), 0.5F * (area.top + area.bottom));
  const vec2 half = vec2(area.right, area.bottom) - center;
  radius = std::min({radius, half.x, half.y});
  const Pixels box = touched(image, area);
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      const vec2 q = glm::abs(p - center) - half + radius;
      const float distance =
          glm::length(glm::max(q, vec2(0.0F))) + std::min(std::max(q.x, q.y), 0.0F) - radius;
      blend(image, x, y, color, opacity * coverage(distance));
    }
  }
}

void drawLine(scene::Image& image, const vec2& from, const vec2& to, float width, const vec3& color,
              float opacity) {
  drawSegments(image, {{from, to}}, width, color, opacity);
}

float strokeWidth(float height) {
  return std::max(1.0F, 0.125F * height);
}

void drawText(scene::Image& image, const vec2& at, float height, std::string_view text,
              const vec3& color) {
  StrokeText laid = layOut(text);
  const float scale = height / kCapHeight;
  for (Stroke& s : laid.strokes) {
    s = {at + scale * vec2(s.a.x, -s.a.y), at + scale * vec2(s.b.x, -s.b.y)};
  }
  drawSegments(image, laid.strokes, strokeWidth(height), color, 1.0F);
}

float textWidth(std::string_view text, float height) {
  return layOut(text).width * height / kCapHeight;
}

}  // namespace soffit::render
