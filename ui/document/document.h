// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/project.h"
#include "core/scene/edits.h"
#include "ui/document/pending_files.h"
#include "ui/document/scene_command.h"

#include <QObject>
#include <QStringList>
#include <QUndoStack>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

/// The project that is open. Knows no widget.
namespace soffit::ui {

/// A project in the hands of its user: immutable snapshots of the scene, the undo stack that leads
/// from one to the next, the layout that is shown and what is selected.
///
/// Everything that changes the scene goes through edit() or a preview that ends in
/// commitPreview(): one undo step each. Lives in the GUI thread.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(io::Project project, QObject* parent = nullptr);

  [[nodiscard]] const ScenePtr& scene() const { return scene_; }
  [[nodiscard]] const io::Project& project() const { return project_; }
  [[nodiscard]] QString path() const;
  [[nodiscard]] QString name() const;
  [[nodiscard]] QUndoStack* undoStack() { return &undo_stack_; }
  [[nodiscard]] bool isModified() const { return !undo_stack_.isClean(); }

  /// The layout that is shown and edited; empty: the base.
  [[nodiscard]] const QString& layout() const { return layout_; }
  void setLayout(const QString& name);
  /// The luminaires of the layout that is shown, in order.
  [[nodiscard]] const std::vector<light::Luminaire>& luminaires() const { return luminaires_; }
  [[nodiscard]] const light::Luminaire* luminaire(const QString& name) const;

  [[nodiscard]] const QStringList& selection() const { return selection_; }
  void setSelection(const QStringList& names);

  /// Luminaires out of sight: their bodies are neither drawn nor found, their light stays. No part
  /// of the project, and no undo step.
  [[nodiscard]] const QStringList& hidden() const { return hidden_; }
  void setHidden(const QStringList& names);

  /// The light scenes of the layout that is shown.
  [[nodiscard]] const std::vector<io::LightScene>& lightScenes() const;
  /// Others, as one undo step.
  void editLightScenes(const QString& text, std::vector<io::LightScene> scenes);

  /// Points of surfaces whose light is watched.
  [[nodiscard]] const std::vector<io::Probe>& probes() const { return project_.probes; }
  /// Others, as one undo step.
  void editProbes(const QString& text, std::vector<io::Probe> probes);

  /// Groups that are listened to alone: all others are dark in litLuminaires(). Empty: none. No
  /// part of the project, and no undo step.
  [[nodiscard]] const QStringList& soloGroups() const { return solo_; }
  void setSoloGroups(const QStringList& groups);
  /// The luminaires as they are lit now.
  [[nodiscard]] std::vector<light::Luminaire> litLuminaires() const;

  /// Another scene, as one undo step. Consecutive edits with the same text and merge_key (not -1)
  /// are one step. An equal scene is no step.
  void edit(const QString& text, scene::Scene next, int merge_key = -1);
  /// Another scene in which another layout is shown, as one undo step. scenes_from: of a
  /// layout that is a copy of another, or itself under another name, the one whose light scenes it
  /// takes over, in this order. Scenes of layouts that are gone go too.
  void editLayouts(const QString& text, scene::Scene next, const QString& layout_after,
                   const std::optional<std::pair<QString, QString>>& scenes_from = std::nullopt);
  /// The same for the luminaires named: `change` alters each in place, in the layout that is shown.
  void editLuminaires(const QString& text, const QStringList& names,
                      const std::function<void(light::Luminaire&)>& change, int merge_key = -1);

  /// Shows luminaires changed, without an undo step: the movement of a drag. Each call starts from
  /// the scene before the preview.
  void preview(const QStringList& names, const std::function<void(light::Luminaire&)>& change);
  /// Shows another scene without an undo step, and lets preview() start from it: copies that are
  /// about to be dragged, an array whose numbers are still being typed.
  void previewScene(scene::Scene scene);
  [[nodiscard]] bool previewing() const { return before_preview_ != nullptr; }
  /// Makes the preview an undo step, or goes back to the scene before it.
  void commitPreview(const QString& text);
  void cancelPreview();

  /// The project as it is now, to be written or read by other threads.
  [[nodiscard]] io::Project current() const;
  /// `saved` was written at its path and is the project from now on; nothing is left to save.
  void setSaved(const io::Project& saved);
  /// What was loaded is not what lies at path(): a recovered version.
  void setRecovered();
  /// A project that grew by a model (io::withModel of current()), as one undo step.
  void growTo(const QString& text, io::Project grown);
  /// Whether the project's folder holds a file that luminaires name, or will when it is saved.
  [[nodiscard]] bool hasFile(const std::string& file) const;
  /// A file for luminaires to name: written with the project. PendingFiles::add() of its folder.
  std::string addFile(const std::string& wanted, std::string bytes);

  /// Writes those of addFile() that the scene names into the project's folder: before anything else
  /// that reads or copies what the project names. Errors: the disk.
  [[nodiscard]] Result<void> writeFiles() const;

 Q_SIGNALS:
  void sceneChanged();      ///< another snapshot, or another layout of it
  void layoutChanged();     ///< which layout is shown
  void selectionChanged();  ///< which luminaires are selected
  void hiddenChanged();     ///< which luminaires are out of sight
  void lightScenesChanged();
  void probesChanged();
  void soloChanged();
  void pathChanged();
  void modifiedChanged(bool modified);

 private:
  void show(const ScenePtr& scene, const QString& layout);
  void resolve();
  void takeProbes(std::vector<io::Probe> probes);
  void takeLightScenes(const QString& layout, std::vector<io::LightScene> scenes);
  void dropMissingFromSelection();

  io::Project project_;
  ScenePtr scene_;
  ScenePtr before_preview_;
  ScenePtr preview_base_;  ///< what preview() starts from
  QString layout_;
  std::vector<light::Luminaire> luminaires_;
  QStringList selection_;
  QStringList hidden_;
  QStringList solo_;
  PendingFiles pending_files_;
  QUndoStack undo_stack_;
};

}  // namespace soffit::ui
