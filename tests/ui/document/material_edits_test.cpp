// SPDX-License-Identifier: MIT
#include "ui/document/material_edits.h"

#include "core/scene/reflectances.h"

#include <QTest>

namespace soffit::ui {

/// Reflectances are kept as whole hundred-thousandths per channel.
constexpr double kRounding = 1e-5;

class MaterialEditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void reflectanceScalesTheColour() {
    scene::Material m;
    m.diffuse = {0.4, 0.2, 0.1};
    const scene::Material half = withReflectance(m, 0.5 * scene::reflectance(m));
    QVERIFY(std::abs(half.diffuse.x - 0.2) < kRounding);
    QVERIFY(std::abs(half.diffuse.z - 0.05) < kRounding);
    m.specular = 0.04;
    QVERIFY(std::abs(scene::reflectance(withReflectance(m, 0.3)) - 0.3) < kRounding);
  }

  void blackBecomesGrey() {
    scene::Material m;
    m.diffuse = dvec3(0.0);
    const scene::Material grey = withReflectance(m, 0.6);
    QVERIFY(glm::length(grey.diffuse - dvec3(0.6)) < kRounding);
  }

  void noChannelReflectsMoreThanItGets() {
    scene::Material m;
    m.diffuse = {0.9, 0.1, 0.1};
    m.specular = 0.05;
    const scene::Material bright = withReflectance(m, 0.9);
    for (int c = 0; c < 3; ++c) QVERIFY(bright.diffuse[c] + bright.specular <= 1.0);
    const scene::Material glossy = withSpecular(m, 0.8);
    for (int c = 0; c < 3; ++c) QVERIFY(glossy.diffuse[c] + glossy.specular <= 1.0);
  }

  void aColourKeepsTheReflectance() {
    scene::Material m;
    m.diffuse = dvec3(0.3);
    const scene::Material blue = withColour(m, {0.2, 0.4, 0.9});
    QVERIFY(std::abs(scene::reflectance(blue) - 0.3) < kRounding);
    QVERIFY(blue.diffuse.z > blue.diffuse.x);
  }

  void aPictureCountsWithItsMean() {
    auto image = std::make_shared<scene::Image>();
    image->width = image->height = 1;
    image->pixels = {0.5F, 0.5F, 0.5F};
    scene::Material m;
    m.diffuse = dvec3(1.0);
    m.diffuse_image = image;
    QVERIFY(std::abs(scene::reflectance(withReflectance(m, 0.25)) - 0.25) < kRounding);
  }

  void aSlidersWayIsOneStep() {
    io::Project project;
    project.scene.mesh = std::make_shared<geometry::Mesh>();
    scene::Material wall;
    wall.name = "wall";
    project.scene.materials.push_back(wall);
    Document document(std::move(project));
    for (const double rho : {0.6, 0.7, 0.8}) {
      editMaterial(
          document, QStringLiteral("Change reflectance"), "wall",
          [rho](const scene::Material& m) { return withReflectance(m, rho); }, 7);
    }
    QCOMPARE(document.undoStack()->count(), 1);
    QVERIFY(std::abs(scene::reflectance(document.scene()->materials[0]) - 0.8) < kRounding);
    document.undoStack()->undo();
    QCOMPARE(document.scene()->materials[0].diffuse, dvec3(0.5));
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::MaterialEditsTest)
#include "material_edits_test.moc"
