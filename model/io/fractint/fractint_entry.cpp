// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_entry.h"

#include "document/text/text.h"
#include "io/fractint/fractint_numbers.h"
#include "io/fractint/fractint_rows.h"
#include "io/fractint/metadata_comments.h"
#include "io/text/export_weights.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace io::fractint {

namespace {

using document::Problem;

constexpr std::size_t maxMapsElsewhere = 63;
constexpr qsizetype maxName = 18;
constexpr std::size_t maxNumbers = maxMaps * 13;

struct RawToken {
    Span span;
    int line = 0;
};

std::string_view textOf(QByteArrayView text, Span span) {
    return {text.data() + span.begin, static_cast<std::size_t>(span.size())};
}

class EntryParser {
public:
    EntryParser(QByteArrayView text, const Block& block, char lineEndByte)
        : m_text(text), m_lineEnd(lineEndByte) {
        m_entry.layout.block = block;
    }

    ParsedEntry parse() &&;

private:
    struct TextPosition {
        int line = 1;
        int column = 1;
    };
    struct Reading {
        std::vector<RawToken> tokens;
        RowShape shape;
        bool isValid = true; // every token is a number
        bool decimalComma = false;
        bool usesHeader = false;
        bool isByLines = false;     // rows of a bare file that would fill rows of 7 as well
        double sumOfSevenths = NAN; // of every seventh number, where none of them is negative
    };

    void readName();
    void readHeader();
    void readBody();
    void readSystem();
    void readLine(qsizetype begin, qsizetype end, qsizetype next, int line);
    void readComment(qsizetype begin, qsizetype next, Span comment);
    bool isGlued(qsizetype i, qsizetype begin) const;
    void split(Span span, int line, std::vector<RawToken>& tokens) const;
    std::vector<RawToken> splitAtCommas(const std::vector<RawToken>& tokens) const;
    void readByLines(Reading& reading, std::size_t rowLength) const;
    Reading reading(const std::vector<RawToken>& tokens, bool decimalComma) const;
    Reading withHeader(const std::vector<RawToken>& body, bool decimalComma) const;
    std::optional<Reading> chooseReading();
    void readNumbers(const Reading& chosen);
    void buildSystem();
    template <int Dim> void addMap(ifs::IteratedFunctionSystem<Dim>& system, const Token* row);
    void applyMetadataComments();

    void explainShape();
    void explainTokens(const std::vector<RawToken>& tokens);
    void explain(const RawToken& token, const Number& number);
    void warnAboutReading(const Reading& chosen);
    void warnAboutWeights();
    void report(Problem::Severity severity, qsizetype position, const QString& message);
    void warn(qsizetype position, const QString& message) {
        report(Problem::Severity::Warning, position, message);
    }
    void fail(qsizetype position, const QString& message) {
        report(Problem::Severity::Error, position, message);
    }
    TextPosition textPosition(qsizetype position);

    QByteArrayView m_text;
    char m_lineEnd;
    ParsedEntry m_entry;
    bool m_isMarked3D = false;
    std::vector<RawToken> m_headerTokens; // all of them numbers, or none
    std::vector<RawToken> m_bodyTokens;
    bool m_hasCommas = false;
    qsizetype m_longLine = -1;
    qsizetype m_nul = -1;
    MetadataComments m_metadataComments;
    qsizetype m_suppressed = 0;
    std::vector<qsizetype> m_lineBegins;
};

ParsedEntry EntryParser::parse() && {
    for (qsizetype i = 0; i <= m_text.size() && m_lineBegins.size() <= maxLines;
         i = lineEnd(m_text, i, m_lineEnd) + 1)
        m_lineBegins.push_back(i);
    readName();
    readHeader();
    if (m_lineBegins.size() > maxLines) {
        fail(0, Text::tr("The entry has more than %1 lines, which is the limit; it is kept as text.")
                    .arg(maxLines));
    } else {
        readBody();
        readSystem();
    }
    if (m_suppressed > 0)
        m_entry.problems.append(
            {Problem::Severity::Warning,
             {},
             1,
             1,
             Text::tr("Other problems in this entry, not listed: %1.").arg(m_suppressed)});
    for (Problem& problem : m_entry.problems)
        problem.entry = m_entry.fractal.name;
    return std::move(m_entry);
}

void EntryParser::readSystem() {
    if (m_entry.layout.block.kind == BlockKind::Unclosed) {
        fail(m_entry.layout.block.open, Text::tr("The entry that starts here has no closing “}” before the "
                                                 "next entry or the end of the file."));
    } else if (const auto chosen = chooseReading()) {
        readNumbers(*chosen);
        warnAboutReading(*chosen);
        buildSystem();
        applyMetadataComments();
        warnAboutWeights();
    }
}

void EntryParser::readName() {
    const Block& block = m_entry.layout.block;
    const QByteArrayView name = m_text.sliced(block.name.begin, block.name.size());
    m_entry.fractal.name = block.open < 0 ? QStringLiteral("unnamed") : decoded(name);
    const auto say = [&](const QString& text) { warn(block.name.begin, text.arg(m_entry.fractal.name)); };
    if (name.contains('\0') || name.contains('\x1a'))
        say(Text::tr("The name “%1” contains a control character, at which other programs may end it."));
    else if (std::any_of(name.begin(), name.end(), isBlank))
        say(Text::tr("The name “%1” contains a space; Fractint uses only its first word."));
    else if (name.size() > maxName)
        say(Text::tr("The name “%1” is longer than 18 bytes; Fractint truncates it."));
}

void EntryParser::readHeader() {
    Layout& layout = m_entry.layout;
    const Block& block = layout.block;
    if (block.open < 0) return;
    const qsizetype end = lineEnd(m_text, block.open, m_lineEnd);
    layout.headerEnd = std::min(end, block.close);
    layout.bodyBegin = std::min(end + 1, block.close);
    Span rest{block.open + 1, layout.headerEnd};
    const qsizetype semicolon = m_text.sliced(rest.begin, rest.size()).indexOf(';');
    if (semicolon >= 0) layout.headerSemicolon = rest.begin + semicolon;
    Span text{rest.begin, semicolon >= 0 ? layout.headerSemicolon : rest.end};

    const qsizetype nameLine = lineEnd(m_text, 0, m_lineEnd);
    if (nameLine < block.open)
        warn(0, Text::tr("The opening brace is on a line of its own; Fractint does not find this entry."));
    QByteArray marker = m_text.first(text.end).toByteArray().toLower();
    if (const qsizetype comment = marker.first(block.open).indexOf(';'); comment >= 0)
        marker.remove(comment, std::max<qsizetype>(0, std::min(nameLine, block.open) - comment));
    m_isMarked3D = marker.contains("(3d)");

    std::vector<RawToken> tokens;
    split(text, 0, tokens);
    const bool areNumbers = std::all_of(tokens.begin(), tokens.end(), [&](const RawToken& token) {
        return readNumber(textOf(m_text, token.span)).kind == Number::Kind::Good;
    });
    layout.headerTextEnd = rest.begin;
    if (areNumbers && !tokens.empty()) {
        m_headerTokens = std::move(tokens);
        layout.headerTextEnd = m_headerTokens.back().span.end;
    }
    Span comment;
    if (layout.headerSemicolon >= 0)
        comment = withoutBlanks(m_text, {layout.headerSemicolon + 1, rest.end});
    else if (m_headerTokens.empty())
        comment = withoutSpaceMarker(m_text, text);
    layout.headerComment = comment;
    m_entry.fractal.headerComment = decoded(m_text.sliced(comment.begin, comment.size()));
}

void EntryParser::readBody() {
    const Layout& layout = m_entry.layout;
    int line = static_cast<int>(std::upper_bound(m_lineBegins.begin(), m_lineBegins.end(), layout.bodyBegin) -
                                m_lineBegins.begin()) -
               1;
    for (qsizetype begin = layout.bodyBegin; begin < layout.block.close; ++line) {
        const qsizetype end = std::min(lineEnd(m_text, begin, m_lineEnd), layout.block.close);
        const qsizetype next = std::min(end + 1, layout.block.close);
        readLine(begin, end, next, line);
        begin = std::max(next, begin + 1);
    }
    m_hasCommas = std::any_of(m_bodyTokens.begin(), m_bodyTokens.end(), [this](const RawToken& token) {
        const QByteArrayView text = m_text.sliced(token.span.begin, token.span.size());
        return text.contains(',') || text.contains('\'');
    });
}

void EntryParser::readLine(qsizetype begin, qsizetype end, qsizetype next, int line) {
    const QByteArrayView text = m_text.sliced(begin, end - begin);
    const auto stop = std::find_if(text.begin(), text.end(), [](char c) { return c == ';' || c == '\0'; });
    const qsizetype numbersEnd = begin + (stop - text.begin());
    const bool isComment = stop != text.end() && *stop == ';';
    if (stop != text.end() && *stop == '\0' && m_nul < 0) m_nul = numbersEnd;
    if (numbersEnd - begin > maxLine && m_longLine < 0) m_longLine = begin + maxLine;
    const std::size_t before = m_bodyTokens.size();
    split({begin, numbersEnd}, line, m_bodyTokens);
    if (isComment && m_bodyTokens.size() == before) readComment(begin, next, {numbersEnd + 1, end});
}

void EntryParser::readComment(qsizetype begin, qsizetype next, Span text) {
    while (text.begin < text.end && isBlank(m_text[text.begin]))
        ++text.begin;
    while (text.end > text.begin && isBlank(m_text[text.end - 1]))
        --text.end;
    const QByteArrayView content = m_text.sliced(text.begin, text.size());
    Comment comment{{begin, next}, text, isOwnComment(content), false};
    if (comment.isOwn)
        comment.isUnderstood = m_metadataComments.read(content);
    else
        m_entry.fractal.comments << decoded(content);
    m_entry.layout.comments.push_back(comment);
}

// The editor of Fractint 10–18 could write "-10.00-20.00", which its reader took apart again.
bool EntryParser::isGlued(qsizetype i, qsizetype begin) const {
    return m_entry.layout.block.open < 0 && i > begin && (m_text[i] == '-' || m_text[i] == '+') &&
           isNumberEnd(m_text[i - 1]);
}

void EntryParser::split(Span span, int line, std::vector<RawToken>& tokens) const {
    for (qsizetype i = span.begin; i < span.end && tokens.size() <= maxNumbers;) {
        while (i < span.end && isBlank(m_text[i]))
            ++i;
        const qsizetype begin = i;
        while (i < span.end && !isBlank(m_text[i]) && !isGlued(i, begin))
            ++i;
        if (i > begin) tokens.push_back({{begin, i}, line});
    }
}

std::vector<RawToken> EntryParser::splitAtCommas(const std::vector<RawToken>& tokens) const {
    std::vector<RawToken> parts;
    for (const RawToken& token : tokens) {
        qsizetype begin = token.span.begin;
        for (qsizetype i = begin; i <= token.span.end && parts.size() <= maxNumbers; ++i) {
            if (i < token.span.end && m_text[i] != ',' && m_text[i] != '\'') continue;
            if (i > begin) parts.push_back({{begin, i}, token.line});
            begin = i + 1;
        }
    }
    return parts;
}

EntryParser::Reading EntryParser::reading(const std::vector<RawToken>& tokens, bool decimalComma) const {
    Reading result;
    result.tokens = m_hasCommas && !decimalComma ? splitAtCommas(tokens) : tokens;
    result.decimalComma = decimalComma;
    std::vector<std::size_t> perLine;
    int line = -1;
    for (const RawToken& token : result.tokens) {
        if (token.line != line) perLine.push_back(0);
        line = token.line;
        ++perLine.back();
        result.isValid = result.isValid && !std::isnan(valueOf(textOf(m_text, token.span), decimalComma));
    }
    result.shape = rowShape(perLine, m_isMarked3D);
    if (result.shape.isLineLengthOdd && result.isValid && m_entry.layout.block.open < 0)
        readByLines(result, perLine.front());
    return result;
}

// In a file of nothing but rows the lines say where a map ends, although Fractint does not look at them.
void EntryParser::readByLines(Reading& reading, std::size_t rowLength) const {
    reading.shape = {static_cast<int>(rowLength), rowLength > 7, false};
    reading.isByLines = true;
    double sum = 0;
    for (std::size_t i = 6; i < reading.tokens.size(); i += 7) {
        const double weight = valueOf(textOf(m_text, reading.tokens[i].span), reading.decimalComma);
        sum += weight >= 0 ? weight : NAN;
    }
    reading.sumOfSevenths = sum;
}

// The body alone where it fills rows, as every reader has it; else together with the numbers on the header
// line.
EntryParser::Reading EntryParser::withHeader(const std::vector<RawToken>& body, bool decimalComma) const {
    Reading alone = reading(body, decimalComma);
    if (alone.shape.rowLength != 0 || m_headerTokens.empty()) return alone;
    std::vector<RawToken> all = m_headerTokens;
    all.insert(all.end(), body.begin(), body.end());
    Reading together = reading(all, decimalComma);
    together.usesHeader = true;
    return together.shape.rowLength != 0 ? together : alone;
}

std::optional<EntryParser::Reading> EntryParser::chooseReading() {
    const auto tooMany = [&](const std::vector<RawToken>& tokens) {
        if (tokens.size() <= maxNumbers) return false;
        fail(tokens.back().span.begin,
             Text::tr("The entry has more than %1 maps, which is the limit.").arg(maxMaps));
        return true;
    };
    if (tooMany(m_bodyTokens)) return std::nullopt;
    Reading separated = withHeader(m_bodyTokens, false);
    if (tooMany(separated.tokens)) return std::nullopt;
    const bool separatedFits = separated.isValid && separated.shape.rowLength != 0;
    if (!m_hasCommas) {
        if (separatedFits) return separated;
        if (!separated.isValid)
            explainTokens(separated.tokens);
        else
            explainShape();
        return std::nullopt;
    }
    Reading decimal = withHeader(m_bodyTokens, true);
    const bool decimalFits = decimal.isValid && decimal.shape.rowLength != 0;
    if (separatedFits != decimalFits) return separatedFits ? separated : decimal;
    const auto comma = std::find_if(m_bodyTokens.begin(), m_bodyTokens.end(), [this](const RawToken& token) {
        return m_text.sliced(token.span.begin, token.span.size()).contains(',');
    });
    const auto& first = comma == m_bodyTokens.end() ? m_bodyTokens.front() : *comma;
    const QString token =
        decoded(m_text.sliced(first.span.begin, std::min<qsizetype>(first.span.size(), 40)));
    if (separatedFits)
        fail(first.span.begin, Text::tr("“%1”: the comma can be a decimal comma or a separator; both "
                                        "readings give complete rows. Use decimal points and spaces.")
                                   .arg(token));
    else if (separated.isValid || decimal.isValid)
        fail(first.span.begin, Text::tr("“%1”: the comma gives complete rows of 7 numbers (13 with “(3D)”) "
                                        "neither as a decimal comma nor as a separator.")
                                   .arg(token));
    else
        explainTokens(separated.tokens);
    return std::nullopt;
}

void EntryParser::readNumbers(const Reading& chosen) {
    Layout& layout = m_entry.layout;
    layout.rowLength = chosen.shape.rowLength;
    layout.decimalComma = chosen.decimalComma;
    layout.numbers.reserve(chosen.tokens.size());
    for (const RawToken& token : chosen.tokens)
        layout.numbers.push_back(
            {token.span, valueOf(textOf(m_text, token.span), chosen.decimalComma), token.line});
    if (!chosen.usesHeader && !m_headerTokens.empty()) {
        warn(m_headerTokens.front().span.begin,
             Text::tr("Numbers on the line of the opening brace are ignored, as in Fractint."));
        layout.headerTextEnd = layout.block.open + 1;
        if (layout.headerSemicolon < 0) {
            layout.headerComment = {m_headerTokens.front().span.begin, m_headerTokens.back().span.end};
            m_entry.fractal.headerComment =
                decoded(m_text.sliced(layout.headerComment.begin, layout.headerComment.size()));
        }
    }
}

template <int Dim> void EntryParser::addMap(ifs::IteratedFunctionSystem<Dim>& system, const Token* row) {
    ifs::WeightedMap<Dim> map;
    map.id = static_cast<ifs::MapId>(system.maps.size() + 1);
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            map.map.linear(i, j) = row[i * Dim + j].value;
    for (int i = 0; i < Dim; ++i)
        map.map.translation[i] = row[Dim * Dim + i].value;
    if (m_entry.layout.rowLength % 2 == 1) map.weight = row[Dim * Dim + Dim].value;
    system.maps.push_back(map);
}

void EntryParser::buildSystem() {
    const Layout& layout = m_entry.layout;
    document::System2 plane;
    document::System3 space;
    const auto rowLength = static_cast<std::size_t>(layout.rowLength);
    if (rowLength < 12) plane.maps.reserve(layout.numbers.size() / rowLength);
    for (std::size_t i = 0; i + rowLength <= layout.numbers.size(); i += rowLength) {
        if (rowLength < 12)
            addMap(plane, &layout.numbers[i]);
        else
            addMap(space, &layout.numbers[i]);
    }
    if (std::max(plane.maps.size(), space.maps.size()) > maxMaps)
        fail(0, Text::tr("The entry has more than %1 maps, which is the limit.").arg(maxMaps));
    else if (rowLength < 12)
        m_entry.fractal.shape = document::Shape<2>{std::move(plane)};
    else
        m_entry.fractal.shape = document::Shape<3>{std::move(space)};
}

void EntryParser::applyMetadataComments() {
    const MetadataComments::Outcome outcome = m_metadataComments.applyTo(m_entry.fractal);
    std::vector<Comment*> own;
    for (Comment& comment : m_entry.layout.comments)
        if (comment.isOwn) own.push_back(&comment);
    for (const QString& sentence : outcome.sentences)
        warn(own.front()->line.begin, sentence);
    for (const Comment* comment : own)
        if (!comment->isUnderstood)
            warn(comment->line.begin,
                 Text::tr("This version of Barycage does not understand “%1”; the line is kept.")
                     .arg(decoded(
                         m_text.sliced(comment->text.begin, std::min<qsizetype>(comment->text.size(), 69)))));
    for (const std::size_t kept : outcome.kept)
        own[kept]->isUnderstood = false;
}

void EntryParser::explainShape() {
    const int wanted = m_isMarked3D ? 13 : 7;
    if (m_bodyTokens.empty() && m_headerTokens.empty()) {
        fail(m_entry.layout.block.open < 0 ? 0 : m_entry.layout.block.open,
             Text::tr("The entry contains no numbers."));
        return;
    }
    const auto& tokens = m_bodyTokens.empty() ? m_headerTokens : m_bodyTokens;
    // The first line whose numbers are not whole rows is where the user should look.
    const RawToken* odd = &tokens.front();
    std::size_t oddCount = 0;
    for (std::size_t i = 0; i < tokens.size() && oddCount == 0;) {
        std::size_t end = i;
        while (end < tokens.size() && tokens[end].line == tokens[i].line)
            ++end;
        if ((end - i) % static_cast<std::size_t>(wanted) != 0) {
            odd = &tokens[i];
            oddCount = end - i;
        }
        i = end;
    }
    fail(odd->span.begin, Text::tr("Numbers are missing or left over: this line has %1, the entry has %2, "
                                   "and each map has %3%4.")
                              .arg(oddCount)
                              .arg(tokens.size())
                              .arg(wanted)
                              .arg(m_isMarked3D ? Text::tr(" in an entry marked “(3D)”") : QString()));
}

void EntryParser::explainTokens(const std::vector<RawToken>& tokens) {
    for (const RawToken& token : tokens) {
        const Number number = readNumber(textOf(m_text, token.span));
        if (number.kind != Number::Kind::Good) explain(token, number);
    }
}

void EntryParser::explain(const RawToken& token, const Number& number) {
    const QByteArrayView bytes = m_text.sliced(token.span.begin, std::min<qsizetype>(token.span.size(), 40));
    const QString text = decoded(bytes);
    switch (number.kind) {
    case Number::Kind::Trailing:
        return fail(
            token.span.begin,
            Text::tr("“%1” is not a plain number: Fractint reads %2 and ignores the rest. Write it as "
                     "one decimal number.")
                .arg(text, QString::number(number.value)));
    case Number::Kind::NotFinite:
        return fail(token.span.begin, Text::tr("“%1” is not a finite number.").arg(text));
    case Number::Kind::Huge:
        return fail(token.span.begin,
                    Text::tr("“%1” is too large for a coefficient (the largest absolute value is 3.4e38).")
                        .arg(text));
    case Number::Kind::NotANumber:
    case Number::Kind::Good:
        break;
    }
    if (bytes.startsWith("\xe2\x88\x92"))
        return fail(
            token.span.begin,
            Text::tr("“%1” begins with a typographic minus sign (U+2212). Use a plain “-”.").arg(text));
    fail(token.span.begin, Text::tr("“%1” is not a number.").arg(text));
}

void EntryParser::warnAboutReading(const Reading& chosen) {
    const Layout& layout = m_entry.layout;
    const qsizetype first = layout.numbers.front().span.begin;
    if (chosen.usesHeader)
        warn(first, Text::tr("There are numbers on the line of the opening brace, where Fractint ignores "
                             "them; Barycage reads them."));
    if (m_hasCommas)
        warn(first,
             chosen.decimalComma
                 ? Text::tr("Commas are read as decimal points; Fractint reads different numbers here.")
                 : Text::tr("Commas or apostrophes separate the numbers; Iterated Dynamics cannot read this "
                            "entry."));
    if (layout.rowLength == 6 || layout.rowLength == 12)
        warn(first, Text::tr("The maps have no weights (%1 numbers each), so the weights are computed from "
                             "the determinants. Fractint cannot read this entry.")
                        .arg(layout.rowLength));
    if (chosen.shape.isMarkMissing)
        warn(first,
             Text::tr(
                 "Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot "
                 "read this entry.")
                 .arg(layout.rowLength));
    if (chosen.isByLines) {
        constexpr double tolerance = 0.02; // weights are often given to two digits
        const std::size_t lines = layout.numbers.size() / static_cast<std::size_t>(layout.rowLength);
        const std::size_t sevens = layout.numbers.size() / 7;
        warn(first,
             std::abs(chosen.sumOfSevenths - 1) <= tolerance
                 ? Text::tr(
                       "The numbers can be read as %1 maps of %2 numbers, line by line, or as %3 maps of 7 "
                       "numbers, whose weights then sum to 1. They are read line by line, unlike in "
                       "Fractint; for the other reading, put 7 numbers on each line.")
                       .arg(lines)
                       .arg(layout.rowLength)
                       .arg(sevens)
                 : Text::tr(
                       "The numbers are read line by line, as %1 maps of %2 numbers. Fractint ignores line "
                       "ends and reads %3 maps of 7 numbers.")
                       .arg(lines)
                       .arg(layout.rowLength)
                       .arg(sevens));
    }
    if (chosen.shape.isLineLengthOdd)
        warn(first, Text::tr("The lines do not have 7 numbers each, but together the numbers fill rows of 7 "
                             "and are read that way, as in Fractint. The weights are probably missing."));
    if (layout.block.open >= 0 && layout.block.close > 0 && !isBlank(m_text[layout.block.close - 1]) &&
        layout.numbers.back().span.end == layout.block.close)
        warn(layout.block.close,
             Text::tr("The closing brace touches the last number; Fractint cannot read this entry."));
    if (m_longLine >= 0)
        warn(m_longLine, Text::tr("The line is longer than 200 bytes; Fractint truncates it."));
    if (m_nul >= 0)
        warn(m_nul, Text::tr("There is a NUL byte here; the rest of the line is ignored, as in Fractint."));
    if (const std::size_t maps = layout.numbers.size() / static_cast<std::size_t>(layout.rowLength);
        maps > maxMapsElsewhere)
        warn(0, Text::tr("The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.").arg(maps));
}

void EntryParser::warnAboutWeights() {
    const Layout& layout = m_entry.layout;
    const auto rowLength = static_cast<std::size_t>(layout.rowLength);
    if (rowLength % 2 == 0) return;
    const auto check = [&](const auto& maps) {
        double sum = 0;
        bool isNone = true; // above 0: then there are no proportions
        for (std::size_t i = 0; i < maps.size(); ++i) {
            const Token& token = layout.numbers[i * rowLength + rowLength - 1];
            sum += token.value;
            isNone = isNone && !(token.value > 0);
            if (!maps[i].enabled || !maps[i].weight) continue;
            if (const auto remark = weightRemark(i + 1, token.value)) warn(token.span.begin, *remark);
        }
        const bool allOn = std::all_of(maps.begin(), maps.end(), [](const auto& map) { return map.enabled; });
        if (!isNone && allOn && !(std::abs(sum - 1) <= 0.02))
            report(Problem::Severity::Remark, layout.numbers[rowLength - 1].span.begin,
                   Text::tr("The weights sum to %1, not 1. They are scaled in proportion; Fractint gives any "
                            "shortfall to the last map and cuts off any excess.")
                       .arg(sum));
    };
    if (const auto* plane = document::system2(m_entry.fractal))
        check(plane->maps);
    else if (const auto* space = document::system3(m_entry.fractal))
        check(space->maps);
}

void EntryParser::report(Problem::Severity severity, qsizetype position, const QString& message) {
    if (m_entry.problems.size() >= maxProblems) {
        ++m_suppressed;
        return;
    }
    const TextPosition at = textPosition(position);
    m_entry.problems.append({severity, {}, at.line, at.column, message});
}

EntryParser::TextPosition EntryParser::textPosition(qsizetype position) {
    const auto after = std::upper_bound(m_lineBegins.begin(), m_lineBegins.end(), position);
    return {static_cast<int>(after - m_lineBegins.begin()), static_cast<int>(position - *(after - 1)) + 1};
}

} // namespace

ParsedEntry parseEntry(QByteArrayView text, const Block& block, char lineEndByte) {
    return EntryParser(text, block, lineEndByte).parse();
}

QString decoded(QByteArrayView bytes) {
    return bytes.isValidUtf8() ? QString::fromUtf8(bytes) : QString::fromLatin1(bytes);
}

} // namespace io::fractint
