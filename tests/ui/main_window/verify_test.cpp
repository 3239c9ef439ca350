// SPDX-License-Identifier: MIT
#include "window_fixture.h"

#include "ui/panels/verify_panel.h"

#include <QSignalSpy>

namespace soffit::ui {

/// Rough: the tests are about what becomes of a result.
VerifyWish quickWish() {
  return {.error = 0.3, .time_limit_s = 60.0, .luminaire = {}};
}

design::VerifiedPoint pointOf(const std::string& set, double value, double reference,
                              double noise) {
  design::VerifiedPoint p;
  p.set = set;
  p.value = {value, 0.0};
  p.reference = {reference, 0.0};
  p.standard_error = noise;
  return p;
}

class VerifyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QVERIFY(fixture_.open()); }
  void cleanup() { fixture_.window.reset(); }

  void aResultHoldsForTheLightThatWasVerified() {
    QVERIFY(!verification().isVerified());
    verify();
    QVERIFY(verification().isVerified());
    const design::VerifyReport& report = verification().result()->report;
    QCOMPARE(report.total.receivers.receivers, std::size_t{1000});
    QVERIFY(report.total.receivers.mean_lux > 1.0);
    QVERIFY(report.total.receivers.rms < 0.3);
    fixture_.switchFirst();
    QVERIFY(!verification().isVerified());
    fixture_.document().undoStack()->undo();
    QVERIFY(verification().isVerified());
    scene::Scene next = *fixture_.document().scene();
    next.view.exposure += 1.0;
    fixture_.document().edit(QStringLiteral("Exposure"), next);
    QVERIFY(verification().isVerified());
    next.materials.front().diffuse *= 0.5;
    fixture_.document().edit(QStringLiteral("Paint"), next);
    QVERIFY(!verification().isVerified());
  }

  void aChangeEndsTheReferenceAndSaysSo() {
    QSignalSpy stopped(&verification(), &Verification::stopped);
    VerifyWish wish = quickWish();
    wish.error = 1e-6;
    verification().start(wish);
    QTRY_COMPARE(verification().state(), Verification::State::running);
    fixture_.switchFirst();
    QCOMPARE(verification().state(), Verification::State::idle);
    QCOMPARE(stopped.count(), 1);
    QVERIFY(!stopped[0][0].toString().isEmpty());
    QVERIFY(verification().result() == nullptr);
  }

  void cancellingIsNoFault() {
    QSignalSpy stopped(&verification(), &Verification::stopped);
    VerifyWish wish = quickWish();
    wish.error = 1e-6;
    verification().start(wish);
    QTRY_COMPARE(verification().state(), Verification::State::running);
    fixture_.trigger(QStringLiteral("&Stop computing"));
    QCOMPARE(verification().state(), Verification::State::idle);
    QVERIFY(stopped[0][0].toString().isEmpty());
  }

  void theMapShowsWhatIsInSight() {
    verify();
    ErrorMap& map = fixture_.window->workspace().area->errors();
    QVERIFY(!map.isVisible());
    QVERIFY(fixture_.trigger(QStringLiteral("Show the &errors in the view")));
    QVERIFY(map.isVisible());
    (void)map.grab();
    QVERIFY(map.drawn() > 50);
    QVERIFY(map.drawn() < static_cast<int>(map.points().size()));
    // Every view has them, but for one that shows another layout.
    ViewArea& area = *fixture_.window->workspace().area;
    area.grid().setArrangement(ViewGrid::Arrangement::four);
    QCOMPARE(area.errors(3).points().size(), map.points().size());
    QVERIFY(area.errors(1).isVisible());
    const std::string& other = fixture_.document().scene()->layouts.back().name;
    Q_EMIT area.grid().pane(1).bar().layoutChosen(QString::fromStdString(other));
    QVERIFY(area.errors(1).points().empty());
    Q_EMIT area.grid().pane(1).bar().layoutChosen(std::nullopt);
    QVERIFY(!area.errors(1).points().empty());
    area.grid().setArrangement(ViewGrid::Arrangement::one);
    fixture_.switchFirst();
    QVERIFY(!map.isVisible());
  }

  void figuresCanBeCopied() {
    verify();
    const QString text = fixture_.window->workspace().verify->text();
    QVERIFY(text.contains(QStringLiteral("RMS")));
    QVERIFY(text.contains(QStringLiteral("1,000")) || text.contains(QStringLiteral("1000")));
  }

  void errorsAreRelativeToTheirOwnSet() {
    design::VerifyReport report;
    report.points = {pointOf("surface", 110.0, 100.0, 1.0), pointOf("surface", 0.5, 0.0, 0.1),
                     pointOf("desk", 990.0, 1000.0, 5.0), pointOf("cellar", 0.0, 0.0, 0.0)};
    const auto points = errorPointsOf(report);
    QCOMPARE(points.size(), std::size_t{3});  // of a set without any light nothing can be said
    QCOMPARE(points[0].error, 0.1);
    QCOMPARE(points[0].noise, 0.01);
    QCOMPARE(points[1].error, 0.5 / (0.05 * 50.0));
    QCOMPARE(points[2].error, -0.01);
    QCOMPARE(fittingErrorScale({}), 0.01);
    QCOMPARE(fittingErrorScale(points), 0.2);
  }

 private:
  Verification& verification() { return fixture_.window->session()->verification(); }
  void verify() {
    QSignalSpy finished(&verification(), &Verification::finished);
    verification().start(quickWish());
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kPatienceMs);
  }

  WindowFixture fixture_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::prepareProgram();
  QApplication application(argc, argv);
  soffit::ui::nameProgram(QStringLiteral("verify-test"));
  soffit::ui::VerifyTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "verify_test.moc"
