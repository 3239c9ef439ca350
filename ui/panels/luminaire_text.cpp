// SPDX-License-Identifier: MIT
#include "ui/panels/luminaire_text.h"

#include "core/color/srgb.h"
#include "core/light/emitter.h"
#include "ui/document/text.h"
#include "ui/widgets/quantity.h"

#include <QCoreApplication>

#include <algorithm>

namespace soffit::ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

QString metres(double value) {
  return formatQuantity(value, Dimension::length, 3);
}

struct ShapeText {
  Q_DECLARE_TR_FUNCTIONS(soffit::ui::ShapeText)

 public:
  QString operator()(const light::PointShape&) const { return tr("Point"); }
  QString operator()(const light::Rectangle& r) const {
    return tr("Rectangle %1 \u00d7 %2")
        .arg(formatNumber(r.width, Dimension::length, 3), metres(r.height));
  }
  QString operator()(const light::Disk& d) const {
    return tr("Disk \u2300 %1").arg(metres(2.0 * d.radius));
  }
  QString operator()(const light::Sphere& s) const {
    return tr("Sphere \u2300 %1").arg(metres(2.0 * s.radius));
  }
  QString operator()(const light::Tube& t) const {
    return tr("Tube %1, \u2300 %2").arg(metres(t.length), metres(2.0 * t.radius));
  }
  QString operator()(const light::Polygon& p) const {
    return tr("Polygon, %1 corners").arg(p.outline.size());
  }
  QString operator()(const light::MeshShape& m) const { return tr("Mesh %1").arg(toQt(m.file)); }
};

}  // namespace

QString describeShape(const light::Shape& shape) {
  return std::visit(ShapeText{}, shape);
}

QString describeType(const LuminaireType& type) {
  QString about = type.about;
  for (std::size_t i = 0; i < type.lengths.size(); ++i) {
    const bool last = i + 1 == type.lengths.size();
    about = about.arg(last ? formatQuantity(type.lengths[i], Dimension::length, 2)
                           : formatNumber(type.lengths[i], Dimension::length, 2));
  }
  return about;
}

QString describeDistribution(const light::Distribution& distribution) {
  switch (distribution.kind) {
    case light::DistributionKind::lambertian:
      return tr("Lambertian");
    case light::DistributionKind::isotropic:
      return tr("Isotropic");
    default:
      return toQt(distribution.file);
  }
}

double fluxOf(const light::Luminaire& luminaire) {
  if (luminaire.flux) return *luminaire.flux;
  const auto emitter = light::makeEmitter(luminaire);
  return emitter ? emitter->flux : 0.0;
}

QString describeColour(const light::Colour& colour) {
  return colour.cct_k ? formatQuantity(*colour.cct_k, Dimension::temperature, 0) : tr("RGB");
}

QColor swatchOf(const light::Colour& colour) {
  const dvec3 c = light::emissionColor(colour);
  const double most = std::max({c.x, c.y, c.z, 1e-9});
  const auto code = [&](double v) { return color::srgbEncode(static_cast<float>(v / most)); };
  return QColor::fromRgbF(code(c.x), code(c.y), code(c.z));
}

}  // namespace soffit::ui
