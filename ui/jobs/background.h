// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QThreadPool>

#include <functional>

namespace soffit::ui {

/// Pieces of work off the GUI thread, one after the other, that end in the GUI thread. Deleting it
/// waits for the piece under way; ends that were not reached are dropped.
class Background : public QObject {
  Q_OBJECT

 public:
  /// What is left to do in the GUI thread; may be empty.
  using End = std::function<void()>;

  explicit Background(QObject* parent = nullptr);
  ~Background() override;

  /// `work` runs on another thread; the end that it returns runs in this object's.
  void run(std::function<End()> work);
  /// Waits until all work is done; its ends come later.
  void wait() { pool_.waitForDone(); }
  [[nodiscard]] bool isBusy() const { return under_way_ > 0; }

 Q_SIGNALS:
  /// All work is done and ended.
  void idle();

 private:
  QThreadPool pool_;
  int under_way_ = 0;
};

}  // namespace soffit::ui
