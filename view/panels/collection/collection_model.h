// SPDX-License-Identifier: MIT
#pragma once

#include "io/collection_source.h"
#include "widgets/thumbnails.h"

#include <QAbstractListModel>
#include <QSet>

namespace view {

// A collection as one list: the title of each theme, followed by its readable entries.
class CollectionModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        HeadingRole = Qt::UserRole, // bool: title of a theme
        ThumbnailStateRole,         // int of Thumbnail::State
        SearchRole,                 // QString: searchable text
        FolderRole,                 // QString: user's folder of the theme; empty for the bundled ones
        FavouriteRole,              // bool; editable
        RecentRole,                 // int: 0 for the entry used last, then 1, …; −1 for all others
        MovesRole,                  // bool: has an animation
        SectionRole,                // QString: theme and folder, unique even among themes of the same name
    };

    // `thumbnails` must outlive the model.
    explicit CollectionModel(Thumbnails* thumbnails, QObject* parent = nullptr);

    // Themes of different folders, which may come in any order, stand in the order in which their folders
    // were expected.
    void expect(const QString& folder);
    void append(const io::CollectionTheme& theme, const QString& folder = {});
    void removeFolder(const QString& folder);

    // The user's favourites, by folder, theme and name.
    void setFavourites(const QStringList& favourites);
    QStringList favourites() const { return {m_favourites.begin(), m_favourites.end()}; }
    // Entries used last, the newest first, named like favourites.
    void setRecent(const QStringList& recent);
    const QStringList& recent() const { return m_recent; }
    void addRecent(const QModelIndex& index);

    // nullptr for the title of a theme.
    std::shared_ptr<const document::Fractal> fractalAt(const QModelIndex& index) const;
    // Number of an entry, unique while the entry is there; 0 for titles.
    Thumbnails::Key keyAt(const QModelIndex& index) const;
    QModelIndex indexOf(Thumbnails::Key key) const; // invalid for 0 and for removed entries
    // The fractal, followed by the partner of its fractal transformation, with the full path of the picture.
    QList<document::Fractal> withPartnerAt(const QModelIndex& index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;

private:
    struct Row {
        Thumbnails::Key key = 0;
        QString file; // file of the theme
        QString theme;
        QString description; // description of the theme; set in its title only
        QString folder;
        document::Entry entry; // no fractal: title of a theme
        bool moves = false;
    };

    int placeFor(const QString& folder) const; // row behind the existing ones
    static QString favouriteKey(const Row& row);
    static QString formerKey(const Row& row); // key in earlier versions
    bool isFavourite(const Row& row) const;
    QVariant headingData(const Row& row, int role) const;
    QVariant entryData(const Row& row, int role) const;

    Thumbnails* m_thumbnails;
    QList<Row> m_rows;
    QStringList m_folders; // folders in their order
    QSet<QString> m_favourites;
    QStringList m_recent;
    Thumbnails::Key m_lastKey = 0;
};

} // namespace view
