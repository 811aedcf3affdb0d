// SPDX-License-Identifier: MIT
#pragma once

#include "notation/rows/numbers.h"
#include "notation/rows/scanner.h"

#include <cstddef>
#include <optional>
#include <vector>

// The numbers between the braces of an entry. docs/formats.md, "Reading one entry".
namespace notation {

constexpr std::size_t maxMaps = 250'000;    // per entry
constexpr std::size_t maxLines = 1'000'000; // per entry
constexpr Offset maxLine = 200;             // bytes of a line that Fractint and Iterated Dynamics read

struct RowToken {
    Span span;
    int line = 0; // line of the entry, 0-based
};

// A way to take tokens for rows.
struct RowReading {
    std::vector<RowToken> tokens;
    RowShape shape;
    bool isValid = true; // true if all tokens are numbers
    bool decimalComma = false;
    bool usesHeader = false;    // true if the numbers on the line of the brace count
    bool isByLines = false;     // true for rows of a bare file that would also fill rows of 7
    double sumOfSevenths = NAN; // sum of every seventh number; NaN if one of them is negative
};

enum class RowFlaw {
    None,
    TooManyLines,
    Unclosed,
    TooManyMaps,     // found at the last token
    NotNumbers,      // found at tokens of `refused`
    NotRows,         // wrong number of numbers
    CommaOfTwoKinds, // rows with commas as separators, and others with commas as decimal points
    CommaOfNoKind,   // no rows with either meaning of commas
};

// A line that holds nothing but a comment.
struct CommentLine {
    Span line; // includes the line end
    Span text; // text after the semicolon, without surrounding blanks
};

// Byte offsets in the text of the entry.
struct Rows {
    std::vector<Offset> lineBegins; // at most maxLines + 1
    bool isMarked3D = false;
    bool isBraceBelow = false;          // true if the opening brace is below the line of the name
    Offset headerEnd = 0;               // line end of the header line, or the closing brace
    Offset bodyBegin = 0;               // first byte after the header line; at most the closing brace
    Offset headerTextEnd = 0;           // end of the numbers that count on the header line, before a comment
    Offset headerSemicolon = -1;        // semicolon on the header line; −1: none
    Span headerComment;                 // without the semicolon
    std::vector<RowToken> headerTokens; // either all are numbers, or there are none
    std::vector<RowToken> bodyTokens;
    bool hasCommas = false; // true also for apostrophes
    Offset longLine = -1;   // first byte that other programs do not read
    Offset nul = -1;        // first NUL byte
    std::vector<CommentLine> comments;

    std::optional<RowReading> chosen; // nullopt if the numbers make no system
    RowFlaw flaw = RowFlaw::None;
    RowToken flawAt{};             // TooManyMaps, CommaOfTwoKinds, CommaOfNoKind
    std::vector<RowToken> refused; // NotNumbers

    // Of numbers on the header line that do not count, a comment: readRows() has said so.
    bool ignoresHeader() const { return chosen && !chosen->usesHeader && !headerTokens.empty(); }
};

// `text` begins where block.all begins (offset 0). Never fails.
Rows readRows(Bytes text, const Block& block, char lineEndByte);

inline Bytes textOf(Bytes text, Span span) {
    return text.sliced(span.begin, span.size());
}

} // namespace notation
