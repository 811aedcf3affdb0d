// SPDX-License-Identifier: MIT
#pragma once

#include <QSortFilterProxyModel>

namespace view {

// Entries of a part of the collection that contain every word searched for, and the titles of the themes that
// have such entries. Rows come and go all at once: one by one, long lists would take long.
class CollectionFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    enum class Part {
        All,
        Favourites,
        Recent, // newest first, without titles
        Theme,  // single theme without its title
    };

    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setWords(const QString& words);
    // `section`: CollectionModel::SectionRole of a theme.
    void setPart(Part part, const QString& section = {});
    Part part() const { return m_part; }
    void setSourceModel(QAbstractItemModel* model) override;

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    bool hasTitles() const { return m_part == Part::All || m_part == Part::Favourites; }
    bool isWanted(const QModelIndex& entry) const;
    bool isInPart(const QModelIndex& entry) const;

    QStringList m_words;
    Part m_part = Part::All;
    QString m_section;
};

} // namespace view
