// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// render::LitProbes::reflected() for a graphics card, formula by formula (GLSL 1.50).
namespace soffit::ui {

/// Attributes position, normal, gloss (f0, alpha); uniform mat4 clip_from_scene, which must give
/// the very depth of the building's own shader.
const char* reflectionVertexShader();

/// Uniforms: vec4 eye (place and 1, or direction and 0); int probe_count; vec3 probe[]; vec3
/// room_lo, room_hi; int side (of the depths); int level_count; int level_side[], level_row[]
/// (first row in the atlas); vec2 atlas. Textures: sampler2DArray maps (layer 6 i + face of probe
/// i: the levels one under the other, with their rims), depths (the same layers: 1/z, with rims),
/// sights (the same layers: glossy::ProbeSight),
/// lobes (layers base and rise of glossy::lobeTable()), lamps (render::LampMap, six layers each);
/// int lamp_count; vec4 lamp[] (place, radius); vec3 lamp_color[]. Writes light to be added, 0 to
/// alpha.
std::string reflectionFragmentShader();

/// Most probes, levels and lamps that the shader has room for.
inline constexpr int kMostShaderProbes = 16;
inline constexpr int kMostShaderLevels = 20;
inline constexpr int kMostShaderLamps = 64;

}  // namespace soffit::ui
