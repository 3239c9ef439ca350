// SPDX-License-Identifier: MIT
#include "ui/jobs/autosave.h"

#include "core/io/project/atomic_file.h"
#include "ui/document/text.h"
#include "ui/jobs/recovery.h"

#include <QDateTime>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUuid>

namespace soffit::ui {
namespace {

/// 30 s may be lost at most: this, a drag that is under way, and the disk.
constexpr int kDelayMs = 10000;

Result<void> write(const QString& id, const QString& ending, const std::string& content) {
  return io::writeFileAtomically(toPath(recoveryFile(id, ending)), content);
}

Result<void> keepVersion(const QString& id, const io::Project& project, const QString& name,
                         const QImage& thumbnail) {
  const auto text = io::formatProject(project);
  if (!text) return text.error();
  if (auto written = write(id, QStringLiteral("soffit"), *text); !written) return written;
  if (!thumbnail.isNull()) thumbnail.save(recoveryFile(id, QStringLiteral("png")));
  const QJsonObject facts{
      {QStringLiteral("path"), toQt(project.path)},
      {QStringLiteral("name"), name},
      {QStringLiteral("saved"), QDateTime::currentDateTime().toString(Qt::ISODate)}};
  return write(id, QStringLiteral("json"), QJsonDocument(facts).toJson().toStdString());
}

}  // namespace

Autosave::Autosave(Document& document, QObject* parent)
    : QObject(parent),
      document_(document),
      id_(QUuid::createUuid().toString(QUuid::WithoutBraces)) {
  timer_.setSingleShot(true);
  timer_.setInterval(kDelayMs);
  connect(&timer_, &QTimer::timeout, this, &Autosave::keep);
  connect(&document_, &Document::sceneChanged, this, &Autosave::onChange);
  connect(&document_, &Document::modifiedChanged, this, [this](bool modified) {
    if (modified) {
      onChange();
    } else {
      forget();
    }
  });
}

Autosave::~Autosave() {
  background_.wait();
  forget();
}

void Autosave::onChange() {
  if (!timer_.isActive() && document_.isModified()) timer_.start();
}

void Autosave::keep() {
  if (!document_.isModified()) return;
  if (lock_ == nullptr) {
    lock_ = std::make_unique<QLockFile>(recoveryFile(id_, QStringLiteral("lock")));
    lock_->setStaleLockTime(0);
    lock_->tryLock(0);
  }
  // A recovered version is opened in the project's folder: what it names must lie there.
  if (auto written = document_.writeFiles(); !written) Q_EMIT failed(messageOf(written.error()));
  const QImage thumbnail = thumbnail_ ? thumbnail_() : QImage();
  background_.run([this, id = id_, project = document_.current(), name = document_.name(),
                   thumbnail]() -> Background::End {
    const auto written = keepVersion(id, project, name, thumbnail);
    const QString message = written ? QString() : messageOf(written.error());
    return [this, message] {
      if (!message.isEmpty()) {
        Q_EMIT failed(message);
      } else if (document_.isModified()) {
        Q_EMIT kept();
      } else {
        forget();  // saved while it was being written
      }
    };
  });
}

void Autosave::forget() {
  timer_.stop();
  discardRecovery(id_);
  lock_.reset();
}

}  // namespace soffit::ui
