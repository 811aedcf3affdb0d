// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_entry.h"

#include "document/text/text.h"
#include "io/fractint/fractint_rows.h"
#include "io/fractint/metadata_comments.h"
#include "io/text/export_weights.h"

#include <algorithm>
#include <cmath>

namespace io::fractint {

namespace {

using document::Problem;
using notation::Number;
using notation::RowFlaw;
using notation::RowReading;
using notation::Rows;
using notation::RowToken;

constexpr std::size_t maxMapsElsewhere = 63;
constexpr qsizetype maxName = 18;
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

    void readName();
    void readHeader();
    void readComments();
    void readSystem();
    void readNumbers();
    void buildSystem();
    template <int Dim> void addMap(ifs::IteratedFunctionSystem<Dim>& system, const Token* row);
    void applyMetadataComments();

    void explainFlaw();
    void explainShape();
    void explainTokens(const std::vector<RowToken>& tokens);
    void explain(const RowToken& token, const Number& number);
    void warnAboutReading(const RowReading& chosen);
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
    Rows m_rows;
    MetadataComments m_metadataComments;
    qsizetype m_suppressed = 0;
};

ParsedEntry EntryParser::parse() && {
    m_rows = notation::readRows(m_text, m_entry.layout.block, m_lineEnd);
    readName();
    readHeader();
    readComments();
    readSystem();
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
    if (!m_rows.chosen) return explainFlaw();
    readNumbers();
    warnAboutReading(*m_rows.chosen);
    buildSystem();
    applyMetadataComments();
    warnAboutWeights();
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
    layout.headerEnd = m_rows.headerEnd;
    layout.bodyBegin = m_rows.bodyBegin;
    layout.headerTextEnd = m_rows.headerTextEnd;
    layout.headerSemicolon = m_rows.headerSemicolon;
    layout.headerComment = m_rows.headerComment;
    if (m_rows.isBraceBelow)
        warn(0, Text::tr("The opening brace is on a line of its own; Fractint does not find this entry."));
    const Span comment = layout.headerComment;
    m_entry.fractal.headerComment = decoded(m_text.sliced(comment.begin, comment.size()));
}

void EntryParser::readComments() {
    for (const auto& [line, text] : m_rows.comments) {
        const QByteArrayView content = m_text.sliced(text.begin, text.size());
        Comment comment{line, text, isOwnComment(content), false};
        if (comment.isOwn)
            comment.isUnderstood = m_metadataComments.read(content);
        else
            m_entry.fractal.comments << decoded(content);
        m_entry.layout.comments.push_back(comment);
    }
}

void EntryParser::explainFlaw() {
    const qsizetype at = m_rows.flawAt.span.begin;
    const auto token = [&] {
        return decoded(m_text.sliced(at, std::min<qsizetype>(m_rows.flawAt.span.size(), 40)));
    };
    switch (m_rows.flaw) {
    case RowFlaw::TooManyLines:
        return fail(0, Text::tr("The entry has more than %1 lines, which is the limit; it is kept as text.")
                           .arg(maxLines));
    case RowFlaw::Unclosed:
        return fail(m_entry.layout.block.open,
                    Text::tr("The entry that starts here has no closing “}” before the "
                             "next entry or the end of the file."));
    case RowFlaw::TooManyMaps:
        return fail(at, Text::tr("The entry has more than %1 maps, which is the limit.").arg(maxMaps));
    case RowFlaw::CommaOfTwoKinds:
        return fail(at, Text::tr("“%1”: the comma can be a decimal comma or a separator; both "
                                 "readings give complete rows. Use decimal points and spaces.")
                            .arg(token()));
    case RowFlaw::CommaOfNoKind:
        return fail(at, Text::tr("“%1”: the comma gives complete rows of 7 numbers (13 with “(3D)”) "
                                 "neither as a decimal comma nor as a separator.")
                            .arg(token()));
    case RowFlaw::NotNumbers:
        return explainTokens(m_rows.refused);
    case RowFlaw::NotRows:
    case RowFlaw::None:
        return explainShape();
    }
}

void EntryParser::readNumbers() {
    Layout& layout = m_entry.layout;
    const RowReading& chosen = *m_rows.chosen;
    layout.rowLength = chosen.shape.rowLength;
    layout.decimalComma = chosen.decimalComma;
    layout.numbers.reserve(chosen.tokens.size());
    for (const RowToken& token : chosen.tokens)
        layout.numbers.push_back(
            {token.span, notation::valueOf(notation::textOf(m_text, token.span).view(), chosen.decimalComma),
             token.line});
    if (m_rows.ignoresHeader())
        warn(m_rows.headerTokens.front().span.begin,
             Text::tr("Numbers on the line of the opening brace are ignored, as in Fractint."));
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
    if (rowLength < 12)
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
    const int wanted = m_rows.isMarked3D ? 13 : 7;
    if (m_rows.bodyTokens.empty() && m_rows.headerTokens.empty()) {
        fail(m_entry.layout.block.open < 0 ? 0 : m_entry.layout.block.open,
             Text::tr("The entry contains no numbers."));
        return;
    }
    const auto& tokens = m_rows.bodyTokens.empty() ? m_rows.headerTokens : m_rows.bodyTokens;
    // Token to report: the first on a line whose numbers are not whole rows.
    const RowToken* odd = &tokens.front();
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
                              .arg(m_rows.isMarked3D ? Text::tr(" in an entry marked “(3D)”") : QString()));
}

void EntryParser::explainTokens(const std::vector<RowToken>& tokens) {
    for (const RowToken& token : tokens) {
        const Number number = notation::readNumber(notation::textOf(m_text, token.span).view());
        if (number.kind != Number::Kind::Good) explain(token, number);
    }
}

void EntryParser::explain(const RowToken& token, const Number& number) {
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

void EntryParser::warnAboutReading(const RowReading& chosen) {
    const Layout& layout = m_entry.layout;
    const qsizetype first = layout.numbers.front().span.begin;
    if (chosen.usesHeader)
        warn(first, Text::tr("There are numbers on the line of the opening brace, where Fractint ignores "
                             "them; Barycage reads them."));
    if (m_rows.hasCommas)
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
        constexpr double tolerance = 0.02; // accepts weights with two digits
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
    if (m_rows.longLine >= 0)
        warn(m_rows.longLine, Text::tr("The line is longer than 200 bytes; Fractint truncates it."));
    if (m_rows.nul >= 0)
        warn(m_rows.nul,
             Text::tr("There is a NUL byte here; the rest of the line is ignored, as in Fractint."));
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
        bool isNone = true; // true: no weight above 0, hence no proportions
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
    const auto& begins = m_rows.lineBegins;
    const auto after = std::upper_bound(begins.begin(), begins.end(), position);
    return {static_cast<int>(after - begins.begin()), static_cast<int>(position - *(after - 1)) + 1};
}

} // namespace

ParsedEntry parseEntry(QByteArrayView text, const Block& block, char lineEndByte) {
    return EntryParser(text, block, lineEndByte).parse();
}

QString decoded(QByteArrayView bytes) {
    return bytes.isValidUtf8() ? QString::fromUtf8(bytes) : QString::fromLatin1(bytes);
}

} // namespace io::fractint
