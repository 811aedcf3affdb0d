// SPDX-License-Identifier: MIT
#include "io/fractint_writer.h"

#include "io/fractint_edit.h"
#include "io/fractint_rows.h"
#include "io/own_comments.h"

#include <algorithm>

namespace io {

namespace {

using document::Entry;
using document::FractalFile;

bool isLineOpen(const QByteArray& bytes) {
    return !bytes.isEmpty() && bytes.back() != '\n' && bytes.back() != '\r';
}

bool endsInComment(const QByteArray& bytes) {
    const qsizetype line = std::max(bytes.lastIndexOf('\n'), bytes.lastIndexOf('\r')) + 1;
    return bytes.indexOf(';', line) >= 0;
}

// Whether `b` stood right after `a` in the file they were read from.
bool wereNeighbours(const Entry& a, const Entry& b, char lineEndByte) {
    return a.source && b.source &&
           b.source->line ==
               a.source->line + a.source->text.count(lineEndByte) + b.source->before.count(lineEndByte);
}

bool endsInBlankLine(const QByteArray& bytes, const QByteArray& lineEnd) {
    return bytes.isEmpty() || bytes.endsWith(lineEnd + lineEnd) || bytes == lineEnd;
}

bool isBare(const Entry& entry) {
    return entry.source && fractint::isBare(*entry.source);
}

class FileWriter {
public:
    explicit FileWriter(const FractalFile& file) : m_file(file), m_bytes(file.head) {}

    QByteArray write() && {
        const Entry* previous = nullptr;
        for (const Entry& entry : m_file.entries) {
            separate(previous, entry);
            append(entry);
            previous = &entry;
        }
        // Bare rows go up to ^Z, be it in a comment.
        const bool isCut =
            m_file.entries.size() == 1 && isBare(m_file.entries.first()) && m_file.tail.startsWith('\x1a');
        if (previous != nullptr && !isCut && isLineOpen(m_bytes) && !m_file.tail.isEmpty() &&
            endsInComment(m_bytes))
            m_bytes += m_file.lineEnd;
        return m_bytes + m_file.tail;
    }

private:
    void separate(const Entry* previous, const Entry& entry) {
        const bool wasFirst = previous == nullptr && entry.source;
        const bool stays =
            previous != nullptr ? wereNeighbours(*previous, entry, m_file.lineEnd.back()) : wasFirst;
        if (isLineOpen(m_bytes) && m_bytes != "\xef\xbb\xbf" && (!stays || endsInComment(m_bytes)))
            m_bytes += m_file.lineEnd;
        if (!entry.source && previous != nullptr && !endsInBlankLine(m_bytes, m_file.lineEnd))
            m_bytes += m_file.lineEnd;
    }

    void append(const Entry& entry) {
        if (!entry.source) {
            m_bytes += writeEntry(*entry.fractal, m_file.lineEnd);
            return;
        }
        m_bytes += entry.source->before;
        const bool isUntouched =
            entry.fractal.get() == &entry.source->fractal || *entry.fractal == entry.source->fractal;
        if (m_file.entries.size() > 1 && fractint::isBare(*entry.source))
            m_bytes += fractint::editedText(fractint::withBraces(*entry.source), *entry.fractal);
        else
            m_bytes += isUntouched ? entry.source->text : fractint::editedText(*entry.source, *entry.fractal);
    }

    const FractalFile& m_file;
    QByteArray m_bytes;
};

QByteArrayList commentLines(const document::Fractal& fractal) {
    QByteArrayList lines;
    for (const QString& comment : fractal.comments) {
        const QByteArray text = fractint::storedComment(comment).toUtf8();
        lines << (text.isEmpty() ? QByteArray("  ;") : "  ; " + text);
    }
    return lines;
}

QByteArrayList rowLines(const document::Fractal& fractal) {
    std::vector<std::vector<QByteArray>> cells;
    for (const fractint::Row& row : fractint::rowsOf(fractal)) {
        std::vector<QByteArray> texts;
        for (const double number : row.coefficients)
            texts.push_back(fractint::numberText(number));
        texts.push_back(fractint::numberText(row.written));
        cells.push_back(std::move(texts));
    }
    return fractint::alignedRows(cells);
}

} // namespace

QByteArray writeFractint(const FractalFile& file) {
    return FileWriter(file).write();
}

QByteArray writeEntry(const document::Fractal& fractal, const QByteArray& lineEnd) {
    QByteArray header = fractint::storedName(fractal.name).toUtf8();
    header += document::dimension(fractal) == 3 ? " (3D) {" : " {";
    if (const QByteArray comment = fractint::storedComment(fractal.headerComment).toUtf8();
        !comment.isEmpty())
        header += " ; " + comment;
    const QByteArrayList lines = QByteArrayList{header} + commentLines(fractal) + ownComments(fractal) +
                                 rowLines(fractal) + QByteArrayList{"}"};
    return lines.join(lineEnd) + lineEnd;
}

} // namespace io
