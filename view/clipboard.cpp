// SPDX-License-Identifier: MIT
#include "clipboard.h"

#include "io/fractint_reader.h"
#include "io/fractint_writer.h"
#include "io/table_reader.h"

#include <QCoreApplication>
#include <QMimeData>

#include <algorithm>

namespace view {
namespace {

const QString ifsType = QStringLiteral("application/x-fractint-ifs");

bool isReadable(const document::Entry& entry) {
    return document::dimension(*entry.fractal) != 0;
}

document::Entry fresh(document::Fractal fractal) {
    document::Entry entry;
    entry.fractal = std::make_shared<const document::Fractal>(std::move(fractal));
    return entry;
}

// A text without braces may still be a table of numbers.
FoundEntries entryInTable(const QByteArray& text) {
    FoundEntries found;
    const io::Table table = io::readTable(QString::fromUtf8(text));
    found.problems = table.problems;
    if (table.rows.empty() ||
        std::any_of(table.problems.begin(), table.problems.end(), [](const auto& problem) {
            return problem.severity == document::Problem::Severity::Error;
        }))
        return found;
    document::Fractal fractal;
    fractal.name =
        QCoreApplication::translate("view::Clipboard", "pasted", "name of an entry made from a table");
    fractal.system = io::systemOf(table);
    found.entries.append(fresh(std::move(fractal)));
    return found;
}

} // namespace

QByteArray entriesText(const QList<document::Entry>& entries) {
    QByteArray text;
    for (const document::Entry& entry : entries) {
        if (!text.isEmpty() && !text.endsWith('\n')) text += '\n';
        if (isReadable(entry))
            text += io::writeEntry(*entry.fractal);
        else if (entry.source)
            text += entry.source->text;
    }
    return text;
}

std::unique_ptr<QMimeData> entriesMimeData(const QList<document::Entry>& entries) {
    const QByteArray text = entriesText(entries);
    auto mimeData = std::make_unique<QMimeData>();
    mimeData->setData(ifsType, text);
    mimeData->setText(QString::fromUtf8(text));
    return mimeData;
}

FoundEntries entriesIn(const QByteArray& text) {
    const document::FractalFile file = io::readFractint(text);
    if (file.entries.isEmpty())
        if (FoundEntries table = entryInTable(text); !table.entries.isEmpty()) return table;
    FoundEntries found;
    found.problems = file.problems;
    for (const document::Entry& read : file.entries) {
        document::Entry entry = read;
        if (isReadable(entry)) entry.source.reset();
        found.problems += entry.problems;
        found.entries.append(entry);
    }
    return found;
}

FoundEntries entriesIn(const QMimeData& mimeData) {
    if (mimeData.hasFormat(ifsType)) return entriesIn(mimeData.data(ifsType));
    return entriesIn(mimeData.text().toUtf8());
}

bool mayHoldEntries(const QMimeData& mimeData) {
    // The text of files is their path: opening them is not pasting.
    return mimeData.hasFormat(ifsType) || (mimeData.hasText() && !mimeData.hasUrls());
}

} // namespace view
