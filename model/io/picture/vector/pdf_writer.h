// SPDX-License-Identifier: MIT
#pragma once

#include "io/picture/vector/pdf_file.h"
#include "io/picture/vector/svg_writer.h"

namespace io {

struct PdfPage {
    document::Fractal fractal;
    attractor::Camera camera;
    SvgFormat format;
};

// The shapes of svgPicture() on pages of PDF, as large as the format says. A structured picture is a nest
// of form objects, so the file stays small.
struct PdfPicture {
    QByteArray bytes; // empty after a failure
    Failure failure;  // failure of the first page that cannot be written
};
PdfPicture pdfPicture(const std::vector<PdfPage>& pages, const std::stop_token& stop = {});

// The same as one more page of a file; a failure adds none.
Failure addPage(PdfFile& file, const PdfPage& page, const std::stop_token& stop = {});

} // namespace io
