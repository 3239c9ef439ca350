// SPDX-License-Identifier: MIT
#include "ui/main_window/project_files.h"

#include "core/scene/diff.h"
#include "tests/ui/main_window/window_fixture.h"
#include "ui/actions/file_dialogs.h"
#include "ui/actions/import_sheet.h"
#include "ui/actions/recovery_dialog.h"
#include "ui/document/recent_files.h"
#include "ui/document/state_folder.h"
#include "ui/document/text.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>

#include <csignal>

namespace soffit::ui {

/// A closed room of 600 x 400 x 300 units.
const QByteArray kRoom =
    "mtllib room.mtl\n"
    "v 0 0 0\nv 600 0 0\nv 600 400 0\nv 0 400 0\nv 0 0 300\nv 600 0 300\nv 600 400 300\nv 0 400 "
    "300\n"
    "usemtl plaster\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class ProjectFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { fixture_ = std::make_unique<WindowFixture>(); }
  void cleanup() { fixture_.reset(); }

  void saveAsTakesTheProjectAnywhere() {
    QVERIFY(fixture_->open());
    fixture_->switchFirst();
    const QString place = fixture_->folder.filePath(QStringLiteral("else/where/moved.soffit"));
    QVERIFY(saveAs(fixture_->window.get(), document(), place));
    QCOMPARE(document().path(), place);
    QVERIFY(!document().isModified());
    QVERIFY(QFile::exists(fixture_->folder.filePath(QStringLiteral("else/where/cornell.mtl"))));
    const auto moved = io::loadProject(place.toStdString());
    QVERIFY(moved.ok());
    QVERIFY(!scene::diff(*document().scene(), moved->scene).any());
    // From now on it is saved there, the version before kept.
    fixture_->switchFirst();
    QVERIFY(fixture_->trigger(QStringLiteral("&Save")));
    QVERIFY(QFile::exists(place + QLatin1Char('~')));
    QVERIFY(recentFiles().contains(place));
  }

  void aNewProjectHasNoPlaceUntilItIsSaved() {
    QVERIFY(fixture_->showWindow());
    QVERIFY(fixture_->trigger(QStringLiteral("&New")));
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session() != nullptr, kPatienceMs);
    const QString untitled = document().path();
    QVERIFY(isUntitledProject(untitled));
    QVERIFY(!recentFiles().contains(untitled));
    const QString place = fixture_->folder.filePath(QStringLiteral("mine/mine.soffit"));
    QVERIFY(saveAs(fixture_->window.get(), document(), place));
    QVERIFY(!QFile::exists(untitled));
    QVERIFY(QFile::exists(place));
    // One that is closed without changes leaves nothing.
    QVERIFY(fixture_->trigger(QStringLiteral("&New")));
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session() != nullptr && document().path() != place,
                             kPatienceMs);
    const QString second = document().path();
    QVERIFY(fixture_->window->close());
    QVERIFY(!QFile::exists(second));
  }

  void aModelIsImportedIntoANewProject() {
    QVERIFY(fixture_->showWindow());
    const QString model = writeRoom();
    const QString place = fixture_->folder.filePath(QStringLiteral("house/house.soffit"));
    std::optional<dvec3> metres;
    std::optional<dvec3> centimetres;
    WindowFixture::whenAsked<ImportSheet>([&](ImportSheet& sheet) {
      if (!sheet.size()) return false;
      metres = sheet.size();
      sheet.findChild<QComboBox*>()->setCurrentIndex(1);
      centimetres = sheet.size();
      sheet.findChild<QLineEdit*>()->setText(place);
      sheet.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
      return true;
    });
    fixture_->window->files().openFile(model);
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session() != nullptr, kPatienceMs);
    QCOMPARE(metres->x, 600.0);
    QVERIFY(std::abs(centimetres->z - 3.0) < 1e-6);
    QCOMPARE(document().path(), place);
    QCOMPARE(document().scene()->mesh->triangleCount(), std::size_t{12});
    QVERIFY(std::abs(document().scene()->mesh->bounds().size().x - 6.0F) < 1e-4F);
  }

  void aModelJoinsTheOpenProjectAsOneStep() {
    QVERIFY(fixture_->open());
    const std::size_t before = document().scene()->mesh->triangleCount();
    const QString model = writeRoom();
    WindowFixture::whenAsked<ImportSheet>([](ImportSheet& sheet) {
      if (!sheet.size() || !sheet.toOpenProject()) return false;
      sheet.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
      return true;
    });
    fixture_->window->files().openFile(model);
    QTRY_COMPARE_WITH_TIMEOUT(document().scene()->mesh->triangleCount(), before + 12, kPatienceMs);
    QCOMPARE(document().undoStack()->count(), 1);
    QVERIFY(fixture_->trigger(QStringLiteral("&Save")));
    QCOMPARE(io::loadProject(fixture_->project.toStdString())->geometry.size(), std::size_t{2});
    document().undoStack()->undo();
    QCOMPARE(document().scene()->mesh->triangleCount(), before);
    QVERIFY(fixture_->trigger(QStringLiteral("&Save")));
    QCOMPARE(io::loadProject(fixture_->project.toStdString())->geometry.size(), std::size_t{1});
    // Its files are there as long as a redo may want them.
    QVERIFY(QFile::exists(fixture_->folder.filePath(QStringLiteral("room.obj"))));
    QVERIFY(fixture_->window->close());
    QVERIFY(!QFile::exists(fixture_->folder.filePath(QStringLiteral("room.obj"))));
    QVERIFY(!QFile::exists(fixture_->folder.filePath(QStringLiteral("room.mtl"))));
    QVERIFY(QFile::exists(fixture_->folder.filePath(QStringLiteral("cornell.obj"))));
  }

  void anImportedProjectHasNoSecondBase() {
    const auto made = io::importProject(
        toPath(writeRoom()), toPath(fixture_->folder.filePath(QStringLiteral("h.soffit"))), {});
    QVERIFY(made.ok());
    LayoutsPanel panel;
    Document document(*made);
    panel.setDocument(&document);
    auto* list = panel.findChild<QListWidget*>();
    QCOMPARE(list->findItems(QStringLiteral("Base"), Qt::MatchExactly).size(), 1);
    panel.setDocument(nullptr);
  }

  void filesAreDroppedOnTheWindow() {
    QVERIFY(fixture_->showWindow());
    QMimeData nothing;
    nothing.setText(QStringLiteral("x"));
    QVERIFY(ProjectFiles::droppable(&nothing).isEmpty());
    QFile copy(fixture_->project);
    QVERIFY(copy.open(QIODevice::WriteOnly));
    copy.write(fixture_->text);
    copy.close();
    QMimeData mime;
    mime.setUrls({QUrl::fromLocalFile(fixture_->project)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(fixture_->window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({10, 10}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(fixture_->window.get(), &drop);
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session() != nullptr, kPatienceMs);
    QCOMPARE(document().path(), fixture_->project);
  }

  void aProgramThatIsKilledLosesLittle() {
    QFile copy(fixture_->project);
    QVERIFY(copy.open(QIODevice::WriteOnly));
    copy.write(fixture_->text);
    copy.close();
    QProcess victim;
    victim.setProcessChannelMode(QProcess::ForwardedChannels);
    victim.start(QApplication::applicationFilePath(),
                 {QStringLiteral("--victim"), fixture_->project});
    QVERIFY(victim.waitForStarted());
    const auto kept = [] {
      return !QDir(recoveryFolder()).entryList({QStringLiteral("*.json")}, QDir::Files).isEmpty();
    };
    QTRY_VERIFY_WITH_TIMEOUT(kept(), kPatienceMs);
    QVERIFY2(findRecoveries().isEmpty(), "its program still runs");
    ::kill(static_cast<pid_t>(victim.processId()), SIGKILL);
    QVERIFY(victim.waitForFinished());

    const QList<Recovery> found = findRecoveries();
    QCOMPARE(found.size(), 1);
    QCOMPARE(found.front().path, fixture_->project);
    // The next start offers it.
    QVERIFY(fixture_->showWindow());
    WindowFixture::whenAsked<RecoveryDialog>([](RecoveryDialog& dialog) {
      dialog.accept();
      return true;
    });
    fixture_->window->files().offerRecovery();
    QTRY_VERIFY_WITH_TIMEOUT(fixture_->window->session() != nullptr, kPatienceMs);
    QVERIFY(document().isModified());
    QVERIFY(!document().luminaires().front().on);
    QCOMPARE(document().path(), fixture_->project);
    // What was recovered is kept anew at once, then the old version goes.
    QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(recoveryFile(found.front().id, QStringLiteral("json"))),
                             kPatienceMs);
    QVERIFY(kept());
    QVERIFY(fixture_->trigger(QStringLiteral("&Save")));
    QVERIFY(!document().isModified());
    QTRY_VERIFY_WITH_TIMEOUT(!kept(), kPatienceMs);
    const auto saved = io::loadProject(fixture_->project.toStdString());
    QVERIFY(saved.ok());
    QVERIFY(!saved->scene.layouts.front().edits.empty());
  }

  void versionsCanBeDiscarded() {
    const QString id = QStringLiteral("old");
    QFile text(recoveryFile(id, QStringLiteral("soffit")));
    QVERIFY(text.open(QIODevice::WriteOnly));
    QFile facts(recoveryFile(id, QStringLiteral("json")));
    QVERIFY(facts.open(QIODevice::WriteOnly));
    facts.write("{\"path\": \"/somewhere/a.soffit\", \"name\": \"A\"}");
    facts.close();
    text.close();
    const auto found = findRecoveries();
    QCOMPARE(found.size(), 1);
    RecoveryDialog dialog(found);
    for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
      if (button->text() == QStringLiteral("Discard")) button->click();
    }
    QVERIFY(findRecoveries().isEmpty());
  }

 private:
  Document& document() { return fixture_->document(); }
  QString writeRoom() {
    QDir(fixture_->folder.path()).mkpath(QStringLiteral("models"));
    QFile mtl(fixture_->folder.filePath(QStringLiteral("models/room.mtl")));
    if (mtl.open(QIODevice::WriteOnly)) mtl.write("newmtl plaster\nKd 0.7 0.7 0.7\n");
    QFile obj(fixture_->folder.filePath(QStringLiteral("models/room.obj")));
    if (obj.open(QIODevice::WriteOnly)) obj.write(kRoom);
    return obj.fileName();
  }

  std::unique_ptr<WindowFixture> fixture_;
};

/// The program that is killed: opens a project, changes it, and works on.
int runVictim(QApplication& application, const QString& project) {
  MainWindow window;
  window.show();
  window.open(project);
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
    if (window.session() == nullptr) return;
    timer.stop();
    Document& document = window.session()->document();
    document.editLuminaires(QStringLiteral("Switch off"),
                            {toQt(document.luminaires().front().name)},
                            [](light::Luminaire& l) { l.on = false; });
  });
  timer.start(50);
  return application.exec();
}

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::prepareProgram();
  QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() == 3 && arguments[1] == QStringLiteral("--victim")) {
    return soffit::ui::runVictim(application, arguments[2]);
  }
  soffit::ui::nameProgram(QStringLiteral("soffit-files-test"));
  soffit::ui::ProjectFilesTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "project_files_test.moc"
