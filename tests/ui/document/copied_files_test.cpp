// SPDX-License-Identifier: MIT
#include "ui/document/copied_files.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace soffit::ui {

class CopiedFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    for (const char* name : {"a.obj", "a.mtl", "b/b.obj", "b/deep/map.png", "own.txt"}) make(name);
  }

  void whatIsNotSavedGoes() {
    CopiedFiles files = imports();
    files.removeUnneeded();
    for (const char* name : {"a.obj", "a.mtl", "b/b.obj", "b/deep/map.png", "b"}) {
      QVERIFY2(!there(name), name);
    }
    QVERIFY(there("own.txt"));
    files.removeUnneeded();  // twice is nothing more
  }

  void whatIsSavedStays() {
    CopiedFiles files = imports();
    const std::vector<io::GeometryEntry> all{entry("a.obj"), entry("b/b.obj")};
    files.saved(path(), all);
    files.removeUnneeded();
    for (const char* name : {"a.obj", "a.mtl", "b/b.obj", "b/deep/map.png"}) {
      QVERIFY2(there(name), name);
    }
  }

  void theLastVersionThatWasSavedCounts() {
    CopiedFiles files = imports();
    const std::vector<io::GeometryEntry> all{entry("a.obj"), entry("b/b.obj")};
    files.saved(path(), all);
    files.saved(path(), std::span(all).first(1));
    files.removeUnneeded();
    QVERIFY(there("a.mtl"));
    QVERIFY(!there("b"));
  }

  void anEarlierImportStaysForALaterOne() {
    CopiedFiles files = imports();
    const std::vector<io::GeometryEntry> last{entry("b/b.obj")};
    files.saved(path(), last);
    files.removeUnneeded();
    QVERIFY(there("a.mtl"));  // b may use it
  }

  void aProjectElsewhereNeedsItsOwnAlone() {
    CopiedFiles files = imports();
    const std::vector<io::GeometryEntry> all{entry("a.obj"), entry("b/b.obj")};
    files.saved("/somewhere/else", all);
    files.removeUnneeded();
    QVERIFY(!there("a.obj"));
  }

  void aFolderOfTheUsersStays() {
    make("b/notes.txt");
    CopiedFiles files = imports();
    files.removeUnneeded();
    QVERIFY(there("b/notes.txt"));
    QVERIFY(!there("b/deep"));
  }

 private:
  static io::GeometryEntry entry(const char* file) { return {file, 1.0, {}}; }
  [[nodiscard]] std::filesystem::path path() const { return folder_->path().toStdString(); }
  [[nodiscard]] CopiedFiles imports() const {
    CopiedFiles files;
    files.add(path(), "a.obj", {"a.mtl", "a.obj"});
    files.add(path(), "b/b.obj", {"b/b.obj", "b/deep/map.png"});
    return files;
  }
  void make(const char* name) const {
    const QString file = folder_->filePath(QString::fromLatin1(name));
    QDir().mkpath(QFileInfo(file).path());
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write("x");
  }
  [[nodiscard]] bool there(const char* name) const {
    return QFile::exists(folder_->filePath(QString::fromLatin1(name)));
  }

  std::unique_ptr<QTemporaryDir> folder_;
};

}  // namespace soffit::ui

QTEST_GUILESS_MAIN(soffit::ui::CopiedFilesTest)

#include "copied_files_test.moc"
