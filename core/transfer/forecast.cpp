// SPDX-License-Identifier: MIT
#include "core/transfer/forecast.h"

#include "core/geometry/triangle_area.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"
#include "core/transfer/texel_plan.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

namespace soffit::transfer {
namespace {

constexpr int kPlaces = 200;
constexpr std::size_t kRaysAtPlace = 64;
constexpr int kRounds = 9;

/// Seconds of one core per ray of the samples' machine in an empty box: what the constants below
/// were fitted with.
constexpr double kBoxRay = 103e-9;
constexpr double kPerTriangle = 8.81e-5;  ///< s: laying out
constexpr double kPerNearRay = 1.205;     ///< in times of a ray: nodes and training fields
constexpr double kPerListRay = 0.308;     ///< likewise, per texel and ray of a list
/// s per near ray and training light beyond those of the fits.
constexpr double kPerTraining = 2.5e-9;
constexpr double kTrainings = 96.0;
constexpr double kPerTexel = 6.24e-5;     ///< s
constexpr double kPerRay = 4.64e-8;       ///< s beside the tracing
constexpr double kBytesPerTexel = 585.0;  ///< with the interactive quality's lists
constexpr double kListRays = 32.0;        ///< of that
constexpr double kListShare = 0.22;
constexpr double kBytesPower = 1.26;  ///< of the rays along one side of a list
constexpr double kTolerance = 0.05;

/// Cosine-distributed rays from places that are even over the lit surfaces, as a bake has them.
class Probe {
 public:
  explicit Probe(const StaticScene& scene) : scene_(scene) {
    double sum = 0.0;
    for (std::size_t t = 0; t < scene.mesh->triangles.size(); ++t) {
      if (scene.sides[t] != 0) sum += geometry::areaOf(*scene.mesh, t);
      cumulative_.push_back(sum);
    }
  }

  /// Seconds of one core per ray: the least of some rounds, which others disturb. 0 without lit
  /// surfaces.
  [[nodiscard]] double secondsPerRay() const {
    if (cumulative_.empty() || !(cumulative_.back() > 0.0)) return 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kRounds; ++round) least = std::min(least, time(round));
    return least;
  }

 private:
  [[nodiscard]] double time(int round) const {
    Rng rng(7, static_cast<std::uint64_t>(round));
    std::array<geometry::Ray, kRaysAtPlace> rays;
    std::array<geometry::Hit, kRaysAtPlace> hits;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kPlaces; ++i) {
      aim(rng, rays);
      scene_.caster.closest(rays, hits, false);
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return passed.count() / (kPlaces * static_cast<double>(kRaysAtPlace));
  }

  void aim(Rng& rng, std::span<geometry::Ray> rays) const {
    const double place = rng.uniformDouble() * cumulative_.back();
    const auto found = std::lower_bound(cumulative_.begin(), cumulative_.end(), place);
    const auto triangle =
        std::min(static_cast<std::size_t>(found - cumulative_.begin()), cumulative_.size() - 1);
    const geometry::Mesh& mesh = *scene_.mesh;
    const uvec3& t = mesh.triangles[triangle];
    const float root = std::sqrt(rng.uniform());
    const float share = rng.uniform();
    const vec3 p = (1.0F - root) * mesh.positions[t.x] +
                   root * (1.0F - share) * mesh.positions[t.y] + root * share * mesh.positions[t.z];
    const bool front = (scene_.sides[triangle] & kFront) != 0;
    const vec3 n = front ? scene_.normals[triangle] : -scene_.normals[triangle];
    vec3 a(0.0F);
    vec3 b(0.0F);
    orthonormalBasis(n, a, b);
    for (geometry::Ray& ray : rays) {
      const float r = std::sqrt(rng.uniform());
      const float phi = static_cast<float>(2.0 * kPi) * rng.uniform();
      ray = {};
      ray.origin = geometry::offsetOrigin(p, n);
      ray.direction = r * std::cos(phi) * a + r * std::sin(phi) * b +
                      std::sqrt(std::max(0.0F, 1.0F - r * r)) * n;
    }
  }

  const StaticScene& scene_;
  std::vector<double> cumulative_;
};

/// A closed box of twelve triangles, seen from inside.
std::shared_ptr<const StaticScene> emptyBox() {
  auto mesh = std::make_shared<geometry::Mesh>();
  for (int corner = 0; corner < 8; ++corner) {
    mesh->positions.emplace_back(3.0F * static_cast<float>(corner & 1),
                                 3.0F * static_cast<float>((corner >> 1) & 1),
                                 3.0F * static_cast<float>((corner >> 2) & 1));
  }
  mesh->triangles = {{0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}, {0, 5, 1}, {0, 4, 5},
                     {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  mesh->materials = {"box"};
  mesh->material_of.assign(mesh->triangles.size(), 0);
  return makeStaticScene(mesh, std::vector<vec3>{vec3(1.5F)});
}

}  // namespace

BakeForecast forecastBake(const StaticScene& scene, const BakeSettings& settings, int threads) {
  BakeForecast forecast;
  if (scene.mesh->triangles.empty()) return forecast;
  forecast.texels = planTexels(scene, settings).count;
  const double box = Probe(*emptyBox()).secondsPerRay();
  const double ray = Probe(scene).secondsPerRay();
  if (!(box > 0.0) || !(ray > 0.0)) return forecast;
  const double machine = box / kBoxRay;
  const double clutter = std::max(ray / box, 1.0);

  const auto texels = static_cast<double>(forecast.texels);
  const double near = settings.node_rays * settings.node_rays +
                      static_cast<double>(settings.field_rays) * settings.field_rays;
  const double list = static_cast<double>(settings.list_rays) * settings.list_rays;
  const double lists = settings.lists / kListShare;
  const double more_trainings = std::max(settings.trainings - kTrainings, 0.0);
  const double seconds =
      machine * (kPerTriangle * static_cast<double>(scene.mesh->triangles.size()) +
                 texels * (kPerTexel + kPerRay * (near + settings.lists * list) +
                           kPerTraining * near * more_trainings)) +
      ray * texels * (kPerNearRay * near + kPerListRay * lists * list);
  forecast.seconds = seconds / std::max(threads, 1);

  // A tolerance leaves out most where there is little clutter: with twice the usual one a third of
  // the lists is left in an empty room, four fifths in an office.
  const double coarser = std::max(std::log2(settings.tolerance / kTolerance), 0.0);
  const double kept = std::pow(std::clamp(0.32 + 0.43 * (clutter - 1.0), 0.1, 1.0), coarser);
  forecast.bytes = texels * kBytesPerTexel * lists * kept *
                   std::pow(settings.list_rays / kListRays, kBytesPower);
  return forecast;
}

}  // namespace soffit::transfer
