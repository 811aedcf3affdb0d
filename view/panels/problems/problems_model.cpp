// SPDX-License-Identifier: MIT
#include "panels/problems/problems_model.h"

#include "widgets/icon.h"
#include "widgets/text/tooltip_text.h"

#include <algorithm>

namespace view {
namespace {

QString severityName(document::Problem::Severity severity) {
    return severity == document::Problem::Severity::Error ? ProblemsModel::tr("Error")
                                                          : ProblemsModel::tr("Warning");
}

QString location(const document::Problem& problem) {
    return problem.line > 0 ? QStringLiteral("%1:%2").arg(problem.line).arg(problem.column) : QString();
}

} // namespace

ProblemsModel::ProblemsModel(document::Document* document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_rows(collect()) {
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        if (change.parts & (document::Change::File | document::Change::Entries | document::Change::Name))
            refresh();
    });
}

int ProblemsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ProblemsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ProblemsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {}; // asked by views without a current row
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const document::Problem& problem = m_rows[index.row()].problem;
    const bool error = problem.severity == document::Problem::Severity::Error;
    switch (role) {
    case Qt::DisplayRole:
        switch (index.column()) {
        case Place:
            return location(problem);
        case EntryName:
            return problem.entry;
        case Message:
            return problem.message;
        default:
            return {};
        }
    case Qt::DecorationRole:
        if (index.column() == Place) return icon(error ? QStringLiteral("error") : QStringLiteral("warning"));
        return {};
    case Qt::ToolTipRole:
        return tooltipText(index.column() == EntryName ? problem.entry : problem.message);
    case Qt::AccessibleTextRole:
        if (index.column() == Place)
            return QStringLiteral("%1 %2").arg(severityName(problem.severity), location(problem)).trimmed();
        return data(index, Qt::DisplayRole);
    default:
        return {};
    }
}

QVariant ProblemsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case Place:
        return tr("Line:column");
    case EntryName:
        return tr("Entry");
    case Message:
        return tr("Problem");
    default:
        return {};
    }
}

document::EntryId ProblemsModel::entryAt(int row) const {
    return m_rows[row].entry;
}

QList<ProblemsModel::Row> ProblemsModel::collect() const {
    qsizetype count = m_document->file().problems.size();
    for (const document::Entry& entry : m_document->file().entries)
        count += entry.problems.size();
    QList<Row> rows;
    rows.reserve(count); // up to one for each entry of a large file
    for (const document::Problem& problem : m_document->file().problems)
        rows.append({document::EntryId::None, problem});
    for (const document::Entry& entry : m_document->file().entries)
        for (const document::Problem& problem : entry.problems) {
            rows.append({entry.id, problem});
            rows.last().problem.entry = entry.fractal->name;
        }
    const auto isBefore = [](const Row& a, const Row& b) {
        return std::pair(a.problem.line, a.problem.column) < std::pair(b.problem.line, b.problem.column);
    };
    if (!std::is_sorted(rows.begin(), rows.end(), isBefore))
        std::stable_sort(rows.begin(), rows.end(), isBefore);
    return rows;
}

int ProblemsModel::attentionCount() const {
    return int(std::ranges::count_if(
        m_rows, [](const Row& row) { return document::callsForAttention(row.problem); }));
}

void ProblemsModel::refresh() {
    QList<Row> rows = collect();
    if (rows == m_rows) return;
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

} // namespace view
