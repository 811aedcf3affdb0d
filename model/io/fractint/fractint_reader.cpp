// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_reader.h"

#include "document/text/text.h"
#include "io/fractint/format_detection.h"
#include "io/fractint/fractint_entry.h"

#include <QHash>

#include <algorithm>
#include <memory>
#include <utility>

namespace io {

namespace {

using document::Entry;
using document::EntryId;
using document::EntrySource;
using document::FractalFile;
using document::Problem;
using document::Problems;
using fractint::Block;
using fractint::BlockKind;

constexpr qsizetype maxFileProblems = 100;
constexpr qsizetype maxEntriesElsewhere = 2000;
constexpr qsizetype comparedName = 18;

QByteArray firstLineEnd(QByteArrayView bytes) {
    if (fractint::lineEndByte(bytes) == '\r') return "\r";
    const qsizetype first = bytes.indexOf('\n');
    return first > 0 && bytes[first - 1] == '\r' ? "\r\n" : "\n";
}

// Line and column of growing offsets.
class LineCounter {
public:
    LineCounter(QByteArrayView bytes, char lineEndByte) : m_bytes(bytes), m_lineEnd(lineEndByte) {}

    void moveTo(qsizetype position) {
        if (position <= m_position) return;
        const QByteArrayView passed = m_bytes.sliced(m_position, position - m_position);
        m_line += static_cast<int>(passed.count(m_lineEnd));
        if (const qsizetype last = passed.lastIndexOf(m_lineEnd); last >= 0)
            m_lineBegin = m_position + last + 1;
        m_position = position;
    }
    int line() const { return m_line; }
    int column() const { return static_cast<int>(m_position - m_lineBegin) + 1; }

private:
    QByteArrayView m_bytes;
    char m_lineEnd;
    qsizetype m_position = 0;
    qsizetype m_lineBegin = 0;
    int m_line = 1;
};

class FileReader {
public:
    FileReader(const QByteArray& bytes, const QString& bareName)
        : m_bytes(bytes),
          m_bareName(bareName),
          m_lineEnd(fractint::lineEndByte(bytes)),
          m_lines(bytes, m_lineEnd) {}

    FractalFile read() &&;

private:
    void readBlocks();
    void readBlock(const Block& block);
    bool readBare();
    void addEntry(const Block& block);
    void leaveAsText(const Block& block);
    void finish();
    void checkName(Entry& entry, const EntrySource& source, int column);
    QByteArray slice(qsizetype begin, qsizetype end) const { return m_bytes.sliced(begin, end - begin); }
    void splitHead(qsizetype nameBegin);
    void report(Problem::Severity severity, int line, int column, const QString& message);

    const QByteArray& m_bytes;
    QString m_bareName;
    char m_lineEnd;
    LineCounter m_lines;
    FractalFile m_file;
    qsizetype m_taken = 0; // bytes that belong to entries or to the head
    QHash<QByteArray, int> m_lineOfName;
    qsizetype m_parameterSets = 0;
    bool m_isParameterFile = false;
    std::pair<int, int> m_firstPrefix; // line and column
    Problems m_textWarnings;
};

FractalFile FileReader::read() && {
    m_file.lineEnd = firstLineEnd(m_bytes);
    if (const auto sentence = foreignFormatRemark(m_bytes)) {
        report(Problem::Severity::Error, 0, 0, *sentence);
        m_file.tail = m_bytes;
        return std::move(m_file);
    }
    readBlocks();
    if (m_file.entries.isEmpty() && !readBare())
        report(Problem::Severity::Error, 0, 0,
               m_bytes.trimmed().isEmpty() ? Text::tr("The file is empty.")
               : m_parameterSets > 0 ? Text::tr("The file contains Fractint parameter sets or formulas, but "
                                                "no iterated function system.")
                                     : Text::tr("No iterated function system was found: an entry consists of "
                                                "a name, “{”, rows of 7 numbers and “}”."));
    finish();
    return std::move(m_file);
}

void FileReader::readBlocks() {
    const qsizetype begin = m_bytes.startsWith("\xef\xbb\xbf") ? 3 : 0;
    fractint::Scanner scanner(m_bytes, m_lineEnd, begin);
    while (const auto block = scanner.next()) {
        m_lines.moveTo(block->all.begin);
        if (m_file.entries.size() >= fractint::maxEntries) {
            report(Problem::Severity::Error, m_lines.line(), m_lines.column(),
                   Text::tr("The file has more than %1 entries; the rest is kept as text but not shown.")
                       .arg(fractint::maxEntries));
            return;
        }
        readBlock(*block);
    }
}

void FileReader::readBlock(const Block& block) {
    if (block.hasPrefix && !m_isParameterFile) {
        m_lines.moveTo(block.all.begin);
        m_firstPrefix = {m_lines.line(), m_lines.column()};
    }
    m_isParameterFile = m_isParameterFile || block.hasPrefix;
    const bool isOpenEntry = block.kind == BlockKind::Entry || block.kind == BlockKind::Unclosed;
    if (isOpenEntry && !fractint::isAssignment(m_bytes, block, m_lineEnd))
        addEntry(block);
    else
        leaveAsText(block);
}

void FileReader::leaveAsText(const Block& block) {
    const auto name = [&] { return fractint::decoded(slice(block.name.begin, block.name.end).left(40)); };
    QString sentence;
    if (block.kind == BlockKind::Unnamed)
        sentence = Text::tr("A block without a name is kept as text; Fractint does not list it.");
    else if (block.kind == BlockKind::TwoBraces)
        sentence = Text::tr(
            "There are two opening braces on one line: no program finds an entry here. The text is kept.");
    else if (block.kind != BlockKind::CommentBlock)
        ++m_parameterSets;
    if (block.kind == BlockKind::Entry || block.kind == BlockKind::Unclosed ||
        block.kind == BlockKind::OtherType)
        sentence =
            Text::tr(
                "“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.")
                .arg(name());
    if (!sentence.isEmpty() && m_textWarnings.size() < maxFileProblems)
        m_textWarnings.append({Problem::Severity::Warning, {}, m_lines.line(), m_lines.column(), sentence});
}

// Files of Fractint 10–15: nothing but the rows of one system.
bool FileReader::readBare() {
    const qsizetype begin = m_bytes.startsWith("\xef\xbb\xbf") ? 3 : 0;
    const QByteArrayView rest = QByteArrayView(m_bytes).sliced(begin);
    if (!fractint::holdsOnlyRows(rest, m_lineEnd)) return false;
    Block block;
    block.all = {begin, m_bytes.size()};
    // Text after ^Z stays in the tail; new entries go before it.
    if (const qsizetype ctrlZ = m_bytes.indexOf('\x1a', begin); ctrlZ >= 0) block.all.end = ctrlZ;
    block.name = {begin, begin};
    block.close = block.all.end;
    addEntry(block);
    return true;
}

// The head of the file is what a blank line or a byte order mark separates from the first entry: it stays
// where it is when entries are moved or removed.
void FileReader::splitHead(qsizetype nameBegin) {
    const qsizetype begin = m_bytes.startsWith("\xef\xbb\xbf") ? 3 : 0;
    qsizetype head = begin;
    bool isBlankLine = true;
    for (qsizetype i = begin; i < nameBegin; ++i) {
        if (m_bytes[i] == m_lineEnd && std::exchange(isBlankLine, true))
            head = i + 1;
        else if (!fractint::isBlank(m_bytes[i]))
            isBlankLine = false;
    }
    m_file.head = m_bytes.first(head);
    m_taken = head;
}

void FileReader::addEntry(const Block& block) {
    if (m_file.entries.isEmpty()) splitHead(block.all.begin);
    auto source = std::make_shared<EntrySource>();
    source->before = slice(m_taken, block.all.begin);
    source->text = slice(block.all.begin, block.all.end);
    source->line = m_lines.line();
    source->lineEnd = source->text.contains('\r') || source->text.contains('\n') ? firstLineEnd(source->text)
                                                                                 : m_file.lineEnd;
    fractint::ParsedEntry parsed = fractint::parseEntry(source->text, fractint::relative(block), m_lineEnd);
    source->fractal = std::move(parsed.fractal);
    if (block.open < 0 && !m_bareName.isEmpty()) {
        source->fractal.name = document::uniqueName({}, m_bareName);
        for (Problem& problem : parsed.problems)
            problem.entry = source->fractal.name;
    }

    Entry entry;
    entry.id = static_cast<EntryId>(m_file.entries.size() + 1);
    for (Problem& problem : parsed.problems) {
        problem.column += problem.line == 1 ? m_lines.column() - 1 : 0;
        problem.line += m_lines.line() - 1;
    }
    entry.problems = std::move(parsed.problems);
    checkName(entry, *source, m_lines.column());
    entry.fractal = std::shared_ptr<const document::Fractal>(source, &source->fractal);
    entry.source = std::move(source);
    m_file.entries.append(std::move(entry));
    m_taken = block.all.end;
}

void FileReader::checkName(Entry& entry, const EntrySource& source, int column) {
    const QByteArray compared = source.fractal.name.toLower().toUtf8().left(comparedName);
    if (const auto first = m_lineOfName.constFind(compared); first != m_lineOfName.constEnd())
        entry.problems.append({Problem::Severity::Warning, source.fractal.name, source.line, column,
                               Text::tr("The entry in line %1 has the same name (Fractint compares 18 "
                                        "characters and ignores case); Fractint never reaches this one.")
                                   .arg(*first)});
    else
        m_lineOfName.insert(compared, source.line);
}

void FileReader::finish() {
    m_file.tail = m_bytes.sliced(m_taken);
    if (!m_isParameterFile && !m_file.entries.isEmpty())
        for (const Problem& warning : m_textWarnings)
            m_file.problems.append(warning);
    if (m_bytes.startsWith("\xef\xbb\xbf") && !m_file.entries.isEmpty())
        report(
            Problem::Severity::Warning, 1, 1,
            Text::tr(
                "The file begins with a byte order mark, which Fractint treats as part of the first name."));
    if (m_isParameterFile && m_parameterSets == 0 && !m_file.entries.isEmpty())
        report(Problem::Severity::Warning, m_firstPrefix.first, m_firstPrefix.second,
               Text::tr(
                   "Entries whose names begin with “ifs:” belong in parameter files (.par); in a collection, "
                   "Fractint takes the prefix as part of the name."));
    if (m_lineEnd == '\r' && !m_file.entries.isEmpty())
        report(
            Problem::Severity::Warning, 1, 1,
            Text::tr(
                "The lines end with CR alone, as on old Macintosh computers; Fractint reads such a file as "
                "a single line."));
    const qsizetype ctrlZ = m_bytes.indexOf('\x1a');
    if (ctrlZ >= 0 && ctrlZ < m_taken) {
        LineCounter lines(m_bytes, m_lineEnd);
        lines.moveTo(ctrlZ);
        report(
            Problem::Severity::Warning, lines.line(), lines.column(),
            Text::tr("Fractint stops reading at this byte (^Z); Barycage reads the entries after it too."));
    }
    if (m_file.entries.size() > maxEntriesElsewhere)
        report(Problem::Severity::Warning, 0, 0,
               Text::tr("The file has %1 entries; Fractint and Iterated Dynamics use only the first 2000.")
                   .arg(m_file.entries.size()));
}

void FileReader::report(Problem::Severity severity, int line, int column, const QString& message) {
    m_file.problems.append({severity, {}, line, column, message});
}

} // namespace

document::FractalFile readFractint(const QByteArray& bytes, const QString& bareName) {
    return FileReader(bytes, bareName).read();
}

} // namespace io
