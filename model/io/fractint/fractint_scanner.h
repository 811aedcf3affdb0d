// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArrayView>

#include <optional>

// Positions of the entries of a Fractint collection. docs/formats.md, "Finding entries".
namespace io::fractint {

struct Span {
    qsizetype begin = 0;
    qsizetype end = 0; // one past the last byte
    qsizetype size() const { return end - begin; }
};

enum class BlockKind {
    Entry,        // name { … }
    Unclosed,     // an entry without its closing brace: ends where the next one begins
    Unnamed,      // { … }
    CommentBlock, // comment { … }
    OtherType,    // frm:name { … }, par:…, lsys:…
    TwoBraces,    // a line with two opening braces: no reader makes anything of it
};

// Byte offsets of one block.
struct Block {
    BlockKind kind = BlockKind::Entry;
    Span all;  // from the name to the closing brace and the rest of that line where it is blank or comment
    Span name; // without the prefix "ifs:"
    qsizetype open = -1;    // the opening brace; −1 in a bare file
    qsizetype close = -1;   // the closing brace; the end of the text when there is none
    bool hasPrefix = false; // "ifs:" stood before the name
};

// The block in its own text: where it begins is offset 0.
Block relative(Block block);

// '\n', or '\r' for a file that has no other line ends.
char lineEndByte(QByteArrayView bytes);

bool isBlank(char c); // white space, and the bytes that readers treat like it between entries: NUL, ^Z

Span withoutBlanks(QByteArrayView bytes, Span span);      // at its ends
Span withoutSpaceMarker(QByteArrayView bytes, Span span); // "(3D)" at its beginning, and blanks

// Offset of the end of the line that holds `position`: of its line end byte, or the size.
qsizetype lineEnd(QByteArrayView bytes, qsizetype position, char lineEndByte);

// Goes through a file once, in time linear in its size.
class Scanner {
public:
    Scanner(QByteArrayView bytes, char lineEndByte, qsizetype begin = 0);
    std::optional<Block> next();

private:
    void skipBetween();
    qsizetype findOpen() const;
    Block blockAt(qsizetype open);
    void findClose(Block& block);
    qsizetype restart(const Block& block, qsizetype secondOpen) const;
    qsizetype endOfEntry(qsizetype close) const;

    QByteArrayView m_bytes;
    char m_lineEnd;
    qsizetype m_position;
};

} // namespace io::fractint
