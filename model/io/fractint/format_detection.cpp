// SPDX-License-Identifier: MIT
#include "io/fractint/format_detection.h"

#include "document/text/text.h"
#include "io/fractint/fractint_entry.h"
#include "io/text/number.h"

#include <QByteArrayList>

#include <algorithm>
#include <array>

namespace io {

namespace {

constexpr qsizetype sampleSize = 4096;

bool isBinary(QByteArrayView bytes) {
    QByteArrayView head = bytes.first(std::min<qsizetype>(bytes.size(), 512));
    // Bytes after ^Z are arbitrary: DOS filled the last block of a text.
    if (const qsizetype end = head.indexOf('\x1a'); end > 0) head = head.first(end);
    const auto odd = std::count_if(head.begin(), head.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte < 0x20 && !(byte >= '\t' && byte <= '\r') && byte != 0x1a) || byte == 0x7f;
    });
    return odd > 2 && odd * 20 > head.size();
}

// An entry that can be read outweighs every word and odd byte around it, and does so after any edit of it.
// Entries that are never shown are not looked at.
bool holdsSystem(QByteArrayView bytes) {
    const char lineEnd = fractint::lineEndByte(bytes);
    fractint::Scanner scanner(bytes, lineEnd);
    qsizetype count = 0;
    while (const auto block = scanner.next()) {
        if (block->kind != fractint::BlockKind::Entry && block->kind != fractint::BlockKind::Unclosed)
            continue;
        if (++count > fractint::maxEntries) return false;
        const QByteArrayView text = bytes.sliced(block->all.begin, block->all.size());
        if (fractint::parseEntry(text, fractint::relative(*block), lineEnd).layout.rowLength > 0) return true;
    }
    return false;
}

QString ifstile() {
    return Text::tr("This is an IFStile file (.aifs), not a Fractint collection.");
}

QString xaos() {
    return Text::tr("This is a XaoS position file, not a Fractint collection.");
}

std::optional<QString> byMagic(QByteArrayView bytes) {
    struct Magic {
        QByteArrayView bytes;
        const char* name;
    };
    static const std::array magics{
        Magic{"\x89PNG", "PNG"}, Magic{"\xff\xd8\xff", "JPEG"}, Magic{"GIF89a", "GIF"},
        Magic{"GIF87a", "GIF"},  Magic{"PK\x03\x04", "ZIP"},    Magic{"\x1f\x8b", "gzip"},
        Magic{"%PDF-", "PDF"},   Magic{"BM", nullptr},
    };
    for (const auto& [magic, name] : magics)
        if (name != nullptr && bytes.startsWith(magic))
            return Text::tr("This is a %1 file, not a text file with iterated function systems.")
                .arg(QLatin1String(name));
    if (bytes.startsWith("\xff\xfe") || bytes.startsWith("\xfe\xff"))
        return Text::tr("This text is encoded in UTF-16. Save it as UTF-8 or ASCII and open it again.");
    return std::nullopt;
}

// A tag, and no entry whose name begins with this sign. Markup may hold entries: our pictures do.
bool isMarkup(QByteArrayView text) {
    const auto lineEnd =
        std::find_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; });
    return text.startsWith('<') && std::find(text.begin(), lineEnd, '{') == lineEnd;
}

std::optional<QString> byBeginning(QByteArrayView text) {
    if (text.startsWith("(("))
        return Text::tr(
            "This is a list written by a Racket program (wgmitchener's IFS editor), not a Fractint "
            "collection.");
    if (text.startsWith('<')) {
        if (text.contains("<flame"))
            return Text::tr("This is a flame file (XML), not a Fractint collection.");
        if (text.contains("<svg")) return Text::tr("This is an SVG picture, not a Fractint collection.");
        return text.contains("<Transform") || text.contains("<ifs")
                   ? Text::tr("This is an XML file of an IFS program such as IFS Explorer, not a Fractint "
                              "collection.")
                   : Text::tr("This is an XML or HTML file, not a Fractint collection.");
    }
    if (text.startsWith('@')) return ifstile();
    if (text.startsWith("(initstate)")) return xaos();
    return std::nullopt;
}

// The text begins like a program.
bool isProgram(QByteArrayView text) {
    static const std::array beginnings{"#include",  "#!",       "import ",         "def ",
                                       "function ", "package ", "using namespace "};
    return std::ranges::any_of(beginnings, [&](const char* words) { return text.startsWith(words); });
}

bool isJson(QByteArrayView text) {
    if (text.isEmpty()) return false;
    const QByteArrayView rest = text.sliced(1).trimmed();
    const char second = rest.isEmpty() ? '\0' : rest[0];
    return (text.startsWith('{') && (second == '"' || second == '}')) ||
           (text.startsWith('[') && (second == '{' || second == '[' || second == '"' || second == ']' ||
                                     second == '-' || (second >= '0' && second <= '9')));
}

std::optional<QString> byWords(QByteArrayView text) {
    if (isJson(text))
        return Text::tr("This is JSON text (data of another program), not a Fractint collection, and none of "
                        "its lists are affine maps.");
    if (isProgram(text))
        return Text::tr("This is the text of a program, not a Fractint collection, and none of its lists are "
                        "affine maps.");
    if (text.contains("$dim")) return ifstile();
    if (text.contains("(formula '")) return xaos();
    return std::nullopt;
}

QByteArrayList linesOf(QByteArrayView text) {
    QByteArrayList lines;
    for (const QByteArray& line : QByteArray(text.data(), text.size()).replace('\r', '\n').split('\n'))
        if (const QByteArray simple = line.simplified(); !simple.isEmpty() && !simple.startsWith(';'))
            lines << simple;
    return lines;
}

// Numbers in a line, −1 when anything else stands there.
qsizetype numbersIn(const QByteArray& line) {
    const QByteArrayList words = line.split(' ');
    const bool all = std::all_of(words.begin(), words.end(), [](const QByteArray& word) {
        return parseNumber(QString::fromLatin1(word)).has_value();
    });
    return all ? words.size() : -1;
}

std::optional<QString> byLines(const QByteArrayList& lines) {
    if (lines.size() < 2)
        return lines.size() == 1 && lines[0].contains("*x")
                   ? std::optional(Text::tr(
                         "The lines are expressions in x and y, as pyfractal writes them, not a Fractint "
                         "collection."))
                   : std::nullopt;
    const qsizetype first = numbersIn(lines[0]);
    const qsizetype second = numbersIn(lines[1]);
    if (first == 1 && second == 7)
        return Text::tr(
            "This is a table of the program Fraktale: a count, maps with cumulative percentages and a "
            "window. It "
            "is not a Fractint collection.");
    if (first == 3 && second == 5)
        return Text::tr(
            "This table has 5 numbers per map (scales, shifts and a rotation in pixels). It is not a "
            "Fractint "
            "collection.");
    const auto isFileName = [](const QByteArray& line) { return line.endsWith(".ifs"); };
    if (std::count_if(lines.begin(), lines.end(), isFileName) * 3 > lines.size())
        return Text::tr(
            "This is a list of other files, as used by the program Fraktale, not a Fractint collection.");
    const auto isExpression = [](const QByteArray& line) {
        const qsizetype semicolon = line.indexOf(';');
        return semicolon > 0 && line.first(semicolon).contains(',') &&
               (line.contains('x') || line.contains('y')) && (line.contains('*') || line.contains('/'));
    };
    if (isExpression(lines[0]) || isExpression(lines[1]))
        return Text::tr(
            "The lines are expressions in x and y, as pyfractal writes them, not a Fractint collection.");
    const auto isScript = [](const QByteArray& line) {
        return line.startsWith("//") || line.startsWith("xform") || line.startsWith("translate") ||
               line.startsWith("rotate") || line.startsWith("scale");
    };
    if (std::count_if(lines.begin(), lines.end(), isScript) * 2 > lines.size())
        return Text::tr("This is a StyrofoamIFS script, not a Fractint collection.");
    return std::nullopt;
}

} // namespace

std::optional<QString> foreignFormatRemark(QByteArrayView bytes) {
    if (bytes.startsWith("\xef\xbb\xbf")) bytes = bytes.sliced(3);
    if (const auto magic = byMagic(bytes)) return magic;
    const bool isCollection = holdsSystem(bytes);
    if (!isCollection && isBinary(bytes))
        return Text::tr("This is a binary file (perhaps a fractal-compressed image or an icon library), not "
                        "a text file with iterated function systems.");
    const QByteArrayView text = bytes.first(std::min(bytes.size(), sampleSize)).trimmed();
    if (isCollection && !isMarkup(text)) return std::nullopt;
    if (const auto beginning = byBeginning(text)) return beginning;
    if (const auto words = byWords(text)) return words;
    return byLines(linesOf(text));
}

} // namespace io
