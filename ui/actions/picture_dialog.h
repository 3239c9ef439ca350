// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QSize>
#include <QString>
#include <QStringList>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QSpinBox;

namespace soffit::ui {

/// The largest side of a picture, px: what graphics cards draw in one go.
inline constexpr int kLargestPicture = 8192;

/// What a picture of the view, or a set of pictures, is to be like: size, format, what is printed
/// into it, and for a set of which cameras and layouts.
class PictureDialog : public QDialog {
  Q_OBJECT

 public:
  /// One picture. view: its physical pixels.
  PictureDialog(const QSize& view, QWidget* parent = nullptr);
  /// A set. layouts: empty names are the base.
  PictureDialog(const QSize& view, const QStringList& cameras, const QStringList& layouts,
                QWidget* parent = nullptr);

  [[nodiscard]] QSize pixels() const;
  /// "png", "jpg", "tif" or "exr".
  [[nodiscard]] QString format() const;
  [[nodiscard]] bool legend() const;
  [[nodiscard]] bool title() const;
  /// With exact shadows and reflections instead of as the live view.
  [[nodiscard]] bool traced() const;
  void setTraced(bool traced);
  /// Of a set.
  [[nodiscard]] QStringList cameras() const;
  [[nodiscard]] QStringList layouts() const;

 private:
  void build(const QSize& view);
  void addLists(const QStringList& cameras, const QStringList& layouts);
  void takePreset();
  void updateButtons();

  QComboBox* preset_;
  QSpinBox* width_;
  QSpinBox* height_;
  QComboBox* rendering_;
  QComboBox* format_;
  QCheckBox* legend_;
  QCheckBox* title_;
  QListWidget* cameras_ = nullptr;
  QListWidget* layouts_ = nullptr;
  QLabel* count_ = nullptr;
  QWidget* accept_ = nullptr;
};

}  // namespace soffit::ui
