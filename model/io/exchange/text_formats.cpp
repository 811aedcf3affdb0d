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

#include <algorithm>
#include <array>

namespace io {

namespace {

struct Name {
    const char* name;
    TextFormat format;
};
// The first of each format is its suffix.
constexpr std::array names{Name{"ifs", TextFormat::Fractint},      Name{"flame", TextFormat::Flame},
                           Name{"aifs", TextFormat::Aifs},         Name{"tex", TextFormat::Latex},
                           Name{"csv", TextFormat::Csv},           Name{"tsv", TextFormat::Tsv},
                           Name{"fractint", TextFormat::Fractint}, Name{"flam3", TextFormat::Flame},
                           Name{"latex", TextFormat::Latex}};

} // namespace

std::optional<TextFormat> textFormat(const QString& name) {
    for (const Name& known : names)
        if (name.compare(QLatin1String(known.name), Qt::CaseInsensitive) == 0) return known.format;
    return std::nullopt;
}

QString suffixOf(TextFormat format) {
    const auto* const known = std::find_if(names.begin(), names.end(),
                                           [format](const Name& name) { return name.format == format; });
    return QLatin1String(known->name);
}

bool holdsOneSystem(TextFormat format) {
    return format == TextFormat::Csv || format == TextFormat::Tsv;
}

bool holds(TextFormat format, const document::Fractal& fractal) {
    const int dimension = document::dimension(fractal);
    return dimension == 2 || (dimension == 3 && format != TextFormat::Flame);
}

namespace {

// Whether the format has a place for the symmetry of an entry; in the others its maps are listed.
bool holdsSymmetry(TextFormat format) {
    return format == TextFormat::Fractint ||
           format == TextFormat::Flame; // which lists them itself if need be
}

std::shared_ptr<const document::Fractal> plain(const std::shared_ptr<const document::Fractal>& fractal) {
    if (!document::isSymmetric(*fractal)) return fractal;
    return std::make_shared<const document::Fractal>(document::expanded(*fractal));
}

QByteArray tableOf(const document::Fractal& fractal, const TableColumns& columns, TableSeparator separator) {
    const auto* space = document::system3(fractal);
    return space ? writeTable(*space, separator)
                 : writeTable(*document::system2(fractal), columns, separator);
}

} // namespace

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
    QList<std::shared_ptr<const document::Fractal>> held;
    for (const auto& fractal : fractals)
        if (holds(format, *fractal)) held << (holdsSymmetry(format) ? fractal : plain(fractal));
    if (held.isEmpty()) return {};
    switch (format) {
    case TextFormat::Flame:
        return writeFlame(held, options.axis);
    case TextFormat::Aifs:
        return writeAifs(held);
    case TextFormat::Latex:
        return writeLatex(held);
    case TextFormat::Csv:
        return tableOf(*held.first(), options.columns, TableSeparator::Comma);
    case TextFormat::Tsv:
        return tableOf(*held.first(), options.columns, TableSeparator::Tab);
    case TextFormat::Fractint:
        break;
    }
    QByteArrayList entries;
    for (const auto& fractal : std::as_const(held))
        entries << writeEntry(*fractal);
    return entries.join('\n');
}

} // namespace io
