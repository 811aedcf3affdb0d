// SPDX-License-Identifier: MIT
#pragma once

#include "animation/morph.h"

#include <QColor>
#include <QWidget>

#include <optional>
#include <vector>

namespace view {

// The maps of two codes as two columns in their colours, with a line from each map to each one that it
// becomes: the more of the weight goes that way, the thicker. Pairs are pinned and let go by dragging from
// one column to the other, by clicking one map after the other, or with the keyboard.
class MorphLines : public QWidget {
    Q_OBJECT

public:
    enum Column { From, To };
    struct Place {
        Column column = From;
        int map = 0;
        friend bool operator==(const Place&, const Place&) = default;
    };

    explicit MorphLines(QWidget* parent = nullptr);

    void setColumns(std::vector<QColor> from, std::vector<QColor> to); // clears pairs and pins
    void setPairs(std::vector<animation::Shipment> pairs);
    const std::vector<animation::Pin>& pins() const { return m_pins; }
    void clearPins();

    const Place& current() const { return m_current; }
    QRect rectOf(const Place& place) const;
    QString sentence() const; // fate of the current map

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void pinsChanged();
    void currentChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    const std::vector<QColor>& colours(Column column) const { return column == From ? m_from : m_to; }
    std::optional<Place> placeAt(const QPointF& point) const;
    int rowHeight() const;
    int columnWidth() const;
    QPointF endOf(const Place& place) const; // end of the lines of a place
    bool isPinned(std::size_t from, std::size_t to) const;
    void setCurrent(const Place& place);
    void choose(const Place& place); // first or second place of a pair
    void togglePin(const Place& one, const Place& other);
    void removePins(const Place& place);
    void paintLine(QPainter& painter, const animation::Shipment& pair) const;
    void paintPlace(QPainter& painter, const Place& place) const;

    std::vector<QColor> m_from;
    std::vector<QColor> m_to;
    std::vector<animation::Shipment> m_pairs;
    std::vector<animation::Pin> m_pins;
    Place m_current;
    std::optional<Place> m_held;   // first place of a pair
    std::optional<QPointF> m_hand; // pointer during the drag of a line from m_held
};

} // namespace view
