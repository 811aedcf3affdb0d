// SPDX-License-Identifier: MIT
#include "panels/collection/collection_model.h"

#include "desktop/clipboard.h"
#include "document/moments/animated_fractal.h"
#include "document/text/user_comments.h"
#include "document/tops/kept_theft.h"
#include "document/tops/partner_names.h"
#include "io/file/background.h"
#include "widgets/text/tooltip_text.h"

#include <QMimeData>

#include <algorithm>
#include <memory>
#include <utility>

namespace view {
namespace {

constexpr qsizetype mostRecent = 24; // two screens of small pictures

bool isReadable(const document::Entry& entry) {
    return document::dimension(*entry.fractal) != 0;
}

// The title without the part behind a colon: there is room for a few words below a picture.
QString shortTitle(const QString& title) {
    return title.section(QLatin1String(": "), 0, 0).trimmed(); // removes the blank before a French colon
}

// In the user's language for the bundled files, which lie in no folder.
QString titleOf(const document::Fractal& fractal, const QString& folder) {
    const QString title = fractal.headerComment.trimmed();
    if (title.isEmpty()) return fractal.name;
    return folder.isEmpty() ? io::bundledTitle(title) : title;
}

QString toolTip(const document::Fractal& fractal, const QString& title, const QString& theme) {
    QStringList comments;
    for (const QString& comment : document::userComments(fractal.comments))
        comments.append(comment.trimmed());
    QString text = QStringLiteral("<b>%1</b> (%2)").arg(title.toHtmlEscaped(), fractal.name.toHtmlEscaped());
    if (!comments.isEmpty()) text += QStringLiteral("<br>") + comments.join(QLatin1Char(' ')).toHtmlEscaped();
    return text + QStringLiteral("<br><i>%1</i>").arg(theme.toHtmlEscaped());
}

} // namespace

CollectionModel::CollectionModel(Thumbnails* thumbnails, QObject* parent)
    : QAbstractListModel(parent), m_thumbnails(thumbnails) {
    connect(thumbnails, &Thumbnails::ready, this, [this](quint64 key) {
        const QModelIndex changed = indexOf(key);
        if (changed.isValid()) emit dataChanged(changed, changed, {Qt::DecorationRole, ThumbnailStateRole});
    });
}

void CollectionModel::expect(const QString& folder) {
    if (!m_folders.contains(folder)) m_folders.append(folder);
}

int CollectionModel::placeFor(const QString& folder) const {
    const auto order = m_folders.indexOf(folder);
    const auto later =
        std::ranges::find_if(m_rows, [&](const Row& row) { return m_folders.indexOf(row.folder) > order; });
    return int(later - m_rows.begin());
}

void CollectionModel::append(const io::CollectionTheme& theme, const QString& folder) {
    QList<Row> rows{{0, theme.file, theme.title, theme.description, folder, {}, false}};
    for (const document::Entry& entry : theme.entries)
        if (isReadable(entry))
            rows.append({++m_lastKey,
                         theme.file,
                         theme.title,
                         {},
                         folder,
                         entry,
                         document::animationFacts(*entry.fractal).has_value()});
    expect(folder);
    const int first = placeFor(folder);
    beginInsertRows({}, first, first + static_cast<int>(rows.size()) - 1);
    m_rows = m_rows.mid(0, first) + rows + m_rows.mid(first);
    endInsertRows();
}

void CollectionModel::removeFolder(const QString& folder) {
    m_folders.removeAll(folder);
    for (int row = rowCount() - 1; row >= 0; --row) {
        if (m_rows[row].folder != folder) continue;
        const int last = row;
        while (row > 0 && m_rows[row - 1].folder == folder)
            --row;
        beginRemoveRows({}, row, last);
        io::freeInBackground(m_rows.mid(row, last - row + 1));
        m_rows.remove(row, last - row + 1);
        endRemoveRows();
    }
}

std::shared_ptr<const document::Fractal> CollectionModel::fractalAt(const QModelIndex& index) const {
    return index.isValid() ? m_rows[index.row()].entry.fractal : nullptr;
}

Thumbnails::Key CollectionModel::keyAt(const QModelIndex& index) const {
    return index.isValid() ? m_rows[index.row()].key : 0;
}

QModelIndex CollectionModel::indexOf(Thumbnails::Key key) const {
    const auto row = std::ranges::find(m_rows, key, &Row::key);
    return key == 0 || row == m_rows.end() ? QModelIndex() : index(int(row - m_rows.begin()));
}

QList<document::Fractal> CollectionModel::withPartnerAt(const QModelIndex& index) const {
    const auto chosen = fractalAt(index);
    if (!chosen) return {};
    const Row& row = m_rows[index.row()];
    QList<document::Fractal> fractals{document::withPictureFrom(*chosen, row.folder)};
    const auto theft = document::keptTheft(*chosen);
    if (!theft) return fractals;
    const auto partner = std::ranges::find_if(m_rows, [&](const Row& other) {
        return other.theme == row.theme && other.folder == row.folder && other.entry.fractal &&
               other.entry.fractal->name.compare(theft->partner, Qt::CaseInsensitive) == 0;
    });
    if (partner != m_rows.end()) fractals << document::withPictureFrom(*partner->entry.fractal, row.folder);
    return fractals;
}

int CollectionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QVariant CollectionModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {}; // asked by views without a current row
    if (!checkIndex(index, CheckIndexOption::ParentIsInvalid)) return {};
    const Row& row = m_rows[index.row()];
    if (role == FolderRole) return row.folder;
    if (role == SectionRole) return QString(row.folder + u'|' + row.theme);
    return row.entry.fractal ? entryData(row, role) : headingData(row, role);
}

bool CollectionModel::isFavourite(const Row& row) const {
    if (m_favourites.contains(favouriteKey(row))) return true;
    return m_favourites.contains(formerKey(row));
}

// By the title of the theme, which is another one in another language.
QString CollectionModel::formerKey(const Row& row) {
    return QStringList{row.folder, row.theme, row.entry.fractal->name}.join(QLatin1Char('|'));
}

QString CollectionModel::favouriteKey(const Row& row) {
    return QStringList{row.folder, row.file, row.entry.fractal->name}.join(QLatin1Char('|'));
}

void CollectionModel::setFavourites(const QStringList& favourites) {
    m_favourites = {favourites.begin(), favourites.end()};
    if (!m_rows.isEmpty()) emit dataChanged(index(0), index(rowCount() - 1), {FavouriteRole});
}

bool CollectionModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != FavouriteRole || !fractalAt(index)) return false;
    const Row& row = m_rows[index.row()];
    m_favourites.remove(formerKey(row));
    if (value.toBool())
        m_favourites.insert(favouriteKey(row));
    else
        m_favourites.remove(favouriteKey(row));
    emit dataChanged(index, index, {FavouriteRole});
    return true;
}

void CollectionModel::setRecent(const QStringList& recent) {
    m_recent = recent.first(std::min(recent.size(), mostRecent));
    if (!m_rows.isEmpty()) emit dataChanged(index(0), index(rowCount() - 1), {RecentRole});
}

void CollectionModel::addRecent(const QModelIndex& index) {
    if (!fractalAt(index)) return;
    QStringList recent = m_recent;
    const QString key = favouriteKey(m_rows[index.row()]);
    recent.removeAll(key);
    recent.prepend(key);
    setRecent(recent);
}

QVariant CollectionModel::headingData(const Row& row, int role) const {
    switch (role) {
    case Qt::DisplayRole:
        return row.theme;
    case Qt::ToolTipRole:
        return tooltipText(row.description);
    case Qt::AccessibleTextRole:
        return tr("Theme: %1").arg(row.theme);
    case Qt::AccessibleDescriptionRole:
        return row.description;
    case HeadingRole:
        return true;
    default:
        return {};
    }
}

QVariant CollectionModel::entryData(const Row& row, int role) const {
    const document::Fractal& fractal = *row.entry.fractal;
    const auto title = [&] { return titleOf(fractal, row.folder); };
    switch (role) {
    case Qt::DisplayRole:
        return shortTitle(title());
    case Qt::ToolTipRole:
        return toolTip(fractal, title(), row.theme);
    case Qt::AccessibleTextRole:
        return isFavourite(row) ? tr("%1, from %2, a favourite").arg(title(), row.theme)
                                : tr("%1, from %2").arg(title(), row.theme);
    case Qt::AccessibleDescriptionRole:
        return fractal.comments.join(QLatin1Char(' ')).simplified();
    case Qt::DecorationRole:
        return m_thumbnails->thumbnail(row.key, row.entry.fractal).pixmap;
    case ThumbnailStateRole:
        return static_cast<int>(m_thumbnails->thumbnail(row.key, row.entry.fractal).state);
    case HeadingRole:
        return false;
    case FavouriteRole:
        return isFavourite(row);
    case RecentRole:
        return int(m_recent.indexOf(favouriteKey(row)));
    case MovesRole:
        return row.moves;
    case SearchRole: {
        QStringList words{fractal.name, fractal.headerComment, title(), row.theme};
        if (document::space(fractal)) words << tr("solid 3D space", "words of a search");
        if (row.moves) words << tr("moving animation motion", "words of a search");
        return (words + fractal.comments).join(QLatin1Char('\n'));
    }
    default:
        return {};
    }
}

Qt::ItemFlags CollectionModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    if (!fractalAt(index)) return Qt::ItemNeverHasChildren; // titles are neither selectable nor stepped on
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled | Qt::ItemNeverHasChildren;
}

QStringList CollectionModel::mimeTypes() const {
    return {QStringLiteral("text/plain")};
}

QMimeData* CollectionModel::mimeData(const QModelIndexList& indexes) const {
    QList<document::Entry> entries;
    for (const QModelIndex& index : indexes)
        for (document::Fractal& fractal : withPartnerAt(index)) {
            entries.append(document::Entry());
            entries.last().fractal = std::make_shared<const document::Fractal>(std::move(fractal));
        }
    return entriesMimeData(entries).release();
}

} // namespace view
