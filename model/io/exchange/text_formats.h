// SPDX-License-Identifier: MIT
#pragma once

#include "io/exchange/flame.h"
#include "io/table/table_columns.h"

#include <QByteArray>
#include <QList>
#include <QString>

#include <array>
#include <memory>
#include <optional>

namespace io {

// The forms in which systems are handed to other programs as text, in the order of lists.
enum class TextFormat { Fractint, Flame, Aifs, Latex, Csv, Tsv };
inline constexpr std::array textFormats{TextFormat::Fractint, TextFormat::Flame, TextFormat::Aifs,
                                        TextFormat::Latex,    TextFormat::Csv,   TextFormat::Tsv};

// The format with this file suffix or other name, in any case.
std::optional<TextFormat> textFormat(const QString& name);
QString suffixOf(TextFormat format);
const char* wordOf(TextFormat format);  // name on the command line
const char* titleOf(TextFormat format); // title in the list of the window, for Text::tr(); null: not listed
bool holdsOneSystem(TextFormat format); // true if a file has no place for a second system

struct TextOptions {
    FlameAxis axis = FlameAxis::Flipped;
    TableColumns columns = fractintColumns();
};

// Flames lie in the plane; what could not be read nothing holds.
bool holds(TextFormat format, const document::Fractal& fractal);

// The parts of the fractal that the format has no place for, as a sentence; nullopt when nothing is lost.
std::optional<QString> lossOf(TextFormat format, const document::Fractal& fractal);

// The text of the fractals that the format holds; a format that holds one system gets the first.
QByteArray textOf(const QList<std::shared_ptr<const document::Fractal>>& fractals, TextFormat format,
                  const TextOptions& options = {});

} // namespace io
