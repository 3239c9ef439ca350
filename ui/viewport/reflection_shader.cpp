// SPDX-License-Identifier: MIT
#include "ui/viewport/reflection_shader.h"

#include "core/glossy/lobe_shape.h"
#include "core/glossy/parallax.h"
#include "core/glossy/reflection_map.h"
#include "core/render/lit_probes.h"

#include <fmt/format.h>

namespace soffit::ui {
namespace {

constexpr const char* kVertex = R"(#version 150
invariant gl_Position;
in vec3 position;
in vec3 normal;
in vec2 gloss;
in vec2 uv;
uniform mat4 clip_from_scene;
out vec3 place;
out vec3 facing;
flat out vec2 lobe;
out vec2 picture;
void main() {
  gl_Position = clip_from_scene * vec4(position, 1.0);
  place = position;
  facing = normal;
  lobe = gloss;
  picture = uv;
}
)";

/// Names and formulas follow core/glossy and core/render/lit_probes.cpp.
constexpr const char* kBody = R"(
in vec3 place;
in vec3 facing;
flat in vec2 lobe;
in vec2 picture;
uniform int mapped;
uniform sampler2D roughness_map;
uniform vec4 eye;
uniform int probe_count;
uniform vec3 probe[MOST_PROBES];
uniform vec3 room_lo;
uniform vec3 room_hi;
uniform int side;
uniform int level_count;
uniform int level_side[MOST_LEVELS];
uniform int level_row[MOST_LEVELS];
uniform vec2 atlas;
uniform sampler2DArray maps;
uniform sampler2DArray depths;
uniform sampler2DArray sights;
uniform sampler2DArray lobes;
uniform sampler2DArray lamps;
uniform int lamp_count;
uniform vec4 lamp[MOST_LAMPS];
uniform vec3 lamp_color[MOST_LAMPS];
out vec4 color;

// u, v and the face (core/sh/cube_map.h).
vec3 cubePoint(vec3 d) {
  vec3 s = abs(d);
  if (s.x >= s.y && s.x >= s.z) {
    return d.x >= 0.0 ? vec3(-d.y / s.x, -d.z / s.x, 0.0) : vec3(d.y / s.x, -d.z / s.x, 1.0);
  }
  if (s.y >= s.z) {
    return d.y >= 0.0 ? vec3(d.x / s.y, -d.z / s.y, 2.0) : vec3(-d.x / s.y, -d.z / s.y, 3.0);
  }
  return d.z >= 0.0 ? vec3(d.x / s.z, d.y / s.z, 4.0) : vec3(d.x / s.z, -d.y / s.z, 5.0);
}

float toward(int i, vec3 d) {
  vec3 c = cubePoint(d);
  float n = float(side);
  vec2 at = clamp(0.5 * (c.xy + 1.0) * n - 0.5, vec2(-0.5), vec2(n - 0.5)) + 1.5;
  float inverse = texture(depths, vec3(at / (n + 2.0), float(6 * i) + c.z)).r;
  return sqrt(1.0 + dot(c.xy, c.xy)) / max(inverse, 1.0e-30);
}

// core/glossy/probe_sight.h
float sight(int i, vec3 d, float away) {
  vec3 c = cubePoint(d);
  vec2 at = clamp(0.5 * (c.xy + 1.0) * SIGHT_SIDE - 0.5, vec2(-0.5), vec2(SIGHT_SIDE - 0.5)) + 1.5;
  vec2 m = texture(sights, vec3(at / (SIGHT_SIDE + 2.0), float(6 * i) + c.z)).rg;
  float excess = SIGHT_SHARE * away - m.x;
  if (excess <= 0.0) return 1.0;
  float least = SIGHT_DEVIATION * away;
  float variance = max(m.y - m.x * m.x, least * least);
  return smoothstep(SIGHT_HIDDEN, 1.0, variance / (variance + excess * excess));
}

float behind(int i, vec3 p, vec3 d, float t) {
  vec3 v = p + t * d - probe[i];
  float distance = length(v);
  return distance > 0.0 ? distance * (1.0 - ON_SURFACE) - toward(i, v) : -1.0;
}

float reach(int i, vec3 p, vec3 d, float far) {
  float before = 0.0;
  float step_start = behind(i, p, d, 0.0);
  for (int k = 1; k <= STEPS; ++k) {
    float share = float(k) / float(STEPS);
    float t = far * share * sqrt(share);
    float now = behind(i, p, d, t);
    if (now > 0.0 && step_start <= 0.0) {
      float low = before, high = t;
      for (int b = 0; b < BISECTIONS; ++b) {
        float middle = 0.5 * (low + high);
        if (behind(i, p, d, middle) > 0.0) high = middle; else low = middle;
      }
      if (behind(i, p, d, high + BEYOND) < MOST_BEHIND) return 0.5 * (low + high);
    }
    before = t;
    step_start = now;
  }
  return far;
}

float distanceToRoom(vec3 p, vec3 d) {
  if (any(lessThan(p, room_lo - 1.0e-3)) || any(greaterThan(p, room_hi + 1.0e-3))) {
    return distance(room_lo, room_hi);
  }
  float nearest = 3.0e38;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0.0) continue;
    float wall = d[axis] > 0.0 ? room_hi[axis] : room_lo[axis];
    nearest = min(nearest, max(0.0, (wall - p[axis]) / d[axis]));
  }
  return nearest;
}

vec3 level(int i, int k, vec3 c) {
  float n = float(level_side[k]);
  vec2 at = clamp(0.5 * (c.xy + 1.0) * n - 0.5, vec2(-0.5), vec2(n - 0.5)) + 1.5;
  at.y += float(level_row[k]);
  return texture(maps, vec3(at / atlas, float(6 * i) + c.z)).rgb;
}

vec3 blurred(int i, vec3 d, float alpha) {
  float place = 1.0 + STEPS_PER_OCTAVE * log2(max(alpha, 1.0e-4) / SHARPEST);
  place = clamp(place, 0.0, float(level_count - 1));
  int k = min(int(place), level_count - 2);
  vec3 c = cubePoint(d);
  return mix(level(i, k, c), level(i, k + 1, c), place - float(k));
}

// The direction of a round lobe whose axis has this sine from the normal.
vec3 axisOf(float sine, vec3 n, vec3 to_eye) {
  vec3 along = dot(to_eye, n) * n - to_eye;
  float size = length(along);
  if (size < 1.0e-6) return n;
  return sine / size * along + sqrt(max(0.0, 1.0 - sine * sine)) * n;
}

float smithLambda(float cosine, float alpha) {
  float cos2 = cosine * cosine;
  float tan2 = max(0.0, 1.0 - cos2) / cos2;
  return 0.5 * (sqrt(1.0 + alpha * alpha * tan2) - 1.0);
}

// lit_lamp.cpp, microfacet.cpp.
vec3 highlight(int i, vec3 p, vec3 n, vec3 to_eye, float f0, float alpha) {
  vec3 away = p - lamp[i].xyz;
  float r = max(length(away), 1.0e-4);
  vec3 wi = -away / r;
  float cos_i = dot(wi, n), cos_o = dot(to_eye, n);
  if (cos_i <= 0.0 || cos_o <= 0.0) return vec3(0.0);
  vec3 c = cubePoint(away);
  vec2 at = clamp(0.5 * (c.xy + 1.0) * LAMP_SIDE - 0.5, vec2(-0.5), vec2(LAMP_SIDE - 0.5)) + 1.5;
  vec2 seen = texture(lamps, vec3(at / (LAMP_SIDE + 2.0), float(6 * i) + c.z)).rg;
  float reach = sqrt(1.0 + dot(c.xy, c.xy)) / max(seen.r, 1.0e-30);
  float lit = 1.0 - smoothstep(LAMP_SEEN * (r + 1.0), LAMP_HIDDEN * (r + 1.0), r - reach);
  if (lit * seen.g <= 0.0) return vec3(0.0);
  float spread = lamp[i].w / r;
  float wide = clamp(sqrt(alpha * alpha + SPREAD * spread * spread), MIRROR_ALPHA, 1.0);
  float near = max(r, lamp[i].w);
  vec3 h = normalize(to_eye + wi);
  float cos_h = dot(h, n);
  if (cos_h <= 0.0) return vec3(0.0);
  float a2 = wide * wide;
  float d = (1.0 - cos_h) * (1.0 + cos_h) + a2 * cos_h * cos_h;
  float density = a2 / (PI * d * d);
  float shadowing = 1.0 / (1.0 + smithLambda(cos_o, wide) + smithLambda(cos_i, wide));
  float m = clamp(1.0 - dot(to_eye, h), 0.0, 1.0);
  float fresnel = f0 + (1.0 - f0) * m * m * m * m * m;
  return lit * seen.g / (near * near) * density * shadowing * fresnel / (4.0 * cos_o) *
         lamp_color[i];
}

void main() {
  vec3 p = place;
  vec3 n = normalize(facing);
  vec3 to_eye = normalize(eye.xyz - eye.w * p);
  float cosine = dot(n, to_eye);
  if (cosine < LEAST_COSINE) {
    n = normalize(n + (LEAST_COSINE - cosine) * to_eye);
    cosine = dot(n, to_eye);
  }
  float f0 = lobe.x, alpha = lobe.y;
  if (mapped == 1) {  // core/render/surface_sample.h
    float share = texture(roughness_map, vec2(picture.x, 1.0 - picture.y)).g;
    alpha = max(alpha * share * share, min(alpha, MIRROR_ALPHA));
  }
  cosine = clamp(cosine, TABLE_COSINE, 1.0);
  vec4 base, rise;  // weight, sine of the axis, alpha
  float sine = sqrt(max(1.0e-12, (1.0 - cosine) * (1.0 + cosine)));
  if (alpha < MIRROR_ALPHA) {
    float schlick = pow(1.0 - cosine, 5.0);
    base = vec4(1.0 - schlick, sine, MIRROR_ALPHA, 1.0);
    rise = vec4(schlick, sine, MIRROR_ALPHA, 1.0);
  } else {
    alpha = min(alpha, 1.0);
    vec2 at = vec2(sqrt((cosine - TABLE_COSINE) / (1.0 - TABLE_COSINE)),
                   (sqrt(alpha) - TABLE_ROUGHNESS) / (1.0 - TABLE_ROUGHNESS));
    at = (at * (TABLE_NODES - 1.0) + 0.5) / TABLE_NODES;
    base = texture(lobes, vec3(at, 0.0));
    rise = texture(lobes, vec3(at, 1.0));
    base.yz = min(vec2(1.0), base.yz * vec2(sine, alpha));
    rise.yz = min(vec2(1.0), rise.yz * vec2(sine, alpha));
  }
  base.x *= f0;
  vec3 base_axis = axisOf(base.y, n, to_eye), rise_axis = axisOf(rise.y, n, to_eye);
  vec3 axis = normalize(base.x * base_axis + rise.x * rise_axis);
  float far = distanceToRoom(p, axis);

  vec4 weight = vec4(0.0);  // of those that take part, in falling order, and of the next
  ivec4 which = ivec4(-1);
  float near_weight = -1.0;
  int nearest = 0;
  for (int i = 0; i < probe_count; ++i) {
    vec3 d = p - probe[i];
    float away = length(d);
    float w = 1.0 / (away * away + NEAR);
    if (dot(d, n) >= 0.0) continue;
    if (w > near_weight) {
      near_weight = w;
      nearest = i;
    }
    w *= sight(i, d, away);
    if (w > weight.x) {
      weight = vec4(w, weight.xyz);
      which = ivec4(i, which.xyz);
    } else if (w > weight.y) {
      weight.yzw = vec3(w, weight.yz);
      which.yzw = ivec3(i, which.yz);
    } else if (w > weight.z) {
      weight.zw = vec2(w, weight.z);
      which.zw = ivec2(i, which.z);
    } else if (w > weight.w) {
      weight.w = w;
    }
  }
  weight.xyz = max(vec3(0.0), weight.xyz - NEXT_SHARE * weight.w);
  if (which.x < 0 && near_weight > 0.0) {
    weight.x = near_weight;
    which.x = nearest;
  }
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 3; ++k) {
    int i = which[k];
    if (i < 0 || weight[k] <= 0.0) continue;
    float t = reach(i, p, axis, far);
    vec3 seen = p + t * base_axis - probe[i];
    float away = max(length(seen), 1.0e-6);
    sum += weight[k] * base.x * blurred(i, seen, min(base.z * t / away, 1.0));
    seen = p + t * rise_axis - probe[i];
    away = max(length(seen), 1.0e-6);
    sum += weight[k] * rise.x * blurred(i, seen, min(rise.z * t / away, 1.0));
  }
  sum /= max(weight.x + weight.y + weight.z, 1.0e-30);
  for (int i = 0; i < lamp_count; ++i) sum += highlight(i, p, n, to_eye, f0, alpha);
  color = vec4(sum, 0.0);
}
)";

}  // namespace

const char* reflectionVertexShader() {
  return kVertex;
}

std::string reflectionFragmentShader() {
  using glossy::ProbeDepth;
  using glossy::ReflectionMap;
  using render::LitProbes;
  static_assert(LitProbes::kMostAtOnce == 3);
  const glossy::LobeTable table = glossy::lobeTable();
  std::string text = "#version 150\n";
  const auto define = [&](const char* name, double value) {
    text += fmt::format("#define {} {:.9f}\n", name, value);
  };
  const auto defineInt = [&](const char* name, int value) {
    text += fmt::format("#define {} {}\n", name, value);
  };
  defineInt("MOST_PROBES", kMostShaderProbes);
  defineInt("MOST_LEVELS", kMostShaderLevels);
  defineInt("MOST_LAMPS", kMostShaderLamps);
  define("LAMP_SIDE", render::LampMap::kSide);
  define("PI", kPi);
  define("LAMP_SEEN", static_cast<double>(render::LitLamp::kSeen));
  define("LAMP_HIDDEN", static_cast<double>(render::LitLamp::kHidden));
  define("SPREAD", static_cast<double>(render::LitLamp::kSpread));
  defineInt("STEPS", ProbeDepth::kSteps);
  defineInt("BISECTIONS", ProbeDepth::kBisections);
  define("ON_SURFACE", static_cast<double>(ProbeDepth::kOnSurface));
  define("BEYOND", static_cast<double>(ProbeDepth::kBeyond));
  define("MOST_BEHIND", static_cast<double>(ProbeDepth::kMostBehind));
  define("SHARPEST", static_cast<double>(ReflectionMap::kSharpest));
  define("STEPS_PER_OCTAVE", ReflectionMap::kStepsPerOctave);
  define("NEXT_SHARE", static_cast<double>(LitProbes::kNextShare));
  define("SIGHT_SIDE", glossy::ProbeSight::kSide);
  define("SIGHT_SHARE", static_cast<double>(glossy::ProbeSight::kShare));
  define("SIGHT_DEVIATION", static_cast<double>(glossy::ProbeSight::kLeastDeviation));
  define("SIGHT_HIDDEN", static_cast<double>(glossy::ProbeSight::kHidden));
  define("NEAR", static_cast<double>(LitProbes::kNear));
  define("LEAST_COSINE", static_cast<double>(LitProbes::kLeastCosine));
  define("MIRROR_ALPHA", glossy::kMirrorAlpha);
  define("TABLE_COSINE", table.least_cosine);
  define("TABLE_ROUGHNESS", table.least_roughness);
  define("TABLE_NODES", static_cast<double>(table.nodes));
  return text + kBody;
}

}  // namespace soffit::ui
