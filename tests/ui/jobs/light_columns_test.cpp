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
    for (const char* group : {"A", "A", "B", "A", "A", "A"}) {  // sums are made of more than three
      l.name = std::to_string(luminaires_.size());
      l.group = group;
      l.position.x += 0.05;
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

  void oneLuminaireOfManyIsDimmedAndSwitchedOften() {
    const auto before = luminaires_;
    for (light::Luminaire& l : luminaires_) l.group = "A";
    (void)total();
    for (int i = 0; i < 150;
         ++i) {  // beyond the differences that are added before a sum is renewed
      luminaires_[1].dimming = 0.01 * (i % 90);
      (void)total();
    }
    expectSum(total(), 1e-5F);             // as GroupSums promises
    luminaires_[1].colour.cct_k = 2700.0;  // channels change by different signs
    expectSum(total(), 1e-5F);
    for (light::Luminaire& l : luminaires_) {
      l.on = false;
      (void)total();
    }
    const relight::Planes dark = total();
    for (const auto& plane : dark)
      QVERIFY(std::ranges::all_of(plane, [](float e) { return e == 0.0F; }));
    luminaires_ = before;
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

  void severalInHandMoveTogether() {
    const auto before = luminaires_;
    (void)total();
    const std::vector<std::size_t> hand{0, 2, 3};
    for (int step = 0; step < 3; ++step) {
      for (const std::size_t i : hand) luminaires_[i].position.y += 0.05;
      const auto answer = columns_.light("", luminaires_, hand, {});
      QVERIFY(answer.ok());
      QVERIFY(answer->times.direct > 0.0);  // a move, and no light of every luminaire
      expectSum(answer->lux, 1e-3F);        // energy is conserved by the sum
    }
    expectSum(total());
    // A mix in hand needs no move.
    luminaires_[0].dimming = luminaires_[2].dimming = luminaires_[3].dimming = 0.5;
    const auto dimmed = columns_.light("", luminaires_, hand, {});
    QVERIFY(dimmed.ok());
    QCOMPARE(dimmed->times.total(), 0.0);
    expectSum(dimmed->lux);
    luminaires_ = before;
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

  void paintOfManyIsShownAtOnce() {
    const auto before = luminaires_;
    while (luminaires_.size() < 5) {
      luminaires_.push_back(luminaires_.back());
      luminaires_.back().name += "+";
      luminaires_.back().position.x -= 0.07;
    }
    (void)total();
    QVERIFY(!columns_.paintedLight("", luminaires_).has_value());  // nothing was painted
    auto materials = scene_.materials;
    for (scene::Material& m : materials) m.diffuse *= 0.5;
    columns_.repaint(solver_->repainted(materials));
    const auto quick = columns_.paintedLight("", luminaires_);
    QVERIFY(quick.has_value());
    const relight::Planes whole = total();
    double difference = 0.0;
    double sum = 0.0;
    for (std::size_t s = 0; s < whole[1].size(); ++s) {
      difference += std::abs(static_cast<double>(quick->lux[1][s] - whole[1][s]));
      sum += static_cast<double>(whole[1][s]);
    }
    QVERIFY(difference < 1e-3 * sum);
    columns_.repaint(solver_->repainted(scene_.materials));
    luminaires_[1].position.y += 0.1;  // more than paint: the ordinary way
    QVERIFY(!columns_.paintedLight("", luminaires_).has_value());
    luminaires_ = before;
  }

 private:
  relight::Planes total() {
    auto answer = columns_.light("", luminaires_, {}, {});
    return answer ? answer->lux : relight::Planes{};
  }
  /// Three sums of a few floats in another order.
  static constexpr float kRounding = 16.0F * 6e-8F;

  void expectSum(const relight::Planes& mixed, float roundoff = kRounding) {
    relight::Lighting fresh(solver_);
    QVERIFY(fresh.setLuminaires(luminaires_).ok());
    expectSame(mixed, fresh.total(), roundoff);
  }
  static void expectSame(const relight::Planes& a, const relight::Planes& b,
                         float share = kRounding) {
    for (std::size_t c = 0; c < 3; ++c) {
      QCOMPARE(a[c].size(), b[c].size());
      const float most = *std::ranges::max_element(b[c]);
      const float roundoff = share * most;
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
