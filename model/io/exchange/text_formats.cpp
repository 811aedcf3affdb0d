// SPDX-License-Identifier: MIT
#include "io/exchange/text_formats.h"

#include "document/edits/maps/symmetry_edits.h"
#include "io/exchange/aifs.h"
#include "io/exchange/flame_colours.h"
#include "io/exchange/flame_symmetry.h"
#include "io/exchange/latex.h"
#include "io/fractint/entry_writer.h"
#include "io/table/table_writer.h"
#include "io/text/lost_parts.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <vector>

namespace io {

namespace {

using Fractals = QList<std::shared_ptr<const document::Fractal>>;

std::shared_ptr<const document::Fractal> plain(const std::shared_ptr<const document::Fractal>& fractal) {
    if (!document::isSymmetric(*fractal)) return fractal;
    return std::make_shared<const document::Fractal>(document::expanded(*fractal));
}

QByteArray writeEntries(const Fractals& held, const TextOptions& /*options*/) {
    QByteArrayList entries;
    for (const auto& fractal : held)
        entries << writeEntry(*fractal);
    return entries.join('\n');
}

template <TableSeparator separator> QByteArray tableOf(const Fractals& held, const TextOptions& options) {
    const auto* space = document::system3(*held.first());
    return space ? writeTable(*space, separator)
                 : writeTable(*document::system2(*held.first()), options.columns, separator);
}

struct Kind {
    TextFormat format;
    const char* title;              // null: not in the list of the window
    const char* word;               // name on the command line
    std::vector<const char*> names; // suffix first
    QByteArray (*write)(const Fractals& held, const TextOptions& options);
    bool holdsOneSystem = false;
    bool holdsSolids = true;
    bool holdsSymmetry = false; // false: maps are listed
};

const Kind& kindOf(TextFormat format) {
    static const std::array kinds{
        Kind{.format = TextFormat::Fractint,
             .title = nullptr,
             .word = "fractint",
             .names = {"ifs", "fractint"},
             .write = writeEntries,
             .holdsSymmetry = true},
        Kind{.format = TextFormat::Flame,
             .title = QT_TRANSLATE_NOOP("Text", "Flame: flam3, Apophysis, JWildfire, Fractorium"),
             .word = "flame",
             .names = {"flame", "flam3"},
             .write = [](const Fractals& held,
                         const TextOptions& options) { return writeFlame(held, options.axis); },
             .holdsSolids = false,
             .holdsSymmetry = true}, // expands the symmetry itself if necessary
        Kind{.format = TextFormat::Aifs,
             .title = QT_TRANSLATE_NOOP("Text", "IFStile (.aifs)"),
             .word = "aifs",
             .names = {"aifs"},
             .write = [](const Fractals& held, const TextOptions&) { return writeAifs(held); }},
        Kind{.format = TextFormat::Latex,
             .title = QT_TRANSLATE_NOOP("Text", "Formulas and a figure for LaTeX (.tex)"),
             .word = "tex",
             .names = {"tex", "latex"},
             .write = [](const Fractals& held, const TextOptions&) { return writeLatex(held); }},
        Kind{.format = TextFormat::Csv,
             .title = QT_TRANSLATE_NOOP("Text", "Table with commas (.csv)"),
             .word = "csv",
             .names = {"csv"},
             .write = tableOf<TableSeparator::Comma>,
             .holdsOneSystem = true},
        Kind{.format = TextFormat::Tsv,
             .title = QT_TRANSLATE_NOOP("Text", "Table with tabs (.tsv)"),
             .word = "tsv",
             .names = {"tsv"},
             .write = tableOf<TableSeparator::Tab>,
             .holdsOneSystem = true}};
    return *std::ranges::find(kinds, format, &Kind::format);
}

} // namespace

std::optional<TextFormat> textFormat(const QString& name) {
    for (const TextFormat format : textFormats)
        for (const char* known : kindOf(format).names)
            if (name.compare(QLatin1String(known), Qt::CaseInsensitive) == 0) return format;
    return std::nullopt;
}

QString suffixOf(TextFormat format) {
    return QLatin1String(kindOf(format).names.front());
}

const char* wordOf(TextFormat format) {
    return kindOf(format).word;
}

const char* titleOf(TextFormat format) {
    return kindOf(format).title;
}

bool holdsOneSystem(TextFormat format) {
    return kindOf(format).holdsOneSystem;
}

bool holds(TextFormat format, const document::Fractal& fractal) {
    const int dimension = document::dimension(fractal);
    return dimension == 2 || (dimension == 3 && kindOf(format).holdsSolids);
}

std::optional<QString> lossOf(TextFormat format, const document::Fractal& fractal) {
    if (format == TextFormat::Fractint) return std::nullopt;
    KeptParts kept;
    if (format == TextFormat::Flame && document::system2(fractal)) {
        const FlameColours colours = flameColoursOf(fractal);
        kept = {colours.isPalette,
                fractal.appearance.background.alpha == 255,
                true,
                colours.holdsMapColours,
                true,
                flameHoldsSymmetry(fractal),
                true,
                false,
                true,
                colours.holdsMapBlends};
    }
    return lossBeside(kept, fractal);
}

QByteArray textOf(const QList<std::shared_ptr<const document::Fractal>>& fractals, TextFormat format,
                  const TextOptions& options) {
    Fractals held;
    for (const auto& fractal : fractals)
        if (holds(format, *fractal)) held << (kindOf(format).holdsSymmetry ? fractal : plain(fractal));
    return held.isEmpty() ? QByteArray() : kindOf(format).write(held, options);
}

} // namespace io
