// SPDX-License-Identifier: MIT
#include "ui/jobs/light_columns.h"

#include "core/io/project/project.h"
#include "core/relight/engine.h"

#include <QTest>

#include <algorithm>

namespace soffit::ui {

class LightColumnsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    auto project = io::loadProject(SOFFIT_SOURCE_DIR "/projects/cornell");
    scene_ = project->scene;
    scene_.quality.settings = {{"texels", 1500},  {"trainings", 8}, {"field_rays", 8},
                               {"list_rays", 16}, {"node_rays", 4}, {"max_rank", 8}};
    relight::EngineReport report;
    const auto quality = relight::qualitySettings(scene_.quality);
    solver_ = *relight::makeSolver(scene_, *quality, false, {}, report);
    light::Luminaire l = scene_.luminaires.front();
    l.dimming = 1.0;
    for (const char* group : {"A", "A", "B"}) {
      l.name = std::to_string(luminaires_.size());
      l.group = group;
      l.position.x += 0.1;
      luminaires_.push_back(l);
    }
  }
  void init() { columns_.setSolver(solver_); }

  void aMixByGroupsIsTheSum() {
    (void)total();
    luminaires_[0].dimming = luminaires_[1].dimming = 0.4;
    expectSum(total());
    luminaires_[0].colour.cct_k = luminaires_[1].colour.cct_k = 2700.0;
    expectSum(total());
    luminaires_[2].on = false;
    expectSum(total());
    luminaires_[2].on = true;
    luminaires_[1].dimming = 0.9;  // no longer one factor
    expectSum(total());
  }

  void changesOfMembershipAndPlaceAreNoticed() {
    (void)total();
    luminaires_[1].group = "B";
    expectSum(total());
    luminaires_[1].position.y += 0.2;
    expectSum(total());
    luminaires_.erase(luminaires_.begin());
    expectSum(total());
  }

  void otherReflectancesFollowWithoutABake() {
    (void)total();
    auto materials = scene_.materials;
    for (scene::Material& m : materials) m.diffuse *= 0.5;
    const auto painted = solver_->repainted(materials);
    columns_.repaint(painted);
    const relight::Planes now = total();
    relight::Lighting fresh(painted);
    QVERIFY(fresh.setLuminaires(luminaires_).ok());
    expectSame(now, fresh.total());
  }

 private:
  relight::Planes total() {
    auto answer = columns_.light("", luminaires_, std::nullopt, {});
    return answer ? answer->lux : relight::Planes{};
  }
  void expectSum(const relight::Planes& mixed) {
    relight::Lighting fresh(solver_);
    QVERIFY(fresh.setLuminaires(luminaires_).ok());
    expectSame(mixed, fresh.total());
  }
  static void expectSame(const relight::Planes& a, const relight::Planes& b) {
    for (std::size_t c = 0; c < 3; ++c) {
      QCOMPARE(a[c].size(), b[c].size());
      const float most = *std::ranges::max_element(b[c]);
      // Three sums of a few floats in another order.
      const float roundoff = 16.0F * 6e-8F * most;
      float worst = 0.0F;
      for (std::size_t s = 0; s < a[c].size(); ++s) {
        worst = std::max(worst, std::abs(a[c][s] - b[c][s]));
      }
      QVERIFY2(worst <= roundoff, qPrintable(QString::number(static_cast<double>(worst / most))));
    }
  }

  scene::Scene scene_;
  std::shared_ptr<const relight::Solver> solver_;
  std::vector<light::Luminaire> luminaires_;
  LightColumns columns_;
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::LightColumnsTest)
#include "light_columns_test.moc"
