// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_edit.h"

#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_entry.h"
#include "io/fractint/fractint_rows.h"
#include "io/fractint/metadata_comments.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace io::fractint {

namespace {

using document::EntrySource;
using document::Fractal;

// Replaces bytes [begin, end) of the source by `text`.
struct Patch {
    qsizetype begin = 0;
    qsizetype end = 0;
    QByteArray text;
};

QByteArray patched(QByteArrayView source, std::vector<Patch> patches) {
    std::stable_sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) {
        return a.begin != b.begin ? a.begin < b.begin : (a.begin == a.end && b.begin != b.end);
    });
    QByteArray result;
    qsizetype done = 0;
    for (const Patch& patch : patches) {
        result += source.sliced(done, std::max(done, patch.begin) - done);
        result += patch.text;
        done = std::max(done, patch.end);
    }
    result += source.sliced(done);
    return result;
}

char lineEndByteOf(const EntrySource& source) {
    return source.lineEnd == "\r" ? '\r' : '\n';
}

Block bareBlock(qsizetype size) {
    Block block;
    block.all = {0, size};
    block.close = size;
    return block;
}

std::optional<ParsedEntry> parsed(QByteArrayView text, char lineEndByte, bool bare) {
    if (bare) return parseEntry(text, bareBlock(text.size()), lineEndByte);
    const auto block = Scanner(text, lineEndByte).next();
    const bool isEntry = block && block->all.begin == 0 &&
                         (block->kind == BlockKind::Entry || block->kind == BlockKind::Unclosed);
    return isEntry ? std::optional(parseEntry(text, *block, lineEndByte)) : std::nullopt;
}

// The result that reading the written entry must give.
Fractal expected(const Fractal& fractal, const Fractal& before) {
    Fractal stored = asStored(fractal);
    if (fractal.name != before.name) stored.name = storedName(fractal.name);
    if (fractal.headerComment != before.headerComment)
        stored.headerComment = storedComment(fractal.headerComment);
    if (fractal.comments != before.comments)
        for (QString& comment : stored.comments)
            comment = storedComment(comment);
    return stored;
}

class Edit {
public:
    Edit(const EntrySource& source, const Layout& layout, const Fractal& after, qsizetype longestLine)
        : m_source(source),
          m_text(source.text),
          m_layout(layout),
          m_after(after),
          m_isUtf8(m_text.isValidUtf8()),
          m_lineEnd(lineEndByteOf(source)),
          m_longestLine(longestLine) {}

    QByteArray text() &&;

private:
    struct Slot {
        std::size_t first = 0; // index of the first token
        std::size_t last = 0;
        bool isOwnLine = false; // true if its lines contain only this row, perhaps followed by a comment
        Span line;              // first to last line, including the line end
    };

    void rename();
    void editHeaderComment();
    void editComments();
    void editMetadataComments();
    void editRows();
    void replaceRow(std::size_t row, const Row& after);
    void permute(const std::vector<std::size_t>& kept, const std::vector<const Row*>& wanted);
    void removeRow(std::size_t row);
    void insertRows(const std::vector<Slot>::const_iterator& slot, bool before,
                    const std::vector<const Row*>& rows);

    std::vector<Slot> rowSlots() const;
    std::vector<Patch> numberPatches(std::size_t row, const Row& after) const;
    void breakLongLine(const Slot& slot, std::vector<Patch>& patches) const;
    QByteArray rowText(const Row& row) const;
    QByteArray numberAsHere(double value) const;
    QByteArray encoded(const QString& text) const;
    void insertLines(qsizetype position, const QByteArrayList& lines);
    void replace(qsizetype begin, qsizetype end, const QByteArray& text) {
        m_patches.push_back({begin, end, text});
    }
    qsizetype lineBegin(qsizetype position) const;
    bool isHeaderLine(qsizetype position) const {
        return m_layout.block.open >= 0 && position < m_layout.headerEnd;
    }

    const EntrySource& m_source;
    QByteArrayView m_text;
    const Layout& m_layout;
    const Fractal& m_after;
    bool m_isUtf8;
    char m_lineEnd;
    qsizetype m_longestLine; // longest line permitted for a row
    QByteArray m_indent;
    bool m_writesWeights = true;
    std::vector<Slot> m_slots;
    std::vector<Patch> m_patches;
};

QByteArray Edit::text() && {
    if (!m_layout.numbers.empty()) {
        const qsizetype first = m_layout.numbers.front().span.begin;
        const QByteArrayView indent = m_text.sliced(lineBegin(first), first - lineBegin(first));
        const bool isIndent =
            std::all_of(indent.begin(), indent.end(), [](char c) { return c == ' ' || c == '\t'; });
        m_indent = isIndent ? indent.toByteArray() : QByteArray("  ");
    }
    rename();
    editHeaderComment();
    editComments();
    editMetadataComments();
    editRows();
    return patched(m_text, std::move(m_patches));
}

void Edit::rename() {
    if (m_after.name != m_source.fractal.name)
        replace(m_layout.block.name.begin, m_layout.block.name.end, encoded(storedName(m_after.name)));
}

void Edit::editHeaderComment() {
    if (m_after.headerComment == m_source.fractal.headerComment) return;
    const QByteArray comment = encoded(storedComment(m_after.headerComment));
    const Span old = m_layout.headerComment;
    const qsizetype semicolon = m_layout.headerSemicolon;
    const bool closesHere = m_layout.headerEnd == m_layout.block.close;
    const QByteArray after = closesHere ? m_source.lineEnd : QByteArray();
    if (comment.isEmpty()) {
        qsizetype begin = semicolon >= 0 ? semicolon : old.begin;
        while (begin > m_layout.block.open + 1 && isBlank(m_text[begin - 1]))
            --begin;
        replace(begin, std::max(old.end, begin), {});
    } else if (semicolon >= 0) {
        if (old.size() > 0)
            replace(old.begin, old.end, comment);
        else
            replace(semicolon + 1, semicolon + 1, ' ' + comment);
    } else if (old.size() > 0) {
        replace(old.begin, old.end, "; " + comment + after);
    } else {
        replace(m_layout.headerTextEnd, m_layout.headerTextEnd, " ; " + comment + after);
    }
}

void Edit::editComments() {
    const QStringList& before = m_source.fractal.comments;
    const QStringList& after = m_after.comments;
    if (before == after) return;
    std::vector<const Comment*> lines;
    for (const Comment& comment : m_layout.comments)
        if (!comment.isOwn) lines.push_back(&comment);
    qsizetype same = 0;
    while (same < std::min(before.size(), after.size()) && before[same] == after[same])
        ++same;
    qsizetype tail = 0;
    while (tail < std::min(before.size(), after.size()) - same &&
           before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    qsizetype position = same > 0 ? lines[static_cast<std::size_t>(same - 1)]->line.end : m_layout.bodyBegin;
    QByteArrayList added;
    for (qsizetype i = same; i < std::max(before.size(), after.size()) - tail; ++i) {
        const bool isOld = i < before.size() - tail;
        const bool isNew = i < after.size() - tail;
        const QByteArray text = isNew ? encoded(storedComment(after[i])) : QByteArray();
        if (!isOld) {
            added << m_indent + (text.isEmpty() ? QByteArray(";") : "; " + text);
            continue;
        }
        const Comment& line = *lines[static_cast<std::size_t>(i)];
        position = line.line.end;
        if (isNew)
            replace(line.text.begin, line.text.end, line.text.size() == 0 ? ' ' + text : text);
        else
            replace(line.line.begin, line.line.end, {});
    }
    insertLines(position, added);
}

void Edit::editMetadataComments() {
    const QByteArrayList after = metadataComments(m_after);
    if (after == metadataComments(m_source.fractal)) return;
    qsizetype position = -1;
    for (const Comment& comment : m_layout.comments) {
        if (!comment.isUnderstood) continue;
        if (position < 0) position = comment.line.begin;
        replace(comment.line.begin, comment.line.end, {});
    }
    insertLines(position < 0 ? m_layout.bodyBegin : position, after);
}

void Edit::insertLines(qsizetype position, const QByteArrayList& lines) {
    if (lines.isEmpty()) return;
    QByteArray text = position > 0 && m_text[position - 1] != m_lineEnd ? m_source.lineEnd : QByteArray();
    for (const QByteArray& line : lines)
        text += line + m_source.lineEnd;
    replace(position, position, text);
}

qsizetype Edit::lineBegin(qsizetype position) const {
    return position == 0 ? 0 : m_text.lastIndexOf(m_lineEnd, position - 1) + 1;
}

std::vector<Edit::Slot> Edit::rowSlots() const {
    const auto& tokens = m_layout.numbers;
    const auto length = static_cast<std::size_t>(m_layout.rowLength);
    std::vector<Slot> rows;
    Span line;
    const auto lineOf = [&](qsizetype position) { // cached, because all rows may share one line
        if (position < line.begin || position >= line.end)
            line = {lineBegin(position), std::min(lineEnd(m_text, position, m_lineEnd) + 1, m_text.size())};
        return line;
    };
    for (std::size_t first = 0; length > 0 && first + length <= tokens.size(); first += length) {
        const std::size_t last = first + length - 1;
        Slot slot{first, last, false, {lineOf(tokens[first].span.begin).begin, 0}};
        slot.line.end = lineOf(tokens[last].span.end).end;
        const bool isShared = (first > 0 && tokens[first - 1].line == tokens[first].line) ||
                              (last + 1 < tokens.size() && tokens[last + 1].line == tokens[last].line);
        const auto numbers =
            m_text.sliced(tokens[first].span.begin, tokens[last].span.end - tokens[first].span.begin);
        slot.isOwnLine = !isShared && !numbers.contains(';') && !isHeaderLine(tokens[first].span.begin) &&
                         slot.line.end <= m_layout.block.close;
        rows.push_back(slot);
    }
    return rows;
}

void Edit::editRows() {
    if (document::isSameSystem(m_after, m_source.fractal) &&
        metadataComments(m_after) == metadataComments(m_source.fractal))
        return;
    const std::vector<Row> before = rowsOf(m_source.fractal);
    const std::vector<Row> after = rowsOf(m_after);
    m_slots = rowSlots();
    m_writesWeights =
        m_layout.rowLength % 2 == 1 ||
        std::any_of(after.begin(), after.end(), [](const Row& row) { return row.weight.value_or(0) != 0; });

    std::unordered_map<std::uint32_t, std::size_t> indexBefore;
    for (std::size_t i = 0; i < before.size(); ++i)
        indexBefore[static_cast<std::uint32_t>(before[i].id)] = i;
    std::vector<bool> isKept(before.size(), false);
    std::vector<std::size_t> kept;  // slots that stay, in their old order
    std::vector<const Row*> wanted; // rows for these slots, in the new order
    for (const Row& row : after)
        if (const auto known = indexBefore.find(static_cast<std::uint32_t>(row.id));
            known != indexBefore.end()) {
            isKept[known->second] = true;
            kept.push_back(known->second);
            wanted.push_back(&row);
        }
    const bool inOrder = std::is_sorted(kept.begin(), kept.end());
    for (std::size_t i = 0; i < before.size(); ++i)
        if (!isKept[i]) removeRow(i);
    if (inOrder)
        for (std::size_t i = 0; i < kept.size(); ++i)
            replaceRow(kept[i], *wanted[i]);
    else
        permute(kept, wanted);

    std::sort(kept.begin(), kept.end());
    std::size_t passed = 0; // kept rows passed
    std::vector<const Row*> added;
    const auto flush = [&] {
        const std::size_t slot = passed > 0 ? kept[passed - 1] : kept.empty() ? 0 : kept.front();
        if (!added.empty())
            insertRows(m_slots.cbegin() + static_cast<std::ptrdiff_t>(slot), passed == 0, added);
        added.clear();
    };
    for (const Row& row : after) {
        if (indexBefore.contains(static_cast<std::uint32_t>(row.id))) {
            flush();
            ++passed;
        } else {
            added.push_back(&row);
        }
    }
    flush();
}

QByteArray Edit::numberAsHere(double value) const {
    QByteArray text = numberText(value);
    if (!m_layout.decimalComma) return text;
    if (!text.contains('.') && !text.contains('e'))
        return text + ",0"; // as many commas as before: see chooseReading
    return text.replace('.', ',');
}

std::vector<Patch> Edit::numberPatches(std::size_t row, const Row& after) const {
    std::vector<Patch> patches;
    const Slot& slot = m_slots[row];
    const auto change = [&](const Token& token, double value) {
        if (token.value != value) patches.push_back({token.span.begin, token.span.end, numberAsHere(value)});
    };
    for (std::size_t i = 0; i < after.coefficients.size(); ++i)
        change(m_layout.numbers[slot.first + i], after.coefficients[i]);
    const Token& last = m_layout.numbers[slot.last];
    if (m_layout.rowLength % 2 == 1) {
        change(last, after.written);
    } else if (m_writesWeights) {
        patches.push_back({last.span.end, last.span.end, ' ' + numberAsHere(after.written)});
    }
    breakLongLine(slot, patches);
    return patches;
}

// A row that stood on one line takes a second one once its numbers need more than other programs read.
void Edit::breakLongLine(const Slot& slot, std::vector<Patch>& patches) const {
    const Token& last = m_layout.numbers[slot.last];
    if (!slot.isOwnLine || m_layout.numbers[slot.first].line != last.line) return;
    const qsizetype before = last.span.end - slot.line.begin;
    qsizetype after = before;
    for (const Patch& patch : patches)
        after += patch.text.size() - (patch.end - patch.begin);
    if (before > m_longestLine || after <= m_longestLine) return;
    const std::size_t second = slot.first + secondLine(slot.last - slot.first + 1);
    patches.push_back({m_layout.numbers[second - 1].span.end, m_layout.numbers[second].span.begin,
                       m_source.lineEnd + m_indent + m_indent});
}

void Edit::replaceRow(std::size_t row, const Row& after) {
    for (Patch& patch : numberPatches(row, after))
        m_patches.push_back(std::move(patch));
}

// Whole lines change places when every row has one; else only the numbers and the text between them.
void Edit::permute(const std::vector<std::size_t>& kept, const std::vector<const Row*>& wanted) {
    const bool wholeLines =
        std::all_of(kept.begin(), kept.end(), [this](std::size_t row) { return m_slots[row].isOwnLine; });
    const auto content = [&](std::size_t row) {
        const Slot& slot = m_slots[row];
        if (wholeLines) {
            const qsizetype last = m_layout.numbers[slot.last].span.begin;
            return Span{slot.line.begin, lineEnd(m_text, last, m_lineEnd)};
        }
        return Span{m_layout.numbers[slot.first].span.begin, m_layout.numbers[slot.last].span.end};
    };
    std::vector<std::size_t> sorted = kept;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        std::vector<Patch> patches = numberPatches(kept[i], *wanted[i]);
        if (sorted[i] == kept[i]) {
            m_patches.insert(m_patches.end(), patches.begin(), patches.end());
            continue;
        }
        const Span from = content(kept[i]);
        for (Patch& patch : patches) {
            patch.begin -= from.begin;
            patch.end -= from.begin;
        }
        const Span to = content(sorted[i]);
        replace(to.begin, to.end, patched(m_text.sliced(from.begin, from.size()), std::move(patches)));
    }
}

void Edit::removeRow(std::size_t row) {
    const Slot& slot = m_slots[row];
    if (slot.isOwnLine) return replace(slot.line.begin, slot.line.end, {});
    const auto& tokens = m_layout.numbers;
    for (std::size_t i = slot.first; i <= slot.last; ++i) {
        const bool hasNext = i + 1 < tokens.size() && tokens[i + 1].line == tokens[i].line;
        replace(tokens[i].span.begin, hasNext ? tokens[i + 1].span.begin : tokens[i].span.end, {});
    }
}

QByteArray Edit::rowText(const Row& row) const {
    QByteArrayList numbers;
    for (const double number : row.coefficients)
        numbers << numberAsHere(number);
    if (m_writesWeights) numbers << numberAsHere(row.written);
    const QByteArray text = numbers.join(' ');
    if (m_indent.size() + text.size() <= m_longestLine) return text;
    const auto second = static_cast<qsizetype>(secondLine(static_cast<std::size_t>(numbers.size())));
    return numbers.first(second).join(' ') + m_source.lineEnd + m_indent + m_indent +
           numbers.sliced(second).join(' ');
}

void Edit::insertRows(const std::vector<Slot>::const_iterator& slot, bool before,
                      const std::vector<const Row*>& rows) {
    const auto& tokens = m_layout.numbers;
    QByteArrayList lines;
    for (const Row* row : rows)
        lines << m_indent + rowText(*row);
    if (slot->isOwnLine) return insertLines(before ? slot->line.begin : slot->line.end, lines);
    if (before) {
        const qsizetype position = tokens[slot->first].span.begin;
        return replace(position, position,
                       lines.join(m_source.lineEnd).trimmed() + m_source.lineEnd + m_indent);
    }
    const bool endsLine =
        slot->last + 1 == tokens.size() || tokens[slot->last + 1].line != tokens[slot->last].line;
    if (endsLine && slot->line.end <= m_layout.block.close) return insertLines(slot->line.end, lines);
    const qsizetype position = tokens[slot->last].span.end;
    replace(position, position, m_source.lineEnd + lines.join(m_source.lineEnd));
}

QByteArray Edit::encoded(const QString& text) const {
    if (m_isUtf8) return text.toUtf8();
    const QByteArray latin1 = text.toLatin1(); // encoding of the surrounding bytes
    return decoded(latin1) == text ? latin1 : text.toUtf8();
}

} // namespace

bool isBare(const EntrySource& source) {
    const auto block = Scanner(source.text, lineEndByteOf(source)).next();
    return !block.has_value();
}

EntrySource withBraces(const EntrySource& bare) {
    EntrySource source = bare;
    source.text = storedName(bare.fractal.name).toUtf8() + " {" + bare.lineEnd + bare.text;
    if (!source.text.endsWith(lineEndByteOf(bare))) source.text += bare.lineEnd;
    source.text += '}' + bare.lineEnd;
    // Numbers without a gap between them are valid only in a bare file.
    const auto reread = parsed(source.text, lineEndByteOf(bare), false);
    if (!reread || !document::isSameSystem(reread->fractal, bare.fractal))
        source.text = writeEntry(bare.fractal, bare.lineEnd);
    return source;
}

QByteArray editedText(const EntrySource& source, const Fractal& fractal) {
    if (fractal == source.fractal) return source.text;
    const Fractal& before = source.fractal;
    const bool bare = isBare(source);
    if (bare && (fractal.name != before.name || fractal.comments != before.comments ||
                 fractal.headerComment != before.headerComment ||
                 metadataComments(fractal) != metadataComments(before)))
        return editedText(withBraces(source), fractal);

    const auto original = parsed(source.text, lineEndByteOf(source), bare);
    const bool canPatch = original && document::dimension(fractal) == document::dimension(before) &&
                          document::dimension(original->fractal) == document::dimension(before);
    const auto isRead = [&](const QByteArray& text) {
        auto reread = parsed(text, lineEndByteOf(source), bare);
        if (reread && bare) reread->fractal.name = before.name; // bare files have no name
        return reread && reread->fractal == expected(fractal, before);
    };
    // True if the entry is marked as one of space, or its rows are recognisable from their lines.
    if (canPatch)
        for (const qsizetype longestLine : {maxLine, std::numeric_limits<qsizetype>::max()}) {
            const QByteArray text = Edit(source, original->layout, fractal, longestLine).text();
            if (isRead(text)) return text;
        }
    return writeEntry(fractal, source.lineEnd);
}

} // namespace io::fractint
