// SPDX-License-Identifier: MIT
#pragma once

#include <QIdentityProxyModel>

namespace view {

class CollectionModel;
class Thumbnails;

// The same collection with pictures of another size.
class CollectionPictures : public QIdentityProxyModel {
    Q_OBJECT

public:
    CollectionPictures(CollectionModel* collection, Thumbnails* thumbnails, QObject* parent = nullptr);

    QVariant data(const QModelIndex& index, int role) const override;

private:
    CollectionModel* m_collection;
    Thumbnails* m_thumbnails;
};

} // namespace view
