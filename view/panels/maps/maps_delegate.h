// SPDX-License-Identifier: MIT
#pragma once

#include "panels/maps/maps_model.h"

#include <QStyledItemDelegate>

namespace view {

// Paints numbers with their decimal points in one line, colours as swatches, and marks what does not
// contract. Typing in a cell is live; a text that is no number stays in its editor and is refused there.
class MapsDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    MapsDelegate(MapsModel* model, QObject* parent);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
    void destroyEditor(QWidget* editor, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

signals:
    void colourRequested(const QModelIndex& index);
    void refused(const QString& reason) const; // an edit was left with a text that is no number

protected:
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;

private:
    MapsModel* m_model;
};

// A warning sign in the text's height; drawn, so that it looks the same with every font.
void paintWarningSign(QPainter& painter, const QRectF& area, const QPalette& palette);

} // namespace view
