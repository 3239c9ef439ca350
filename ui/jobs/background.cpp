// SPDX-License-Identifier: MIT
#include "ui/jobs/background.h"

#include <QMetaObject>

#include <utility>

namespace soffit::ui {

Background::Background(QObject* parent) : QObject(parent) {
  pool_.setMaxThreadCount(1);
}

Background::~Background() {
  pool_.clear();
  pool_.waitForDone();
}

void Background::run(std::function<End()> work) {
  ++under_way_;
  pool_.start([this, work = std::move(work)] {
    End end = work();
    QMetaObject::invokeMethod(
        this,
        [this, end = std::move(end)] {
          --under_way_;
          if (end) end();
          if (under_way_ == 0) Q_EMIT idle();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace soffit::ui
