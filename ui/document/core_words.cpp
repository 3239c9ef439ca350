// SPDX-License-Identifier: MIT
#include "ui/document/core_words.h"

#include <QCoreApplication>

#include <string>

namespace soffit::ui {
namespace {

/// Core knows no Qt: its words stand here once more for lupdate. tests/ui/translations holds them
/// against core's sources.
[[maybe_unused]] constexpr const char* kWords[] = {
    // Job::report()
    QT_TRANSLATE_NOOP("Core", "reading models"), QT_TRANSLATE_NOOP("Core", "reading the model"),
    QT_TRANSLATE_NOOP("Core", "cleaning the model"),
    QT_TRANSLATE_NOOP("Core", "preparing geometry"),
    QT_TRANSLATE_NOOP("Core", "looking for a stored bake"),
    QT_TRANSLATE_NOOP("Core", "laying out texels"), QT_TRANSLATE_NOOP("Core", "tracing surfaces"),
    QT_TRANSLATE_NOOP("Core", "tracing paths"), QT_TRANSLATE_NOOP("Core", "last bounce"),
    QT_TRANSLATE_NOOP("Core", "making receivers"), QT_TRANSLATE_NOOP("Core", "training lights"),
    QT_TRANSLATE_NOOP("Core", "looking where light differs"),
    QT_TRANSLATE_NOOP("Core", "tracing gather rays"), QT_TRANSLATE_NOOP("Core", "storing the bake"),
    QT_TRANSLATE_NOOP("Core", "computing luminaires"),
    QT_TRANSLATE_NOOP("Core", "following reflections"),
    QT_TRANSLATE_NOOP("Core", "shadows for direct light"), QT_TRANSLATE_NOOP("Core", "shadow pass"),
    QT_TRANSLATE_NOOP("Core", "looking for the sky"),
    QT_TRANSLATE_NOOP("Core", "light of smooth skies"),
    QT_TRANSLATE_NOOP("Core", "comparing layouts"),
    QT_TRANSLATE_NOOP("Core", "tracing reference paths"),
    // scene::demandOf()
    QT_TRANSLATE_NOOP("Core", "direct light"), QT_TRANSLATE_NOOP("Core", "no luminaire is on"),
    QT_TRANSLATE_NOOP("Core", "interreflection"), QT_TRANSLATE_NOOP("Core", "no surface reflects"),
    QT_TRANSLATE_NOOP("Core", "visibility"), QT_TRANSLATE_NOOP("Core", "there is no geometry"),
    QT_TRANSLATE_NOOP("Core", "three color channels"),
    QT_TRANSLATE_NOOP("Core", "all reflectances are grey"),
    QT_TRANSLATE_NOOP("Core", "highlights and reflections"),
    QT_TRANSLATE_NOOP("Core", "no material has a specular share"),
    QT_TRANSLATE_NOOP("Core", "pictures on surfaces"),
    QT_TRANSLATE_NOOP("Core", "no material has a diffuse map"),
    QT_TRANSLATE_NOOP("Core", "bent normals"),
    QT_TRANSLATE_NOOP("Core", "no material has a normal map"),
    QT_TRANSLATE_NOOP("Core", "roughness that changes"),
    QT_TRANSLATE_NOOP("Core", "no material has a roughness map"),
    QT_TRANSLATE_NOOP("Core", "measured photometry"),
    QT_TRANSLATE_NOOP("Core", "no luminaire names a file"),
    QT_TRANSLATE_NOOP("Core", "luminaires as obstacles"),
    QT_TRANSLATE_NOOP("Core", "no luminaire casts a shadow"),
    QT_TRANSLATE_NOOP("Core", "light from outside"),
    QT_TRANSLATE_NOOP("Core", "the project has no environment"),
    QT_TRANSLATE_NOOP("Core", "sunlight"), QT_TRANSLATE_NOOP("Core", "the environment has no sun"),
    QT_TRANSLATE_NOOP("Core", "light through glass"),
    QT_TRANSLATE_NOOP("Core", "no material is glass")};

}  // namespace

QString coreWords(std::string_view text) {
  return QCoreApplication::translate("Core", std::string(text).c_str());
}

}  // namespace soffit::ui
