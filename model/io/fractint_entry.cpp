// SPDX-License-Identifier: MIT
#include "io/fractint_entry.h"

#include "io/coefficient.h"
#include "io/number.h"
#include "io/own_comments.h"
#include "io/written_weights.h"

#include <QCoreApplication>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <string>

namespace io::fractint {

namespace {

using document::Problem;

constexpr qsizetype longestLine = 200; // what Fractint and Iterated Dynamics read of a line
constexpr std::size_t mostMapsElsewhere = 63;
constexpr qsizetype longestName = 18;
constexpr std::size_t maxNumbers = maxMaps * 13;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

struct RawToken {
    Span span;
    int line = 0;
};

struct Number {
    enum class Kind { Good, Trailing, NotFinite, Huge, NotANumber };
    Kind kind = Kind::NotANumber;
    double value = 0; // Trailing: what C reads of it
};

bool isNumberEnd(char c) {
    return (c >= '0' && c <= '9') || c == '.';
}

Number parse(std::string text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
    const char* first = text.data() + (plus ? 1 : 0);
    const char* last = text.data() + text.size();
    double value = 0;
    const auto [end, error] = fromChars(first, last, value);
    if (error == std::errc::invalid_argument) return {};
    if (error == std::errc::result_out_of_range) return {Number::Kind::Huge, 0};
    if (!std::isfinite(value)) return {Number::Kind::NotFinite, 0};
    if (text.find_first_of("xX") != std::string::npos)
        return {}; // hexadecimal for some readers, 0 for others
    if (end != last || !isNumberEnd(last[-1])) return {Number::Kind::Trailing, value};
    if (!isCoefficient(value)) return {Number::Kind::Huge, value};
    return {Number::Kind::Good, value};
}

std::string copyOf(QByteArrayView text, Span span) {
    return std::string(text.data() + span.begin, static_cast<std::size_t>(span.size()));
}

// How many numbers make a row, from the numbers per line; 0 when they fill no rows.
struct Shape {
    int rowLength = 0;
    bool isMarkMissing = false;   // three-dimensional without (3D)
    bool isLineLengthOdd = false; // rows of 7 that disagree with the lines: each line has 6, or 13
};

bool allMultiplesOf(const std::vector<std::size_t>& perLine, std::size_t n) {
    return std::all_of(perLine.begin(), perLine.end(), [n](std::size_t count) { return count % n == 0; });
}

bool allEqual(const std::vector<std::size_t>& perLine, std::size_t n) {
    return std::all_of(perLine.begin(), perLine.end(), [n](std::size_t count) { return count == n; });
}

Shape shapeOf(const std::vector<std::size_t>& perLine, bool isMarked3D) {
    const std::size_t count = std::accumulate(perLine.begin(), perLine.end(), std::size_t(0));
    if (count == 0) return {};
    if (isMarked3D) {
        if (count % 13 == 0) return {13, false, false};
        return {allMultiplesOf(perLine, 12) ? 12 : 0, false, false};
    }
    if (count % 7 == 0) return {7, false, allEqual(perLine, 6) || allEqual(perLine, 13)};
    if (allMultiplesOf(perLine, 13)) return {13, true, false};
    if (allEqual(perLine, 12)) return {12, true, false};
    return {allMultiplesOf(perLine, 6) ? 6 : 0, false, false};
}

class EntryParser {
public:
    EntryParser(QByteArrayView text, const Block& block, char lineEndByte)
        : m_text(text), m_lineEnd(lineEndByte) {
        m_entry.layout.block = block;
    }

    ParsedEntry parse() &&;

private:
    struct Place {
        int line = 1;
        int column = 1;
    };
    struct Reading {
        std::vector<RawToken> tokens;
        Shape shape;
        bool isValid = true; // every token is a number
        bool decimalComma = false;
        bool usesHeader = false;
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
    Reading reading(const std::vector<RawToken>& tokens, bool decimalComma) const;
    Reading withHeader(const std::vector<RawToken>& body, bool decimalComma) const;
    std::optional<Reading> chooseReading();
    double valueOf(const RawToken& token, bool decimalComma) const;
    void readNumbers(const Reading& chosen);
    void buildSystem();
    template <int Dim> void addMap(ifs::IteratedFunctionSystem<Dim>& system, const Token* row);
    void applyOwnComments();

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
    Place placeOf(qsizetype position);

    QByteArrayView m_text;
    char m_lineEnd;
    ParsedEntry m_entry;
    bool m_isMarked3D = false;
    std::vector<RawToken> m_headerTokens; // all of them numbers, or none
    std::vector<RawToken> m_bodyTokens;
    bool m_hasCommas = false;
    qsizetype m_longLine = -1;
    qsizetype m_nul = -1;
    OwnComments m_ownComments;
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
             Text::tr("%1 more problems in this entry are not listed.").arg(m_suppressed)});
    for (Problem& problem : m_entry.problems)
        problem.entry = m_entry.fractal.name;
    return std::move(m_entry);
}

void EntryParser::readSystem() {
    if (m_entry.layout.block.kind == BlockKind::Unclosed) {
        fail(m_entry.layout.block.open,
             Text::tr("The entry that opens here is not closed by “}” before the next "
                      "entry or the end of the file."));
    } else if (const auto chosen = chooseReading()) {
        readNumbers(*chosen);
        warnAboutReading(*chosen);
        buildSystem();
        applyOwnComments();
        warnAboutWeights();
    }
}

void EntryParser::readName() {
    const Block& block = m_entry.layout.block;
    const QByteArrayView name = m_text.sliced(block.name.begin, block.name.size());
    m_entry.fractal.name = block.open < 0 ? QStringLiteral("unnamed") : decoded(name);
    if (std::any_of(name.begin(), name.end(), isBlank))
        warn(block.name.begin, Text::tr("The name “%1” holds a blank; Fractint takes only its first word.")
                                   .arg(m_entry.fractal.name));
    else if (name.size() > longestName)
        warn(block.name.begin, Text::tr("The name “%1” is longer than 18 bytes; Fractint cuts it there.")
                                   .arg(m_entry.fractal.name));
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
        warn(0,
             Text::tr("The opening brace stands on a line of its own; Fractint does not find this entry."));
    QByteArray marker = m_text.first(text.end).toByteArray().toLower();
    if (const qsizetype comment = marker.first(block.open).indexOf(';'); comment >= 0)
        marker.remove(comment, std::max<qsizetype>(0, std::min(nameLine, block.open) - comment));
    m_isMarked3D = marker.contains("(3d)");

    std::vector<RawToken> tokens;
    split(text, 0, tokens);
    const bool areNumbers = std::all_of(tokens.begin(), tokens.end(), [&](const RawToken& token) {
        return fractint::parse(copyOf(m_text, token.span)).kind == Number::Kind::Good;
    });
    layout.headerTextEnd = rest.begin;
    if (areNumbers && !tokens.empty()) {
        m_headerTokens = std::move(tokens);
        layout.headerTextEnd = m_headerTokens.back().span.end;
    }
    const bool isComment = layout.headerSemicolon >= 0;
    Span comment = isComment                ? Span{layout.headerSemicolon + 1, rest.end}
                   : m_headerTokens.empty() ? text
                                            : Span{};
    while (comment.begin < comment.end && isBlank(m_text[comment.begin]))
        ++comment.begin;
    while (comment.end > comment.begin && isBlank(m_text[comment.end - 1]))
        --comment.end;
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
    if (numbersEnd - begin > longestLine && m_longLine < 0) m_longLine = begin + longestLine;
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
        comment.isUnderstood = m_ownComments.read(content);
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

// nan for a token that is no number in this reading.
double EntryParser::valueOf(const RawToken& token, bool decimalComma) const {
    std::string text = copyOf(m_text, token.span);
    if (decimalComma) {
        const auto comma = text.find(',');
        if (comma != std::string::npos) {
            const bool isBetweenDigits =
                comma + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[comma + 1])) != 0;
            if (!isBetweenDigits || text.find('.') != std::string::npos) return std::nan("");
            text[comma] = '.';
        }
    }
    const Number number = fractint::parse(std::move(text));
    return number.kind == Number::Kind::Good ? number.value : std::nan("");
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
        result.isValid = result.isValid && !std::isnan(valueOf(token, decimalComma));
    }
    result.shape = shapeOf(perLine, m_isMarked3D);
    return result;
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
        fail(first.span.begin,
             Text::tr("“%1”: the comma can be read as a decimal point or between two numbers, and both "
                      "give whole rows. Write decimal points and blanks.")
                 .arg(token));
    else if (separated.isValid || decimal.isValid)
        fail(first.span.begin,
             Text::tr("“%1”: neither as a decimal point nor between two numbers does the comma give "
                      "whole rows of 7 numbers (13 with “(3D)”).")
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
        layout.numbers.push_back({token.span, valueOf(token, chosen.decimalComma), token.line});
    if (!chosen.usesHeader && !m_headerTokens.empty()) {
        warn(m_headerTokens.front().span.begin,
             Text::tr("The numbers on the line of the opening brace are ignored, as Fractint ignores them."));
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
        m_entry.fractal.system = std::move(plane);
    else
        m_entry.fractal.system = std::move(space);
}

void EntryParser::applyOwnComments() {
    const QStringList sentences = m_ownComments.applyTo(m_entry.fractal);
    const auto first = std::find_if(m_entry.layout.comments.begin(), m_entry.layout.comments.end(),
                                    [](const Comment& comment) { return comment.isOwn; });
    for (const QString& sentence : sentences)
        warn(first->line.begin, sentence);
    for (const Comment& comment : m_entry.layout.comments)
        if (comment.isOwn && !comment.isUnderstood)
            warn(comment.line.begin,
                 Text::tr("“%1” is not understood by this version of Barycage; the line is kept.")
                     .arg(decoded(
                         m_text.sliced(comment.text.begin, std::min<qsizetype>(comment.text.size(), 69)))));
}

void EntryParser::explainShape() {
    const int wanted = m_isMarked3D ? 13 : 7;
    if (m_bodyTokens.empty() && m_headerTokens.empty()) {
        fail(m_entry.layout.block.open < 0 ? 0 : m_entry.layout.block.open,
             Text::tr("The entry holds no numbers."));
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
    fail(odd->span.begin,
         Text::tr(
             "This line has %1 numbers and the entry %2, which is no multiple of %3: a map is %3 numbers%4.")
             .arg(oddCount)
             .arg(tokens.size())
             .arg(wanted)
             .arg(m_isMarked3D ? Text::tr(" in an entry marked “(3D)”") : QString()));
}

void EntryParser::explainTokens(const std::vector<RawToken>& tokens) {
    for (const RawToken& token : tokens) {
        const Number number = fractint::parse(copyOf(m_text, token.span));
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
                    Text::tr("“%1” is larger than a coefficient can be (3.4e38 in size).").arg(text));
    case Number::Kind::NotANumber:
    case Number::Kind::Good:
        break;
    }
    if (bytes.startsWith("\xe2\x88\x92"))
        return fail(
            token.span.begin,
            Text::tr("“%1” begins with a typographic minus sign (U+2212). Write the plain “-”.").arg(text));
    fail(token.span.begin, Text::tr("“%1” is not a number.").arg(text));
}

void EntryParser::warnAboutReading(const Reading& chosen) {
    const Layout& layout = m_entry.layout;
    const qsizetype first = layout.numbers.front().span.begin;
    if (chosen.usesHeader)
        warn(first,
             Text::tr("Numbers stand on the line of the opening brace, where Fractint ignores them; they "
                      "are read."));
    if (m_hasCommas)
        warn(first,
             chosen.decimalComma
                 ? Text::tr("Commas are read as decimal points; Fractint reads other numbers here.")
                 : Text::tr("Commas or apostrophes stand between the numbers; Iterated Dynamics cannot read "
                            "this entry."));
    if (layout.rowLength == 6 || layout.rowLength == 12)
        warn(first,
             Text::tr("The maps have no weights (%1 numbers each); weights are taken from the determinants. "
                      "Fractint cannot read this entry.")
                 .arg(layout.rowLength));
    if (chosen.shape.isMarkMissing)
        warn(first,
             Text::tr(
                 "Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot "
                 "read this entry.")
                 .arg(layout.rowLength));
    if (chosen.shape.isLineLengthOdd)
        warn(first,
             Text::tr(
                 "The lines do not hold 7 numbers each, but all numbers together fill rows of 7 and are read "
                 "so, as Fractint does. Probably the weights are missing."));
    if (layout.block.open >= 0 && layout.block.close > 0 && !isBlank(m_text[layout.block.close - 1]) &&
        layout.numbers.back().span.end == layout.block.close)
        warn(layout.block.close,
             Text::tr("The closing brace touches the last number; Fractint cannot read this entry."));
    if (m_longLine >= 0)
        warn(m_longLine, Text::tr("The line is longer than 200 bytes; Fractint cuts it there."));
    if (m_nul >= 0)
        warn(m_nul, Text::tr("A NUL byte; the rest of the line is ignored, as Fractint ignores it."));
    if (const std::size_t maps = layout.numbers.size() / static_cast<std::size_t>(layout.rowLength);
        maps > mostMapsElsewhere)
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
            warn(layout.numbers[rowLength - 1].span.begin,
                 Text::tr("The weights sum to %1, not 1. They are used in proportion; Fractint gives what is "
                          "missing to the "
                          "last map and cuts what is too much.")
                     .arg(sum));
    };
    if (const auto* plane = std::get_if<document::System2>(&m_entry.fractal.system))
        check(plane->maps);
    else if (const auto* space = std::get_if<document::System3>(&m_entry.fractal.system))
        check(space->maps);
}

void EntryParser::report(Problem::Severity severity, qsizetype position, const QString& message) {
    if (m_entry.problems.size() >= maxProblems) {
        ++m_suppressed;
        return;
    }
    const Place place = placeOf(position);
    m_entry.problems.append({severity, {}, place.line, place.column, message});
}

EntryParser::Place EntryParser::placeOf(qsizetype position) {
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
