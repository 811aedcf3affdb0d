// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "widgets/thumbnails.h"

#include <QAbstractListModel>
#include <QHash>

#include <memory>

namespace view {

// The entries of the open file as a list, in their order. Pictures are asked for when a view asks for them
// and not before, so that a long file costs what is in sight. During a gesture the list shows what was before
// it.
class EntriesModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        IdRole = Qt::UserRole, // document::EntryId as uint
        ThumbnailStateRole,    // int of Thumbnail::State
        SubtitleRole,          // QString: number of maps, whether they are placed, or why nothing is shown
        ModifiedRole,          // bool: changed since it was read or saved
        SeverityRole,          // int of document::Problem::Severity; invalid without problems
    };

    // `document` and `thumbnails` must outlive the model.
    EntriesModel(document::Document* document, Thumbnails* thumbnails, QObject* parent = nullptr);
    ~EntriesModel() override;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override; // Qt::EditRole renames

    document::EntryId idAt(const QModelIndex& index) const;
    QModelIndex indexOf(document::EntryId id) const;
    // True while rows follow the document, without a click by the user.
    bool isSyncing() const { return m_syncing; }

signals:
    void refused(const QString& reason); // reason why an edit was not possible

private:
    void follow(const document::Change& change);
    void syncRows();
    void removeVanished(const document::FractalFile& now);
    void reorder(const document::FractalFile& now);
    void insertNew(const document::FractalFile& now);
    void announceDifferences(const document::FractalFile& before);
    QString subtitle(const document::Entry& entry) const;
    QString toolTip(const document::Entry& entry) const;
    QString accessibleText(const document::Entry& entry) const;
    bool isModified(const document::Entry& entry) const;
    void takeSaved();
    std::shared_ptr<const document::Fractal> savedOf(document::EntryId id) const;

    document::Document* m_document;
    Thumbnails* m_thumbnails;
    document::FractalFile m_shown;     // content known to views; follows the document by row operations
    document::FractalFile m_savedFile; // state last read or saved
    // The same by id, once it was asked for.
    mutable QHash<document::EntryId, std::shared_ptr<const document::Fractal>> m_saved;
    bool m_syncing = false;
};

} // namespace view
