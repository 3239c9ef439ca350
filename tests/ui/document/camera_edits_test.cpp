// SPDX-License-Identifier: MIT
#include "ui/document/camera_edits.h"

#include <QTest>

namespace soffit::ui {

class CameraEditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    io::Project project;
    project.scene.mesh = std::make_shared<const geometry::Mesh>();
    for (const char* name : {"Entrance", "Desks", "Window"}) {
      project.scene.cameras.push_back({name, {1, 1, 1.6}, {6, 4, 1.2}, 50.0});
    }
    document_ = std::make_unique<Document>(std::move(project));
  }

  void aNewCameraIsTheLastAndItsNameIsFree() {
    QCOMPARE(freeCameraName(*document_->scene()), QStringLiteral("View 1"));
    addCamera(*document_, {"View 1", {0, 0, 1}, {1, 0, 1}, 60.0});
    QCOMPARE(freeCameraName(*document_->scene()), QStringLiteral("View 2"));
    QCOMPARE(names(), QStringLiteral("Entrance Desks Window View 1"));
  }

  void updatingKeepsNameAndPlace() {
    updateCamera(*document_, {"Desks", {9, 9, 2}, {0, 0, 1}, 35.0});
    QCOMPARE(names(), QStringLiteral("Entrance Desks Window"));
    QCOMPARE(document_->scene()->cameras[1].vertical_fov_deg, 35.0);
    updateCamera(*document_, {"Nowhere", {9, 9, 2}, {0, 0, 1}, 35.0});
    QCOMPARE(document_->undoStack()->count(), 1);
  }

  void namesStayUniqueAndAreNotEmpty() {
    QVERIFY(renameCamera(*document_, QStringLiteral("Desks"), QStringLiteral(" Tables ")));
    QCOMPARE(names(), QStringLiteral("Entrance Tables Window"));
    QVERIFY(!renameCamera(*document_, QStringLiteral("Tables"), QStringLiteral("Window")));
    QVERIFY(!renameCamera(*document_, QStringLiteral("Tables"), QStringLiteral("  ")));
    QCOMPARE(document_->undoStack()->count(), 1);
  }

  void camerasAreMovedAndDeleted() {
    moveCamera(*document_, QStringLiteral("Entrance"), 2);
    QCOMPARE(names(), QStringLiteral("Desks Window Entrance"));
    moveCamera(*document_, QStringLiteral("Window"), 0);
    QCOMPARE(names(), QStringLiteral("Window Desks Entrance"));
    moveCamera(*document_, QStringLiteral("Window"), -1);  // is there already
    QCOMPARE(document_->undoStack()->count(), 2);
    removeCamera(*document_, QStringLiteral("Desks"));
    QCOMPARE(names(), QStringLiteral("Window Entrance"));
  }

  void eachChangeIsAStepBack() {
    addCamera(*document_, {"View 1", {0, 0, 1}, {1, 0, 1}, 60.0});
    renameCamera(*document_, QStringLiteral("View 1"), QStringLiteral("Corner"));
    moveCamera(*document_, QStringLiteral("Corner"), 0);
    updateCamera(*document_, {"Corner", {9, 9, 2}, {0, 0, 1}, 35.0});
    removeCamera(*document_, QStringLiteral("Desks"));
    QCOMPARE(document_->undoStack()->count(), 5);
    for (int i = 0; i < 5; ++i) document_->undoStack()->undo();
    QCOMPARE(names(), QStringLiteral("Entrance Desks Window"));
  }

 private:
  [[nodiscard]] QString names() const {
    QStringList all;
    for (const scene::Camera& c : document_->scene()->cameras)
      all.append(QString::fromStdString(c.name));
    return all.join(QLatin1Char(' '));
  }
  std::unique_ptr<Document> document_;
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::CameraEditsTest)
#include "camera_edits_test.moc"
