// SPDX-License-Identifier: MIT
#include "ui/document/luminaire_types.h"

#include "core/geometry/triangle_area.h"
#include "core/io/photometry/ies_writer.h"
#include "ui/document/mesh_text.h"
#include "ui/document/synthetic_photometry.h"
#include "ui/document/text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

constexpr double kUnknownRadius = 0.04;    // m, of a file without an opening
constexpr double kMeshLuminance = 3000.0;  // cd/m^2 of a mesh that was just made luminous

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

QString flux(double lm) {
  return QStringLiteral("%1 lm").arg(std::lround(lm));
}

LuminaireType plain(const char* id, const QString& name, const QString& about, light::Shape shape,
                    double lm, double cct_k, std::vector<double> lengths = {}) {
  LuminaireType type;
  type.id = id;
  type.name = name;
  type.about = flux(lm) + QStringLiteral(" \u00b7 ") + about;
  type.lengths = std::move(lengths);
  type.prototype.name = toStd(name);
  type.prototype.shape = std::move(shape);
  type.prototype.flux = lm;
  type.prototype.colour.cct_k = cct_k;
  type.prototype.group = toStd(tr("General"));
  return type;
}

LuminaireType hung(LuminaireType type, double drop) {
  type.mounting = Mounting::suspended;
  type.drop = drop;
  return type;
}

LuminaireType measured(LuminaireType type, const io::PhotometricFile& file,
                       const std::string& file_name) {
  type.photometry = {file_name, io::toIes(file)};
  type.prototype.distribution.kind = light::DistributionKind::ies;
  type.prototype.distribution.file = file_name;
  type.prototype.distribution.table =
      std::make_shared<const photometry::IntensityDistribution>(file.distribution);
  return type;
}

LuminaireType ring() {
  constexpr float kOuter = 0.45F;
  constexpr float kInner = 0.40F;
  auto mesh = std::make_shared<const geometry::Mesh>(ringMesh(kOuter, kInner, 48));
  LuminaireType type = plain("Ring", tr("Ring"), tr("\u2300 %1, suspended"), light::PointShape{},
                             4200.0, 3500.0, {0.9});
  type.prototype.shape = light::MeshShape{"ring_light.obj", 1.0, 'z', mesh};
  type.mesh = {"ring_light.obj", objText(*mesh)};
  return hung(std::move(type), 0.8);
}

/// 1234.5 to 1200: a guess should look like one.
double roundTwo(double v) {
  if (v <= 0.0) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(v)) - 1.0);
  return unit * std::round(v / unit);
}

}  // namespace

std::vector<LuminaireType> builtInTypes() {
  std::vector<LuminaireType> all;
  all.push_back(plain("Panel", tr("Panel"), tr("%1 \u00d7 %2"), light::Rectangle{0.6, 0.6}, 3600,
                      4000, {0.6, 0.6}));
  all.push_back(plain("Panel long", tr("Panel long"), tr("%1 \u00d7 %2"),
                      light::Rectangle{1.2, 0.3}, 3600, 4000, {1.2, 0.3}));
  all.push_back(plain("Linear", tr("Linear"), tr("%1, on the ceiling"), light::Rectangle{1.5, 0.06},
                      3000, 4000, {1.5}));
  all.push_back(hung(plain("Linear suspended", tr("Linear suspended"), tr("%1, suspended"),
                           light::Tube{1.5, 0.025}, 4200, 4000, {1.5}),
                     0.7));
  all.push_back(hung(plain("Pendant", tr("Pendant"), tr("\u2300 %1, suspended"), light::Disk{0.2},
                           1800, 3000, {0.4}),
                     1.0));
  all.push_back(
      measured(plain("Downlight", tr("Downlight"), tr("70\u00b0"), light::Disk{0.06}, 1500, 3500),
               syntheticSpot("Downlight 70", 70.0, 1500.0), "downlight_70.ies"));
  all.push_back(measured(plain("Spot", tr("Spot"), tr("24\u00b0"), light::Disk{0.04}, 900, 3000),
                         syntheticSpot("Spot 24", 24.0, 900.0), "spot_24.ies"));
  all.push_back(hung(measured(plain("Track spot", tr("Track spot"), tr("36\u00b0, on a track"),
                                    light::Disk{0.04}, 1100, 3000),
                              syntheticSpot("Track spot 36", 36.0, 1100.0), "track_spot_36.ies"),
                     0.16));
  all.push_back(measured(
      plain("Wall washer", tr("Wall washer"), tr("lights one side"), light::Disk{0.06}, 1600, 3500),
      syntheticWallWasher("Wall washer", 1600.0), "wall_washer.ies"));
  all.push_back(hung(plain("Sphere", tr("Sphere"), tr("\u2300 %1, suspended"), light::Sphere{0.15},
                           1400, 2700, {0.3}),
                     0.8));
  all.push_back(ring());
  all.push_back(
      plain("Custom", tr("Custom"), tr("see Properties"), light::Rectangle{0.4, 0.4}, 2000, 4000));
  return all;
}

LuminaireType typeFromPhotometry(const io::PhotometricFile& file, const std::string& file_name,
                                 std::string bytes) {
  const dvec3 opening = file.distribution.opening;
  light::Shape shape = light::Disk{kUnknownRadius};
  if (opening.x > 0.0 && opening.y > 0.0) shape = light::Rectangle{opening.x, opening.y};
  if (opening.x < 0.0 || opening.y < 0.0) {
    shape = light::Disk{0.5 * std::max(std::abs(opening.x), std::abs(opening.y))};
  }
  LuminaireType type;
  type.name = toQt(file.distribution.name.empty() ? file_name : file.distribution.name);
  type.about = flux(file.lumens);
  type.prototype.name = toStd(type.name);
  type.prototype.shape = std::move(shape);
  type.prototype.colour.cct_k = 4000.0;
  type.prototype.group = toStd(tr("General"));
  light::Distribution& distribution = type.prototype.distribution;
  distribution.kind =
      file.format == "EULUMDAT" ? light::DistributionKind::ldt : light::DistributionKind::ies;
  distribution.file = file_name;
  distribution.table = std::make_shared<const photometry::IntensityDistribution>(file.distribution);
  type.photometry = {file_name, std::move(bytes)};
  return type;
}

LuminaireType typeFromMesh(const QString& name, std::shared_ptr<const geometry::Mesh> mesh,
                           const std::string& file_name, std::string obj_text) {
  double area = 0.0;
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) area += geometry::areaOf(*mesh, t);
  LuminaireType type;
  type.name = name;
  type.prototype.name = toStd(name);
  type.prototype.shape = light::MeshShape{file_name, 1.0, 'z', std::move(mesh)};
  type.prototype.flux = roundTwo(kPi * kMeshLuminance * area);
  type.prototype.colour.cct_k = 3000.0;
  type.prototype.group = toStd(tr("General"));
  type.about = flux(*type.prototype.flux);
  type.mesh = {file_name, std::move(obj_text)};
  return type;
}

}  // namespace soffit::ui
