// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/lesson/lesson.h"
#include "ifs/names.h"

#include <QByteArray>
#include <QList>
#include <QSize>
#include <QString>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

// An entry, or all of a collection, as one file for browsers: the attractor in its cage, live, without a
// server or a network.
namespace io {

enum class PageParts {
    Figure, // picture alone, with its name and caption
    Table,  // picture and maps
    All,    // picture, maps, palettes, and files to be saved
};

// A step of a lesson: a text, and what is shown with it.
struct PageStep {
    QString title, text;
    qsizetype entry = 0;                        // index of the entry
    std::optional<document::LessonArea> area{}; // visible area in the plane; nullopt: all
    bool holdsMaps = false;                     // true: handles of the maps in place of the cage
};

struct PageExport {
    document::Fractal fractal;
    // Of a gallery or of a lesson, which begins with the fractal; empty: none.
    QList<std::shared_ptr<const document::Fractal>> entries;
    QString title;         // title of the gallery or lesson
    QList<PageStep> steps; // steps of a lesson; empty: none
    PageParts parts = PageParts::All;
    bool allowsCage = true;            // permits the reader to drag the cage
    bool allowsMaps = true;            // permits the reader to drag maps
    bool allowsCode = true;            // permits the reader to type maps
    QString caption;                   // text below the name or title; empty: none
    QString language;                  // one of pageLanguages(); empty: language of the browser
    std::optional<QSize> size;         // CSS pixels of the picture; nullopt: available room
    std::uint64_t points = 20'000'000; // points of a picture at rest
};

// Why the entry cannot be shown in a page, in a sentence; empty where it can.
QString pageObstacle(const document::Fractal& fractal);

QByteArray pageOf(const PageExport& page);
// The same as a script for articles: where it is loaded, it puts a frame with the figure behind itself. Of a
// collection, each place of the article names its entry. All figures of an article share one engine.
QByteArray scriptOf(const PageExport& page);

inline constexpr std::array pageLanguages{"en", "de", "es", "fr", "mk"};

} // namespace io

template <>
inline constexpr auto ifs::names<io::PageParts> = std::to_array<ifs::Named<io::PageParts>>({
    {io::PageParts::Figure, "figure"},
    {io::PageParts::Table, "table"},
    {io::PageParts::All, "all"},
});
