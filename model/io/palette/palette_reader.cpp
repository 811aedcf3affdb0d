// SPDX-License-Identifier: MIT
#include "io/palette/palette_reader.h"

#include "document/text/text.h"
#include "io/palette/palette_ggr.h"
#include "io/palette/palette_hex.h"
#include "io/palette/palette_stops.h"
#include "io/palette/palette_ugr.h"
#include "io/text/encoding.h"
#include "io/text/number.h"

#include <QByteArrayList>

#include <optional>

namespace io {

namespace {

using attractor::Palette;
using attractor::Rgba;
using document::Problem;

constexpr qsizetype maxFile = 16 * 1024 * 1024;
constexpr std::size_t maxColours = 4096;
constexpr qsizetype maxProblems = 10;
constexpr const char* stopPrefix = "barycage: stop ";

void report(PaletteFile& file, Problem::Severity severity, int line, const QString& message) {
    if (file.problems.size() < maxProblems || severity == Problem::Severity::Error)
        file.problems << Problem{severity, {}, line, line > 0 ? 1 : 0, message};
}

QString textOf(const QByteArray& bytes) {
    const QString text = QString::fromUtf8(bytes);
    return (text.contains(QChar::ReplacementCharacter) ? QString::fromLatin1(bytes) : text).simplified();
}

// "r g b anything", 0 … 255 each.
std::optional<Rgba> colourOf(const QByteArray& line) {
    const QByteArrayList words = line.simplified().split(' ');
    if (words.size() < 3) return std::nullopt;
    std::array<std::uint8_t, 3> channels{};
    for (qsizetype i = 0; i < 3; ++i) {
        bool good = false;
        const int value = words[i].toInt(&good);
        if (!good || value < 0 || value > 255) return std::nullopt;
        channels[std::size_t(i)] = std::uint8_t(value);
    }
    return Rgba{channels[0], channels[1], channels[2], 255};
}

std::optional<Palette::Stop> stopOf(const QByteArray& values) {
    const QByteArrayList words = values.simplified().split(' ');
    if (words.size() != 2) return std::nullopt;
    const auto position = parseNumber(QString::fromLatin1(words[0]));
    const auto colour = parseColour(words[1]);
    if (!position || !colour) return std::nullopt;
    return Palette::Stop{*position, *colour};
}

// Rows of three numbers: all of a colour map, or those behind the head of a GIMP palette.
class Rows {
public:
    explicit Rows(PaletteFile& file) : m_file(file) {}

    void read(const QByteArray& line, int number) {
        if (m_colours.size() >= maxColours) {
            if (!m_full)
                report(
                    m_file, Problem::Severity::Warning, number,
                    Text::tr("A palette can have at most %1 colours; the rest are ignored.").arg(maxColours));
            m_full = true;
            return;
        }
        if (const auto colour = colourOf(line))
            m_colours.push_back(*colour);
        else
            report(m_file, Problem::Severity::Warning, number,
                   Text::tr("This line is ignored: a colour consists of three whole numbers from 0 to 255."));
    }

    void readStop(const QByteArray& values) {
        if (m_stops.size() > maxColours) return;
        if (const auto stop = stopOf(values)) m_stops.push_back(*stop);
    }

    void finish(const QString& name) {
        std::vector<Palette::Stop> stops = isGradient(m_stops) ? m_stops : stopsThrough(m_colours);
        if (stops.empty())
            report(m_file, Problem::Severity::Error, 0, Text::tr("The file contains no colours."));
        else
            m_file.palettes.push_back({name.toStdString(), std::move(stops)});
    }

private:
    PaletteFile& m_file;
    std::vector<Rgba> m_colours;
    std::vector<Palette::Stop> m_stops;
    bool m_full = false;
};

void readGimpPalette(const QByteArrayList& lines, QString name, PaletteFile& file) {
    Rows rows(file);
    for (qsizetype i = 1; i < lines.size(); ++i) {
        const QByteArray line = lines[i].trimmed();
        if (line.isEmpty()) continue;
        if (line.startsWith('#')) {
            const QByteArray comment = line.sliced(1).trimmed();
            if (comment.startsWith(stopPrefix)) rows.readStop(comment.sliced(qstrlen(stopPrefix)));
        } else if (line.toLower().startsWith("name:")) {
            const QString own = textOf(line.sliced(5).left(200));
            if (!own.isEmpty()) name = own;
        } else if (!line.toLower().startsWith("columns:") && !line.toLower().startsWith("channels:")) {
            rows.read(line, int(i) + 1);
        }
    }
    rows.finish(name);
}

void readColourMap(const QByteArrayList& lines, const QString& name, PaletteFile& file) {
    Rows rows(file);
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QByteArray line = lines[i].trimmed();
        if (!line.isEmpty() && !line.startsWith(';')) rows.read(line, int(i) + 1);
    }
    rows.finish(name);
}

} // namespace

PaletteFile readPalettes(const QByteArray& bytes, const QString& name) {
    PaletteFile file;
    if (bytes.size() > maxFile) {
        report(file, Problem::Severity::Error, 0,
               Text::tr("The file is larger than 16 MB, which is the limit for a palette."));
        return file;
    }
    QByteArray text = fromUtf16(bytes).value_or(bytes);
    if (text.startsWith("\xef\xbb\xbf")) text = text.sliced(3);
    text.replace("\r\n", "\n").replace('\r', '\n');
    const QByteArray head = text.left(64).toLower();
    if (text.contains('\0'))
        report(file, Problem::Severity::Error, 0,
               Text::tr("The file is not a text file, so it is not a palette."));
    else if (head.startsWith("gimp palette"))
        readGimpPalette(text.split('\n'), name, file);
    else if (head.startsWith("gimp gradient"))
        readGimpGradient(text.split('\n'), name, file);
    else if (const std::vector<Rgba> colours = hexColours(text); !colours.empty())
        file.palettes.push_back({name.toStdString(), stopsThrough(colours)});
    else if (text.contains('{'))
        readUltraFractalGradients(text, file);
    else
        readColourMap(text.split('\n'), name, file);
    return file;
}

QByteArray writeGimpPalette(const Palette& palette) {
    constexpr int colours = 256;
    QByteArray name = QString::fromStdString(palette.name).simplified().toUtf8();
    if (name.isEmpty()) name = "Barycage";
    QByteArray text = "GIMP Palette\nName: " + name + "\nColumns: 16\n#\n";
    for (const Palette::Stop& stop : palette.stops)
        text += QByteArray("# ") + stopPrefix + formatNumber(stop.position) + ' ' + colourText(stop.colour) +
                '\n';
    for (int i = 0; i < colours; ++i) {
        const Rgba colour = attractor::colourAt(palette, double(i) / (colours - 1));
        text += QByteArray::number(colour.red) + ' ' + QByteArray::number(colour.green) + ' ' +
                QByteArray::number(colour.blue) + '\t' + QByteArray::number(i) + '\n';
    }
    return text;
}

} // namespace io
