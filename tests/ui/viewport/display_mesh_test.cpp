// SPDX-License-Identifier: MIT
#include "ui/viewport/display_mesh.h"

#include "core/io/project/project.h"
#include "core/relight/engine.h"
#include "ui/viewport/chart_cutting.h"

#include <QTest>

#include <map>

namespace soffit::ui {

/// A sample's mesh with texels, the way a bake lays them.
struct Laid {
  io::Project project;
  std::shared_ptr<const transfer::StaticScene> scene;
  transfer::Texels texels;
};

Laid layTexels(const char* name, std::size_t count) {
  auto project = io::loadProject(std::string(SOFFIT_SOURCE_DIR "/projects/") + name);
  Laid laid{std::move(*project), nullptr, {}};
  laid.scene = relight::makeStaticScene(laid.project.scene);
  const geometry::Mesh& mesh = *laid.scene->mesh;
  const double cell = transfer::cellForCount(mesh, laid.scene->sides, count, 0.03);
  laid.texels = transfer::makeTexels(mesh, laid.scene->sides, cell, &laid.scene->caster, 2 * count);
  return laid;
}

double areaOf(const vec3& a, const vec3& b, const vec3& c) {
  return 0.5 * glm::length(glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a)));
}

class DisplayMeshTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void litSidesAreCoveredOnceEach_data() { samples(); }
  void litSidesAreCoveredOnceEach() {
    QFETCH(QByteArray, sample);
    const Laid laid = layTexels(sample.constData(), 3000);
    const geometry::Mesh& mesh = *laid.scene->mesh;
    const DisplayMesh shown = makeDisplayMesh(mesh, laid.texels, laid.project.scene.materials);
    double wanted = 0.0;
    for (const transfer::Chart& chart : laid.texels.charts.charts) {
      const int sides = (chart.sides & 1) + ((chart.sides >> 1) & 1);
      for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
        const uvec3& t = mesh.triangles[laid.texels.charts.triangles[chart.first_triangle + k]];
        wanted += sides * areaOf(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
      }
    }
    double found = 0.0;
    for (std::size_t i = 0; i < shown.indices.size(); i += 3) {
      found += areaOf(shown.positions[shown.indices[i]], shown.positions[shown.indices[i + 1]],
                      shown.positions[shown.indices[i + 2]]);
    }
    // Vertices are single precision, and corners within 1/4096 of a cell are joined.
    QVERIFY2(std::abs(found - wanted) < 1e-4 * wanted,
             qPrintable(QStringLiteral("%1 of %2 m2").arg(found).arg(wanted)));
  }

  void evenLightStaysEven_data() { samples(); }
  void evenLightStaysEven() {
    QFETCH(QByteArray, sample);
    const Laid laid = layTexels(sample.constData(), 3000);
    const DisplayMesh shown =
        makeDisplayMesh(*laid.scene->mesh, laid.texels, laid.project.scene.materials);
    relight::Planes lux;
    for (auto& plane : lux) plane.assign(laid.texels.slotCount(), 250.0F);
    std::vector<vec3> at(shown.vertexCount());
    lightVertices(shown, lux, at);
    std::size_t dark = 0;
    for (const vec3& e : at) {
      if (e == vec3(0.0F)) {
        ++dark;  // no texel: what stands under matter
        continue;
      }
      QVERIFY(std::abs(e.x - 250.0F) < 250.0F * 16 * 1.2e-7F);  // rounding of up to 16 weights
    }
    QVERIFY2(dark < shown.vertexCount() / 10, qPrintable(QString::number(dark)));
  }

  void chartsHaveNoCracks_data() { samples(); }
  void chartsHaveNoCracks() {
    QFETCH(QByteArray, sample);
    const Laid laid = layTexels(sample.constData(), 3000);
    const geometry::Mesh& mesh = *laid.scene->mesh;
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    for (std::uint32_t c = 0; c < laid.texels.charts.charts.size(); ++c) {
      const transfer::Chart& chart = laid.texels.charts.charts[c];
      if (!chart.planar || chart.triangle_count < 2) continue;
      const CutChart cut = cutChart(mesh, laid.texels, c, 0);
      std::map<Edge, int> open;
      for (const uvec3& t : cut.triangles) {
        for (const Edge& e : {Edge(t.x, t.y), Edge(t.y, t.z), Edge(t.z, t.x)}) {
          if (open.erase({e.second, e.first}) == 0) ++open[e];
        }
      }
      double rim = 0.0;
      for (const auto& [edge, count] : open) {
        rim +=
            count * glm::length(dvec2(cut.vertices[edge.first].at - cut.vertices[edge.second].at));
      }
      const double wanted = rimOf(mesh, laid.texels.charts, chart);
      QVERIFY2(
          std::abs(rim - wanted) < 2e-3 * wanted,
          qPrintable(QStringLiteral("chart %1: rim %2, %3 wanted").arg(c).arg(rim).arg(wanted)));
    }
  }

 private:
  static void samples() {
    QTest::addColumn<QByteArray>("sample");
    QTest::newRow("cornell") << QByteArray("cornell");
    QTest::newRow("flat") << QByteArray("flat");
  }

  /// Length of the chart's border in the mesh; vertices at one place are one.
  static double rimOf(const geometry::Mesh& mesh, const transfer::Charts& charts,
                      const transfer::Chart& chart) {
    using Place = std::array<long, 3>;
    const auto place = [&](std::uint32_t v) {
      const vec3 p = mesh.positions[v] * 10000.0F;
      return Place{std::lround(p.x), std::lround(p.y), std::lround(p.z)};
    };
    std::map<std::pair<Place, Place>, int> open;
    for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
      const uvec3& t = mesh.triangles[charts.triangles[chart.first_triangle + k]];
      for (int i = 0; i < 3; ++i) {
        const Place a = place(t[i]);
        const Place b = place(t[(i + 1) % 3]);
        const auto back = open.find({b, a});
        if (back != open.end()) {
          if (--back->second == 0) open.erase(back);
        } else {
          ++open[{a, b}];
        }
      }
    }
    double rim = 0.0;
    for (const auto& [edge, count] : open) {
      dvec3 d(0.0);
      for (int i = 0; i < 3; ++i) {
        d[i] = static_cast<double>(edge.first[static_cast<std::size_t>(i)] -
                                   edge.second[static_cast<std::size_t>(i)]);
      }
      rim += count * glm::length(d) / 10000.0;
    }
    return rim;
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::DisplayMeshTest)
#include "display_mesh_test.moc"
