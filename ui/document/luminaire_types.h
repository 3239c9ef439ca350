// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/photometry/photometric_file.h"
#include "core/light/luminaire.h"

#include <QByteArray>
#include <QString>

#include <string>
#include <vector>

/// What can be placed: kinds of luminaires, ready made or from files.
namespace soffit::ui {

/// Where a luminaire of a kind hangs when it is placed.
enum class Mounting {
  ceiling,    ///< in or on the ceiling above the place
  suspended,  ///< below the ceiling by `drop`
};

/// A file that luminaires of a kind name; it is written into the project's folder when the first of
/// them is saved.
struct TypeFile {
  std::string name;
  std::string bytes;  ///< empty: the kind needs none
};

/// A kind of luminaire. The prototype stands unrotated at the origin; its name is the stem of the
/// names that luminaires of this kind get.
struct LuminaireType {
  QString name;
  QString about;  ///< one line: lumens, and what else tells it from others, %1, %2 for `lengths`
  light::Luminaire prototype;
  Mounting mounting = Mounting::ceiling;
  double drop = 0.0;  ///< m
  TypeFile photometry;
  TypeFile mesh;
  std::vector<double> lengths = {};  ///< m
  QByteArray id = {};  ///< of a built-in kind, the same in every language; else empty
};

/// Kinds that need no files of the user: panel, linear, pendant, downlight, spot, wall washer,
/// sphere, ring, track spot and a plain one to be changed. Their photometry is our own, synthetic.
std::vector<LuminaireType> builtInTypes();

/// A kind from a photometric file: the shape of its luminous opening (a small disk where it states
/// none), its candela as they stand. `bytes`: of the file, to be copied beside the project.
LuminaireType typeFromPhotometry(const io::PhotometricFile& file, const std::string& file_name,
                                 std::string bytes);

/// A kind from a mesh in metres, z up, with the OBJ text that it is saved as.
LuminaireType typeFromMesh(const QString& name, std::shared_ptr<const geometry::Mesh> mesh,
                           const std::string& file_name, std::string obj_text);

}  // namespace soffit::ui
