// SPDX-License-Identifier: MIT
#include "panels/entries/entries_model.h"

#include "document/edits/cage/placements.h"
#include "document/edits/entries_edits.h"
#include "document/tops/partner_names.h"
#include "io/file/background.h"

#include <QScopedValueRollback>
#include <QSet>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace view {
namespace {

using document::Entry;
using document::EntryId;
using document::FractalFile;

std::optional<document::Problem::Severity> worst(const document::Problems& problems) {
    using enum document::Problem::Severity;
    auto severity = Remark;
    for (const document::Problem& problem : problems)
        severity = std::max(severity, problem.severity);
    return severity == Remark ? std::nullopt : std::optional(severity);
}

std::size_t mapCount(const document::Fractal& fractal) {
    if (const auto* plane = document::system2(fractal)) return plane->maps.size();
    if (const auto* space = document::system3(fractal)) return space->maps.size();
    return 0;
}

bool shownAlike(const Entry& a, const Entry& b) {
    return a.fractal == b.fractal && a.source == b.source && a.problems == b.problems;
}

// Returns true if the entries of `part` are in `whole`, too, in the same order.
bool isPartOf(const FractalFile& part, const FractalFile& whole) {
    auto entry = part.entries.begin();
    for (auto other = whole.entries.begin(); entry != part.entries.end() && other != whole.entries.end();
         ++other)
        if (entry->id == other->id) ++entry;
    return entry == part.entries.end();
}

} // namespace

EntriesModel::EntriesModel(document::Document* document, Thumbnails* thumbnails, QObject* parent)
    : QAbstractListModel(parent), m_document(document), m_thumbnails(thumbnails), m_shown(document->file()) {
    connect(document, &document::Document::changed, this, &EntriesModel::follow);
    takeSaved();
    connect(document->undoStack(), &QUndoStack::cleanChanged, this, [this](bool clean) {
        if (clean) takeSaved();
        if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1), {ModifiedRole});
    });
    connect(thumbnails, &Thumbnails::ready, this, [this](quint64 key) {
        if (const QModelIndex row = indexOf(static_cast<EntryId>(key)); row.isValid())
            emit dataChanged(row, row, {Qt::DecorationRole, ThumbnailStateRole, SubtitleRole});
    });
}

EntriesModel::~EntriesModel() {
    io::freeInBackground(std::move(m_shown));
}

int EntriesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_shown.entries.size());
}

QVariant EntriesModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {}; // asked by views without a current row
    if (!checkIndex(index, CheckIndexOption::ParentIsInvalid)) return {};
    const Entry& entry = m_shown.entries.at(index.row());
    const auto key = static_cast<Thumbnails::Key>(entry.id);
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return entry.fractal->name;
    case Qt::DecorationRole:
        return m_thumbnails->thumbnail(key, entry.fractal).pixmap;
    case Qt::ToolTipRole:
        return toolTip(entry);
    case Qt::AccessibleTextRole:
        return accessibleText(entry);
    case IdRole:
        return static_cast<uint>(entry.id);
    case ThumbnailStateRole:
        return static_cast<int>(m_thumbnails->thumbnail(key, entry.fractal).state);
    case SubtitleRole:
        return subtitle(entry);
    case ModifiedRole:
        return isModified(entry);
    case SeverityRole:
        if (const auto severity = worst(entry.problems)) return static_cast<int>(*severity);
        return {};
    default:
        return {};
    }
}

Qt::ItemFlags EntriesModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::ItemIsDropEnabled;
    const Qt::ItemFlags always =
        Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled | Qt::ItemNeverHasChildren;
    const bool readable = document::dimension(*m_shown.entries.at(index.row()).fractal) != 0;
    return readable ? always | Qt::ItemIsEditable : always;
}

bool EntriesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) return false;
    const Entry entry = m_shown.entries.at(index.row());
    const QString name = value.toString().trimmed();
    if (name == entry.fractal->name) return true;
    if (const auto problem = nameProblem(m_document->file(), entry.id, name)) {
        emit refused(*problem);
        return false;
    }
    m_document->editFile(tr("Rename “%1” to “%2”").arg(entry.fractal->name, name),
                         document::renamed(m_document->file(), entry.id, name));
    return true;
}

EntryId EntriesModel::idAt(const QModelIndex& index) const {
    return index.isValid() ? m_shown.entries.at(index.row()).id : EntryId::None;
}

QModelIndex EntriesModel::indexOf(EntryId id) const {
    const qsizetype row = document::indexOf(m_shown, id);
    return row < 0 ? QModelIndex() : index(static_cast<int>(row));
}

void EntriesModel::follow(const document::Change& change) {
    using document::Change;
    const bool isTimeOnly = change.parts & Change::Time && !(change.parts & Change::File);
    if (change.live || isTimeOnly) return; // thumbnails do not move
    if (change.parts & document::Change::File) {
        const QScopedValueRollback<bool> guard(m_syncing, true);
        beginResetModel();
        m_shown = m_document->file();
        takeSaved();
        m_thumbnails->clear();
        endResetModel();
        return;
    }
    syncRows();
}

void EntriesModel::syncRows() {
    const QScopedValueRollback<bool> guard(m_syncing, true);
    const FractalFile before = m_shown;
    const FractalFile now = m_document->file();
    if (!isPartOf(before, now)) {
        removeVanished(now);
        if (!isPartOf(m_shown, now)) reorder(now);
    }
    insertNew(now);
    m_shown = now;
    announceDifferences(before);
}

void EntriesModel::removeVanished(const FractalFile& now) {
    QSet<EntryId> remaining;
    for (const Entry& entry : now.entries)
        remaining.insert(entry.id);
    for (int last = rowCount() - 1; last >= 0; --last) {
        if (remaining.contains(m_shown.entries.at(last).id)) continue;
        int first = last;
        while (first > 0 && !remaining.contains(m_shown.entries.at(first - 1).id))
            --first;
        beginRemoveRows({}, first, last);
        m_shown.entries.remove(first, last - first + 1);
        endRemoveRows();
        last = first;
    }
}

void EntriesModel::reorder(const FractalFile& now) {
    QHash<EntryId, qsizetype> indices;
    for (qsizetype index = 0; index < now.entries.size(); ++index)
        indices.insert(now.entries[index].id, index);
    std::vector<std::pair<qsizetype, int>> order; // index in the file, present row
    for (int row = 0; row < rowCount(); ++row)
        order.emplace_back(indices.value(m_shown.entries.at(row).id), row);
    emit layoutAboutToBeChanged({}, VerticalSortHint);
    std::sort(order.begin(), order.end());
    QList<Entry> sorted;
    std::vector<int> rows(order.size()); // new rows by present row
    for (const auto& [index, row] : order) {
        rows[static_cast<std::size_t>(row)] = static_cast<int>(sorted.size());
        sorted.append(m_shown.entries.at(row));
    }
    const QModelIndexList from = persistentIndexList();
    QModelIndexList to;
    for (const QModelIndex& index : from)
        to.append(this->index(rows[static_cast<std::size_t>(index.row())]));
    m_shown.entries = sorted;
    changePersistentIndexList(from, to);
    emit layoutChanged({}, VerticalSortHint);
}

// The rows shown are now some of the rows to be shown, in the same order.
void EntriesModel::insertNew(const FractalFile& now) {
    for (int first = 0; first < now.entries.size(); ++first) {
        const EntryId next = first < rowCount() ? m_shown.entries.at(first).id : EntryId::None;
        if (next == now.entries[first].id) continue;
        int last = first;
        while (last + 1 < now.entries.size() && now.entries[last + 1].id != next)
            ++last;
        beginInsertRows({}, first, last);
        if (now.entries.size() - rowCount() == last - first + 1) { // all rows
            m_shown.entries = now.entries;
        } else {
            const QList<Entry> behind = m_shown.entries.mid(first);
            m_shown.entries.resize(first);
            m_shown.entries += now.entries.mid(first, last - first + 1);
            m_shown.entries += behind;
        }
        endInsertRows();
        first = last;
    }
}

void EntriesModel::announceDifferences(const FractalFile& before) {
    const FractalFile now = m_shown;
    // Guess: usually the next entry was also shown next before.
    const Entry* next = before.entries.constData();
    const Entry* const end = next + before.entries.size();
    QHash<EntryId, const Entry*> known; // fallback for other orders
    for (int row = 0; row < now.entries.size(); ++row) {
        const Entry& entry = now.entries[row];
        if (next == end || next->id != entry.id) {
            if (known.isEmpty())
                for (const Entry& each : before.entries)
                    known.insert(each.id, &each);
            const Entry* former = known.value(entry.id);
            if (!former) continue; // new entry
            next = former;
        }
        if (!shownAlike(*next, entry)) emit dataChanged(index(row), index(row));
        ++next;
    }
}

QString EntriesModel::subtitle(const Entry& entry) const {
    const int dimension = document::dimension(*entry.fractal);
    if (dimension == 0) return tr("could not be read");
    const auto maps = static_cast<int>(mapCount(*entry.fractal));
    const QString number = maps == 1 ? tr("1 map") : tr("%n maps", nullptr, maps);
    const QString count = dimension == 3 ? tr("%1 in space").arg(number) : number;
    const auto key = static_cast<Thumbnails::Key>(entry.id);
    const bool nothing = m_thumbnails->thumbnail(key, entry.fractal).state == Thumbnail::State::NoAttractor;
    if (nothing) return tr("%1, no attractor").arg(count);
    return document::isPlaced(*entry.fractal) ? tr("%1, placed").arg(count) : count;
}

QString EntriesModel::toolTip(const Entry& entry) const {
    QStringList lines{QStringLiteral("<b>%1</b>").arg(entry.fractal->name.toHtmlEscaped())};
    if (!entry.fractal->headerComment.trimmed().isEmpty())
        lines.append(entry.fractal->headerComment.trimmed().toHtmlEscaped());
    lines.append(subtitle(entry).toHtmlEscaped());
    for (const document::Problem& problem : entry.problems) {
        const QString where =
            problem.line > 0 ? tr("Line %1, column %2: ").arg(problem.line).arg(problem.column) : QString();
        lines.append((where + problem.message).toHtmlEscaped());
    }
    return lines.join(QStringLiteral("<br>"));
}

QString EntriesModel::accessibleText(const Entry& entry) const {
    QStringList parts{entry.fractal->name, subtitle(entry)};
    if (isModified(entry)) parts.append(tr("modified"));
    if (const auto severity = worst(entry.problems))
        parts.append(*severity == document::Problem::Severity::Error ? tr("has errors") : tr("has warnings"));
    return parts.join(QStringLiteral(", "));
}

bool EntriesModel::isModified(const Entry& entry) const {
    if (!m_document->isModified()) return false;
    const auto saved = savedOf(entry.id);
    return !saved || (saved != entry.fractal && *saved != *entry.fractal);
}

void EntriesModel::takeSaved() {
    m_savedFile = m_document->file();
    m_saved.clear();
}

std::shared_ptr<const document::Fractal> EntriesModel::savedOf(EntryId id) const {
    if (m_saved.isEmpty())
        for (const Entry& entry : m_savedFile.entries)
            m_saved.insert(entry.id, entry.fractal);
    return m_saved.value(id);
}

} // namespace view
