// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

#include <QString>

#include <optional>
#include <vector>

/// The light mixer: groups of luminaires dimmed, switched and coloured together, and scenes that
/// remember it. Every change is one undo step of the luminaires themselves, so that lumens stay
/// lumens; nothing is kept twice.
namespace soffit::ui {

/// A group of the layout that is shown; values that its luminaires do not share are absent.
struct GroupState {
  QString name;
  int count = 0;
  double level = 0.0;  ///< the highest dimming in it: where its fader stands
  std::optional<double> dimming;
  std::optional<bool> on;
  std::optional<light::Colour> colour;
};

/// In the order of their first luminaires.
std::vector<GroupState> groupsOf(const Document& document);

/// The luminaires of a group by name.
QStringList membersOf(const Document& document, const QString& group);

/// Moves a group's fader: all are scaled, so that the highest gets `level` and differences stay; a
/// group that was all dark gets it everywhere. Consecutive ways of one fader are one step.
void setGroupLevel(Document& document, const QString& group, double level);
void setGroupOn(Document& document, const QString& group, bool on);
/// Consecutive changes of one group's colour are one step.
void setGroupColour(Document& document, const QString& group, const light::Colour& colour);

/// What is lit now as a scene: by group where all its luminaires agree, else one by one.
io::LightScene sceneOf(const Document& document, const QString& name);
/// Sets the luminaires to a scene, as one step. What the scene does not name stays.
void recallScene(Document& document, const io::LightScene& scene);
/// Whether recalling it would change nothing.
bool isShown(const Document& document, const io::LightScene& scene);

/// Stores what is lit now as scene `number` (from 0); past the end it is added there. The name of a
/// scene that is replaced stays.
void storeScene(Document& document, std::size_t number);
void renameScene(Document& document, std::size_t number, const QString& name);
void removeScene(Document& document, std::size_t number);

inline constexpr std::size_t kMostScenes = 9;

}  // namespace soffit::ui
