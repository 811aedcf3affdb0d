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
        HeadingRole = Qt::UserRole, // bool: the row is the title of a theme
        ThumbnailStateRole,         // int of Thumbnail::State
        SearchRole,                 // QString: all that a search looks at
        FolderRole,    // QString: the user's folder the theme came from, empty for the bundled ones
        FavouriteRole, // bool; can be set
        RecentRole,    // int: 0 for the entry used last, then 1, …; −1 for those not used lately
        MovesRole,     // bool: the entry has an animation
        SectionRole,   // QString: the theme and its folder, which tell it from themes of the same name
    };

    explicit CollectionModel(Thumbnails* thumbnails, QObject* parent = nullptr); // which must outlive it

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
    QModelIndex indexOf(Thumbnails::Key key) const; // invalid for 0 and for entries that are gone
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
        QString file; // of the theme
        QString theme;
        QString description; // of the theme; for its title only
        QString folder;
        document::Entry entry; // without fractal: the title of a theme
        bool moves = false;
    };

    int placeFor(const QString& folder) const; // behind what is there
    static QString favouriteKey(const Row& row);
    static QString formerKey(const Row& row); // of earlier versions
    bool isFavourite(const Row& row) const;
    QVariant headingData(const Row& row, int role) const;
    QVariant entryData(const Row& row, int role) const;

    Thumbnails* m_thumbnails;
    QList<Row> m_rows;
    QStringList m_folders; // in their order
    QSet<QString> m_favourites;
    QStringList m_recent;
    Thumbnails::Key m_lastKey = 0;
};

} // namespace view
