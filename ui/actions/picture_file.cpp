// SPDX-License-Identifier: MIT
#include "ui/actions/picture_file.h"

#include "core/io/image/write_image.h"
#include "core/render/legend.h"
#include "ui/document/document.h"
#include "ui/document/text.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {
namespace {

scene::Image codeValues(const QImage& picture) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  scene::Image image{rgb.width(), rgb.height(), 3, {}};
  image.pixels.reserve(3 * static_cast<std::size_t>(rgb.width()) *
                       static_cast<std::size_t>(rgb.height()));
  for (int y = 0; y < rgb.height(); ++y) {
    const uchar* row = rgb.constScanLine(y);
    for (int i = 0; i < 3 * rgb.width(); ++i) {
      image.pixels.push_back(static_cast<float>(row[i]) / 255.0F);
    }
  }
  return image;
}

QImage toQt(const scene::Image& image) {
  QImage picture(image.width, image.height, QImage::Format_RGB888);
  for (int y = 0; y < image.height; ++y) {
    uchar* row = picture.scanLine(y);
    const float* from =
        &image.pixels[3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width)];
    for (int i = 0; i < 3 * image.width; ++i) {
      row[i] = static_cast<uchar>(std::lround(255.0F * std::clamp(from[i], 0.0F, 1.0F)));
    }
  }
  return picture;
}

scene::Image decoratedValues(const PictureFile& file) {
  scene::Image image = codeValues(file.picture.image);
  if (file.legend && (file.look.false_color || !file.look.levels.empty())) {
    render::drawLegend(image, file.look.scale);
  }
  if (!file.title.isEmpty()) render::drawTitle(image, toStd(file.title));
  return image;
}

scene::Image linearValues(const PictureFile& file) {
  scene::Image image{file.picture.image.width(), file.picture.image.height(), 3, {}};
  image.pixels.reserve(3 * file.picture.linear.size());
  for (const vec3& pixel : file.picture.linear) {
    image.pixels.insert(image.pixels.end(), {pixel.x, pixel.y, pixel.z});
  }
  return image;
}

}  // namespace

QImage decorated(const PictureFile& file) {
  return toQt(decoratedValues(file));
}

Result<void> writePictureFile(const PictureFile& file) {
  const auto path = toPath(file.path);
  const bool linear = io::isSceneLinear(path);
  if (file.picture.image.isNull() || (linear && file.picture.linear.empty())) {
    return Error{toStd(file.path), "there is no light to take a picture of yet",
                 "Wait until the first light is computed."};
  }
  render::PictureFacts facts = file.facts;
  facts.view = file.look.false_color ? color::kFalseColorView : file.look.display.view;
  facts.white_balance = file.look.false_color ? 0.0 : color::balanceOf(file.look.display);
  facts.exposure_ev = file.look.false_color ? 0.0 : file.look.exposure_ev;
  io::WriteOptions how;
  how.metadata = render::pictureMetadata(facts, linear);
  return io::writeImage(path, linear ? linearValues(file) : decoratedValues(file), how);
}

render::PictureFacts factsOf(const Document& document, const QString& layout,
                             const QString& camera) {
  return {.project = toStd(document.name()),
          .layout = layout.isEmpty() ? "Base" : toStd(layout),
          .camera = toStd(camera)};
}

}  // namespace soffit::ui
