// SPDX-License-Identifier: MIT
#include "core/design/verify.h"

#include "core/design/rooms.h"

#include <fmt/format.h>

#include <algorithm>

namespace soffit::design {
namespace {

/// Rooms with fewer receivers say nothing.
constexpr std::size_t kLeastInZone = 5;

/// Which point belongs where.
struct Places {
  std::vector<std::string> rooms;  ///< fewer than two: none are reported
  std::vector<std::string> planes;
  std::vector<std::size_t> room_of_surface;
  std::vector<std::size_t> room_of_sensor;
  std::vector<std::size_t> plane_of_sensor;
  bool sensors_are_receivers = false;
};

ErrorSamples subset(const ErrorSamples& all, std::span<const std::size_t> key, std::size_t wanted) {
  ErrorSamples out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (key[i] == wanted) out.add(all.value[i], all.reference[i], all.standard_error[i]);
  }
  return out;
}

ErrorFigures pooledSubset(std::span<const ErrorSamples> sets, std::span<const std::size_t> key,
                          std::size_t wanted) {
  std::vector<ErrorSamples> parts;
  for (const ErrorSamples& set : sets) parts.push_back(subset(set, key, wanted));
  return pooledFigures(parts);
}

/// Figures over the samples of one or several positions.
LightErrors errorsOf(std::span<const PointSamples> positions, const Places& places) {
  std::vector<ErrorSamples> surfaces;
  std::vector<ErrorSamples> sensors;
  for (const PointSamples& p : positions) {
    surfaces.push_back(p.surfaces.lux);
    sensors.push_back(p.sensors.lux);
  }
  LightErrors out;
  const auto& main = places.sensors_are_receivers ? sensors : surfaces;
  const auto& rooms = places.sensors_are_receivers ? places.room_of_sensor : places.room_of_surface;
  out.receivers = pooledFigures(main);
  for (std::size_t r = 0; places.rooms.size() > 1 && r < places.rooms.size(); ++r) {
    if (static_cast<std::size_t>(std::count(rooms.begin(), rooms.end(), r)) < kLeastInZone)
      continue;
    out.zones.push_back({places.rooms[r], pooledSubset(main, rooms, r)});
  }
  if (places.sensors_are_receivers || places.planes.empty()) return out;
  out.work_planes = pooledFigures(sensors);
  for (std::size_t p = 0; p < places.planes.size(); ++p) {
    out.planes.push_back({places.planes[p], pooledSubset(sensors, places.plane_of_sensor, p)});
  }
  return out;
}

Places placesOf(const relight::Solver& solver, const scene::Scene& scene,
                std::span<const SurfaceReceiver> surfaces, std::span<const scene::Sensor> sensors,
                bool sensors_are_receivers) {
  Places places;
  places.sensors_are_receivers = sensors_are_receivers;
  const geometry::RayCaster& caster = solver.scene().caster;
  const std::vector<Room> rooms = findRooms(caster, scene.mesh->origin, scene.work_planes);
  for (const Room& room : rooms) places.rooms.push_back(room.name);
  std::vector<dvec3> positions;
  std::vector<dvec3> normals;
  for (const SurfaceReceiver& r : surfaces) {
    positions.push_back(r.position);
    normals.push_back(r.normal);
  }
  places.room_of_surface = assignRooms(caster, rooms, positions, normals);
  if (sensors_are_receivers) {
    positions.clear();
    normals.clear();
    for (const scene::Sensor& s : sensors) {
      positions.push_back(s.position - scene.mesh->origin);
      normals.push_back(s.normal);
    }
    places.room_of_sensor = assignRooms(caster, rooms, positions, normals);
    return places;
  }
  std::vector<std::size_t> room_of_plane(scene.work_planes.size(), kNoRoom);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    for (const std::size_t p : rooms[r].planes) room_of_plane[p] = r;
  }
  for (std::size_t p = 0; p < scene.work_planes.size(); ++p) {
    const scene::WorkPlane& plane = scene.work_planes[p];
    places.planes.push_back(plane.name);
    const auto count = static_cast<std::size_t>(plane.nu) * static_cast<std::size_t>(plane.nv);
    places.plane_of_sensor.insert(places.plane_of_sensor.end(), count, p);
    places.room_of_sensor.insert(places.room_of_sensor.end(), count, room_of_plane[p]);
  }
  return places;
}

std::vector<VerifiedPoint> pointsOf(const VerifyPoints& points, const PointSamples& samples,
                                    const Places& places, const dvec3& origin) {
  std::vector<VerifiedPoint> out;
  const auto add = [&](const scene::Sensor& sensor, const std::string& set, std::size_t room,
                       const SetSamples& from, std::size_t i) {
    out.push_back({sensor, set, room < places.rooms.size() ? places.rooms[room] : "", from.value[i],
                   from.reference[i], from.lux.standard_error[i]});
  };
  for (std::size_t i = 0; i < points.surfaces().size(); ++i) {
    add(toSensor(points.surfaces()[i], origin), "surface", places.room_of_surface[i],
        samples.surfaces, i);
  }
  for (std::size_t i = 0; i < points.sensors().size(); ++i) {
    const std::string set =
        places.sensors_are_receivers ? "sensor" : places.planes[places.plane_of_sensor[i]];
    add(points.sensors()[i], set, places.room_of_sensor[i], samples.sensors, i);
  }
  return out;
}

Result<std::size_t> indexOf(const scene::Scene& scene, const std::string& name) {
  std::string known;
  for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
    if (scene.luminaires[i].name == name) return i;
    known += (known.empty() ? "" : ", ") + scene.luminaires[i].name;
  }
  return Error{"luminaires", fmt::format("there is no luminaire \"{}\"", name),
               known.empty() ? "The project has none." : "It has: " + known + "."};
}

/// The luminaire apart from the others.
class Alone {
 public:
  Alone(VerifyPoints& points, const scene::Scene& scene, std::size_t index)
      : points_(points), scene_(scene), index_(index) {}

  Result<PointSamples> alone(const dvec3& position, std::size_t left, const Job& job) {
    return evaluate(position, true, left, job);
  }
  Result<PointSamples> others(const dvec3& position, std::size_t left, const Job& job) {
    return evaluate(position, false, left, job);
  }
  /// The others' light depends on where its body stands.
  [[nodiscard]] bool shades() const { return scene_.luminaires[index_].casts_shadow; }

 private:
  Result<PointSamples> evaluate(const dvec3& position, bool own, std::size_t left, const Job& job) {
    std::vector<light::Luminaire> luminaires = scene_.luminaires;
    luminaires[index_].position = position;
    for (std::size_t i = 0; i < luminaires.size(); ++i) {
      if ((i == index_) != own) luminaires[i].on = false;
    }
    return points_.evaluate(luminaires, left, job, !own);
  }

  VerifyPoints& points_;
  const scene::Scene& scene_;
  std::size_t index_;
};

Result<void> reportAlone(VerifyPoints& points, const scene::Scene& scene, const Places& places,
                         std::size_t index, std::span<const dvec3> path, const Job& job,
                         VerifyReport& report) {
  Alone light(points, scene, index);
  const dvec3 home = scene.luminaires[index].position;
  std::size_t left = (light.shades() ? 2 : 1) * path.size() + 2;
  auto rest = light.others(home, left--, job);
  if (!rest) return rest.error();
  const auto at_home = light.alone(home, left--, job);
  if (!at_home) return at_home.error();
  const std::vector<PointSamples> total{sumOf(*rest, *at_home)};
  report.total = errorsOf(total, places);
  report.points = pointsOf(points, total[0], places, scene.mesh->origin);
  report.luminaire = VerifyReport::Luminaire{scene.luminaires[index].name, {}, {}};
  std::vector<PointSamples> all;
  for (const dvec3& position : path) {
    if (light.shades()) {
      rest = light.others(position, left--, job);
      if (!rest) return rest.error();
    }
    auto alone = light.alone(position, left--, job);
    if (!alone) return alone.error();
    const std::vector<PointSamples> own{*alone};
    const std::vector<PointSamples> both{sumOf(*rest, *alone)};
    report.luminaire->positions.push_back(
        {position, errorsOf(own, places), errorsOf(both, places)});
    all.push_back(std::move(*alone));
  }
  if (all.empty()) all.push_back(*at_home);
  report.luminaire->alone = errorsOf(all, places);
  return {};
}

}  // namespace

Result<VerifyReport> verify(const std::shared_ptr<const relight::Solver>& solver,
                            const scene::Scene& scene, const VerifyOptions& options,
                            const Job& job) {
  std::optional<std::size_t> index;
  if (!options.luminaire.empty()) {
    const auto found = indexOf(scene, options.luminaire);
    if (!found) return found.error();
    index = *found;
  }
  std::vector<SurfaceReceiver> surfaces;
  std::vector<scene::Sensor> sensors = options.sensors;
  const bool given = !sensors.empty();
  if (!given) {
    auto chosen = chooseReceivers(solver, scene, options.receivers, options.effort.seed, job);
    if (!chosen) return chosen.error();
    surfaces = std::move(*chosen);
    for (const scene::WorkPlane& plane : scene.work_planes) {
      const auto points = scene::sensorsOf(plane);
      sensors.insert(sensors.end(), points.begin(), points.end());
    }
  }
  if (surfaces.empty() && sensors.empty()) {
    return Error{"verify", "no surface of the project is lit and it has no work plane",
                 "Switch a luminaire on, or name points with --sensors PTS.csv"};
  }
  const Places places = placesOf(*solver, scene, surfaces, sensors, given);
  VerifyPoints points(solver, scene, std::move(surfaces), std::move(sensors), options.sensor_rays,
                      options.effort);
  points.setGroups(places.room_of_surface, places.room_of_sensor);
  VerifyReport report;
  if (index) {
    const auto done = reportAlone(points, scene, places, *index, options.path, job, report);
    if (!done) return done.error();
  } else {
    const auto samples = points.evaluate(scene.luminaires, 1, job, true);
    if (!samples) return samples.error();
    report.total = errorsOf(std::span(&*samples, 1), places);
    report.points = pointsOf(points, *samples, places, scene.mesh->origin);
  }
  report.reached = points.reached();
  report.rays = points.rays();
  return report;
}

}  // namespace soffit::design
