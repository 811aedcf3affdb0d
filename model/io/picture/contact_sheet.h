// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"
#include "io/picture/png_export.h"

#include <QImage>
#include <QList>
#include <QSize>
#include <QString>

#include <memory>

namespace io {

// Pictures of many fractals side by side, each with its name, under a heading for every collection. Needs a
// QGuiApplication for the letters.
struct ContactSheet {
    enum class Paper { Dark, Light };
    struct Section {
        QString title; // none: no heading
        QList<std::shared_ptr<const document::Fractal>> fractals;
    };

    QString title; // over the whole; none: no line for it
    QList<Section> sections;
    int columns = 0;      // 0: as many as make the sheet about as wide as a screen
    QSize tile{240, 240}; // pixels
    Paper paper = Paper::Dark;
    int samplesPerPixel = 120;
    int threads = 1;
};

struct DrawnSheet {
    QImage image;    // null when stopped or after a failure
    Failure failure; // too large
};
QSize sizeOf(const ContactSheet& sheet);
DrawnSheet drawSheet(const ContactSheet& sheet, const Progress& progress = {},
                     const std::stop_token& stop = {});

} // namespace io
