// SPDX-License-Identifier: MIT
#include "panels/collection/collection_pictures.h"

#include "panels/collection/collection_model.h"
#include "widgets/thumbnails.h"

namespace view {

CollectionPictures::CollectionPictures(CollectionModel* collection, Thumbnails* thumbnails, QObject* parent)
    : QIdentityProxyModel(parent), m_collection(collection), m_thumbnails(thumbnails) {
    setSourceModel(collection);
    connect(thumbnails, &Thumbnails::ready, this, [this](quint64 key) {
        const QModelIndex changed = mapFromSource(m_collection->indexOf(key));
        if (changed.isValid())
            emit dataChanged(changed, changed, {Qt::DecorationRole, CollectionModel::ThumbnailStateRole});
    });
}

QVariant CollectionPictures::data(const QModelIndex& index, int role) const {
    if (role != Qt::DecorationRole && role != CollectionModel::ThumbnailStateRole)
        return QIdentityProxyModel::data(index, role);
    const QModelIndex entry = mapToSource(index);
    const auto fractal = m_collection->fractalAt(entry);
    if (!fractal) return {};
    const Thumbnail picture = m_thumbnails->thumbnail(m_collection->keyAt(entry), fractal);
    if (role == Qt::DecorationRole) return picture.pixmap;
    return static_cast<int>(picture.state);
}

} // namespace view
