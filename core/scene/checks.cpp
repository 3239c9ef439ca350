// SPDX-License-Identifier: MIT
#include "core/scene/checks.h"

#include "core/light/emitter.h"
#include "core/scene/edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace soffit::scene {
namespace {

constexpr std::int64_t kMostPoints = 10'000'000;

Error vectorFault(const char* field) {
  return {field, "expected finite numbers", "Correct the numbers."};
}

Error placeFault(const char* field, const dvec3& p) {
  if (!isFinite(p)) return vectorFault(field);
  return {field, fmt::format("expected coordinates within {:g} m of the origin", kFarthest),
          "Correct the numbers; they are metres."};
}

bool inUnitRange(double x) {
  return x >= 0.0 && x <= 1.0;
}  // false for NaN

Error rangeFault(const char* field, double found) {
  return {field, fmt::format("expected a number from 0 to 1, found {}", found),
          "Correct the number."};
}

Result<void> checkGlass(const Glass& glass) {
  if (!std::isfinite(glass.index) || glass.index < 1.0 || glass.index > 5.0) {
    return Error{"glass.index",
                 fmt::format("expected a refractive index from 1 to 5, found {}", glass.index),
                 "Window glass has 1.52."};
  }
  if (!inUnitRange(glass.transmittance)) {
    return rangeFault("glass.transmittance", glass.transmittance);
  }
  return {};
}

/// Collects faults and puts the way to the faulty part before their place.
class Faults {
 public:
  void add(std::string_view prefix, const Result<void>& result) {
    if (result) return;
    Error fault = result.error();
    fault.place = fmt::format("{}.{}", prefix, fault.place);
    list_.push_back(std::move(fault));
  }
  void add(Error fault) { list_.push_back(std::move(fault)); }
  /// `name` is empty or occurred before among `seen`.
  void checkName(std::string_view kind, std::size_t index, const std::string& name,
                 std::set<std::string>& seen) {
    if (name.empty()) {
      add({fmt::format("{}[{}].name", kind, index), "the name is empty", "Give it a name."});
    } else if (!seen.insert(name).second) {
      add({fmt::format("{}[{}].name", kind, index), fmt::format("the name '{}' occurs twice", name),
           "Names must be unique: rename one."});
    }
  }
  std::vector<Error> take() { return std::move(list_); }

 private:
  std::vector<Error> list_;
};

/// The fault of an emitter, its place below `prefix` in place of "luminaires.NAME.".
void checkLuminaire(const light::Luminaire& luminaire, std::string_view prefix, Faults& faults) {
  const auto emitter = light::makeEmitter(luminaire);
  if (emitter) {
    if (!isPlace(luminaire.position)) {
      faults.add(prefix, placeFault("position", luminaire.position));
    }
    return;
  }
  Error fault = emitter.error();
  const std::string usual = fmt::format("luminaires.{}.", luminaire.name);
  if (fault.place.starts_with(usual)) fault.place.erase(0, usual.size());
  fault.place = fmt::format("{}.{}", prefix, fault.place);
  faults.add(std::move(fault));
}

void checkLuminaires(const Scene& scene, Faults& faults) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
    const light::Luminaire& luminaire = scene.luminaires[i];
    faults.checkName("luminaires", i, luminaire.name, names);
    checkLuminaire(luminaire, fmt::format("luminaires.{}", luminaire.name), faults);
  }
}

void checkLayouts(const Scene& scene, Faults& faults) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < scene.layouts.size(); ++i) {
    const Layout& layout = scene.layouts[i];
    faults.checkName("layouts", i, layout.name, names);
    for (const auto& [name, edit] : layout.edits) {
      const std::string prefix = fmt::format("layouts.{}.luminaires.{}", layout.name, name);
      const light::Luminaire* base = findLuminaire(scene, name);
      light::Luminaire own;
      own.name = name;
      checkLuminaire(applyEdit(base != nullptr ? *base : own, edit), prefix, faults);
    }
  }
}

void checkMesh(const Scene& scene, Faults& faults) {
  if (scene.mesh == nullptr) {
    faults.add({"geometry", "the scene has no mesh", "Give it one, even if it is empty."});
    return;
  }
  const geometry::Mesh& mesh = *scene.mesh;
  const auto corners = static_cast<std::uint32_t>(mesh.positions.size());
  const bool indices_ok = std::ranges::all_of(mesh.triangles, [&](const uvec3& t) {
    return t.x < corners && t.y < corners && t.z < corners;
  });
  const bool finite = std::ranges::all_of(mesh.positions, [](const vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
  const bool materials_ok = mesh.material_of.size() == mesh.triangles.size() &&
                            std::ranges::all_of(mesh.material_of, [&](std::uint32_t m) {
                              return m < scene.materials.size();
                            });
  if (!indices_ok || !finite || !materials_ok || !isFinite(mesh.origin)) {
    faults.add({"geometry", "the mesh is damaged (indices, materials or coordinates)",
                "Export the geometry again."});
  }
}

void checkQuality(const Quality& quality, Faults& faults) {
  if (quality.preset != "draft" && quality.preset != "interactive" && quality.preset != "final") {
    faults.add({"quality",
                fmt::format("expected draft, interactive or final, found '{}'", quality.preset),
                "Choose one of the three."});
  }
  for (const auto& [name, value] : quality.settings) {
    if (!std::isfinite(value)) faults.add(vectorFault(("quality." + name).c_str()));
  }
}

}  // namespace

Result<void> checkMaterial(const Material& material) {
  const dvec3& d = material.diffuse;
  for (int k = 0; k < 3; ++k) {
    if (!inUnitRange(d[k])) return rangeFault("diffuse", d[k]);
  }
  if (!inUnitRange(material.specular)) return rangeFault("specular", material.specular);
  if (!inUnitRange(material.roughness)) return rangeFault("roughness", material.roughness);
  // A sum that is 1 in decimals (0.7 + 0.3) may exceed 1 by the rounding of its two terms.
  constexpr double kRoundoff = 4e-16;
  const double sum = std::max({d.x, d.y, d.z}) + material.specular;
  if (sum > 1.0 + kRoundoff) {
    return Error{"specular",
                 fmt::format("diffuse and specular together reflect {:.6g}, more than 1", sum),
                 "Lower one of them."};
  }
  if (material.glass) return checkGlass(*material.glass);
  return {};
}

bool isPlace(const dvec3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kFarthest && isFinite(p);
}

Result<void> checkCamera(const Camera& camera) {
  if (!isPlace(camera.position)) return placeFault("position", camera.position);
  if (!isPlace(camera.target)) return placeFault("target", camera.target);
  if (camera.position == camera.target) {
    return Error{"target", "the target is where the camera stands", "Move one of them."};
  }
  const double fov = camera.vertical_fov_deg;
  if (!(fov >= 0.1 && fov <= 175.0)) {
    return Error{"vertical_fov", fmt::format("expected degrees from 0.1 to 175, found {}", fov),
                 "A room is usually shown with 40 to 70."};
  }
  return {};
}

Result<void> checkWorkPlane(const WorkPlane& plane) {
  if (!isPlace(plane.origin)) return placeFault("origin", plane.origin);
  if (!isPlace(plane.u)) return placeFault("u", plane.u);
  if (!isPlace(plane.v)) return placeFault("v", plane.v);
  const double area = glm::length(glm::cross(plane.u, plane.v));
  // Relative to the sides: parallel sides leave no area but rounding.
  const double sides = glm::length(plane.u) * glm::length(plane.v);
  if (!(sides > 0.0) || !std::isfinite(sides) || area < 1e-9 * sides) {
    return Error{"u", "u and v span no area", "Give both a length, in different directions."};
  }
  if (plane.nu < 1 || plane.nv < 1 || std::int64_t{plane.nu} * plane.nv > kMostPoints) {
    return Error{"grid",
                 fmt::format("expected two counts from 1 and at most {} points, found {} x {}",
                             kMostPoints, plane.nu, plane.nv),
                 "Correct the counts."};
  }
  return {};
}

double losslessTransmittance(double index) {
  const double amplitude = (index - 1.0) / (index + 1.0);
  const double reflectance = amplitude * amplitude;
  return (1.0 - reflectance) / (1.0 + reflectance);
}

std::vector<Error> findFaults(const Scene& scene) {
  Faults faults;
  checkMesh(scene, faults);
  std::set<std::string> materials;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    faults.checkName("materials", i, material.name, materials);
    faults.add(fmt::format("materials.{}", material.name), checkMaterial(material));
  }
  checkLuminaires(scene, faults);
  checkLayouts(scene, faults);
  std::set<std::string> cameras;
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    faults.checkName("cameras", i, scene.cameras[i].name, cameras);
    faults.add(fmt::format("cameras.{}", scene.cameras[i].name), checkCamera(scene.cameras[i]));
  }
  std::set<std::string> planes;
  for (std::size_t i = 0; i < scene.work_planes.size(); ++i) {
    const WorkPlane& plane = scene.work_planes[i];
    faults.checkName("work_planes", i, plane.name, planes);
    faults.add(fmt::format("work_planes.{}", plane.name), checkWorkPlane(plane));
  }
  if (!std::isfinite(scene.view.exposure)) faults.add(vectorFault("view.exposure"));
  checkQuality(scene.quality, faults);
  return faults.take();
}

}  // namespace soffit::scene
