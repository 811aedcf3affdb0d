// SPDX-License-Identifier: MIT
#pragma once

#include "notation/text/bytes.h"

#include <optional>

// Where the entries of a Fractint collection are. docs/formats.md, "Finding entries".
namespace notation {

struct Span {
    Offset begin = 0;
    Offset end = 0; // one past the last byte
    Offset size() const { return end - begin; }
};

enum class BlockKind {
    Entry,        // name { … }
    Unclosed,     // entry without closing brace; ends before the next one
    Unnamed,      // { … }
    CommentBlock, // comment { … }
    OtherType,    // frm:name { … }, par:…, lsys:…
    TwoBraces,    // line with two opening braces, which no reader understands
};

// Byte offsets of one block.
struct Block {
    BlockKind kind = BlockKind::Entry;
    Span all;          // from the name to the closing brace, and the rest of that line if blank or comment
    Span name;         // name without the prefix "ifs:"
    Offset open = -1;  // opening brace; −1 in a bare file
    Offset close = -1; // closing brace; end of the text if there is none
    bool hasPrefix = false; // true for "ifs:" before the name
};

// The block in its own text: where it begins is offset 0.
Block relative(Block block);

// '\n', or '\r' for a file that has no other line ends.
char lineEndByte(Bytes bytes);

bool isBlank(char c); // true for white space and for NUL and ^Z, which readers skip between entries

Span withoutBlanks(Bytes bytes, Span span);      // removes blanks at both ends
Span withoutSpaceMarker(Bytes bytes, Span span); // removes "(3D)" at the beginning, and blanks

// Offset of the end of the line that holds `position`: of its line end byte, or the size.
Offset lineEnd(Bytes bytes, Offset position, char lineEndByte);

// Whether the block is a set of parameters or a formula: its first words hold an equals sign.
bool isAssignment(Bytes bytes, const Block& block, char lineEndByte);

// Whether the file is rows of numbers without names and braces, as of Fractint 10 to 15.
bool holdsOnlyRows(Bytes bytes, char lineEndByte);

// Goes through a file once, in time linear in its size.
class Scanner {
public:
    Scanner(Bytes bytes, char lineEndByte, Offset begin = 0);
    std::optional<Block> next();

private:
    void skipBetween();
    Offset findOpen() const;
    Block blockAt(Offset open);
    void findClose(Block& block);
    Offset restart(const Block& block, Offset secondOpen) const;
    Offset endOfEntry(Offset close) const;

    Bytes m_bytes;
    char m_lineEnd;
    Offset m_position;
};

} // namespace notation
