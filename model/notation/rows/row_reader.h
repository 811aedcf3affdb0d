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
constexpr Offset maxLine = 200;             // bytes that Fractint and Iterated Dynamics read of a line

struct RowToken {
    Span span;
    int line = 0; // of the entry, 0-based
};

// A way to take tokens for rows.
struct RowReading {
    std::vector<RowToken> tokens;
    RowShape shape;
    bool isValid = true; // every token is a number
    bool decimalComma = false;
    bool usesHeader = false;    // the numbers on the line of the brace count
    bool isByLines = false;     // rows of a bare file that would fill rows of 7 as well
    double sumOfSevenths = NAN; // of every seventh number, where none of them is negative
};

enum class RowFlaw {
    None,
    TooManyLines,
    Unclosed,
    TooManyMaps,     // at the last token
    NotNumbers,      // some tokens of `refused`
    NotRows,         // their count
    CommaOfTwoKinds, // as separator and as decimal point it gives rows
    CommaOfNoKind,   // it gives rows as neither
};

// A line that holds nothing but a comment.
struct CommentLine {
    Span line; // from its first byte to past its line end
    Span text; // after the semicolon, without blanks at its ends
};

// Byte offsets in the text of the entry.
struct Rows {
    std::vector<Offset> lineBegins; // at most one more than maxLines
    bool isMarked3D = false;
    bool isBraceBelow = false;   // the opening brace is not on the line of the name
    Offset headerEnd = 0;        // of the header line: its line end, or the closing brace
    Offset bodyBegin = 0;        // the first byte after the header line; at most the closing brace
    Offset headerTextEnd = 0;    // of numbers on the header line that count: a comment may stand after it
    Offset headerSemicolon = -1; // on the header line
    Span headerComment;          // without the semicolon
    std::vector<RowToken> headerTokens; // all of them numbers, or none
    std::vector<RowToken> bodyTokens;
    bool hasCommas = false; // or apostrophes
    Offset longLine = -1;   // the first byte that other programs do not read
    Offset nul = -1;        // the first one
    std::vector<CommentLine> comments;

    std::optional<RowReading> chosen; // nullopt where the numbers make no system
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
