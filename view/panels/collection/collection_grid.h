// SPDX-License-Identifier: MIT
#pragma once

#include "panels/collection/collection_filter.h"

#include <QListView>

class QLabel;

namespace view {

class CollectionDelegate;

// The pictures of a collection under the titles of their themes. It says why there is nothing to see.
class CollectionGrid : public QListView {
    Q_OBJECT

public:
    // Pictures of so many device-independent pixels, of a CollectionModel or a proxy of one.
    CollectionGrid(QAbstractItemModel* collection, int pictureSide, QWidget* parent = nullptr);

    CollectionDelegate* delegate() const { return m_delegate; }
    QModelIndex current() const; // index in the collection; invalid: none
    void setPart(CollectionFilter::Part part, const QString& section = {});

public slots:
    void search(const QString& words); // also selects the first result, so that Enter opens it

private:
    void chooseFirst();
    void sayWhyEmpty();

    CollectionFilter* m_filtered;
    CollectionDelegate* m_delegate;
    QLabel* m_whyEmpty;
    QString m_words;
};

} // namespace view
