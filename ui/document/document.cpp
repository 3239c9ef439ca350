// SPDX-License-Identifier: MIT
#include "ui/document/document.h"

#include "core/scene/diff.h"
#include "ui/document/text.h"

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
  const scene::Layout* layout = scene::findLayout(*scene_, toStd(layout_));
  if (layout == nullptr) layout_.clear();
  luminaires_ = layout == nullptr ? scene_->luminaires : scene::resolveLayout(*scene_, *layout);
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
  QStringList known;
  for (const QString& name : names) {
    if (luminaire(name) != nullptr && !known.contains(name)) known.append(name);
  }
  if (known == selection_) return;
  selection_ = known;
  Q_EMIT selectionChanged();
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
      [this](const ScenePtr& scene, const QString& layout) { show(scene, layout); }));
}

void Document::editLayouts(const QString& text, scene::Scene next, const QString& layout_after) {
  cancelPreview();
  auto after = std::make_shared<const scene::Scene>(std::move(next));
  if (!scene::diff(*scene_, *after).any()) return;
  auto* command = new SceneCommand(
      text, scene_, std::move(after), layout_, -1,
      [this](const ScenePtr& scene, const QString& layout) { show(scene, layout); });
  command->setLayoutAfter(layout_after);
  undo_stack_.push(command);
}

scene::Scene Document::withChange(const scene::Scene& from, const QStringList& names,
                                  const std::function<void(light::Luminaire&)>& change) const {
  scene::Scene next = from;
  const scene::Layout* layout = scene::findLayout(from, toStd(layout_));
  const auto before = layout == nullptr ? from.luminaires : scene::resolveLayout(from, *layout);
  for (const light::Luminaire& luminaire : before) {
    if (!names.contains(toQt(luminaire.name))) continue;
    light::Luminaire changed = luminaire;
    change(changed);
    auto edited = scene::withEdit(next, toStd(layout_), luminaire.name,
                                  scene::editBetween(luminaire, changed));
    if (edited) next = std::move(*edited);
  }
  return next;
}

void Document::editLuminaires(const QString& text, const QStringList& names,
                              const std::function<void(light::Luminaire&)>& change, int merge_key) {
  cancelPreview();
  edit(text, withChange(*scene_, names, change), merge_key);
}

void Document::preview(const QStringList& names,
                       const std::function<void(light::Luminaire&)>& change) {
  if (before_preview_ == nullptr) before_preview_ = scene_;
  show(std::make_shared<const scene::Scene>(withChange(*before_preview_, names, change)), layout_);
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

Result<void> Document::save(const std::filesystem::path& file) {
  cancelPreview();
  project_.scene = *scene_;
  const auto saved = io::saveProject(project_, file);
  if (!saved) return saved.error();
  const bool moved = file != project_.path;
  project_.path = file;
  undo_stack_.setClean();
  if (moved) Q_EMIT pathChanged();
  return {};
}

}  // namespace soffit::ui
