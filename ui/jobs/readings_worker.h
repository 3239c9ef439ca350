// SPDX-License-Identifier: MIT
#pragma once

#include "core/relight/sensor_readings.h"
#include "ui/document/scene_command.h"
#include "ui/jobs/power_table.h"
#include "ui/jobs/readings.h"

#include <QObject>

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

namespace soffit::ui {

/// A state of the scene whose work planes are to be read.
struct ReadingsRequest {
  std::shared_ptr<const relight::Solver> solver;
  std::shared_ptr<const daylight::Environment> outside;  ///< that shines in; null: nothing
  ScenePtr scene;
  std::string shown;                         ///< layout, empty for the base
  std::vector<light::Luminaire> luminaires;  ///< of the layout that is shown
  std::filesystem::path folder;              ///< of the project, for photometric files
  bool with_base = false;                    ///< the base too where it is not shown
  bool dragging = false;                     ///< the shown layout alone, at an easy pace
  std::uint64_t revision = 0;                ///< rising
};

/// Reads the work planes off the GUI thread: the layout that is shown first, then those whose
/// luminaires changed. The newest request wins; what a luminaire gives the sensors is kept, so
/// dimming is a re-mix.
class ReadingsWorker : public QObject {
  Q_OBJECT

 public:
  explicit ReadingsWorker(QObject* parent = nullptr);
  ~ReadingsWorker() override;

  void request(ReadingsRequest request);
  /// The newest readings, once each; null when there is nothing new.
  ReadingsPtr take();

 Q_SIGNALS:
  void ready();
  void failed(const QString& message);

 private:
  struct Known {
    LayoutReading reading;
    std::vector<light::Luminaire> luminaires;
  };
  void run(const std::stop_token& stop);
  void serve(const ReadingsRequest& request, const std::stop_token& stop);
  bool prepare(const ReadingsRequest& request);
  [[nodiscard]] Result<LayoutReading> read(const ReadingsRequest& request,
                                           const std::string& layout,
                                           const std::vector<light::Luminaire>& luminaires,
                                           const Job& job);
  void addPower(const ReadingsRequest& request, const std::vector<light::Luminaire>& luminaires,
                LayoutReading& reading);
  void publish(const ReadingsRequest& request);
  [[nodiscard]] bool superseded();

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<ReadingsRequest> newest_;  // guarded by mutex_
  ReadingsPtr finished_;                   // guarded by mutex_

  // Of the thread alone.
  std::optional<relight::SensorReadings> sensors_;
  std::vector<scene::WorkPlane> planes_;
  int rays_ = 0;
  std::shared_ptr<const relight::Solver> solver_;
  std::shared_ptr<const daylight::Environment> outside_;
  std::vector<Known> known_;
  PowerTable power_;

  std::jthread thread_;
};

}  // namespace soffit::ui
