// SPDX-License-Identifier: MIT
#include "notation/entry_reader.h"

#include "notation/lines/look_lines.h"
#include "notation/lines/map_lines.h"
#include "notation/lines/placement_lines.h"
#include "notation/rows/row_reader.h"
#include "notation/text/words.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace notation {

namespace {

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

// Line and column of growing offsets.
class Lines {
public:
    Lines(Bytes text, char lineEndByte) : m_text(text), m_lineEnd(lineEndByte) {}

    Flaw flawAt(Offset position, std::string sentence) {
        for (; m_position < position; ++m_position)
            if (m_text[m_position] == m_lineEnd) {
                ++m_line;
                m_lineBegin = m_position + 1;
            }
        return {m_line, int(position - m_lineBegin) + 1, std::move(sentence)};
    }

private:
    Bytes m_text;
    char m_lineEnd;
    Offset m_position = 0;
    Offset m_lineBegin = 0;
    int m_line = 1;
};

std::string quoted(Bytes text, Span span) {
    constexpr Offset most = 40;
    return "“" + decoded(text.sliced(span.begin, std::min(span.size(), most))) + "”";
}

struct Found {
    Offset at = 0; // position in the text of the entry
    std::string sentence;
};

Found wrongNumber(Bytes text, const std::vector<RowToken>& tokens) {
    for (const RowToken& token : tokens) {
        const std::string word = quoted(text, token.span);
        switch (readNumber(textOf(text, token.span).view()).kind) {
        case Number::Kind::Good:
            continue;
        case Number::Kind::NotFinite:
            return {token.span.begin, word + " is not a finite number."};
        case Number::Kind::Huge:
            return {token.span.begin, word + " is too large for a coefficient (the largest absolute value is "
                                             "3.4e38)."};
        case Number::Kind::Trailing:
            return {token.span.begin, word + " is not a plain number. Write it as one decimal number."};
        case Number::Kind::NotANumber:
            return {token.span.begin, word + " is not a number."};
        }
    }
    return {};
}

// The first line whose numbers are not whole rows is where to look.
Found wrongShape(const Rows& rows, Offset open) {
    const auto& tokens = rows.bodyTokens.empty() ? rows.headerTokens : rows.bodyTokens;
    if (tokens.empty()) return {std::max<Offset>(open, 0), "The entry contains no numbers."};
    const std::size_t wanted = rows.isMarked3D ? 13 : 7;
    std::size_t begin = 0, count = 0;
    for (std::size_t i = 0; i < tokens.size() && count == 0;) {
        std::size_t end = i;
        while (end < tokens.size() && tokens[end].line == tokens[i].line)
            ++end;
        if ((end - i) % wanted != 0) {
            begin = i;
            count = end - i;
        }
        i = end;
    }
    return {tokens[begin].span.begin,
            "Numbers are missing or left over: this line has " + std::to_string(count) + ", the entry has " +
                std::to_string(tokens.size()) + ", and each map has " + std::to_string(wanted) +
                (rows.isMarked3D ? " in an entry marked “(3D)”." : ".")};
}

Found flawOf(Bytes text, const Block& block, const Rows& rows) {
    const Offset at = rows.flawAt.span.begin;
    switch (rows.flaw) {
    case RowFlaw::TooManyLines:
        return {0, "The entry has more than " + std::to_string(maxLines) + " lines, which is the limit."};
    case RowFlaw::Unclosed:
        return {block.open,
                "The entry that starts here has no closing “}” before the next entry or the end of "
                "the file."};
    case RowFlaw::TooManyMaps:
        return {at, "The entry has more than " + std::to_string(maxMaps) + " maps, which is the limit."};
    case RowFlaw::CommaOfTwoKinds:
        return {at, quoted(text, rows.flawAt.span) +
                        ": the comma can be a decimal comma or a separator; both "
                        "readings give complete rows. Use decimal points and "
                        "spaces."};
    case RowFlaw::CommaOfNoKind:
        return {at, quoted(text, rows.flawAt.span) +
                        ": the comma gives complete rows of 7 numbers (13 with "
                        "“(3D)”) neither as a decimal comma nor as a separator."};
    case RowFlaw::NotNumbers:
        return wrongNumber(text, rows.refused);
    case RowFlaw::NotRows:
    case RowFlaw::None:
        break;
    }
    return wrongShape(rows, block.open);
}

template <int Dim> Figure<Dim> figureOf(Bytes text, const RowReading& rows) {
    Figure<Dim> figure;
    const auto length = std::size_t(rows.shape.rowLength);
    figure.system.maps.reserve(rows.tokens.size() / length);
    for (std::size_t i = 0; i + length <= rows.tokens.size(); i += length) {
        const auto number = [&](int k) {
            return valueOf(textOf(text, rows.tokens[i + std::size_t(k)].span).view(), rows.decimalComma);
        };
        ifs::WeightedMap<Dim> map;
        map.id = ifs::MapId(std::uint32_t(figure.system.maps.size()) + 1);
        for (int row = 0; row < Dim; ++row)
            for (int column = 0; column < Dim; ++column)
                map.map.linear(row, column) = number(row * Dim + column);
        for (int row = 0; row < Dim; ++row)
            map.map.translation[row] = number(Dim * Dim + row);
        if (length % 2 == 1) map.weight = number(Dim * Dim + Dim);
        figure.system.maps.push_back(std::move(map));
    }
    return figure;
}

// What Barycage's comment lines say.
class OwnLines {
public:
    void read(const std::string& comment) {
        const auto [key, values] = ownWords(comment);
        if (key != "version" && !m_look.read(key, values) && !m_placement.read(key, values) &&
            !m_maps.read(key, values))
            m_others.push_back(comment);
    }

    template <int Dim> void applyTo(Figure<Dim>& figure, Entry& entry) {
        m_placement.applyTo(figure);
        m_maps.applyTo(figure.system);
        entry.appearance = m_look.appearance(figure.system.maps.size());
        entry.otherLines = std::move(m_others);
    }

private:
    LookReader m_look;
    PlacementReader m_placement;
    MapReader m_maps;
    std::vector<std::string> m_others;
};

class FileReader {
public:
    FileReader(Bytes text, std::string_view bareName)
        : m_text(text),
          m_bareName(bareName),
          m_lineEnd(lineEndByte(text)),
          m_lines(text, m_lineEnd),
          m_begin(text.startsWith(byteOrderMark) ? Offset(byteOrderMark.size()) : 0) {}

    File read() && {
        Scanner scanner(m_text, m_lineEnd, m_begin);
        while (const auto block = scanner.next()) {
            const bool isOpen = block->kind == BlockKind::Entry || block->kind == BlockKind::Unclosed;
            if (!isOpen || isAssignment(m_text, *block, m_lineEnd)) continue;
            if (m_file.entries.size() >= maxEntries) {
                m_file.flaw = m_lines.flawAt(block->all.begin, "The file has more than " +
                                                                   std::to_string(maxEntries) + " entries.");
                break;
            }
            add(*block);
        }
        if (m_file.entries.empty() && !readBare())
            m_file.flaw =
                Flaw{1, 1,
                     "No iterated function system was found: an entry consists of a name, “{”, rows "
                     "of 7 numbers and “}”."};
        return std::move(m_file);
    }

private:
    bool readBare();
    void add(const Block& block);

    Bytes m_text;
    std::string m_bareName;
    char m_lineEnd;
    Lines m_lines;
    Offset m_begin;
    File m_file;
};

bool FileReader::readBare() {
    if (!holdsOnlyRows(m_text.sliced(m_begin), m_lineEnd)) return false;
    Block block;
    block.all = {m_begin, m_text.size()};
    if (const Offset ctrlZ = m_text.indexOf('\x1a', m_begin); ctrlZ >= 0) block.all.end = ctrlZ;
    block.name = {m_begin, m_begin};
    block.close = block.all.end;
    add(block);
    return true;
}

void FileReader::add(const Block& where) {
    const Bytes text = textOf(m_text, where.all);
    const Block block = relative(where);
    const Rows rows = readRows(text, block, m_lineEnd);
    Entry entry;
    entry.name = block.open < 0 ? m_bareName : decoded(textOf(text, block.name));
    entry.headerComment = decoded(textOf(text, rows.headerComment));
    OwnLines own;
    for (const CommentLine& comment : rows.comments) {
        const Bytes content = textOf(text, comment.text);
        if (isOwnComment(content.view()))
            own.read(std::string(content.view()));
        else
            entry.comments.push_back(decoded(content));
    }
    if (!rows.chosen) {
        const Found found = flawOf(text, block, rows);
        entry.flaw = m_lines.flawAt(where.all.begin + found.at, found.sentence);
    } else if (rows.chosen->shape.rowLength < 12) {
        own.applyTo(entry.figure.emplace<Figure<2>>(figureOf<2>(text, *rows.chosen)), entry);
    } else {
        own.applyTo(entry.figure.emplace<Figure<3>>(figureOf<3>(text, *rows.chosen)), entry);
    }
    m_file.entries.push_back(std::move(entry));
}

} // namespace

File readFile(std::string_view text, std::string_view bareName) {
    return FileReader(text, bareName).read();
}

} // namespace notation
