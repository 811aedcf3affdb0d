// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_writer.h"

#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_edit.h"

#include <algorithm>

namespace io {

namespace {

using document::Entry;
using document::FractalFile;

bool isLineOpen(const QByteArray& bytes) {
    return !bytes.isEmpty() && bytes.back() != '\n' && bytes.back() != '\r';
}

// Returns true if `b` stood right after `a` in the file they were read from.
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
    explicit FileWriter(const FractalFile& file) : m_file(file) { add(file.head); }

    QByteArray write() && {
        const Entry* previous = nullptr;
        for (const Entry& entry : m_file.entries) {
            separate(previous, entry);
            append(entry);
            previous = &entry;
        }
        // True for bare rows cut by ^Z, be it in a comment.
        const bool isCut =
            m_file.entries.size() == 1 && isBare(m_file.entries.first()) && m_file.tail.startsWith('\x1a');
        if (previous != nullptr && !isCut && isLineOpen(m_bytes) && !m_file.tail.isEmpty() && m_endsInComment)
            add(m_file.lineEnd);
        add(m_file.tail);
        return std::move(m_bytes);
    }

private:
    void separate(const Entry* previous, const Entry& entry) {
        const bool wasFirst = previous == nullptr && entry.source;
        const bool stays =
            previous != nullptr ? wereNeighbours(*previous, entry, m_file.lineEnd.back()) : wasFirst;
        if (isLineOpen(m_bytes) && m_bytes != "\xef\xbb\xbf" && (!stays || m_endsInComment))
            add(m_file.lineEnd);
        if (!entry.source && previous != nullptr && !endsInBlankLine(m_bytes, m_file.lineEnd))
            add(m_file.lineEnd);
    }

    void append(const Entry& entry) {
        if (!entry.source) {
            add(writeEntry(*entry.fractal, m_file.lineEnd));
            return;
        }
        add(entry.source->before);
        const bool isUntouched =
            entry.fractal.get() == &entry.source->fractal || *entry.fractal == entry.source->fractal;
        if (m_file.entries.size() > 1 && fractint::isBare(*entry.source))
            add(fractint::editedText(fractint::withBraces(*entry.source), *entry.fractal));
        else
            add(isUntouched ? entry.source->text : fractint::editedText(*entry.source, *entry.fractal));
    }

    // Searches only new bytes for line ends, because all entries may share one line.
    void add(const QByteArray& bytes) {
        const qsizetype line = std::max(bytes.lastIndexOf('\n'), bytes.lastIndexOf('\r')) + 1;
        m_endsInComment = (m_endsInComment && line == 0) || bytes.indexOf(';', line) >= 0;
        m_bytes += bytes;
    }

    const FractalFile& m_file;
    QByteArray m_bytes;
    bool m_endsInComment = false; // true for a semicolon on the last line
};

} // namespace

QByteArray writeFractint(const FractalFile& file) {
    return FileWriter(file).write();
}

} // namespace io
