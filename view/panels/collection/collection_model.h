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

    // nullptr for the title of a theme.
    std::shared_ptr<const document::Fractal> fractalAt(const QModelIndex& index) const;
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
        QString theme;
        QString description; // of the theme; for its title only
        QString folder;
        document::Entry entry; // without fractal: the title of a theme
    };

    int placeFor(const QString& folder) const; // behind what is there
    static QString favouriteKey(const Row& row);
    QVariant headingData(const Row& row, int role) const;
    QVariant entryData(const Row& row, int role) const;

    Thumbnails* m_thumbnails;
    QList<Row> m_rows;
    QStringList m_folders; // in their order
    QSet<QString> m_favourites;
    Thumbnails::Key m_lastKey = 0;
};

} // namespace view
