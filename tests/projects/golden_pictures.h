// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

/// The stored pictures of the samples: golden/README.md.
namespace soffit {

struct GoldenPicture {
  const char* file;    ///< in golden/
  const char* sample;  ///< folder of projects/
  const char* layout;
  const char* camera;
};

/// Each sample twice: as it is opened, and another layout, with other shapes of light, from
/// elsewhere.
inline constexpr std::array<GoldenPicture, 8> kGoldenPictures = {{
    {"cornell_classic.png", "cornell", "Classic", "Classic"},
    {"cornell_coloured.png", "cornell", "Coloured", "Inside"},
    {"flat_everyday.png", "flat", "Everyday", "Living room"},
    {"flat_evening.png", "flat", "Evening", "Bedroom"},
    {"gallery_spots.png", "gallery", "Track spots", "Entrance"},
    {"gallery_evening.png", "gallery", "Evening", "Along the pictures"},
    {"office_panels.png", "office", "Panels", "Entrance"},
    {"office_pendants.png", "office", "Pendants", "Workplace"},
}};

inline std::string goldenFolder() {
  return std::string(SOFFIT_SOURCE_DIR) + "/tests/projects/golden";
}

/// `soffit render` of a picture into `output`, the same size for all.
inline std::vector<std::string> renderCommand(const GoldenPicture& picture,
                                              const std::string& output) {
  return {"render",   std::string(SOFFIT_SOURCE_DIR) + "/projects/" + picture.sample,
          "--layout", picture.layout,
          "--camera", picture.camera,
          "--size",   "160x100",
          "-o",       output};
}

}  // namespace soffit
