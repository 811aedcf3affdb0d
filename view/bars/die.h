// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/construction.h"

#include <QWidget>

namespace view {

// The die of the chaos game: the face that fell, in the colour of its map, and beside it all faces, each as
// wide as the share of its map.
class Die : public QWidget {
    Q_OBJECT

public:
    explicit Die(QWidget* parent = nullptr);

    void setFaces(const std::vector<Construction::Face>& faces);
    void setFallen(std::optional<std::size_t> map); // nullopt: none, or too many at once
    std::optional<std::size_t> fallen() const { return m_fallen; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    void paintFace(QPainter& painter, const QRectF& square) const;
    void paintFaces(QPainter& painter, const QRectF& strip) const;
    QString text() const;

    std::vector<Construction::Face> m_faces;
    std::optional<std::size_t> m_fallen;
};

} // namespace view
