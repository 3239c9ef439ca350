// SPDX-License-Identifier: MIT
#pragma once

#include "ui/actions/picture_job.h"
#include "ui/main_window/comparison_session.h"
#include "ui/main_window/light_marks.h"

#include <QObject>
#include <QSize>
#include <QStringList>

#include <deque>
#include <optional>

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
  bool traced = false;  ///< as `soffit render` makes them, where that shows the same
};

/// Pictures of a project's view: into files, into the clipboard, and sets over cameras and layouts.
/// They are made in the background, from what the view was when they were asked for; a set waits
/// for the light of each layout.
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
  void exportView(const QString& path, const QSize& pixels, bool legend, bool title,
                  bool traced = false);
  void exportSet(const PictureSet& set);
  /// Gives up what is under way; pictures that are written stay.
  void cancel();
  [[nodiscard]] bool isBusy() const { return asked_ > 0; }

 Q_SIGNALS:
  void written(const QString& path);
  /// The rest of a set is given up.
  void failed(const QString& message);
  void copied();
  /// A set ended, with so many pictures.
  void setFinished(int count);

 private:
  struct Wanted {
    QString camera;  ///< empty: the view as it stands
    QString layout;
    QString path;  ///< empty: the clipboard
    QSize pixels;
    bool legend = true;
    bool title = false;
    bool traced = false;
    bool of_set = false;
  };
  /// Nothing while its light is not there.
  [[nodiscard]] std::optional<PictureOrder> order(const Wanted& wanted) const;
  [[nodiscard]] QString titleOf(const render::PictureFacts& facts) const;
  /// Of the view as it is now.
  void take(const Wanted& wanted);
  void start(PictureOrder order, const Wanted& wanted);
  void end(const Wanted& wanted, const PictureOutcome& outcome);
  void next();
  void showProgress(double within);
  void endProgress();

  Document& document_;
  Workspace& workspace_;
  ComparisonSession& comparison_;
  const LightMarks& marks_;
  std::deque<Wanted> left_;  ///< of the set
  bool set_running_ = false;
  bool set_drawing_ = false;  ///< one of its pictures is under way
  int set_written_ = 0;
  int asked_ = 0;  ///< since nothing was under way
  int ended_ = 0;
  PictureJob job_;
};

}  // namespace soffit::ui
