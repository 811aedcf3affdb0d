// SPDX-License-Identifier: MIT
#pragma once

#include "io/overlay/overlay_marks.h"
#include "io/raster/picture_writer.h"

#include <QIODevice>
#include <QString>

#include <memory>

namespace io {

class PdfFile;

enum class ShapeFile { Svg, Pdf };

// Titles in the lists of pictures of the plane and of solids; for Text::tr().
struct ShapeFileTitles {
    const char* inPlane;
    const char* inSpace;
};
ShapeFileTitles titlesOf(ShapeFile file);

// A file of vector graphics around a picture of pixels: the pixels as they are, and shapes over them.
struct PicturePage {
    ShapeFile file = ShapeFile::Svg;
    QString title;
    OverlayMarks marks; // coordinates in pixels of the picture
};

// Takes the rows of a picture of 8 bits per channel, not Grey. SVG contains the system as text. Without
// dots per inch, a pixel is one of SVG. The device is open for writing and outlives the writer.
std::unique_ptr<PictureWriter> pageWriter(PicturePage page, QIODevice& device, const PictureFormat& format);
// The same as one more page of a file, which is there once the writer has finished.
std::unique_ptr<PictureWriter> pageWriter(OverlayMarks marks, PdfFile& file, const PictureFormat& format);

} // namespace io

// Suffixes of file names.
template <>
inline constexpr auto ifs::names<io::ShapeFile> = std::to_array<ifs::Named<io::ShapeFile>>({
    {io::ShapeFile::Svg, "svg"},
    {io::ShapeFile::Pdf, "pdf"},
});
