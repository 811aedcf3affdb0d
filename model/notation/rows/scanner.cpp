// SPDX-License-Identifier: MIT
#include "notation/rows/scanner.h"

#include <algorithm>

namespace notation {

namespace {

constexpr char ctrlZ = 0x1a;

// In letters of any size; `word` has small ones.
bool startsWithWord(Bytes text, Bytes word) {
    return text.size() >= word.size() &&
           std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) { return a == lower(b); });
}

// A single word, perhaps followed by (3D): what may stand alone on the line above its brace.
bool isLoneName(Bytes line) {
    const auto paren = std::find(line.begin(), line.end(), '(');
    const Span word = withoutBlanks(line, {0, paren - line.begin()});
    const Bytes name = line.sliced(word.begin, word.size());
    return !name.isEmpty() && std::none_of(name.begin(), name.end(), isBlank);
}

// Only "(…)" or nothing: what may stand between a line break and the brace that belongs to the line above.
bool isOnlyMarker(Bytes text) {
    const Span rest = withoutBlanks(text, {0, text.size()});
    return rest.size() == 0 || (text[rest.begin] == '(' && text[rest.end - 1] == ')');
}

BlockKind kindOf(Bytes name) {
    if (name.isEmpty()) return BlockKind::Unnamed;
    if (name.size() == 7 && startsWithWord(name, "comment")) return BlockKind::CommentBlock;
    if (startsWithWord(name, "frm:") || startsWithWord(name, "par:") || startsWithWord(name, "lsys:"))
        return BlockKind::OtherType;
    return BlockKind::Entry;
}

} // namespace

bool isBlank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r') || c == '\0' || c == ctrlZ;
}

Block relative(Block block) {
    const Offset begin = block.all.begin;
    for (Offset* offset :
         {&block.all.begin, &block.all.end, &block.name.begin, &block.name.end, &block.close})
        *offset -= begin;
    if (block.open >= 0) block.open -= begin;
    return block;
}

char lineEndByte(Bytes bytes) {
    return !bytes.contains('\n') && bytes.contains('\r') ? '\r' : '\n';
}

Span withoutBlanks(Bytes bytes, Span span) {
    while (span.begin < span.end && isBlank(bytes[span.begin]))
        ++span.begin;
    while (span.end > span.begin && isBlank(bytes[span.end - 1]))
        --span.end;
    return span;
}

Span withoutSpaceMarker(Bytes bytes, Span span) {
    constexpr Offset length = 4;
    span = withoutBlanks(bytes, span);
    if (span.size() < length || lowered(bytes.sliced(span.begin, length)) != "(3d)") return span;
    return withoutBlanks(bytes, {span.begin + length, span.end});
}

Offset lineEnd(Bytes bytes, Offset position, char lineEndByte) {
    const Offset found = bytes.indexOf(lineEndByte, position);
    return found < 0 ? bytes.size() : found;
}

bool isAssignment(Bytes bytes, const Block& block, char lineEndByte) {
    int words = 0;
    bool inWord = false;
    for (Offset i = block.open + 1; i < block.close && words <= 2; ++i) {
        if (bytes[i] == ';') {
            i = lineEnd(bytes, i, lineEndByte);
            inWord = false;
        } else if (isBlank(bytes[i])) {
            inWord = false;
        } else {
            words += inWord ? 0 : 1;
            inWord = true;
            if (bytes[i] == '=' && words <= 2) return true;
        }
    }
    return false;
}

bool holdsOnlyRows(Bytes bytes, char lineEndByte) {
    bool any = false;
    for (Offset begin = 0; begin < bytes.size();) {
        const Offset end = lineEnd(bytes, begin, lineEndByte);
        const Bytes line = bytes.sliced(begin, end - begin);
        const auto comment = std::find(line.begin(), line.end(), ';');
        const auto numberLike = [](char c) {
            return isBlank(c) || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' ||
                   c == 'E';
        };
        if (!std::all_of(line.begin(), comment, numberLike)) return false;
        any = any || std::any_of(line.begin(), comment, [](char c) { return c >= '0' && c <= '9'; });
        begin = end + 1;
    }
    return any;
}

Scanner::Scanner(Bytes bytes, char lineEndByte, Offset begin)
    : m_bytes(bytes), m_lineEnd(lineEndByte), m_position(begin) {}

std::optional<Block> Scanner::next() {
    for (skipBetween(); m_position < m_bytes.size(); skipBetween()) {
        const Offset open = findOpen();
        if (open < 0) { // free text
            m_position = std::min(lineEnd(m_bytes, m_position, m_lineEnd) + 1, m_bytes.size());
            continue;
        }
        Block block = blockAt(open);
        findClose(block);
        m_position = block.all.end;
        return block;
    }
    return std::nullopt;
}

void Scanner::skipBetween() {
    while (m_position < m_bytes.size()) {
        const char c = m_bytes[m_position];
        if (c == ';')
            m_position = lineEnd(m_bytes, m_position, m_lineEnd);
        else if (isBlank(c) || c == '}')
            ++m_position;
        else
            return;
    }
}

// The opening brace on the line that begins at the position, or on the next one when this line is a lone
// name.
Offset Scanner::findOpen() const {
    const Bytes rest = m_bytes.sliced(m_position);
    const auto stop = std::find_if(rest.begin(), rest.end(),
                                   [this](char c) { return c == '{' || c == ';' || c == m_lineEnd; });
    const Offset end = m_position + (stop - rest.begin());
    if (stop != rest.end() && *stop == '{') return end;
    if (!isLoneName(rest.first(end - m_position))) return -1;
    Offset next = lineEnd(m_bytes, end, m_lineEnd);
    while (next < m_bytes.size() && isBlank(m_bytes[next]))
        ++next;
    const Offset nextEnd = lineEnd(m_bytes, next, m_lineEnd);
    const Offset open = m_bytes.sliced(next, nextEnd - next).indexOf('{');
    return open >= 0 && isOnlyMarker(m_bytes.sliced(next, open)) ? next + open : -1;
}

Block Scanner::blockAt(Offset open) {
    Block block;
    block.open = open;
    block.all.begin = m_position;
    const Bytes header = m_bytes.sliced(m_position, open - m_position);
    if (const Offset brace = header.lastIndexOf('}'); brace >= 0) block.all.begin += brace + 1;
    while (block.all.begin < open && isBlank(m_bytes[block.all.begin]))
        ++block.all.begin;
    const auto stop = std::find_if(m_bytes.begin() + block.all.begin, m_bytes.begin() + open,
                                   [this](char c) { return c == '(' || c == ';' || c == m_lineEnd; });
    block.name = withoutBlanks(m_bytes, {block.all.begin, stop - m_bytes.begin()});
    if (startsWithWord(m_bytes.sliced(block.name.begin, block.name.size()), "ifs:")) {
        block.hasPrefix = true;
        block.name = withoutBlanks(m_bytes, {block.name.begin + 4, block.name.end});
    }
    block.kind = kindOf(m_bytes.sliced(block.name.begin, block.name.size()));
    return block;
}

void Scanner::findClose(Block& block) {
    for (Offset i = block.open + 1; i < m_bytes.size(); ++i) {
        const char c = m_bytes[i];
        if (c == ';') {
            i = lineEnd(m_bytes, i, m_lineEnd);
        } else if (c == '}') {
            block.close = i;
            block.all.end = endOfEntry(i);
            return;
        } else if (c == '{' && block.kind != BlockKind::CommentBlock) {
            const Offset headerEnd = lineEnd(m_bytes, block.open, m_lineEnd);
            const bool onHeader = i < headerEnd;
            block.kind = onHeader ? BlockKind::TwoBraces : BlockKind::Unclosed;
            block.all.end = onHeader ? std::min(headerEnd + 1, m_bytes.size()) : restart(block, i);
            block.close = block.all.end;
            return;
        }
    }
    block.kind = BlockKind::Unclosed;
    block.close = block.all.end = m_bytes.size();
}

// Where the entry begins whose opening brace was met inside `block`: at the start of that line, or of the
// line above when that is a lone name.
Offset Scanner::restart(const Block& block, Offset secondOpen) const {
    const auto lineBegin = [&](Offset position) {
        while (position > block.open + 1 && m_bytes[position - 1] != m_lineEnd)
            --position;
        return position;
    };
    const Offset begin = lineBegin(secondOpen);
    if (!isOnlyMarker(m_bytes.sliced(begin, secondOpen - begin))) return begin;
    Offset above = begin;
    while (above > block.open + 1 && isBlank(m_bytes[above - 1]))
        --above;
    const Offset aboveBegin = lineBegin(above);
    const Bytes line = m_bytes.sliced(aboveBegin, above - aboveBegin);
    const bool isName =
        aboveBegin > lineEnd(m_bytes, block.open, m_lineEnd) && isLoneName(line) && !line.contains(';');
    return isName ? aboveBegin : begin;
}

Offset Scanner::endOfEntry(Offset close) const {
    Offset end = close + 1;
    while (end < m_bytes.size() && m_bytes[end] != m_lineEnd &&
           (m_bytes[end] == ' ' || m_bytes[end] == '\t' || m_bytes[end] == '\r'))
        ++end;
    if (end == m_bytes.size() || (m_bytes[end] != m_lineEnd && m_bytes[end] != ';'))
        return end == m_bytes.size() ? end : close + 1;
    return std::min(lineEnd(m_bytes, end, m_lineEnd) + 1, m_bytes.size());
}

} // namespace notation
