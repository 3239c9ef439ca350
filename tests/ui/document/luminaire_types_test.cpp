// SPDX-License-Identifier: MIT
#include "ui/document/luminaire_types.h"

#include "core/geometry/shapes.h"
#include "core/io/model/model_import.h"
#include "core/io/project/move_project.h"
#include "core/light/emitter.h"
#include "core/photometry/beam.h"
#include "tests/ui/document/saving.h"
#include "ui/document/document.h"
#include "ui/document/mesh_text.h"
#include "ui/document/synthetic_photometry.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace soffit::ui {

class LuminaireTypesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyBuiltInKindEmitsItsFlux() {
    for (const LuminaireType& type : builtInTypes()) {
      const auto emitter = light::makeEmitter(type.prototype);
      QVERIFY2(emitter.ok(), qPrintable(type.name));
      QVERIFY2(emitter->flux > 100.0, qPrintable(type.name));
    }
  }

  void syntheticPhotometryHasTheBeamAndTheLumensItSays() {
    for (const double beam : {12.0, 24.0, 36.0, 70.0, 110.0}) {
      const auto file = syntheticSpot("Test", beam, 1000.0);
      // Candela are whole hundredths; the table is linear between its angles.
      QVERIFY(std::abs(file.distribution.flux() - 1000.0) < 0.5);
      const auto angles =
          photometry::beamAngles(file.distribution, photometry::BeamReference::peak);
      QVERIFY2(std::abs(angles.c0_deg - beam) < 0.02 * beam, qPrintable(QString::number(beam)));
      const auto again =
          io::parsePhotometry(builtInTypes()[5].photometry.bytes, "downlight_70.ies");
      QVERIFY(again.ok());
    }
    const auto washer = syntheticWallWasher("Washer", 1000.0);
    QVERIFY(washer.distribution.intensityAt(0.0, 35.0) >
            2.0 * washer.distribution.intensityAt(180.0, 35.0));
  }

  void aFilesOpeningBecomesTheShape() {
    io::PhotometricFile file = syntheticSpot("Test", 60.0, 800.0);
    file.distribution.opening = {0.3, 1.2, 0.0};
    const LuminaireType rectangle = typeFromPhotometry(file, "test.ies", "bytes");
    QCOMPARE(std::get<light::Rectangle>(rectangle.prototype.shape).height, 1.2);
    QVERIFY(!rectangle.prototype.flux.has_value());
    file.distribution.opening = {-0.2, -0.2, 0.0};
    const LuminaireType disk = typeFromPhotometry(file, "test.ies", "bytes");
    QCOMPARE(std::get<light::Disk>(disk.prototype.shape).radius, 0.1);
  }

  void filesReachTheDiskWithTheProjectThatNamesThem() {
    QTemporaryDir folder;
    io::Project project;
    project.scene.mesh = std::make_shared<geometry::Mesh>();
    project.path = folder.filePath(QStringLiteral("a.soffit")).toStdString();
    Document document(std::move(project));
    const auto types = builtInTypes();
    const auto downlight = std::ranges::find_if(
        types, [](const auto& type) { return !type.photometry.bytes.empty(); });
    const std::string name =
        document.addFile(downlight->photometry.name, downlight->photometry.bytes);
    QCOMPARE(document.addFile(downlight->photometry.name, downlight->photometry.bytes), name);
    const std::string other = document.addFile(downlight->photometry.name, "something else");
    QVERIFY(other != name);
    QVERIFY(document.hasFile(name));
    scene::Scene next = *document.scene();
    light::Luminaire luminaire = downlight->prototype;
    luminaire.name = "Downlight 1";
    next.luminaires.push_back(luminaire);
    document.edit(QStringLiteral("Place"), std::move(next));
    QVERIFY(testing::saved(document, document.project().path));
    QVERIFY(QFile::exists(folder.filePath(QString::fromStdString(name))));
    QVERIFY(!QFile::exists(folder.filePath(QString::fromStdString(other))));
    const auto again = io::loadProject(document.project().path);
    QVERIFY2(again.ok(), again.ok() ? "" : again.error().message().c_str());
    QVERIFY(again->scene.luminaires.front().distribution.table != nullptr);
  }

  void filesGoWithAProjectThatIsSavedElsewhere() {
    QTemporaryDir from;
    QTemporaryDir to;
    io::Project project;
    project.scene.mesh = std::make_shared<geometry::Mesh>();
    const std::string path = from.filePath(QStringLiteral("a.soffit")).toStdString();
    project.path = path;
    QVERIFY(io::saveProject(project, path).ok());
    auto loaded = io::loadProject(path);
    QVERIFY(loaded.ok());
    Document document(std::move(*loaded));
    const LuminaireType spot = builtInTypes()[6];
    const std::string name = document.addFile(spot.photometry.name, spot.photometry.bytes);
    QVERIFY(document.hasFile(name));
    scene::Scene next = *document.scene();
    next.luminaires.push_back(spot.prototype);
    document.edit(QStringLiteral("Place"), std::move(next));
    const auto moved = io::saveProjectAs(document.current(),
                                         to.filePath(QStringLiteral("b.soffit")).toStdString());
    QVERIFY2(moved.ok(), moved.ok() ? "" : moved.error().message().c_str());
    const auto again = io::loadProject(moved->path);
    QVERIFY2(again.ok(), again.ok() ? "" : again.error().message().c_str());
    QVERIFY(again->scene.luminaires.front().distribution.table != nullptr);
  }

  void aMeshReadsBackAsItWasWritten() {
    QTemporaryDir folder;
    const geometry::Mesh ring = ringMesh(0.4F, 0.3F, 12);
    const QString path = folder.filePath(QStringLiteral("ring.obj"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(objText(ring)));
    file.close();
    const auto model = io::importModel(path.toStdString(), {});
    QVERIFY2(model.ok(), model.ok() ? "" : model.error().message().c_str());
    QCOMPARE(model->mesh.triangles.size(), ring.triangles.size());
  }

  void aPartOfABuildingIsCutOutAndLifted() {
    geometry::Mesh box = geometry::makeBox(vec3(1.0F), vec3(2.0F));
    const geometry::Mesh far = geometry::makeBox(vec3(5.0F), vec3(6.0F));
    const auto first = static_cast<std::uint32_t>(box.positions.size());
    for (const vec3& p : far.positions) box.positions.push_back(p);
    for (const uvec3& t : far.triangles) {
      box.triangles.push_back(t + uvec3(first));
      box.material_of.push_back(0);
      box.object_of.push_back(0);
    }
    const auto part = partAround(box, 3);
    QCOMPARE(part.size(), std::size_t{12});
    dvec3 middle(0.0);
    const geometry::Mesh lifted = liftedPart(box, part, false, 0.01F, middle);
    QVERIFY(glm::length(middle - dvec3(1.5)) < 1e-6);
    QCOMPARE(lifted.triangles.size(), std::size_t{12});
    const Box bounds = lifted.bounds();
    QVERIFY(bounds.hi.x > 0.5F && bounds.hi.x < 0.52F);
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::LuminaireTypesTest)
#include "luminaire_types_test.moc"
