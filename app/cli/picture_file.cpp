// SPDX-License-Identifier: MIT
#include "app/cli/picture_file.h"

#include "core/io/image/write_image.h"

namespace soffit::cli {
namespace {

scene::Image luxImage(const render::Film& film) {
  scene::Image image{film.width, film.height, 3, {}};
  image.pixels.reserve(3 * film.count());
  for (const float lux : film.lux) image.pixels.insert(image.pixels.end(), 3, lux);
  return image;
}

}  // namespace

Result<void> writePicture(const std::filesystem::path& path, const render::Film& film,
                          const render::PictureOptions& options, render::PictureFacts facts) {
  const bool linear = io::isSceneLinear(path);
  const bool lux = options.display.view == color::kFalseColorView;
  facts.view = options.display.view;
  facts.white_balance = color::balanceOf(options.display);
  facts.exposure_ev = lux ? 0.0 : options.exposure_ev;
  if (lux) facts.unit = "lx";
  io::WriteOptions how;
  how.metadata = render::pictureMetadata(facts, linear);
  if (linear) return io::writeImage(path, lux ? luxImage(film) : render::linearPicture(film), how);
  const auto picture = render::developPicture(film, options);
  if (!picture) return picture.error();
  // The colours of a map mean values; noise would blur them.
  how.dither = !lux;
  return io::writeImage(path, *picture, how);
}

}  // namespace soffit::cli
