// SPDX-License-Identifier: MIT
#include "notation/rows/row_reader.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace notation {

namespace {

constexpr std::size_t maxNumbers = maxMaps * 13;

class RowReader {
public:
    RowReader(Bytes text, const Block& block, char lineEndByte)
        : m_text(text), m_block(block), m_lineEnd(lineEndByte) {}

    Rows read() &&;

private:
    void readHeader();
    void readMarker(Offset textEnd);
    void readBody();
    void readLine(Offset begin, Offset end, Offset next, int line);
    bool isGlued(Offset i, Offset begin) const;
    void split(Span span, int line, std::vector<RowToken>& tokens) const;
    std::vector<RowToken> splitAtCommas(const std::vector<RowToken>& tokens) const;
    void readByLines(RowReading& reading, std::size_t rowLength) const;
    RowReading reading(const std::vector<RowToken>& tokens, bool decimalComma) const;
    RowReading withHeader(bool decimalComma) const;
    bool isTooMuch(const std::vector<RowToken>& tokens);
    void choose();
    void chooseAmongCommas(RowReading separated);
    void refuse(RowFlaw flaw, const RowToken& at);
    void ignoreHeader();

    Bytes m_text;
    const Block& m_block;
    char m_lineEnd;
    Rows m_rows;
};

Rows RowReader::read() && {
    for (Offset i = 0; i <= m_text.size() && m_rows.lineBegins.size() <= maxLines;
         i = lineEnd(m_text, i, m_lineEnd) + 1)
        m_rows.lineBegins.push_back(i);
    readHeader();
    if (m_rows.lineBegins.size() > maxLines) {
        m_rows.flaw = RowFlaw::TooManyLines;
        return std::move(m_rows);
    }
    readBody();
    if (m_block.kind == BlockKind::Unclosed)
        m_rows.flaw = RowFlaw::Unclosed;
    else
        choose();
    if (m_rows.ignoresHeader()) ignoreHeader();
    return std::move(m_rows);
}

void RowReader::readHeader() {
    if (m_block.open < 0) return;
    const Offset end = lineEnd(m_text, m_block.open, m_lineEnd);
    m_rows.headerEnd = std::min(end, m_block.close);
    m_rows.bodyBegin = std::min(end + 1, m_block.close);
    const Span rest{m_block.open + 1, m_rows.headerEnd};
    const Offset semicolon = textOf(m_text, rest).indexOf(';');
    if (semicolon >= 0) m_rows.headerSemicolon = rest.begin + semicolon;
    const Span text{rest.begin, semicolon >= 0 ? m_rows.headerSemicolon : rest.end};
    readMarker(text.end);

    std::vector<RowToken> tokens;
    split(text, 0, tokens);
    const bool areNumbers = std::ranges::all_of(tokens, [&](const RowToken& token) {
        return readNumber(textOf(m_text, token.span).view()).kind == Number::Kind::Good;
    });
    m_rows.headerTextEnd = rest.begin;
    if (areNumbers && !tokens.empty()) {
        m_rows.headerTokens = std::move(tokens);
        m_rows.headerTextEnd = m_rows.headerTokens.back().span.end;
    }
    if (m_rows.headerSemicolon >= 0)
        m_rows.headerComment = withoutBlanks(m_text, {m_rows.headerSemicolon + 1, rest.end});
    else if (m_rows.headerTokens.empty())
        m_rows.headerComment = withoutSpaceMarker(m_text, text);
}

void RowReader::readMarker(Offset textEnd) {
    const Offset nameLine = lineEnd(m_text, 0, m_lineEnd);
    m_rows.isBraceBelow = nameLine < m_block.open;
    std::string marker = lowered(m_text.first(textEnd));
    if (const Offset comment = m_text.first(m_block.open).indexOf(';'); comment >= 0)
        marker.erase(std::size_t(comment),
                     std::size_t(std::max<Offset>(0, std::min(nameLine, m_block.open) - comment)));
    m_rows.isMarked3D = marker.find("(3d)") != std::string::npos;
}

void RowReader::readBody() {
    const auto& begins = m_rows.lineBegins;
    int line = int(std::ranges::upper_bound(begins, m_rows.bodyBegin) - begins.begin()) - 1;
    for (Offset begin = m_rows.bodyBegin; begin < m_block.close; ++line) {
        const Offset end = std::min(lineEnd(m_text, begin, m_lineEnd), m_block.close);
        const Offset next = std::min(end + 1, m_block.close);
        readLine(begin, end, next, line);
        begin = std::max(next, begin + 1);
    }
    m_rows.hasCommas = std::ranges::any_of(m_rows.bodyTokens, [this](const RowToken& token) {
        const Bytes text = textOf(m_text, token.span);
        return text.contains(',') || text.contains('\'');
    });
}

void RowReader::readLine(Offset begin, Offset end, Offset next, int line) {
    const Bytes text = m_text.sliced(begin, end - begin);
    const auto stop = std::ranges::find_if(text, [](char c) { return c == ';' || c == '\0'; });
    const Offset numbersEnd = begin + (stop - text.begin());
    const bool isComment = stop != text.end() && *stop == ';';
    if (stop != text.end() && *stop == '\0' && m_rows.nul < 0) m_rows.nul = numbersEnd;
    if (numbersEnd - begin > maxLine && m_rows.longLine < 0) m_rows.longLine = begin + maxLine;
    const std::size_t before = m_rows.bodyTokens.size();
    split({begin, numbersEnd}, line, m_rows.bodyTokens);
    if (isComment && m_rows.bodyTokens.size() == before)
        m_rows.comments.push_back({{begin, next}, withoutBlanks(m_text, {numbersEnd + 1, end})});
}

// The editor of Fractint 10–18 could write "-10.00-20.00", which its reader took apart again.
bool RowReader::isGlued(Offset i, Offset begin) const {
    return m_block.open < 0 && i > begin && (m_text[i] == '-' || m_text[i] == '+') &&
           isNumberEnd(m_text[i - 1]);
}

void RowReader::split(Span span, int line, std::vector<RowToken>& tokens) const {
    for (Offset i = span.begin; i < span.end && tokens.size() <= maxNumbers;) {
        while (i < span.end && isBlank(m_text[i]))
            ++i;
        const Offset begin = i;
        while (i < span.end && !isBlank(m_text[i]) && !isGlued(i, begin))
            ++i;
        if (i > begin) tokens.push_back({{begin, i}, line});
    }
}

std::vector<RowToken> RowReader::splitAtCommas(const std::vector<RowToken>& tokens) const {
    std::vector<RowToken> parts;
    for (const RowToken& token : tokens) {
        Offset begin = token.span.begin;
        for (Offset i = begin; i <= token.span.end && parts.size() <= maxNumbers; ++i) {
            if (i < token.span.end && m_text[i] != ',' && m_text[i] != '\'') continue;
            if (i > begin) parts.push_back({{begin, i}, token.line});
            begin = i + 1;
        }
    }
    return parts;
}

RowReading RowReader::reading(const std::vector<RowToken>& tokens, bool decimalComma) const {
    RowReading result;
    result.tokens = m_rows.hasCommas && !decimalComma ? splitAtCommas(tokens) : tokens;
    result.decimalComma = decimalComma;
    std::vector<std::size_t> perLine;
    int line = -1;
    for (const RowToken& token : result.tokens) {
        if (token.line != line) perLine.push_back(0);
        line = token.line;
        ++perLine.back();
        result.isValid =
            result.isValid && !std::isnan(valueOf(textOf(m_text, token.span).view(), decimalComma));
    }
    result.shape = rowShape(perLine, m_rows.isMarked3D);
    if (result.shape.isLineLengthOdd && result.isValid && m_block.open < 0)
        readByLines(result, perLine.front());
    return result;
}

// In a file of nothing but rows the lines say where a map ends, although Fractint does not look at them.
void RowReader::readByLines(RowReading& reading, std::size_t rowLength) const {
    reading.shape = {int(rowLength), rowLength > 7, false};
    reading.isByLines = true;
    double sum = 0;
    for (std::size_t i = 6; i < reading.tokens.size(); i += 7) {
        const double weight = valueOf(textOf(m_text, reading.tokens[i].span).view(), reading.decimalComma);
        sum += weight >= 0 ? weight : NAN;
    }
    reading.sumOfSevenths = sum;
}

// The body alone where it fills rows, as every reader has it; else together with the numbers on the header
// line.
RowReading RowReader::withHeader(bool decimalComma) const {
    RowReading alone = reading(m_rows.bodyTokens, decimalComma);
    if (alone.shape.rowLength != 0 || m_rows.headerTokens.empty()) return alone;
    std::vector<RowToken> all = m_rows.headerTokens;
    all.insert(all.end(), m_rows.bodyTokens.begin(), m_rows.bodyTokens.end());
    RowReading together = reading(all, decimalComma);
    together.usesHeader = true;
    return together.shape.rowLength != 0 ? together : alone;
}

void RowReader::refuse(RowFlaw flaw, const RowToken& at) {
    m_rows.flaw = flaw;
    m_rows.flawAt = at;
}

bool RowReader::isTooMuch(const std::vector<RowToken>& tokens) {
    if (tokens.size() <= maxNumbers) return false;
    refuse(RowFlaw::TooManyMaps, tokens.back());
    return true;
}

void RowReader::choose() {
    if (isTooMuch(m_rows.bodyTokens)) return;
    RowReading separated = withHeader(false);
    if (isTooMuch(separated.tokens)) return;
    if (m_rows.hasCommas) {
        chooseAmongCommas(std::move(separated));
    } else if (!separated.isValid) {
        m_rows.flaw = RowFlaw::NotNumbers;
        m_rows.refused = std::move(separated.tokens);
    } else if (separated.shape.rowLength == 0) {
        m_rows.flaw = RowFlaw::NotRows;
    } else {
        m_rows.chosen = std::move(separated);
    }
    if (m_rows.chosen &&
        m_rows.chosen->tokens.size() / std::size_t(m_rows.chosen->shape.rowLength) > maxMaps) {
        m_rows.chosen.reset();
        refuse(RowFlaw::TooManyMaps, {});
    }
}

void RowReader::chooseAmongCommas(RowReading separated) {
    const bool separatedFits = separated.isValid && separated.shape.rowLength != 0;
    RowReading decimal = withHeader(true);
    const bool decimalFits = decimal.isValid && decimal.shape.rowLength != 0;
    if (separatedFits != decimalFits) {
        m_rows.chosen = std::move(separatedFits ? separated : decimal);
        return;
    }
    const auto comma = std::ranges::find_if(m_rows.bodyTokens, [this](const RowToken& token) {
        return textOf(m_text, token.span).contains(',');
    });
    const RowToken first = comma == m_rows.bodyTokens.end() ? m_rows.bodyTokens.front() : *comma;
    if (separatedFits) return refuse(RowFlaw::CommaOfTwoKinds, first);
    if (separated.isValid || decimal.isValid) return refuse(RowFlaw::CommaOfNoKind, first);
    m_rows.flaw = RowFlaw::NotNumbers;
    m_rows.refused = std::move(separated.tokens);
}

void RowReader::ignoreHeader() {
    m_rows.headerTextEnd = m_block.open + 1;
    if (m_rows.headerSemicolon < 0)
        m_rows.headerComment = {m_rows.headerTokens.front().span.begin, m_rows.headerTokens.back().span.end};
}

} // namespace

Rows readRows(Bytes text, const Block& block, char lineEndByte) {
    return RowReader(text, block, lineEndByte).read();
}

} // namespace notation
