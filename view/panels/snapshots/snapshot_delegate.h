// SPDX-License-Identifier: MIT
#pragma once

#include <QStyledItemDelegate>

namespace view {

// A snapshot in the strip: its picture with its name below. The picture that the canvas shows has a frame,
// and the one to compare with carries a B.
class SnapshotDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int pictureSide = 72;
    enum Role {
        KeyRole = Qt::UserRole,
        StateRole,  // Thumbnail::State
        ShownRole,  // bool: on the canvas
        MarkedRole, // bool: the one to compare with
    };

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
};

} // namespace view
