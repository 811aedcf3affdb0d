// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_strict.h"

#include "document/edits/maps/symmetry_edits.h"
#include "document/text/text.h"
#include "document/text/unique_names.h"
#include "document/text/user_comments.h"
#include "io/fractint/fractint_entry.h"
#include "io/fractint/fractint_rows.h"
#include "io/text/lost_parts.h"

#include <QSet>

#include <algorithm>
#include <cmath>
#include <limits>

namespace io {

namespace {

using document::Entry;
using document::FractalFile;
using document::Problem;
using fractint::Row;

constexpr qsizetype maxStrictLine = 199;
constexpr qsizetype maxTitle = 100; // characters after the opening brace
constexpr std::size_t maxMaps = 63;
constexpr std::size_t maxMapsBefore18 = 31;
constexpr qsizetype maxEntries = 2000;

// Removes accents; letters without a plain form become a question mark, or `replacement` in a name.
QByteArray ascii(const QString& text, char replacement) {
    QByteArray result;
    for (const QChar c : text.normalized(QString::NormalizationForm_KD)) {
        if (c.unicode() >= 0x20 && c.unicode() < 0x7f)
            result += static_cast<char>(c.unicode());
        else if (!c.isMark() && !c.isLowSurrogate())
            result += replacement;
    }
    return result;
}

class StrictWriter {
public:
    StrictText write(const FractalFile& file, const QSet<document::EntryId>& only) && {
        if (only.isEmpty()) addText(file.head);
        if (!m_text.bytes.isEmpty()) m_text.bytes += '\n'; // blank line between head and entry
        for (const Entry& entry : file.entries)
            if (only.isEmpty() || only.contains(entry.id)) append(entry);
        if (only.isEmpty()) addTail(file.tail);
        if (m_text.entries > maxEntries)
            warn({},
                 Text::tr("The file has %1 entries; Fractint and Iterated Dynamics use only the first 2000.")
                     .arg(m_text.entries));
        return std::move(m_text);
    }

private:
    void append(const Entry& entry) {
        m_line = entry.source ? entry.source->line : 0;
        const document::Fractal fractal = document::expanded(*entry.fractal);
        const std::vector<Row> rows = activeRows(fractal);
        if (rows.empty())
            return m_text.problems.append({Problem::Severity::Error, fractal.name, m_line, m_line > 0 ? 1 : 0,
                                           Text::tr("The entry has no active map and is omitted.")});
        const QByteArray name = strictName(fractal.name);
        ++m_text.entries;
        if (m_text.entries > 1) m_text.bytes += '\n';
        // Comments precede the entry: Fractint 16–18 accept none inside.
        if (entry.source) addText(entry.source->before);
        for (const QString& comment : document::userComments(fractal.comments))
            addComment(comment);
        if (entry.source) addCommentsOfRows(entry.source->text);
        const QByteArrayList title =
            pieces(ascii(fractint::storedComment(fractal.headerComment), '?'), maxTitle);
        for (qsizetype i = 1; i < title.size(); ++i)
            addComment(QString::fromLatin1(title[i]));
        m_text.bytes += name + (document::dimension(fractal) == 3 ? " (3D) {" : " {");
        if (!title.isEmpty()) m_text.bytes += " ; " + title.first();
        m_text.bytes += '\n' + rowText(rows).join('\n') + "\n}\n";
        checkLimits(fractal, rows.size());
        if (const auto loss = lossBeside({}, *entry.fractal)) warn(fractal.name, *loss);
    }

    void addComment(const QString& text) {
        const QByteArrayList lines = pieces(ascii(fractint::storedComment(text), '?'), maxStrictLine - 2);
        if (lines.isEmpty()) m_text.bytes += ";\n";
        for (const QByteArray& line : lines)
            m_text.bytes += "; " + line + '\n';
    }

    // Words of a comment on as many lines as necessary; words longer than a line are cut.
    static QByteArrayList pieces(const QByteArray& text, qsizetype room) {
        QByteArrayList lines;
        for (QByteArrayView rest = QByteArrayView(text).trimmed(); !rest.isEmpty(); rest = rest.trimmed()) {
            const qsizetype blank = rest.size() > room ? rest.first(room + 1).lastIndexOf(' ') : -1;
            const qsizetype end = blank > 0 ? blank : std::min(room, rest.size());
            // Escaped if it now looks like a line of Barycage.
            lines << fractint::storedComment(QString::fromLatin1(rest.first(end))).toLatin1();
            rest = rest.sliced(end);
        }
        return lines;
    }

    // Keeps comments between entries and turns other lines into comments. Drops blocks of parameters and
    // formulas.
    void addText(const QByteArray& text) {
        qsizetype lost = 0;
        bool isBlock = false;
        for (const QByteArray& line : linesOf(text)) {
            const QByteArray code = line.left(line.indexOf(';') < 0 ? line.size() : line.indexOf(';'));
            isBlock = isBlock || code.contains('{');
            if (isBlock)
                ++lost;
            else
                addComment(fractint::decoded(line.sliced(line.startsWith(';') ? 1 : 0)));
            isBlock = isBlock && !code.contains('}');
        }
        if (lost > 0)
            warn({},
                 Text::tr("Omitted lines of blocks that are not iterated function systems: %1.").arg(lost));
    }

    void addTail(const QByteArray& tail) {
        const qsizetype before = m_text.bytes.size();
        addText(tail);
        if (before > 0 && m_text.bytes.size() > before) m_text.bytes.insert(before, '\n');
    }

    // Adds text behind the numbers of a row, or behind the closing brace.
    void addCommentsOfRows(const QByteArray& text) {
        bool isBody = false;
        for (const QByteArray& line : linesOf(text)) {
            const qsizetype semicolon = line.indexOf(';');
            if (isBody && semicolon > 0) addComment(fractint::decoded(line.sliced(semicolon + 1)));
            isBody = isBody || line.left(semicolon < 0 ? line.size() : semicolon).contains('{');
        }
    }

    // Lines with contents, without blanks, byte order mark and ^Z.
    static QByteArrayList linesOf(QByteArray text) {
        if (text.startsWith("\xef\xbb\xbf")) text.remove(0, 3);
        QByteArrayList lines;
        for (const QByteArray& line : text.replace('\r', '\n').replace('\x1a', '\n').split('\n'))
            if (const QByteArray content = line.trimmed(); !content.isEmpty()) lines << content;
        return lines;
    }

    std::vector<Row> activeRows(const document::Fractal& fractal) {
        std::vector<Row> rows = fractint::rowsOf(fractal);
        const std::size_t all = rows.size();
        std::erase_if(rows, [](const Row& row) { return !(row.probability > 0); });
        // Single precision for other readers, some of which stop at a weight of 0.
        for (Row& row : rows)
            row.probability = std::max<double>(row.probability, std::numeric_limits<float>::min());
        if (rows.size() < all && !rows.empty())
            warn(fractal.name, Text::tr("Omitted inactive maps: %1.").arg(all - rows.size()));
        return rows;
    }

    QByteArray strictName(const QString& name) {
        QString legal = QString::fromLatin1(ascii(fractint::storedName(name), '_'));
        legal = m_names.give(legal);
        if (legal != name)
            warn(name, Text::tr("The entry is saved under the name “%1”: other programs need unique names of "
                                "at most 18 plain characters.")
                           .arg(legal));
        return legal.toLatin1();
    }

    // Weights with sum 1; the last one takes the remainder if that exceeds the rounding of the sum.
    static QByteArrayList rowText(const std::vector<Row>& rows) {
        double rest = 1;
        std::vector<std::vector<QByteArray>> cells;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const bool isLast = i + 1 == rows.size();
            const double given = rows[i].probability;
            const bool fits = std::abs(rest - given) <= 0x1p-53 * double(rows.size());
            const double weight = isLast && rest > 0 && !fits ? rest : given;
            rest -= weight;
            cells.push_back(texts(rows[i], weight));
        }
        const auto fits = [](const QByteArray& line) { return line.size() <= maxStrictLine; };
        for (const QByteArrayList& lines : {fractint::alignedRows(cells), fractint::closeRows(cells)})
            if (std::ranges::all_of(lines, fits)) return lines;
        return fractint::rowsOnTwoLines(cells);
    }

    static std::vector<QByteArray> texts(const Row& row, double weight) {
        std::vector<QByteArray> cells;
        for (const double number : row.coefficients)
            cells.push_back(fractint::numberText(number));
        cells.push_back(fractint::numberText(weight));
        return cells;
    }

    void checkLimits(const document::Fractal& fractal, std::size_t maps) {
        if (maps > maxMaps)
            warn(
                fractal.name,
                Text::tr("The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.").arg(maps));
        else if (maps > maxMapsBefore18)
            warn(fractal.name,
                 Text::tr("The entry has %1 maps; Fractint up to 17.2 reads at most 31.").arg(maps));
    }

    void warn(const QString& entry, const QString& message) {
        const int line = entry.isEmpty() ? 0 : m_line;
        m_text.problems.append({Problem::Severity::Warning, entry, line, line > 0 ? 1 : 0, message});
    }

    document::UniqueNames m_names;
    StrictText m_text;
    int m_line = 0; // line of the entry in the original file
};

} // namespace

StrictText writeStrict(const FractalFile& file, const QList<document::EntryId>& only) {
    return StrictWriter().write(file, {only.begin(), only.end()});
}

} // namespace io
