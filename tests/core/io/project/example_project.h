// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/project/project.h"
#include "tests/core/io/project/temporary_folder.h"

#include <string>

namespace soffit::io {

/// A quad of 1 x 1 m in the xy plane with the material "floor" and a triangle with "wall".
inline const std::string kQuadObj =
    "mtllib quad.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
    "usemtl floor\nf 1 2 3 4\nusemtl wall\nf 1 2 5\n";

inline const std::string kQuadMtl = "newmtl floor\nKd 0.2 0.3 0.4\nnewmtl wall\nKd 0.7 0.7 0.7\n";

/// An axial photometric file: 100 cd everywhere below the horizon.
inline const std::string kDiskIes =
    "IESNA:LM-63-2002\n[TEST] own\n[MANUFAC] none\nTILT=NONE\n"
    "1 -1 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n100 100 100\n";

/// A folder with quad.obj, quad.mtl and spot.ies, in which projects are written and loaded.
struct ProjectFolder : TemporaryFolder {
  ProjectFolder() {
    write("quad.obj", kQuadObj);
    write("quad.mtl", kQuadMtl);
    write("spot.ies", kDiskIes);
  }

  /// Loads a project with this text; its name is p.soffit.
  [[nodiscard]] Result<Project> load(const std::string& text,
                                     const LoadOptions& options = {}) const {
    return loadProject(write("p.soffit", text), options);
  }

  /// The error of loading it, without the folder; empty when it loads.
  [[nodiscard]] std::string errorOf(const std::string& text,
                                    const LoadOptions& options = {}) const {
    const auto project = load(text, options);
    return project ? std::string() : local(project.error().message());
  }

  [[nodiscard]] std::string local(std::string text) const {
    for (const std::string& folder :
         {path().string() + "/", std::filesystem::canonical(path()).string() + "/"}) {
      for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
        text.erase(at, folder.size());
      }
    }
    return text;
  }
};

/// A project that uses every section.
inline const std::string kFullProject = R"({
  // comments are allowed
  "soffit": 1,
  "name": "Room",
  "author": "somebody",
  "geometry": [{ "file": "quad.obj", "unit": 1.0, "up": "z", "translate": [1, 2, 3] }],
  "materials": {
    "wall": { "diffuse": [0.80, 0.5, 0.5], "sheen": 1 },
    "floor": { "specular": 0.04, "roughness": 0.30 }
  },
  "luminaires": [
    { "name": "Panel 1", "shape": { "rectangle": [0.6, 0.6] }, "position": [2.0, 1.5, 2.75],
      "rotation": [0, 0, 0], "flux": 3500, "colour": { "cct": 4000 },
      "distribution": "lambertian", "group": "General", "article": "X-1" },
    { "name": "Spot 1.2", "shape": "point", "position": [1, 1, 2.5],
      "distribution": { "ies": "spot.ies" }, "dimming": 0.1 }
  ],
  "layouts": [
    { "name": "As planned" },
    { "name": "Evening", "note": "later",
      "luminaires": { "Panel 1": { "dimming": 0.3 },
                      "Candle": { "shape": { "sphere": 0.01 }, "flux": 12, "position": [3, 3, 1] } } }
  ],
  "cameras": [{ "name": "Entrance", "position": [1, 1, 1.6], "target": [6, 4, 1.2], "vertical_fov": 50 }],
  "work_planes": [{ "name": "Desks", "origin": [0.5, 0.5, 0.8], "u": [11, 0, 0], "v": [0, 7, 0],
                    "grid": [22, 14], "room_type": "office.writing" }],
  "view": { "exposure": 0.5, "ocio_view": "ACES" },
  "quality": { "preset": "final", "gather_rays": 2048 }
})";

}  // namespace soffit::io
