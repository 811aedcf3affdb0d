// SPDX-License-Identifier: MIT
#include "panels/collection/collection_grid.h"

#include "panels/collection/collection_delegate.h"
#include "panels/collection/collection_model.h"

#include <QLabel>
#include <QVBoxLayout>

namespace view {

namespace {

// Pixels: on small screens with large letters the canvas needs the rest.
constexpr int lowest = 64;

} // namespace

CollectionGrid::CollectionGrid(QAbstractItemModel* collection, int pictureSide, QWidget* parent)
    : QListView(parent),
      m_filtered(new CollectionFilter(this)),
      m_delegate(new CollectionDelegate(pictureSide, this)),
      m_whyEmpty(new QLabel(viewport())) {
    m_filtered->setSourceModel(collection);
    setModel(m_filtered);
    setItemDelegate(m_delegate);
    setAccessibleName(tr("Fractals of the collection"));
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setMinimumHeight(lowest);
    setResizeMode(QListView::Adjust);
    setSpacing(2);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setContextMenuPolicy(Qt::CustomContextMenu);
    m_whyEmpty->setAlignment(Qt::AlignCenter);
    m_whyEmpty->setWordWrap(true);
    m_whyEmpty->setEnabled(false); // same look as a placeholder
    m_whyEmpty->hide();
    auto* cover = new QVBoxLayout(viewport());
    cover->addWidget(m_whyEmpty);
    connect(m_filtered, &QAbstractItemModel::rowsInserted, this, &CollectionGrid::sayWhyEmpty);
    connect(m_filtered, &QAbstractItemModel::rowsRemoved, this, &CollectionGrid::sayWhyEmpty);
    connect(m_filtered, &QAbstractItemModel::layoutChanged, this, &CollectionGrid::sayWhyEmpty);
}

QModelIndex CollectionGrid::current() const {
    return m_filtered->mapToSource(currentIndex());
}

void CollectionGrid::setPart(CollectionFilter::Part part, const QString& section) {
    m_filtered->setPart(part, section);
    sayWhyEmpty();
}

void CollectionGrid::search(const QString& words) {
    m_words = words;
    m_filtered->setWords(words);
    sayWhyEmpty();
    if (!words.isEmpty()) chooseFirst();
}

void CollectionGrid::chooseFirst() {
    for (int row = 0; row < m_filtered->rowCount(); ++row) {
        const QModelIndex index = m_filtered->index(row, 0);
        if (index.flags() & Qt::ItemIsSelectable) return setCurrentIndex(index);
    }
}

void CollectionGrid::sayWhyEmpty() {
    using Part = CollectionFilter::Part;
    m_whyEmpty->setVisible(m_filtered->rowCount() == 0);
    m_whyEmpty->setText(!m_words.isEmpty() ? tr("No matches")
                        : m_filtered->part() == Part::Favourites
                            ? tr("No favourites yet. Select a fractal and press Ctrl+D.")
                        : m_filtered->part() == Part::Recent ? tr("Fractals that you use appear here.")
                                                             : QString());
}

} // namespace view
