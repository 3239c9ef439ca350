// SPDX-License-Identifier: MIT
#include "ui/document/mixing.h"

#include "core/scene/equality.h"
#include "ui/document/luminaire_changes.h"
#include "ui/document/text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

enum MergeKey { kLevelWay = 101, kColourWay };

QString tr(const char* text) {
  return QCoreApplication::translate("soffit::ui", text);
}

QString shown(const QString& group) {
  return group.isEmpty() ? tr("no group") : group;
}

void apply(const io::Mix& mix, light::Luminaire& luminaire) {
  if (mix.dimming) luminaire.dimming = *mix.dimming;
  if (mix.on) luminaire.on = *mix.on;
  if (mix.colour) luminaire.colour = *mix.colour;
}

void apply(const io::LightScene& scene, light::Luminaire& luminaire) {
  if (const auto group = scene.groups.find(luminaire.group); group != scene.groups.end()) {
    apply(group->second, luminaire);
  }
  if (const auto own = scene.luminaires.find(luminaire.name); own != scene.luminaires.end()) {
    apply(own->second, luminaire);
  }
}

QStringList allNames(const Document& document) {
  QStringList names;
  for (const light::Luminaire& l : document.luminaires()) names.append(toQt(l.name));
  return names;
}

}  // namespace

std::vector<GroupState> groupsOf(const Document& document) {
  std::vector<GroupState> groups;
  for (const light::Luminaire& l : document.luminaires()) {
    const QString name = toQt(l.group);
    const auto found = std::ranges::find(groups, name, &GroupState::name);
    if (found == groups.end()) {
      groups.push_back({name, 1, l.dimming, l.dimming, l.on, l.colour});
      continue;
    }
    ++found->count;
    found->level = std::max(found->level, l.dimming);
    if (found->dimming != l.dimming) found->dimming.reset();
    if (found->on != l.on) found->on.reset();
    if (found->colour && !scene::same(*found->colour, l.colour)) found->colour.reset();
  }
  return groups;
}

QStringList membersOf(const Document& document, const QString& group) {
  QStringList names;
  for (const light::Luminaire& l : document.luminaires()) {
    if (toQt(l.group) == group) names.append(toQt(l.name));
  }
  return names;
}

void setGroupLevel(Document& document, const QString& group, double level) {
  double highest = 0.0;
  const std::string name = toStd(group);
  for (const light::Luminaire& l : document.luminaires()) {
    if (l.group == name) highest = std::max(highest, l.dimming);
  }
  document.editLuminaires(
      tr("Dim %1").arg(shown(group)), membersOf(document, group),
      [&](light::Luminaire& l) {
        // Whole ten-thousandths: ways to and fro leave nothing behind.
        const double share = highest > 0.0 ? l.dimming / highest : 1.0;
        l.dimming = std::round(1e4 * share * level) / 1e4;
      },
      kLevelWay);
}

void setGroupOn(Document& document, const QString& group, bool on) {
  document.editLuminaires(
      on ? tr("Switch on %1").arg(shown(group)) : tr("Switch off %1").arg(shown(group)),
      membersOf(document, group), [on](light::Luminaire& l) { l.on = on; });
}

void setGroupColour(Document& document, const QString& group, const light::Colour& colour) {
  document.editLuminaires(
      tr("Colour %1").arg(shown(group)), membersOf(document, group),
      [&](light::Luminaire& l) { l.colour = colour; }, kColourWay);
}

io::LightScene sceneOf(const Document& document, const QString& name) {
  io::LightScene scene;
  scene.name = toStd(name);
  for (const GroupState& group : groupsOf(document)) {
    io::Mix mix;
    mix.dimming = group.dimming;
    mix.on = group.on;
    mix.colour = group.colour;
    scene.groups[toStd(group.name)] = mix;
  }
  for (const light::Luminaire& l : document.luminaires()) {
    const io::Mix& group = scene.groups[l.group];
    io::Mix own;
    if (!group.dimming) own.dimming = l.dimming;
    if (!group.on) own.on = l.on;
    if (!group.colour) own.colour = l.colour;
    if (own.dimming || own.on || own.colour) scene.luminaires[l.name] = own;
  }
  return scene;
}

void recallScene(Document& document, const io::LightScene& scene) {
  document.editLuminaires(tr("Light scene %1").arg(toQt(scene.name)), allNames(document),
                          [&](light::Luminaire& l) { apply(scene, l); });
}

bool isShown(const Document& document, const io::LightScene& scene) {
  return std::ranges::all_of(document.luminaires(), [&](const light::Luminaire& l) {
    light::Luminaire recalled = l;
    apply(scene, recalled);
    return recalled.dimming == l.dimming && recalled.on == l.on &&
           scene::same(recalled.colour, l.colour);
  });
}

void storeScene(Document& document, std::size_t number) {
  std::vector<io::LightScene> scenes = document.lightScenes();
  if (number >= kMostScenes) return;
  if (number < scenes.size()) {
    scenes[number] = sceneOf(document, toQt(scenes[number].name));
  } else {
    scenes.push_back(sceneOf(document, tr("Scene %1").arg(scenes.size() + 1)));
  }
  document.editLightScenes(tr("Store light scene"), std::move(scenes));
}

void renameScene(Document& document, std::size_t number, const QString& name) {
  std::vector<io::LightScene> scenes = document.lightScenes();
  if (number >= scenes.size() || name.trimmed().isEmpty()) return;
  if (scenes[number].name == toStd(name.trimmed())) return;
  scenes[number].name = toStd(name.trimmed());
  document.editLightScenes(tr("Rename light scene"), std::move(scenes));
}

void removeScene(Document& document, std::size_t number) {
  std::vector<io::LightScene> scenes = document.lightScenes();
  if (number >= scenes.size()) return;
  scenes.erase(scenes.begin() + static_cast<std::ptrdiff_t>(number));
  document.editLightScenes(tr("Delete light scene"), std::move(scenes));
}

}  // namespace soffit::ui
