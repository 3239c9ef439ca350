// SPDX-License-Identifier: MIT
#include "ui/viewport/lux_marks.h"

#include <QImage>
#include <QTest>

#include <algorithm>

namespace soffit::ui {

class LuxMarksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    marks_ = LuxMarks();
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        marks_.numbers.push_back(
            {dvec3(0.25 * i, 0.25 * j, 0.8), 100.0 + i, gridRank(i, j, kSide, kSide)});
      }
    }
  }

  void numbersNeverTouchAndStayInThePicture_data() {
    QTest::addColumn<double>("distance");
    for (const double distance : {1.5, 6.0, 25.0, 80.0}) {
      QTest::addRow("%g m", distance) << distance;
    }
  }
  void numbersNeverTouchAndStayInThePicture() {
    QFETCH(double, distance);
    const SeenMarks seen = seenFrom(marks_, from(distance), QFont());
    QVERIFY(!seen.numbers.empty());
    const QRectF picture(0.0, 0.0, kSize.x, kSize.y);
    for (std::size_t a = 0; a < seen.numbers.size(); ++a) {
      QVERIFY(picture.contains(seen.numbers[a].box));
      for (std::size_t b = 0; b < a; ++b) {
        QVERIFY(!seen.numbers[a].box.intersects(seen.numbers[b].box));
      }
    }
  }

  void nearerMeansMoreOfThem() {
    const auto far = seenFrom(marks_, from(40.0), QFont()).numbers.size();
    const auto near = seenFrom(marks_, from(12.0), QFont()).numbers.size();
    QVERIFY(near > far);
  }

  void hiddenPlacesAreLeftOut() {
    Sight sight = from(6.0);
    sight.visible = [](const dvec3& place) { return place.x < 1.0; };
    for (const auto& number : seenFrom(marks_, sight, QFont()).numbers) {
      QVERIFY(number.text.toInt() < 104);
    }
    sight.visible = [](const dvec3&) { return false; };
    marks_.pins.push_back(
        {dvec3(1.0, 1.0, 0.8), QStringLiteral("A"), QStringLiteral("1 lx"), false});
    marks_.lines.push_back({{dvec3(0.0, 0.0, 0.8), dvec3(2.0, 2.0, 0.8)}, false, 100.0});
    const SeenMarks seen = seenFrom(marks_, sight, QFont());
    QVERIFY(seen.numbers.empty() && seen.lines.empty() && seen.pins.empty());
  }

  void linesBreakWhereTheyAreHidden() {
    LuxMarks::Line line;
    for (int i = 0; i <= 20; ++i) line.points.emplace_back(0.1 * i, 1.0, 0.8);
    marks_.lines.push_back(line);
    Sight sight = from(6.0);
    sight.visible = [](const dvec3& p) { return p.x < 0.65 || p.x > 1.35; };
    const SeenMarks seen = seenFrom(marks_, sight, QFont());
    QCOMPARE(seen.lines.size(), std::size_t{2});
    QCOMPARE(seen.lines[0].points.size(), qsizetype{7});
    QCOMPARE(seen.lines[1].points.size(), qsizetype{7});
  }

  void numbersAreInTheUnitOfTheScale() {
    marks_.numbers = {{dvec3(1.0, 1.0, 0.8), 50.0 * color::kLuxPerFootcandle, 0}};
    marks_.scale.unit = color::LuxUnit::footcandle;
    const SeenMarks seen = seenFrom(marks_, from(6.0), QFont());
    QCOMPARE(seen.numbers.size(), std::size_t{1});
    QCOMPARE(seen.numbers[0].text, QStringLiteral("50.0"));
  }

  void labelsOfLinesKeepClearOfNumbers() {
    SeenMarks seen = seenFrom(marks_, from(6.0), QFont());
    const QPointF taken = seen.numbers.front().box.center();
    std::vector<render::LineLabel> labels{{vec2(dvec2(taken.x(), taken.y())), 100.0},
                                          {vec2(40.0F, 30.0F), 7.5}};
    seen.numbers.resize(1);
    addLineLabels(labels, 1.0, {}, QFont(), seen);
    QCOMPARE(seen.labels.size(), std::size_t{1});
    QCOMPARE(seen.labels[0].text, QStringLiteral("7.5"));
  }

  void numbersAndLabelsKeepClearOfPins() {
    marks_.pins.push_back(
        {dvec3(2.0, 2.0, 0.8), QStringLiteral("Desk"), QStringLiteral("512 lx"), false});
    SeenMarks seen = seenFrom(marks_, from(12.0), QFont());
    QCOMPARE(seen.pins.size(), std::size_t{1});
    const QRectF plate = seen.pins.front().plate.box;
    QVERIFY(!seen.numbers.empty());
    for (const auto& number : seen.numbers) QVERIFY(!number.box.intersects(plate));
    seen.numbers.clear();
    const QPointF taken = plate.center();
    addLineLabels({{vec2(dvec2(taken.x(), taken.y())), 100.0}}, 1.0, {}, QFont(), seen);
    QVERIFY(seen.labels.empty());
  }

  void aGridThinsFromItsMiddleRegularly() {
    QCOMPARE(gridRank(8, 8, 17, 17), 0);
    QCOMPARE(gridRank(0, 8, 17, 17), 1);
    QCOMPARE(gridRank(4, 8, 17, 17), 2);
    QCOMPARE(gridRank(8, 7, 17, 17), 4);
    int coarse = 0;
    for (int i = 0; i < 17; ++i) {
      for (int j = 0; j < 17; ++j) coarse += gridRank(i, j, 17, 17) <= 2 ? 1 : 0;
    }
    QCOMPARE(coarse, 25);  // every fourth either way
  }

  void everythingIsPaintedIntoAPicture() {
    marks_.borders.push_back(
        {dvec3(0.0, 0.0, 0.8), dvec3(4.0, 0.0, 0.8), dvec3(4.0, 4.0, 0.8), dvec3(0.0, 4.0, 0.8)});
    marks_.lines.push_back({{dvec3(0.0, 0.0, 0.8), dvec3(2.0, 2.0, 0.8)}, false, 100.0});
    marks_.pins.push_back(
        {dvec3(1.0, 1.0, 0.8), QStringLiteral("A"), QStringLiteral("1 lx"), true});
    QImage picture(static_cast<int>(kSize.x), static_cast<int>(kSize.y), QImage::Format_RGB888);
    picture.fill(Qt::gray);
    const QImage before = picture;
    QPainter painter(&picture);
    paint(painter, seenFrom(marks_, from(6.0), QFont()));
    painter.end();
    QVERIFY(picture != before);
  }

 private:
  static constexpr int kSide = 17;
  static constexpr dvec2 kSize{800.0, 500.0};

  /// From above the middle of the plane, a little from the side.
  static Sight from(double distance) {
    const dvec3 middle(2.0, 2.0, 0.8);
    return {
        ViewCamera::from({"", middle + distance * dvec3(0.0, -0.6, 0.8), middle, 40.0}), kSize, {}};
  }

  LuxMarks marks_;
};

}  // namespace soffit::ui

QTEST_MAIN(soffit::ui::LuxMarksTest)
#include "lux_marks_test.moc"
