// SPDX-License-Identifier: MIT
#include "core/design/bench.h"
#include "core/light/emitter.h"
#include "core/math/rng.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>

namespace soffit::design {
namespace {

constexpr std::string_view kHeader =
    "x,y,z,nx,ny,nz,triangle,front,total,total_stderr,alone,alone_stderr,light,scene";

/// A running hash; order matters.
class Key {
 public:
  void add(std::uint64_t value) {
    state_ = mixBits(state_ ^ mixBits(value + 0x9e3779b97f4a7c15ULL));
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const vec3& v) {
    for (int i = 0; i < 3; ++i) add(static_cast<double>(v[i]));
  }
  void add(const dvec3& v) {
    for (int i = 0; i < 3; ++i) add(v[i]);
  }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", state_); }

 private:
  std::uint64_t state_ = 1;
};

void addGeometry(const scene::Scene& scene, Key& key) {
  key.add(scene.mesh->origin);
  for (const vec3& p : scene.mesh->positions) key.add(p);
  for (const uvec3& t : scene.mesh->triangles) {
    key.add(static_cast<std::uint64_t>(t.x) << 32U | t.y);
    key.add(static_cast<std::uint64_t>(t.z));
  }
  for (const std::uint32_t m : scene.mesh->material_of) key.add(static_cast<std::uint64_t>(m));
  for (const scene::Material& m : scene.materials) {
    key.add(m.diffuse);
    key.add(m.specular);
    key.add(m.roughness);
    key.add(static_cast<std::uint64_t>(m.diffuse_image != nullptr ? m.diffuse_image->pixels.size()
                                                                  : 0));
    key.add(static_cast<std::uint64_t>(m.glass.has_value() ? 1 : 0));
  }
}

void addLuminaire(const light::Luminaire& luminaire, Key& key) {
  const auto emitter = light::makeEmitter(luminaire);
  if (!emitter) return;  // refused where it is used
  key.add(static_cast<std::uint64_t>(emitter->kind));
  key.add(emitter->position);
  for (int c = 0; c < 3; ++c) key.add(dvec3(emitter->world_from_light[c]));
  for (const dvec3& p : emitter->outline) key.add(p);
  for (const dvec3& p : emitter->corners) key.add(p);
  for (const double v :
       {emitter->radius, emitter->half_length, emitter->flux, emitter->gain, emitter->table_scale,
        emitter->lambertian ? 1.0 : 0.0, emitter->table != nullptr ? 1.0 : 0.0,
        emitter->casts_shadow ? 1.0 : 0.0}) {
    key.add(v);
  }
  key.add(emitter->color);
}

template <class T>
bool take(std::string_view& line, T& value) {
  const std::size_t comma = std::min(line.find(','), line.size());
  const auto parsed = std::from_chars(line.data(), line.data() + comma, value);
  const bool whole = parsed.ec == std::errc() && parsed.ptr == line.data() + comma;
  line.remove_prefix(std::min(comma + 1, line.size()));
  return whole;
}

bool readRow(std::string_view line, BenchCase& bench) {
  SurfaceReceiver r;
  int front = 0;
  std::array<double, 4> lux{};
  bool good = true;
  for (int i = 0; i < 3; ++i) good = good && take(line, r.position[i]);
  for (int i = 0; i < 3; ++i) good = good && take(line, r.normal[i]);
  good = good && take(line, r.triangle) && take(line, front);
  for (double& v : lux) good = good && take(line, v);
  const std::size_t comma = line.rfind(',');
  if (!good || comma == std::string_view::npos) return false;
  r.front = front != 0;
  bench.receivers.push_back(r);
  bench.total.add(0.0, lux[0], lux[1]);
  bench.alone.add(0.0, lux[2], lux[3]);
  bench.light = std::string(line.substr(0, comma));
  bench.scene = std::string(line.substr(comma + 1));
  return true;
}

}  // namespace

std::string benchKey(const scene::Scene& scene, std::size_t receivers,
                     const ReferenceEffort& effort) {
  Key key;
  addGeometry(scene, key);
  for (const light::Luminaire& l : scene.luminaires) addLuminaire(l, key);
  key.add(static_cast<std::uint64_t>(receivers));
  key.add(effort.error);
  key.add(effort.seed);
  return key.text();
}

Result<BenchCase> makeBenchCase(const std::shared_ptr<const relight::Solver>& solver,
                                const scene::Scene& scene, std::size_t receivers,
                                const ReferenceEffort& effort, const Job& job) {
  std::size_t light = 0;
  while (light < scene.luminaires.size() &&
         !(scene.luminaires[light].on && scene.luminaires[light].dimming > 0.0)) {
    ++light;
  }
  if (light == scene.luminaires.size()) {
    return Error{"bench", "no luminaire of the project is on", "Switch one on."};
  }
  auto chosen = chooseReceivers(solver, scene, receivers, effort.seed, job);
  if (!chosen) return chosen.error();
  if (chosen->empty()) return Error{"bench", "no surface of the project is lit", "Give it light."};
  BenchCase bench;
  bench.scene = benchKey(scene, receivers, effort);
  bench.light = scene.luminaires[light].name;
  bench.receivers = *chosen;
  VerifyPoints points(solver, scene, std::move(*chosen), {}, 8, effort);
  std::vector<light::Luminaire> alone = scene.luminaires;
  std::vector<light::Luminaire> others = scene.luminaires;
  for (std::size_t i = 0; i < alone.size(); ++i) (i == light ? others : alone)[i].on = false;
  const auto of_others = points.evaluate(others, 2, job);
  if (!of_others) return of_others.error();
  const auto of_one = points.evaluate(alone, 1, job);
  if (!of_one) return of_one.error();
  bench.total = sumOf(*of_others, *of_one).surfaces.lux;
  bench.alone = of_one->surfaces.lux;
  return bench;
}

std::string formatBenchCase(const BenchCase& bench) {
  std::string text(kHeader);
  text += '\n';
  for (std::size_t i = 0; i < bench.receivers.size(); ++i) {
    const SurfaceReceiver& r = bench.receivers[i];
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.position.x, r.position.y,
                        r.position.z, r.normal.x, r.normal.y, r.normal.z, r.triangle,
                        r.front ? 1 : 0, bench.total.reference[i], bench.total.standard_error[i],
                        bench.alone.reference[i], bench.alone.standard_error[i], bench.light,
                        bench.scene);
  }
  return text;
}

Result<BenchCase> parseBenchCase(std::string_view text, const std::string& name) {
  BenchCase bench;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const bool good = number == 1 ? line == kHeader : readRow(line, bench);
    if (good) continue;
    return Error{fmt::format("{}:{}", name, number), "this is no row of a bench's reference",
                 "Remove the file to estimate the reference again."};
  }
  return bench;
}

}  // namespace soffit::design
