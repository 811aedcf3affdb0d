// SPDX-License-Identifier: MIT
#include "bars/die.h"

#include "widgets/numbers/number_text.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <array>

namespace view {

namespace {

constexpr double stripWidth = 6;   // letter heights
constexpr std::size_t maxPips = 6; // greater numbers are written as digits
constexpr double gap = 6;          // pixels between the face and the strip

QColor colourOf(const Construction::Face& face) {
    return {face.colour.red, face.colour.green, face.colour.blue};
}

QColor inkOn(const QColor& colour) {
    return qGray(colour.rgb()) > 130 ? QColor(14, 18, 26) : QColor(250, 252, 255);
}

// Positions of the pips of a face, from −1 to 1.
std::vector<QPointF> pips(std::size_t count) {
    static const std::array<std::vector<QPointF>, maxPips + 1> all{
        {{},
         {{0, 0}},
         {{-1, 1}, {1, -1}},
         {{-1, 1}, {0, 0}, {1, -1}},
         {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}},
         {{-1, -1}, {1, -1}, {0, 0}, {-1, 1}, {1, 1}},
         {{-1, -1}, {-1, 0}, {-1, 1}, {1, -1}, {1, 0}, {1, 1}}}};
    return all.at(count);
}

} // namespace

Die::Die(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Die"));
    setAccessibleDescription(text());
    setWhatsThis(
        tr("The die of the chaos game. It has a face for each map, as wide as the probability of "
           "the map. The face that was rolled is shown in the colour of its map, and so is the point that "
           "the map leads to. At more than ten jumps per second, the die rolls too fast to be read."));
}

void Die::setFaces(const std::vector<Construction::Face>& faces) {
    m_faces = faces;
    if (m_fallen && *m_fallen >= m_faces.size()) m_fallen.reset();
    update();
}

void Die::setFallen(std::optional<std::size_t> map) {
    if (map && *map >= m_faces.size()) map.reset();
    if (map == m_fallen) return;
    m_fallen = map;
    setAccessibleDescription(text());
    update();
}

QString Die::text() const {
    if (!m_fallen) return tr("Each map has a face, as wide as its probability.");
    return tr("Map %1 was rolled; its probability is %2.")
        .arg(*m_fallen + 1)
        .arg(roundedNumber(m_faces[*m_fallen].share, maxDecimals));
}

QSize Die::sizeHint() const {
    const int letter = fontMetrics().height();
    const int side = std::max(24, letter * 3 / 2);
    return {int(side + gap + stripWidth * letter), side};
}

void Die::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = height();
    paintFace(painter, QRectF(0.5, 0.5, side - 1, side - 1));
    const double thick = side * 0.42;
    paintFaces(painter, QRectF(side + gap, (side - thick) / 2, width() - side - gap - 1, thick));
}

void Die::paintFace(QPainter& painter, const QRectF& square) const {
    const double corner = square.width() / 5;
    if (!m_fallen) {
        painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(square, corner, corner);
        return;
    }
    const QColor colour = colourOf(m_faces[*m_fallen]);
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
    painter.setBrush(colour);
    painter.drawRoundedRect(square, corner, corner);
    painter.setPen(inkOn(colour));
    if (*m_fallen < maxPips) {
        painter.setBrush(inkOn(colour));
        const double radius = square.width() / 11;
        for (const QPointF& pip : pips(*m_fallen + 1))
            painter.drawEllipse(square.center() + pip * square.width() * 0.26, radius, radius);
        return;
    }
    QFont letters = font();
    letters.setBold(true);
    const QString number = QString::number(*m_fallen + 1);
    letters.setPixelSize(std::max(6, int(square.height() * (number.size() < 3 ? 0.55 : 0.34))));
    painter.setFont(letters);
    painter.drawText(square, Qt::AlignCenter, number);
}

void Die::paintFaces(QPainter& painter, const QRectF& strip) const {
    double left = strip.left();
    QRectF fallen;
    painter.setPen(Qt::NoPen);
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
        const QRectF face(left, strip.top(), strip.width() * m_faces[i].share, strip.height());
        painter.fillRect(face, colourOf(m_faces[i]));
        if (m_fallen == i) fallen = face;
        left = face.right();
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1));
    painter.drawRect(strip);
    if (fallen.isNull()) return;
    const QColor ink = palette().color(QPalette::WindowText);
    painter.setPen(QPen(ink, 2));
    painter.drawRect(fallen.adjusted(0, -1, 0, 1));
    const QPointF tip(fallen.center().x(), strip.top() - 1);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPolygon(QPolygonF({tip, tip + QPointF(-4, -5), tip + QPointF(4, -5)}));
}

bool Die::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), text(), this);
    return true;
}

} // namespace view
