// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <string>

#include "tests/core/io/project/temporary_folder.h"

namespace soffit {

/// A closed room of 4 x 3 x 2.5 m with a panel and a lamp, two layouts, a camera and a work plane,
/// at a quality that computes in a moment. Its cache lies in the same folder.
class SmallRoom : public TemporaryFolder {
 public:
  SmallRoom() {
    write("room.obj",
          "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nv 0 0 2.5\nv 4 0 2.5\nv 4 3 2.5\nv 0 3 2.5\n"
          "usemtl paint\nf 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n");
    file_ = write("room.soffit", R"({
  "soffit": 1, "name": "Room", "geometry": [{ "file": "room.obj" }],
  "materials": { "paint": { "diffuse": [0.5, 0.5, 0.5] } },
  "luminaires": [
    { "name": "Panel", "shape": { "rectangle": [0.6, 0.6] }, "position": [2, 1.5, 2.4], "flux": 3000 },
    { "name": "Lamp", "shape": "point", "position": [1, 1, 1.5], "flux": 500, "distribution": "isotropic" }],
  "layouts": [{ "name": "Both" }, { "name": "Panel alone", "luminaires": { "Lamp": { "on": false } } }],
  "cameras": [{ "name": "Door", "position": [0.3, 0.3, 1.6], "target": [3, 2, 1] }],
  "work_planes": [{ "name": "Desk", "origin": [1, 1, 0.8], "u": [2, 0, 0], "v": [0, 1, 0], "grid": [2, 2] }],
  "quality": { "texels": 600, "trainings": 8, "field_rays": 8, "list_rays": 12, "sensor_rays": 8 } })");
    write("sensors.csv", "x,y,z,nx,ny,nz\n2,1.5,0.8,0,0,1\n1,2,1.2,1,0,0\n3,1,0,0,0,1\n");
    write("path.csv", "x,y,z\n2,1.5,2.4\n1.5,1.5,2.4\n1,1.5,2.4\n");
    ::setenv("SOFFIT_CACHE", at("cache").c_str(), 1);
  }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] std::string at(const std::string& name) const { return (path() / name).string(); }

 private:
  std::string file_;
};

}  // namespace soffit
