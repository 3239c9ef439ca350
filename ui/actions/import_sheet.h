// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/import_project.h"
#include "ui/jobs/background.h"

#include <QDialog>
#include <QString>

#include <map>
#include <optional>
#include <stop_token>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QRadioButton;

namespace soffit::ui {

class QuantityBox;
class SizePreview;

/// Asks how a model is to be read, on one sheet: its unit, its up axis, and where it goes; shows
/// how large it becomes. The model is read in the background.
class ImportSheet : public QDialog {
  Q_OBJECT

 public:
  /// open_project: the name of the project that it can be added to; empty: there is none.
  ImportSheet(const QString& model, const QString& open_project, QWidget* parent = nullptr);
  ~ImportSheet() override;

  [[nodiscard]] double unit() const;
  [[nodiscard]] std::optional<char> up() const;
  /// Whether the model is added to the open project instead of making a new one.
  [[nodiscard]] bool toOpenProject() const;
  /// The file of the new project.
  [[nodiscard]] QString newProject() const;
  /// The size with the choices made, m; nothing while it is not known.
  [[nodiscard]] std::optional<dvec3> size() const;

 private:
  void measure();
  void showSize();
  void browse();
  void updateButtons();

  QString model_;
  std::map<std::optional<char>, Result<io::ModelSize>> known_;  ///< in units of the file
  QComboBox* unit_;
  QComboBox* up_;
  SizePreview* preview_;
  QLabel* facts_;
  QRadioButton* to_new_;
  QRadioButton* to_open_;
  QLineEdit* place_;
  QDialogButtonBox* buttons_;
  std::stop_source stop_;
  Background background_;
};

}  // namespace soffit::ui
