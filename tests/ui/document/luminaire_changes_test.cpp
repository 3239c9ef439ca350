// SPDX-License-Identifier: MIT
#include "ui/document/luminaire_changes.h"

#include "core/scene/diff.h"

#include <QTest>

namespace soffit::ui {

scene::Scene panels(int count) {
  scene::Scene scene;
  scene.mesh = std::make_shared<geometry::Mesh>();
  for (int i = 1; i <= count; ++i) {
    light::Luminaire l;
    l.name = "Panel " + std::to_string(i);
    l.flux = 1000.0;
    scene.luminaires.push_back(l);
  }
  scene.layouts.push_back({"Evening", {}});
  return scene;
}

class LuminaireChangesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aChangeInALayoutLeavesTheBaseAlone() {
    const scene::Scene before = panels(3);
    const auto dim = [](light::Luminaire& l) { l.dimming = 0.25; };
    const scene::Scene after = withChanged(before, "Evening", {QStringLiteral("Panel 2")}, dim);
    QCOMPARE(after.luminaires[1].dimming, 1.0);
    QCOMPARE(luminairesOf(after, "Evening")[1].dimming, 0.25);
    QCOMPARE(after.layouts[0].edits.size(), std::size_t{1});
    const auto more = withChanged(after, "Evening", {QStringLiteral("Panel 2")},
                                  [](light::Luminaire& l) { l.on = false; });
    QCOMPARE(luminairesOf(more, "Evening")[1].dimming, 0.25);
    QVERIFY(!luminairesOf(more, "Evening")[1].on);
  }

  void aChangeThatChangesNothingLeavesNoTrace() {
    const scene::Scene before = panels(2);
    const auto after =
        withChanged(before, "Evening", {QStringLiteral("Panel 1")}, [](light::Luminaire&) {});
    QVERIFY(!scene::diff(before, after).any());
  }

  void copiesAreNumberedOn() {
    const scene::Scene before = panels(3);
    QStringList names;
    const auto after =
        withAdded(before, "",
                  std::vector<light::Luminaire>{before.luminaires[0], before.luminaires[2]}, names);
    QCOMPARE(names, (QStringList{QStringLiteral("Panel 4"), QStringLiteral("Panel 5")}));
    QCOMPARE(after.luminaires.size(), std::size_t{5});
    names.clear();
    const auto in_layout = withAdded(after, "Evening", std::span(&before.luminaires[0], 1), names);
    QCOMPARE(names, QStringList{QStringLiteral("Panel 6")});
    QCOMPARE(in_layout.luminaires.size(), std::size_t{5});
    QCOMPARE(luminairesOf(in_layout, "Evening").size(), std::size_t{6});
    QCOMPARE(*luminairesOf(in_layout, "Evening").back().flux, 1000.0);
  }
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::LuminaireChangesTest)
#include "luminaire_changes_test.moc"
