// SPDX-License-Identifier: MIT
#include "ui/document/document.h"

#include "core/scene/diff.h"
#include "ui/document/luminaire_changes.h"
#include "ui/document/step.h"
#include "ui/document/text.h"

#include <QSet>

#include <algorithm>
#include <utility>

namespace soffit::ui {

Document::Document(io::Project project, QObject* parent)
    : QObject(parent), project_(std::move(project)) {
  scene_ = std::make_shared<const scene::Scene>(project_.scene);
  if (!scene_->layouts.empty()) layout_ = toQt(scene_->layouts.front().name);
  resolve();
  connect(&undo_stack_, &QUndoStack::cleanChanged, this,
          [this](bool clean) { Q_EMIT modifiedChanged(!clean); });
}

QString Document::path() const {
  return toQt(project_.path);
}

QString Document::name() const {
  return scene_->name.empty() ? toQt(project_.path.stem()) : toQt(scene_->name);
}

void Document::resolve() {
  if (scene::findLayout(*scene_, toStd(layout_)) == nullptr) layout_.clear();
  luminaires_ = luminairesOf(*scene_, toStd(layout_));
}

const light::Luminaire* Document::luminaire(const QString& name) const {
  const auto found = std::ranges::find(luminaires_, toStd(name), &light::Luminaire::name);
  return found == luminaires_.end() ? nullptr : &*found;
}

void Document::setLayout(const QString& name) {
  if (name == layout_) return;
  cancelPreview();
  show(scene_, name);
}

void Document::setSelection(const QStringList& names) {
  // Each name once, as far as it is there; told at every place of a drag, with hundreds of them.
  QSet<QString> there;
  if (!names.isEmpty()) {
    for (const light::Luminaire& l : luminaires_) there.insert(toQt(l.name));
  }
  QStringList known;
  for (const QString& name : names) {
    if (there.remove(name)) known.append(name);
  }
  if (known == selection_) return;
  selection_ = known;
  Q_EMIT selectionChanged();
}

void Document::setHidden(const QStringList& names) {
  if (names == hidden_) return;
  hidden_ = names;
  QStringList seen;
  for (const QString& name : selection_) {
    if (!hidden_.contains(name)) seen.append(name);
  }
  setSelection(seen);
  Q_EMIT hiddenChanged();
}

const std::vector<io::LightScene>& Document::lightScenes() const {
  static const std::vector<io::LightScene> kNone;
  const auto found = project_.light_scenes.find(toStd(layout_));
  return found == project_.light_scenes.end() ? kNone : found->second;
}

void Document::takeLightScenes(const QString& layout, std::vector<io::LightScene> scenes) {
  project_.light_scenes[toStd(layout)] = std::move(scenes);
  Q_EMIT lightScenesChanged();
}

void Document::editLightScenes(const QString& text, std::vector<io::LightScene> scenes) {
  undo_stack_.push(new Step(
      text,
      [this, layout = layout_, scenes = std::move(scenes)] { takeLightScenes(layout, scenes); },
      [this, layout = layout_, before = lightScenes()] { takeLightScenes(layout, before); }));
}

void Document::takeProbes(std::vector<io::Probe> probes) {
  project_.probes = std::move(probes);
  Q_EMIT probesChanged();
}

void Document::editProbes(const QString& text, std::vector<io::Probe> probes) {
  if (probes == project_.probes) return;
  undo_stack_.push(new Step(
      text, [this, probes = std::move(probes)] { takeProbes(probes); },
      [this, before = project_.probes] { takeProbes(before); }));
}

void Document::setSoloGroups(const QStringList& groups) {
  if (groups == solo_) return;
  solo_ = groups;
  Q_EMIT soloChanged();
  Q_EMIT sceneChanged();
}

std::vector<light::Luminaire> Document::litLuminaires() const {
  std::vector<light::Luminaire> lit = luminaires_;
  // A group that this layout lacks, or that was renamed, silences nobody.
  const bool heard = std::ranges::any_of(
      lit, [this](const light::Luminaire& l) { return solo_.contains(toQt(l.group)); });
  if (!heard) return lit;
  for (light::Luminaire& l : lit) l.on = l.on && solo_.contains(toQt(l.group));
  return lit;
}

void Document::dropMissingFromSelection() {
  setSelection(QStringList(selection_));
}

void Document::show(const ScenePtr& scene, const QString& layout) {
  scene_ = scene;
  const QString before = layout_;
  layout_ = layout;
  resolve();
  dropMissingFromSelection();
  if (layout_ != before) Q_EMIT layoutChanged();
  Q_EMIT sceneChanged();
}

void Document::edit(const QString& text, scene::Scene next, int merge_key) {
  cancelPreview();
  auto after = std::make_shared<const scene::Scene>(std::move(next));
  if (!scene::diff(*scene_, *after).any()) return;
  undo_stack_.push(new SceneCommand(
      text, scene_, std::move(after), layout_, merge_key,
      [this](const ScenePtr& scene, const QString& layout) {
        before_preview_ = nullptr;  // undone or redone beneath a preview: that is given up
        show(scene, layout);
      }));
}

void Document::editLayouts(const QString& text, scene::Scene next, const QString& layout_after,
                           const std::optional<std::pair<QString, QString>>& scenes_from) {
  cancelPreview();
  auto after = std::make_shared<const scene::Scene>(std::move(next));
  if (!scene::diff(*scene_, *after).any()) return;
  const io::LightScenes before_scenes = project_.light_scenes;
  io::LightScenes after_scenes = before_scenes;
  if (scenes_from) {
    const auto own = before_scenes.find(toStd(scenes_from->second));
    if (own != before_scenes.end()) after_scenes[toStd(scenes_from->first)] = own->second;
  }
  std::erase_if(after_scenes, [&](const auto& entry) {
    return !entry.first.empty() && std::ranges::find(after->layouts, entry.first,
                                                     &scene::Layout::name) == after->layouts.end();
  });
  auto* command = new SceneCommand(
      text, scene_, after, layout_, -1,
      [this, after, before_scenes, after_scenes](const ScenePtr& scene, const QString& layout) {
        before_preview_ = nullptr;  // undone or redone beneath a preview: that is given up
        const bool forth = scene == after;
        // Of the layouts alone that this step made or ended: others may have been edited since.
        for (const auto* scenes : {&before_scenes, &after_scenes}) {
          for (const auto& [name, list] : *scenes) {
            const auto& wanted = forth ? after_scenes : before_scenes;
            const auto found = wanted.find(name);
            if (found == wanted.end()) {
              project_.light_scenes.erase(name);
            } else if (!before_scenes.contains(name) || !after_scenes.contains(name)) {
              project_.light_scenes[name] = found->second;
            }
          }
        }
        show(scene, layout);
        Q_EMIT lightScenesChanged();
      });
  command->setLayoutAfter(layout_after);
  undo_stack_.push(command);
}

void Document::editLuminaires(const QString& text, const QStringList& names,
                              const std::function<void(light::Luminaire&)>& change, int merge_key) {
  cancelPreview();
  edit(text, withChanged(*scene_, toStd(layout_), names, change), merge_key);
}

void Document::preview(const QStringList& names,
                       const std::function<void(light::Luminaire&)>& change) {
  if (before_preview_ == nullptr) before_preview_ = preview_base_ = scene_;
  show(std::make_shared<const scene::Scene>(
           withChanged(*preview_base_, toStd(layout_), names, change)),
       layout_);
}

void Document::previewScene(scene::Scene scene) {
  if (before_preview_ == nullptr) before_preview_ = scene_;
  preview_base_ = std::make_shared<const scene::Scene>(std::move(scene));
  show(preview_base_, layout_);
}

void Document::commitPreview(const QString& text) {
  if (before_preview_ == nullptr) return;
  const ScenePtr before = std::exchange(before_preview_, nullptr);
  const ScenePtr after = std::exchange(scene_, before);
  edit(text, *after);
  // A drag that ended where it began is no step, but the light of its last place may be shown.
  if (scene_ == before) show(before, layout_);
}

void Document::cancelPreview() {
  if (before_preview_ == nullptr) return;
  show(std::exchange(before_preview_, nullptr), layout_);
}

io::Project Document::current() const {
  io::Project project = project_;
  project.scene = before_preview_ == nullptr ? *scene_ : *before_preview_;
  project.pending_files = pending_files_.files();
  return project;
}

void Document::setSaved(const io::Project& saved) {
  const bool moved = saved.path != project_.path;
  project_.path = saved.path;
  project_.assets = saved.assets;
  undo_stack_.setClean();
  if (moved) Q_EMIT pathChanged();
}

void Document::setRecovered() {
  undo_stack_.resetClean();
}

void Document::growTo(const QString& text, io::Project grown) {
  cancelPreview();
  auto after = std::make_shared<const scene::Scene>(std::move(grown.scene));
  grown.scene = {};
  // What saving needs to know of the files goes to and fro with the scene.
  const auto files_before = std::make_shared<io::Project>(project_);
  const auto files_after = std::make_shared<io::Project>(std::move(grown));
  undo_stack_.push(new SceneCommand(
      text, scene_, after, layout_, -1,
      [this, after, files_before, files_after](const ScenePtr& scene, const QString& layout) {
        const io::Project& files = scene == after ? *files_after : *files_before;
        project_.geometry = files.geometry;
        project_.file_materials = files.file_materials;
        project_.document = files.document;
        show(scene, layout);
      }));
}

bool Document::hasFile(const std::string& file) const {
  std::error_code code;
  return pending_files_.holds(file) ||
         std::filesystem::is_regular_file(project_.path.parent_path() / file, code);
}

std::string Document::addFile(const std::string& wanted, std::string bytes) {
  return pending_files_.add(wanted, std::move(bytes), project_.path.parent_path());
}

Result<void> Document::writeFiles() const {
  const ScenePtr& scene = before_preview_ == nullptr ? scene_ : before_preview_;
  return pending_files_.write(*scene, project_.path.parent_path());
}

}  // namespace soffit::ui
