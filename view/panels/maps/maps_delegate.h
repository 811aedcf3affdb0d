// SPDX-License-Identifier: MIT
#pragma once

#include "panels/maps/maps_model.h"

#include <QStyledItemDelegate>

namespace view {

class MapThumbnails;

// Paints numbers with their decimal points in one line, colours beside pictures of the maps, and marks what
// is on, locked, or does not contract. Typing in a cell is live; a text that is no number stays in its editor
// and is refused there.
class MapsDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int numberMargin = 3; // pixels to the left and right of a number

    MapsDelegate(MapsModel* model, QObject* parent);

    // Thumbnails of the Colour column.
    void setThumbnails(MapThumbnails* thumbnails) { m_thumbnails = thumbnails; }

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
    void soloRequested(const QModelIndex& index);
    void refused(const QString& reason) const; // sent for an edit that ended with a text that is no number

protected:
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;

private:
    void paintMark(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
    void paintPicture(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
    void paintNumber(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                     const QString& text) const;
    void paintText(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                   const QString& text) const;
    QWidget* createNameEditor(QWidget* parent, const QModelIndex& index) const;

    MapsModel* m_model;
    MapThumbnails* m_thumbnails = nullptr;
};

// A warning sign in the text's height; drawn, so that it looks the same with every font.
void paintWarningSign(QPainter& painter, const QRectF& area, const QPalette& palette);

} // namespace view
