// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"
#include "ui/jobs/light_frame.h"

#include <QWidget>

class QLabel;
class QTableWidget;
class QTableWidgetItem;
class QToolButton;

namespace soffit::ui {

/// The probes of the project with their readings, and who lights the chosen one: its luminaires,
/// brightest first. Names are edited in place; each change is one undo step.
class ProbesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ProbesPanel(QWidget* parent = nullptr);
  void setDocument(Document* document);
  /// The light that the probes are read in.
  void setFrame(LightFramePtr frame);
  /// Reads them where they are at present: one is being dragged.
  void setPlaces(const std::vector<io::Probe>& probes);

  /// -1: none.
  [[nodiscard]] int chosen() const;
  void choose(int probe);
  void removeChosen();

 Q_SIGNALS:
  void chosenChanged(int probe);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void showShares();
  void takeName(const QTableWidgetItem& item);

  Document* document_ = nullptr;
  LightFramePtr frame_;
  std::vector<io::Probe> probes_;
  QTableWidget* table_;
  QTableWidget* shares_;
  QLabel* whose_;
  QToolButton* remove_;
  bool filling_ = false;
};

}  // namespace soffit::ui
