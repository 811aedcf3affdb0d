// SPDX-License-Identifier: MIT
#pragma once

#include <QStyledItemDelegate>

namespace view {

// A command on one line of a list: where it is found and its name, and at the right edge its keys. What is
// too long for the list loses its beginning: the name of the command is at the end.
class CommandDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    enum Role { NameRole = Qt::UserRole + 1, KeysRole }; // both also in the item's text, for screen readers

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& given, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace view
