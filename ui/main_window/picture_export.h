// SPDX-License-Identifier: MIT
#pragma once

#include "ui/actions/picture_file.h"
#include "ui/jobs/background.h"
#include "ui/main_window/comparison_session.h"
#include "ui/main_window/light_marks.h"

#include <QObject>
#include <QSize>
#include <QStringList>

#include <deque>

namespace soffit::ui {

/// What is taken along for each picture of a set.
struct PictureSet {
  QStringList cameras;  ///< names; an empty one is the view as it stands
  QStringList layouts;  ///< names, empty for the base
  QSize pixels;
  QString format = QStringLiteral("png");
  QString folder;
  bool legend = true;
  bool title = false;
};

/// Pictures of a project's view: into files, into the clipboard, and sets over cameras and layouts.
/// The set waits for the light of each layout and draws one picture per turn of the event loop.
class PictureExport : public QObject {
  Q_OBJECT

 public:
  PictureExport(Document& document, Workspace& workspace, ComparisonSession& comparison,
                const LightMarks& marks);

  /// Asks for size, format and file.
  void exportView();
  /// Asks for cameras, layouts, size, format and folder.
  void exportSet();
  void copyView();

  /// The same without asking. Told by written() or failed().
  void exportView(const QString& path, const QSize& pixels, bool legend, bool title);
  void exportSet(const PictureSet& set);
  /// Gives up the set; pictures that are written stay.
  void cancel();
  [[nodiscard]] bool isBusy() const { return !left_.empty() || background_.isBusy(); }

 Q_SIGNALS:
  void written(const QString& path);
  void failed(const QString& message);
  /// A set ended, with so many pictures.
  void setFinished(int count);

 private:
  struct Wanted {
    QString camera;
    QString layout;
  };
  [[nodiscard]] PictureFile take(const QString& path, const QSize& pixels, const Wanted& wanted,
                                 bool linear) const;
  [[nodiscard]] QString pathOf(const Wanted& wanted) const;
  [[nodiscard]] QString titleOf(const render::PictureFacts& facts) const;
  void write(PictureFile file);
  void next();

  Document& document_;
  Workspace& workspace_;
  ComparisonSession& comparison_;
  const LightMarks& marks_;
  PictureSet set_;
  std::deque<Wanted> left_;
  int count_ = 0;
  int taken_ = 0;
  Background background_;
};

}  // namespace soffit::ui
