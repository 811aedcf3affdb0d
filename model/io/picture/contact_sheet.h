// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/names.h"
#include "io/picture/plane_export.h"

#include <QList>
#include <QPageSize>
#include <QSize>
#include <QString>

#include <array>
#include <memory>

namespace io {

// Pictures of many fractals side by side, each with its name, under a heading for every collection. Needs a
// QGuiApplication for the letters.
struct ContactSheet {
    enum class Paper { Dark, Light };
    struct Section {
        QString title; // heading; empty: none
        QList<std::shared_ptr<const document::Fractal>> fractals;
    };

    QString title; // heading of the whole sheet; empty: no line for it
    QList<Section> sections;
    int columns = 0;      // 0: about as many as fill the width of a screen
    QSize tile{240, 240}; // pixels
    Paper paper = Paper::Dark;
    int samplesPerPixel = 120;
    int threads = 1;
};

QSize sizeOf(const ContactSheet& sheet); // pixels

// Draws and writes the sheet, a row of pictures at a time; `path` appears whole or not at all. What the kind
// of file cannot hold is refused before anything is drawn.
ExportOutcome exportSheet(const ContactSheet& sheet, PictureFile file, const QString& path,
                          const Progress& progress = {}, const std::stop_token& stop = {});
Failure whyImpossible(const ContactSheet& sheet, PictureFile file);

// The same on pages as wide as the sheet, as many as it takes; no row of pictures is divided and no heading
// stands alone. The letters are text, the pictures have the pixels of a tile.
ExportOutcome exportSheetPdf(const ContactSheet& sheet, const QPageSize& page, const QString& path,
                             const Progress& progress = {}, const std::stop_token& stop = {});

} // namespace io

template <>
inline constexpr auto
    ifs::names<io::ContactSheet::Paper> = std::to_array<ifs::Named<io::ContactSheet::Paper>>({
        {io::ContactSheet::Paper::Dark, "dark"},
        {io::ContactSheet::Paper::Light, "light"},
    });
