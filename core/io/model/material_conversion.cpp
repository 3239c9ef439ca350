// SPDX-License-Identifier: MIT
#include "core/io/model/material_conversion.h"

#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/io/model/model_path.h"

namespace soffit::io {
namespace {

std::optional<double> number(const aiMaterial& m, const char* key, unsigned type, unsigned index) {
  ai_real value = 0;
  if (m.Get(key, type, index, value) != AI_SUCCESS || !std::isfinite(value)) return std::nullopt;
  return static_cast<double>(value);
}

std::optional<dvec3> color(const aiMaterial& m, const char* key, unsigned type, unsigned index) {
  aiColor3D value;
  if (m.Get(key, type, index, value) != AI_SUCCESS) return std::nullopt;
  const dvec3 c(value.r, value.g, value.b);
  if (!isFinite(c)) return std::nullopt;
  return c;
}

double luminance(const dvec3& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

double largest(const dvec3& c) {
  return std::max({c.x, c.y, c.z});
}

// GGX alpha of a Blinn-Phong exponent: alpha^2 = 2 / (n + 2) (Walter et al. 2007, eq. 36's
// neighborhood); roughness is its root.
double roughnessOfExponent(double exponent) {
  return std::pow(2.0 / (std::max(exponent, 0.0) + 2.0), 0.25);
}

bool hasTexture(const aiMaterial& m, aiTextureType type) {
  return m.GetTextureCount(type) > 0;
}

// The highlight of a Phong material. Its specular color is an artist's strength of highlights, by
// convention 1 for 8 % at normal incidence (0.5: glass and plastic), unless the library asks for
// ray-traced reflection (illum 3 and above): then it is the reflectance.
void readPhong(const aiMaterial& m, scene::Material& out) {
  constexpr double kConvention = 0.08;
  constexpr double kVisible = 0.005;
  int illum = 2;
  m.Get("$mat.illum", 0, 0, illum);
  const double strength = luminance(color(m, AI_MATKEY_COLOR_SPECULAR).value_or(dvec3(0.0)));
  const double specular = illum >= 3 ? strength : kConvention * std::clamp(strength, 0.0, 1.0);
  if (illum < 2 || specular < kVisible) return;
  out.specular = specular;
  if (const auto exponent = number(m, AI_MATKEY_SHININESS)) {
    out.roughness = roughnessOfExponent(*exponent);
  }
  // A map is multiplied by the factor; without one it speaks for itself.
  if (!out.roughness_map.empty()) out.roughness = 1.0;
  if (const auto roughness = number(m, AI_MATKEY_ROUGHNESS_FACTOR)) out.roughness = *roughness;
}

// glTF's metallic-roughness model. The texture's roughness is read (roughness_map); where it could
// say which parts are metal, none is.
void readMetallicRoughness(const aiMaterial& m, ConvertedMaterial& out) {
  const dvec3 base = out.material.diffuse;
  const bool textured = hasTexture(m, aiTextureType_METALNESS) ||
                        hasTexture(m, aiTextureType_DIFFUSE_ROUGHNESS) ||
                        hasTexture(m, aiTextureType_UNKNOWN);
  double metallic = std::clamp(number(m, AI_MATKEY_METALLIC_FACTOR).value_or(1.0), 0.0, 1.0);
  double roughness = std::clamp(number(m, AI_MATKEY_ROUGHNESS_FACTOR).value_or(1.0), 0.0, 1.0);
  // All defaults: a file that says nothing, not a mirror-white metal.
  if (base == dvec3(1.0) && metallic == 1.0 && roughness == 1.0 && !textured) {
    out.described = hasTexture(m, aiTextureType_BASE_COLOR);
    metallic = 0.0;
  }
  if (textured && metallic > 0.0) {
    metallic = 0.0;
    out.warnings.push_back("its metal texture is not read; taken as no metal");
  }
  const bool mapped = !out.material.roughness_map.empty();
  if (textured && !mapped) roughness = 0.5;
  constexpr double kDielectric = 0.04;
  constexpr double kMatte = 0.95;  // from here on the lobe is as wide as a diffuse one
  out.material.diffuse = base * (1.0 - metallic);
  out.material.specular = kDielectric * (1.0 - metallic) + luminance(base) * metallic;
  if (metallic == 0.0 && roughness > kMatte && !mapped) out.material.specular = 0.0;
  if (out.material.specular > 0.0) out.material.roughness = roughness;
}

double opacityOf(const aiMaterial& m, const MaterialContext& context) {
  if (const auto transmission = number(m, AI_MATKEY_TRANSMISSION_FACTOR)) {
    if (*transmission > 0.5) return 0.0;
  }
  aiString mode;
  if (context.format == ModelFormat::kGltf &&
      (m.Get("$mat.gltf.alphaMode", 0, 0, mode) != AI_SUCCESS ||
       std::string_view(mode.C_Str()) != "BLEND")) {
    return 1.0;  // the alpha of an opaque material means nothing
  }
  return number(m, AI_MATKEY_OPACITY).value_or(1.0);
}

// A texture inside the file, as a path beside the model.
std::string embeddedPath(const aiTexture& texture, std::size_t index,
                         const MaterialContext& context, std::vector<EmbeddedTexture>& embedded) {
  std::string kind(texture.achFormatHint);
  if (kind != "png" && kind != "jpg") kind = kind == "jpeg" ? "jpg" : "png";
  std::string path =
      fmt::format("{}_texture{}.{}", context.file.stem().string(), index, kind);
  const auto known = [&](const EmbeddedTexture& e) { return e.path == path; };
  if (std::none_of(embedded.begin(), embedded.end(), known)) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(texture.pcData);
    embedded.push_back({path, {bytes, bytes + texture.mWidth}});
  }
  return path;
}

std::string texturePath(const aiMaterial& m, aiTextureType type, const MaterialContext& context,
                        std::vector<EmbeddedTexture>& embedded,
                        std::vector<std::string>& warnings) {
  aiString name;
  if (m.GetTexture(type, 0, &name) != AI_SUCCESS || name.length == 0) return {};
  const auto [texture, index] = context.scene.GetEmbeddedTextureAndIndex(name.C_Str());
  if (texture == nullptr) {
    TexturePath found = findTexture(name.C_Str(), context.file, context.folder);
    if (!found.problem.empty()) warnings.push_back(std::move(found.problem));
    return found.relative;
  }
  if (texture->mHeight == 0 && texture->pcData != nullptr) {
    return embeddedPath(*texture, static_cast<std::size_t>(index), context, embedded);
  }
  warnings.push_back(
      fmt::format("texture '{}' is stored without a file format and not read", name.C_Str()));
  return {};
}

void readTextures(const aiMaterial& m, const MaterialContext& context,
                  std::vector<EmbeddedTexture>& embedded, ConvertedMaterial& out) {
  const auto find = [&](std::initializer_list<aiTextureType> types) {
    for (const aiTextureType type : types) {
      if (hasTexture(m, type)) return texturePath(m, type, context, embedded, out.warnings);
    }
    return std::string();
  };
  out.material.diffuse_map = find({aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
  // A bump map is heights, not normals: only what is called a normal map is one.
  out.material.normal_map = find({aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA});
  // glTF's one picture of roughness (green) and metal (blue) is "unknown" to Assimp 5.2.
  out.material.roughness_map = context.format == ModelFormat::kGltf
                                   ? find({aiTextureType_DIFFUSE_ROUGHNESS, aiTextureType_UNKNOWN})
                                   : find({aiTextureType_DIFFUSE_ROUGHNESS});
}

// Names that importers make up where a file has no material.
bool isMadeUp(const std::string& name, ModelFormat format) {
  if (name == AI_DEFAULT_MATERIAL_NAME || name == "<IFCDefault>" || name == "%%%DEFAULT") {
    return true;
  }
  return format == ModelFormat::kStl || (format == ModelFormat::kPly && name.empty());
}

// Albedos within 0..1 and their sum at most 1.
void keepEnergy(ConvertedMaterial& out) {
  scene::Material& m = out.material;
  if (largest(m.diffuse) > 1.0) out.warnings.push_back("its color is above 1 and was cut to 1");
  m.diffuse = glm::clamp(m.diffuse, dvec3(0.0), dvec3(1.0));
  m.specular = std::clamp(m.specular, 0.0, 1.0 - largest(m.diffuse));
  m.roughness = std::clamp(m.roughness, 0.0, 1.0);
}

}  // namespace

ConvertedMaterial convertMaterial(const aiMaterial& source, const MaterialContext& context,
                                  std::vector<EmbeddedTexture>& embedded) {
  ConvertedMaterial out;
  out.material.name = source.GetName().C_Str();
  const bool made_up = isMadeUp(out.material.name, context.format);
  if (made_up || out.material.name.empty()) out.material.name = "default";
  if (made_up) return out;
  const bool is_obj = context.format == ModelFormat::kObj;
  const bool is_gltf = context.format == ModelFormat::kGltf;
  auto diffuse = is_gltf ? color(source, AI_MATKEY_BASE_COLOR) : std::nullopt;
  if (!diffuse) diffuse = color(source, AI_MATKEY_COLOR_DIFFUSE);
  if (is_obj && !context.mtl_colors.contains(out.material.name)) diffuse.reset();
  readTextures(source, context, embedded, out);
  out.described = diffuse.has_value() || !out.material.diffuse_map.empty();
  // A texture alone is the color; nothing at all is the grey of a scene::Material.
  if (diffuse || out.described) out.material.diffuse = diffuse.value_or(dvec3(1.0));
  if (is_gltf) {
    readMetallicRoughness(source, out);
    if (!out.described) out.material.diffuse = dvec3(0.5);
  } else {
    readPhong(source, out.material);
  }
  if (opacityOf(source, context) < 0.5) out.material.glass = scene::Glass{};
  keepEnergy(out);
  return out;
}

}  // namespace soffit::io
