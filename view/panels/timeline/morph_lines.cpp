// SPDX-License-Identifier: MIT
#include "panels/timeline/morph_lines.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyle>

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr int padding = 6;
constexpr int swatch = 14;
constexpr double thinnest = 1.5;
constexpr double thickest = 14; // pixels for all of the weight
constexpr int columnsApart = 240;
constexpr double pinRadius = 4;

} // namespace

MorphLines::MorphLines(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Pairs of maps"));
    setWhatsThis(tr("The maps of this fractal are on the left, those of the other one on the right. A line "
                    "shows what a map becomes, and its thickness shows its share of the weight. Drag from a "
                    "map to one in the other column to pin the pair, and again to unpin it. With the "
                    "keyboard: choose a map with the arrow keys, press Space, go to the other map and press "
                    "Space again. Del removes all pins of a map."));
}

void MorphLines::setColumns(std::vector<QColor> from, std::vector<QColor> to) {
    m_from = std::move(from);
    m_to = std::move(to);
    m_pairs.clear();
    m_pins.clear();
    m_held.reset();
    m_hand.reset();
    m_current = {};
    updateGeometry();
    update();
    emit currentChanged();
}

void MorphLines::setPairs(std::vector<animation::Shipment> pairs) {
    m_pairs = std::move(pairs);
    update();
    emit currentChanged();
}

void MorphLines::clearPins() {
    if (m_pins.empty()) return;
    m_pins.clear();
    update();
    emit pinsChanged();
}

int MorphLines::rowHeight() const {
    return std::max(fontMetrics().height(), swatch) + 2 * padding;
}

int MorphLines::columnWidth() const {
    return fontMetrics().horizontalAdvance(tr("Map %1").arg(888)) + swatch + 3 * padding;
}

QSize MorphLines::sizeHint() const {
    const auto rows = int(std::max<std::size_t>({m_from.size(), m_to.size(), 1}));
    return {2 * columnWidth() + columnsApart, rows * rowHeight() + 2};
}

QRect MorphLines::rectOf(const Place& place) const {
    const int rows = int(colours(place.column).size());
    const int top = (height() - rows * rowHeight()) / 2; // centres the shorter column
    const int left = place.column == From ? 0 : width() - columnWidth();
    return {left, top + place.map * rowHeight(), columnWidth(), rowHeight()};
}

QPointF MorphLines::endOf(const Place& place) const {
    const QRectF rect = rectOf(place);
    return {place.column == From ? rect.right() : rect.left(), rect.center().y()};
}

std::optional<MorphLines::Place> MorphLines::placeAt(const QPointF& point) const {
    for (const Column column : {From, To})
        for (int i = 0; i < int(colours(column).size()); ++i)
            if (QRectF(rectOf({column, i})).contains(point)) return Place{column, i};
    return std::nullopt;
}

bool MorphLines::isPinned(std::size_t from, std::size_t to) const {
    return std::ranges::any_of(m_pins,
                               [&](const animation::Pin& pin) { return pin.from == from && pin.to == to; });
}

QString MorphLines::sentence() const {
    if (m_from.empty() || m_to.empty()) return {};
    QStringList others;
    for (const animation::Shipment& pair : m_pairs) {
        const bool isFrom = m_current.column == From;
        if (int(isFrom ? pair.from : pair.to) != m_current.map) continue;
        const QString other = QString::number((isFrom ? pair.to : pair.from) + 1);
        const QString share = QLocale().toString(pair.amount * 100, 'f', 1);
        others
            << (isPinned(pair.from, pair.to) ? tr("%1 (%2 %, pinned)") : tr("%1 (%2 %)")).arg(other, share);
    }
    const QString number = QString::number(m_current.map + 1);
    if (others.isEmpty()) return tr("Map %1 takes no part.").arg(number);
    return (m_current.column == From ? tr("Map %1 becomes map %2.") : tr("Map %1 comes from map %2."))
        .arg(number, others.join(QStringLiteral(", ")));
}

void MorphLines::setCurrent(const Place& place) {
    if (place == m_current) return;
    m_current = place;
    update();
    emit currentChanged();
}

void MorphLines::choose(const Place& place) {
    if (!m_held || m_held->column == place.column)
        m_held = m_held == place ? std::nullopt : std::optional(place);
    else
        togglePin(*std::exchange(m_held, std::nullopt), place);
    update();
}

void MorphLines::togglePin(const Place& one, const Place& other) {
    const Place& from = one.column == From ? one : other;
    const Place& to = one.column == From ? other : one;
    const animation::Pin pin{std::size_t(from.map), std::size_t(to.map)};
    if (isPinned(pin.from, pin.to))
        std::erase_if(m_pins, [&](const auto& each) { return each.from == pin.from && each.to == pin.to; });
    else
        m_pins.push_back(pin);
    update();
    emit pinsChanged();
}

void MorphLines::removePins(const Place& place) {
    const auto count = std::erase_if(m_pins, [&](const animation::Pin& pin) {
        return int(place.column == From ? pin.from : pin.to) == place.map;
    });
    if (count == 0) return;
    update();
    emit pinsChanged();
}

void MorphLines::mousePressEvent(QMouseEvent* event) {
    const auto place = placeAt(event->position());
    if (event->button() != Qt::LeftButton || !place) {
        m_held.reset();
        return update();
    }
    setCurrent(*place);
    if (m_held) return choose(*place);
    m_held = place;
    update();
}

void MorphLines::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & Qt::LeftButton) || !m_held) return;
    m_hand = event->position();
    update();
}

// A click that chooses the first of a pair waits for the second.
void MorphLines::mouseReleaseEvent(QMouseEvent* event) {
    const auto place = placeAt(event->position());
    m_hand.reset();
    if (event->button() == Qt::LeftButton && m_held && place != m_held) {
        const Place first = *std::exchange(m_held, std::nullopt);
        if (place && place->column != first.column) togglePin(first, *place);
    }
    update();
}

void MorphLines::keyPressEvent(QKeyEvent* event) {
    const int last = int(colours(m_current.column).size()) - 1;
    const auto goTo = [&](int map) { setCurrent({m_current.column, std::clamp(map, 0, std::max(0, last))}); };
    const auto cross = [&](Column column) {
        const int end = int(colours(column).size()) - 1;
        setCurrent({column, std::clamp(m_current.map, 0, std::max(0, end))});
    };
    switch (event->key()) {
    case Qt::Key_Up:
        return goTo(m_current.map - 1);
    case Qt::Key_Down:
        return goTo(m_current.map + 1);
    case Qt::Key_Home:
        return goTo(0);
    case Qt::Key_End:
        return goTo(last);
    case Qt::Key_Left:
        return cross(From);
    case Qt::Key_Right:
        return cross(To);
    case Qt::Key_Space:
        if (last >= 0 && !event->isAutoRepeat()) choose(m_current);
        return;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return removePins(m_current);
    case Qt::Key_Escape:
        if (m_held) {
            m_held.reset();
            m_hand.reset();
            return update();
        }
        break;
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void MorphLines::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    emit currentChanged();
}

void MorphLines::paintLine(QPainter& painter, const animation::Shipment& pair) const {
    const QPointF a = endOf({From, int(pair.from)}), b = endOf({To, int(pair.to)});
    const double pull = (b.x() - a.x()) / 2;
    QPainterPath path(a);
    path.cubicTo(a + QPointF(pull, 0), b - QPointF(pull, 0), b);
    const bool isCurrent = int(m_current.column == From ? pair.from : pair.to) == m_current.map;
    QLinearGradient gradient(a, b);
    for (const auto& [at, of] : {std::pair(0.0, m_from[pair.from]), std::pair(1.0, m_to[pair.to])}) {
        QColor colour = of;
        colour.setAlphaF(isCurrent && hasFocus() ? 1.0F : 0.7F);
        gradient.setColorAt(at, colour);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(
        QPen(gradient, thinnest + (thickest - thinnest) * pair.amount, Qt::SolidLine, Qt::FlatCap));
    painter.drawPath(path);
    if (!isPinned(pair.from, pair.to)) return;
    painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
    painter.setBrush(palette().color(QPalette::Text));
    for (const QPointF& end : {a, b})
        painter.drawEllipse(end, pinRadius, pinRadius);
}

void MorphLines::paintPlace(QPainter& painter, const Place& place) const {
    const QRect rect = rectOf(place);
    const bool isCurrent = place == m_current && hasFocus(), isHeld = place == m_held;
    if (isCurrent || isHeld) {
        const QColor highlight = palette().color(QPalette::Highlight);
        painter.setPen(isCurrent ? QPen(highlight, 1) : QPen(Qt::NoPen));
        painter.setBrush(isHeld ? QBrush(highlight) : QBrush(Qt::NoBrush));
        painter.drawRoundedRect(QRectF(rect).adjusted(2.5, 2.5, -2.5, -2.5), 4, 4);
    }
    const QRect inside = rect.adjusted(padding, 0, -padding, 0);
    const bool isLeft = place.column == From;
    const QRect box(isLeft ? inside.right() - swatch - padding / 2 : inside.left() + padding / 2,
                    rect.center().y() - swatch / 2, swatch, swatch);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.setBrush(colours(place.column)[std::size_t(place.map)]);
    painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    painter.setPen(palette().color(isHeld ? QPalette::HighlightedText : QPalette::Text));
    const QRect text = isLeft ? inside.adjusted(0, 0, -swatch - 2 * padding, 0)
                              : inside.adjusted(swatch + 2 * padding, 0, 0, 0);
    painter.drawText(text, Qt::AlignVCenter | (isLeft ? Qt::AlignRight : Qt::AlignLeft),
                     tr("Map %1").arg(place.map + 1));
}

void MorphLines::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    for (const animation::Shipment& pair : m_pairs)
        if (pair.from < m_from.size() && pair.to < m_to.size()) paintLine(painter, pair);
    if (m_held && m_hand) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2, Qt::DashLine));
        painter.drawLine(endOf(*m_held), *m_hand);
    }
    for (const Column column : {From, To})
        for (int i = 0; i < int(colours(column).size()); ++i)
            paintPlace(painter, {column, i});
}

} // namespace view
