// SPDX-License-Identifier: MIT
#include "core/design/shadow_rays.h"

#include "core/design/surface_reading.h"
#include "core/light/direct_stage.h"
#include "tests/core/design/scenes.h"

#include <cmath>

namespace soffit::design {
namespace {

using namespace testing;

struct Fields {
  std::vector<float> rays, bitmask;
  std::uint64_t traced = 0;
};

Fields directFields(const scene::Scene& scene, const relight::Solver& solver, int rays) {
  const light::Emitter emitter = *light::makeEmitter(scene.luminaires[0]);
  const light::Receivers points = toReceivers(drawReceivers(solver, 1500, 5));
  Fields f;
  f.rays.resize(points.slotCount());
  f.bitmask.resize(points.slotCount());
  std::vector<std::uint8_t> lit(points.clusters.size());
  f.traced = shadowRayIlluminance(emitter, points, solver.scene().caster, rays, f.rays, lit);
  for (std::size_t c = 0; c < lit.size(); ++c) {
    bool any = false;
    for (std::uint32_t s = points.clusters[c].begin; s < points.clusters[c].end; ++s) {
      any = any || f.rays[s] > 0.0F;
    }
    EXPECT_EQ(lit[c] != 0, any);
  }
  light::directIlluminance(light::PreparedLight(emitter), points, solver.scene().blockers,
                           {.epsilon = solver.scene().epsilon, .bodies = {}}, f.bitmask, lit);
  return f;
}

double difference(const Fields& f) {
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < f.rays.size(); ++i) {
    squares += std::pow(static_cast<double>(f.rays[i] - f.bitmask[i]), 2);
    sum += static_cast<double>(f.bitmask[i]);
  }
  const auto n = static_cast<double>(f.rays.size());
  return std::sqrt(squares / n) / (sum / n);
}

TEST(ShadowRays, ApproachTheBitmaskWithMoreRays) {
  const scene::Scene scene = blockRoom();
  const auto solver = solverOf(scene, 500);
  const double few = difference(directFields(scene, *solver, 4));
  const Fields many_rays = directFields(scene, *solver, 1024);
  const double many = difference(many_rays);
  // Truncation: the bitmask's own error (512 samples) is below 1 %, 4 rays err by several times it.
  EXPECT_LT(many, 0.01);
  EXPECT_GT(few, 2.0 * many);
  EXPECT_GT(many_rays.traced, 1024U * 100U);
}

TEST(ShadowRays, AreNotNeededForAPointOnFreeGround) {
  scene::Scene scene = blockRoom();
  scene.luminaires[0].shape = light::PointShape{};
  scene.luminaires[0].distribution.kind = light::DistributionKind::isotropic;
  const auto solver = solverOf(scene, 500);
  const Fields f = directFields(scene, *solver, 64);
  // A point casts hard shadows: both methods say in or out. Points right at a shadow's edge may
  // differ.
  std::size_t different = 0;
  for (std::size_t i = 0; i < f.rays.size(); ++i) {
    if (std::abs(f.rays[i] - f.bitmask[i]) > 1e-4F * f.bitmask[i] + 1e-4F) ++different;
  }
  EXPECT_LT(different, f.rays.size() / 200);
  EXPECT_LE(f.traced, f.rays.size());  // one ray says it all
}

}  // namespace
}  // namespace soffit::design
