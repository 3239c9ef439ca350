// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/render/picture.h"
#include "ui/viewport/shot.h"

#include <QImage>
#include <QString>

namespace soffit::ui {

class Document;

/// A picture of a view on its way to a file.
struct PictureFile {
  QString path;  ///< .png .jpg .tif: as it is seen; .exr .hdr: the light itself, cd/m^2
  Picture picture;
  Look look;                   ///< that it was taken with
  render::PictureFacts facts;  ///< written into the file; view and exposure are the look's
  bool legend = true;          ///< of false colours
  QString title;               ///< in the lower left corner; may be empty
};

/// Draws legend and title into the picture.
QImage decorated(const PictureFile& file);

/// Writes it. Errors: io::writeImage()'s; a scene-linear file without linear light. Takes its time:
/// not for the GUI thread.
Result<void> writePictureFile(const PictureFile& file);

/// Project, layout and camera of a picture; camera: empty for a free view.
render::PictureFacts factsOf(const Document& document, const QString& layout,
                             const QString& camera = {});

}  // namespace soffit::ui
