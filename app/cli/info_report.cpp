// SPDX-License-Identifier: MIT
#include "app/cli/info_report.h"

#include "core/scene/reflectances.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace soffit::cli {
namespace {

constexpr std::size_t kMostRows = 60;  // of one kind; who wants more takes --json

constexpr std::array<const char*, 7> kShapes{"point", "rectangle", "disk", "sphere",
                                             "tube",  "polygon",   "mesh"};

std::string shapeOf(const light::Luminaire& luminaire) {
  return kShapes[luminaire.shape.index()];
}

std::size_t pointCount(const scene::WorkPlane& plane) {
  return static_cast<std::size_t>(plane.nu) * static_cast<std::size_t>(plane.nv);
}

std::size_t pointCount(const scene::Scene& scene) {
  std::size_t count = 0;
  for (const scene::WorkPlane& plane : scene.work_planes) count += pointCount(plane);
  return count;
}

/// Metres to the centimetre, without a minus before zero.
std::string metres(double v) {
  const std::string text = fmt::format("{:.2f}", v);
  return text == "-0.00" ? "0.00" : text;
}
std::string metres(const dvec3& p) {
  return metres(p.x) + ", " + metres(p.y) + ", " + metres(p.z);
}
std::string range(double lo, double hi) {
  return metres(lo) + " to " + metres(hi);
}

/// The most of a name that a column holds, cut between characters.
std::string cut(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text;
  std::size_t end = width - 2;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + "..";
}

/// Sections of the readable report: a heading with its first line, the others below it.
class Lines {
 public:
  void add(const std::string& what, const std::string& line) {
    text_ += fmt::format("  {:<12} {}\n", what, line);
  }
  /// One row per item, `format` makes it.
  template <class Items, class Format>
  void table(const char* what, const Items& items, const Format& format) {
    std::size_t row = 0;
    for (const auto& item : items) {
      if (row == kMostRows) {
        add("", fmt::format("and {} more (--json lists all)", items.size() - row));
        return;
      }
      add(row++ == 0 ? what : "", format(item));
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string materialRow(const scene::Material& m, double area) {
  std::string row = fmt::format("{:<26} {:>9.2f} m²  ", cut(m.name, 26), area);
  if (m.glass) return row + fmt::format("glass, transmittance {:.2f}", m.glass->transmittance);
  row += fmt::format("reflectance {:.2f}", scene::reflectance(m));
  const bool grey = m.diffuse.x == m.diffuse.y && m.diffuse.y == m.diffuse.z;
  if (!grey)
    row += fmt::format(" (rgb {:.2f} {:.2f} {:.2f})", m.diffuse.x, m.diffuse.y, m.diffuse.z);
  if (!m.diffuse_map.empty()) row += ", map " + m.diffuse_map;
  if (m.specular > 0.0) {
    row += fmt::format(", specular {:.3g}, roughness {:.2g}", m.specular, m.roughness);
  }
  return row;
}

std::string roomRow(const geometry::Space& s, const dvec3& origin) {
  const dvec3 lo = origin + dvec3(s.box.lo);
  const dvec3 hi = origin + dvec3(s.box.hi);
  return fmt::format("floor {:>6}, {} m high, {:>6.1f} m²: x {}, y {}; middle {}, {}",
                     metres(origin.z + static_cast<double>(s.floor)),
                     metres(static_cast<double>(s.height)), s.area, range(lo.x, hi.x),
                     range(lo.y, hi.y), metres(origin.x + static_cast<double>(s.center.x)),
                     metres(origin.y + static_cast<double>(s.center.y)));
}

std::string luminaireRow(const light::Luminaire& l) {
  std::string row = fmt::format("{:<26} {:<9} {}", cut(l.name, 26), shapeOf(l), metres(l.position));
  if (l.flux) row += fmt::format("; {:g} lm", *l.flux);
  if (!l.distribution.file.empty()) row += "; " + l.distribution.file;
  if (l.dimming != 1.0) row += fmt::format("; dimmed to {:g}", l.dimming);
  if (!l.on) row += "; off";
  return row;
}

std::vector<std::size_t> byArea(const std::vector<double>& areas) {
  std::vector<std::size_t> order(areas.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  return order;
}

void addGeometry(const scene::Scene& scene, const InfoReport& report, Lines& lines) {
  const geometry::Mesh& mesh = *scene.mesh;
  lines.add("triangles", fmt::format("{}", mesh.triangleCount()));
  if (mesh.triangleCount() == 0) return;
  const dvec3 lo = mesh.origin + dvec3(mesh.bounds().lo);
  const dvec3 hi = mesh.origin + dvec3(mesh.bounds().hi);
  lines.add("extent", fmt::format("x {}, y {}, z {} m", range(lo.x, hi.x), range(lo.y, hi.y),
                                  range(lo.z, hi.z)));
  lines.table("rooms", report.rooms,
              [&](const geometry::Space& s) { return roomRow(s, mesh.origin); });
  lines.table("materials", byArea(report.areas),
              [&](std::size_t i) { return materialRow(scene.materials[i], report.areas[i]); });
}

std::string names(const std::vector<scene::Layout>& layouts) {
  std::string list;
  for (const auto& layout : layouts) list += (list.empty() ? "" : ", ") + layout.name;
  return list.empty() ? "none" : list;
}

void addLighting(const scene::Scene& scene, Lines& lines) {
  double lumens = 0.0;
  for (const auto& l : scene.luminaires) lumens += l.on ? l.flux.value_or(0.0) * l.dimming : 0.0;
  lines.add("luminaires", scene.luminaires.empty()
                              ? "none"
                              : fmt::format("{}, {:g} lm stated", scene.luminaires.size(), lumens));
  lines.table("", scene.luminaires, luminaireRow);
  lines.add("layouts", names(scene.layouts));
  if (scene.cameras.empty()) lines.add("cameras", "none");
  lines.table("cameras", scene.cameras, [](const scene::Camera& c) {
    return fmt::format("{:<26} from {} to {}", cut(c.name, 26), metres(c.position),
                       metres(c.target));
  });
  if (scene.work_planes.empty()) lines.add("work planes", "none");
  lines.table("work planes", scene.work_planes, [](const scene::WorkPlane& p) {
    return fmt::format("{:<26} {} points, {} x {} m from {}", cut(p.name, 26), pointCount(p),
                       metres(glm::length(p.u)), metres(glm::length(p.v)), metres(p.origin));
  });
}

io::Json textArray(const std::vector<std::string>& lines) {
  io::JsonArray array;
  for (const std::string& line : lines) array.emplace_back(line);
  return array;
}

template <class Items>
io::Json nameArray(const Items& items) {
  io::JsonArray array;
  for (const auto& item : items) array.emplace_back(item.name);
  return array;
}

io::Json vectorJson(const dvec3& v) {
  return io::Json::array({v.x, v.y, v.z});
}

io::Json roomsJson(const InfoReport& report, const dvec3& origin) {
  io::JsonArray rooms;
  for (const geometry::Space& s : report.rooms) {
    rooms.push_back(io::Json::object(
        {{"floor", origin.z + static_cast<double>(s.floor)},
         {"height", static_cast<double>(s.height)},
         {"area", static_cast<double>(s.area)},
         {"min", vectorJson(origin + dvec3(s.box.lo))},
         {"max", vectorJson(origin + dvec3(s.box.hi))},
         {"middle", vectorJson(origin + dvec3(dvec2(s.center), static_cast<double>(s.floor)))}}));
  }
  return rooms;
}

io::Json reflectancesJson(const scene::Scene& scene, const InfoReport& report) {
  io::JsonArray list;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const scene::Material& m = scene.materials[i];
    list.push_back(io::Json::object({{"name", m.name},
                                     {"area", report.areas[i]},
                                     {"reflectance", scene::reflectance(m)},
                                     {"glass", m.glass.has_value()}}));
  }
  return list;
}

}  // namespace

std::string toText(const io::Project& project, const InfoReport& report) {
  const scene::Scene& scene = project.scene;
  Lines lines;
  addGeometry(scene, report, lines);
  addLighting(scene, lines);
  lines.add("quality", scene.quality.preset + (scene.quality.settings.empty() ? "" : ", adjusted"));
  lines.add("cost", fmt::format("about {} points to light, {:.0f} s to bake once, {:.0f} MB",
                                report.cost.receivers, report.cost.bake_s, report.cost.megabytes));
  for (const std::string& needed : report.demand.needed) lines.add("needed", needed);
  for (const scene::Demand::Skip& skip : report.demand.skipped) {
    lines.add("skipped", fmt::format("{}: {}", skip.what, skip.why));
  }
  for (const std::string& warning : report.warnings) lines.add("warning", warning);
  return fmt::format("{}\n{}", scene.name.empty() ? project.path.string() : scene.name,
                     lines.text());
}

io::Json toJson(const io::Project& project, const InfoReport& report) {
  const scene::Scene& scene = project.scene;
  io::JsonArray skipped;
  for (const scene::Demand::Skip& skip : report.demand.skipped) {
    skipped.push_back(io::Json::object({{"what", skip.what}, {"why", skip.why}}));
  }
  return io::Json::object({{"name", scene.name},
                           {"triangles", scene.mesh->triangleCount()},
                           {"receivers", report.cost.receivers},
                           {"luminaires", scene.luminaires.size()},
                           {"needed", textArray(report.demand.needed)},
                           {"skipped", skipped},
                           {"bake_seconds", report.cost.bake_s},
                           {"megabytes", report.cost.megabytes},
                           {"points", pointCount(scene)},
                           {"rooms", roomsJson(report, scene.mesh->origin)},
                           {"materials", nameArray(scene.materials)},
                           {"reflectances", reflectancesJson(scene, report)},
                           {"layouts", nameArray(scene.layouts)},
                           {"cameras", nameArray(scene.cameras)},
                           {"work_planes", nameArray(scene.work_planes)},
                           {"warnings", textArray(report.warnings)}});
}

}  // namespace soffit::cli
