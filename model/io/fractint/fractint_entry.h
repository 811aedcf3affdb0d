// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/problem.h"
#include "io/fractint/fractint_scanner.h"
#include "notation/rows/row_reader.h"

#include <QByteArrayView>

#include <vector>

// An entry of a Fractint collection: its meaning, and the place of each part in its text. docs/formats.md,
// "Reading one entry".
namespace io::fractint {

using notation::maxLines;
using notation::maxMaps;

struct Token {
    Span span;
    double value = 0;
    int line = 0; // line of the entry, 0-based
};

struct Comment {
    Span line;                 // includes the line end
    Span text;                 // trimmed text after the semicolon
    bool isOwn = false;        // true for "barycage:" …
    bool isUnderstood = false; // true for known keys and values that suit a system of this dimension
};

// Byte offsets in the entry's text; a row is `rowLength` successive tokens.
struct Layout {
    Block block;
    int rowLength = 0; // 6, 7, 12 or 13; 0 for an entry without a system
    bool decimalComma = false;
    std::vector<Token> numbers;
    qsizetype headerEnd = 0;     // line end of the header line, or the closing brace
    qsizetype bodyBegin = 0;     // first byte after the header line; at most block.close
    qsizetype headerTextEnd = 0; // end of the numbers that count on the header line, before a comment
    qsizetype headerSemicolon = -1;
    Span headerComment; // without the semicolon
    std::vector<Comment> comments;
};

struct ParsedEntry {
    Layout layout;
    document::Fractal fractal;
    document::Problems problems; // positions relative to the text: its first byte is line 1, column 1
};

// `text` begins where block.all begins (offset 0). Never fails: an entry that cannot be read has no system.
ParsedEntry parseEntry(QByteArrayView text, const Block& block, char lineEndByte);

// UTF-8 where it is valid, else Latin-1.
QString decoded(QByteArrayView bytes);

constexpr qsizetype maxEntries = 200'000; // per file
constexpr qsizetype maxProblems = 10;     // problems reported for each entry

} // namespace io::fractint
